// SPDX-License-Identifier: Apache-2.0
#include "features/chords.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace epura::features {

namespace {

bool is_round(const Region& region) {
  return region.surface.kind != SurfaceKind::plane && region.surface.kind != SurfaceKind::free_form;
}

// CAD kernels trim faces along inexact curves: vertices there may lie off both surfaces, by less than the sagitta of
// the tessellation.
constexpr double most_trimmed = 64;  // tolerances

bool is_piece(const Facets& facets, int facet, const Region& region) {
  return is_chord(facets, facet, region.surface, allowance_of(facets, region.sagitta), region.sagitta);
}

bool is_trimmed_piece(const Facets& facets, int facet, const Region& region) {
  const double trimmed = most_trimmed * facets.tolerance;
  return is_chord(facets, facet, region.surface, std::min(region.sagitta / 8, trimmed), region.sagitta) ||
         approximates(facets, facet, region.surface, std::min(region.sagitta, trimmed), region.sagitta);
}

using IsPiece = bool (*)(const Facets& facets, int facet, const Region& region);

// Returns the region across the longest side among those of which the facet is a chord; -1 if there is none.
int region_of_chord(const Facets& facets, int facet, const std::vector<int>& region_of,
                    const std::vector<Region>& regions, IsPiece is_piece_of) {
  int best = -1;
  double longest = 0;
  facets.for_sides(facet, [&](int t, int side, int other) {
    const int number = region_of[other];
    if (number < 0 || number == best || !is_round(regions[number])) return;
    const Region& region = regions[number];
    const double length = facets.length_of(t, side);
    if (length <= longest || !is_piece_of(facets, facet, region)) return;
    best = number;
    longest = length;
  });
  return best;
}

void add(const Facets& facets, int facet, Region& region) {
  region.facets.push_back(facet);
  for (const int v : facets.supports_of(facet))
    region.residual = std::max(region.residual, std::abs(signed_distance(region.surface, facets.points[v])));
}

void take_pieces(const Facets& facets, std::vector<int>& region_of, std::vector<Region>& regions, IsPiece is_piece_of) {
  const auto is_free = [&](int f) { return region_of[f] < 0 && !facets.facets[f].is_plane; };
  std::vector<int> next;
  for (int f = 0; f < static_cast<int>(facets.facets.size()); ++f)
    if (is_free(f)) next.push_back(f);
  // In rounds, so that the region that a facet joins does not depend on the order of facets.
  while (!next.empty()) {
    std::vector<std::pair<int, int>> taken;
    for (const int f : next)
      if (const int region = region_of_chord(facets, f, region_of, regions, is_piece_of); region >= 0)
        taken.emplace_back(f, region);
    next.clear();
    for (const auto& [facet, region] : taken) {
      region_of[facet] = region;
      add(facets, facet, regions[region]);
    }
    for (const auto& [facet, region] : taken)
      facets.for_sides(facet, [&](int, int, int other) {
        if (is_free(other)) next.push_back(other);
      });
    std::sort(next.begin(), next.end());
    next.erase(std::unique(next.begin(), next.end()), next.end());
  }
}

}  // namespace

void take_chords(const Facets& facets, std::vector<int>& region_of, std::vector<Region>& regions) {
  take_pieces(facets, region_of, regions, is_piece);
  for (Region& region : regions) region.exact = region.facets.size();
  take_pieces(facets, region_of, regions, is_trimmed_piece);
}

}  // namespace epura::features
