// SPDX-License-Identifier: Apache-2.0
#include "features/chords.hpp"

#include <algorithm>
#include <utility>

namespace epura::features {

namespace {

bool is_round(const Region& region) {
  return region.surface.kind != SurfaceKind::plane && region.surface.kind != SurfaceKind::free_form;
}

// The region behind the longest of the sides at which the facet is a chord of it; -1 where there is none.
int region_of_chord(const Facets& facets, int facet, const std::vector<int>& region_of,
                    const std::vector<Region>& regions) {
  int best = -1;
  double longest = 0;
  facets.for_sides(facet, [&](int t, int side, int other) {
    const int number = region_of[other];
    if (number < 0 || number == best || !is_round(regions[number])) return;
    const Region& region = regions[number];
    const double length = facets.length_of(t, side);
    if (length <= longest ||
        !is_chord(facets, facet, region.surface, allowance_of(facets, region.sagitta), region.sagitta))
      return;
    best = number;
    longest = length;
  });
  return best;
}

}  // namespace

void take_chords(const Facets& facets, std::vector<int>& region_of, std::vector<Region>& regions) {
  const auto is_free = [&](int f) { return region_of[f] < 0 && !facets.facets[f].is_plane; };
  std::vector<int> next;
  for (int f = 0; f < static_cast<int>(facets.facets.size()); ++f)
    if (is_free(f)) next.push_back(f);
  // In rounds, so that what a facet joins does not depend on the order of the others.
  while (!next.empty()) {
    std::vector<std::pair<int, int>> taken;
    for (const int f : next)
      if (const int region = region_of_chord(facets, f, region_of, regions); region >= 0) taken.emplace_back(f, region);
    next.clear();
    for (const auto& [facet, region] : taken) {
      region_of[facet] = region;
      regions[region].facets.push_back(facet);
    }
    for (const auto& [facet, region] : taken)
      facets.for_sides(facet, [&](int, int, int other) {
        if (is_free(other)) next.push_back(other);
      });
    std::sort(next.begin(), next.end());
    next.erase(std::unique(next.begin(), next.end()), next.end());
  }
}

}  // namespace epura::features
