// SPDX-License-Identifier: Apache-2.0
#include "surfaces/chords.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "surfaces/limits.hpp"

namespace epura::surfaces {

namespace {

bool is_round(const Region& region) {
  return region.surface.kind != SurfaceKind::plane && region.surface.kind != SurfaceKind::free_form;
}

bool is_piece(const Facets& facets, int facet, const Region& region) {
  return is_chord(facets, facet, region.surface, allowance_of(facets, region.sagitta), region.sagitta);
}

// Whether a facet lies on the inner side of a surface that has one, nowhere much deeper than facets do in their
// middles: what cuts the facets of a mesh, rather than the surface, leaves vertices there. Wide ends of cones are
// deeper.
bool is_within_chords(const Facets& facets, int facet, const Region& region) {
  if (region.surface.kind == SurfaceKind::torus) return false;
  const double allowance = allowance_of(facets, region.sagitta), deepest = 2 * region.sagitta + allowance;
  const auto is_inside = [&](const Vec3& p) {
    const double distance = signed_distance(region.surface, p);
    return distance <= allowance && -distance <= deepest;
  };
  const auto triangles = facets.triangles_of(facet);
  return std::all_of(triangles.begin(), triangles.end(), [&](int t) {
    const auto& [a, b, c] = facets.corners[t];
    const Vec3 &p = facets.points[a], &q = facets.points[b], &r = facets.points[c];
    return is_inside(p) && is_inside(q) && is_inside(r) && is_inside((p + q) / 2.0) && is_inside((q + r) / 2.0) &&
           is_inside((r + p) / 2.0);
  });
}

bool is_trimmed_piece(const Facets& facets, int facet, const Region& region) {
  const double most = std::min(region.sagitta, max_trimmed * facets.tolerance);
  return is_chord(facets, facet, region.surface, trimmed_allowance_of(facets, region.sagitta), region.sagitta) ||
         approximates(facets, facet, region.surface, most, region.sagitta) ||
         (is_within_chords(facets, facet, region) &&
          approximates(facets, facet, region.surface, 2 * region.sagitta, region.sagitta));
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

Region with_facet(const Facets& facets, int facet, Region region) {
  region.facets.push_back(facet);
  for (const int v : facets.supports_of(facet))
    region.residual = std::max(region.residual, std::abs(signed_distance(region.surface, facets.points[v])));
  return region;
}

Regions take_pieces(const Facets& facets, Regions found, IsPiece is_piece_of) {
  std::vector<int>& region_of = found.region_of;
  const auto is_free = [&](int f) { return region_of[f] < 0; };
  std::vector<int> next;
  for (int f = 0; f < static_cast<int>(facets.facets.size()); ++f)
    if (is_free(f)) next.push_back(f);
  // In rounds, so that the region that a facet joins does not depend on the order of facets.
  while (!next.empty()) {
    std::vector<std::pair<int, int>> taken;
    for (const int f : next)
      if (const int region = region_of_chord(facets, f, region_of, found.regions, is_piece_of); region >= 0)
        taken.emplace_back(f, region);
    next.clear();
    for (const auto& [facet, region] : taken) {
      region_of[facet] = region;
      found.regions[region] = with_facet(facets, facet, std::move(found.regions[region]));
    }
    for (const auto& [facet, region] : taken)
      facets.for_sides(facet, [&](int, int, int other) {
        if (is_free(other)) next.push_back(other);
      });
    std::sort(next.begin(), next.end());
    next.erase(std::unique(next.begin(), next.end()), next.end());
  }
  return found;
}

// Whether a facet faces as a surface does at its vertices, within an eighth of a turn.
bool faces_along(const Facets& facets, int facet, const PartSurface& surface) {
  const auto vertices = facets.supports_of(facet);
  return std::all_of(vertices.begin(), vertices.end(), [&](int v) {
    return std::abs(glm::dot(normal_near(surface, facets.points[v]), facets.facets[facet].normal)) >= smooth_cosine;
  });
}

// Whether a facet may be a piece of a round surface: all its vertices lie on it, and it faces as the surface does. The
// flat end of a cone has more corners.
bool lies_on(const Facets& facets, int facet, const Region& region) {
  if (facets.facets[facet].is_plane) return false;
  const double allowance = allowance_of(facets, region.sagitta);
  const auto vertices = facets.supports_of(facet);
  return std::all_of(vertices.begin(), vertices.end(),
                     [&](int v) { return std::abs(signed_distance(region.surface, facets.points[v])) <= allowance; }) &&
         faces_along(facets, facet, region.surface);
}

/// Free facets connected with each other that lie on the surface of a region, if nothing but this region is around
/// them.
class Island {
 public:
  Island(const Facets& facets, const std::vector<int>& region_of, const Region& region, int number)
      : facets_(facets), region_of_(region_of), region_(region), number_(number) {}

  /// Returns nothing if the island is larger than a coarse spot of a mesh.
  [[nodiscard]] std::vector<int> from(int facet) const {
    std::vector<int> island{facet};
    bool is_enclosed = lies_on(facets_, facet, region_);
    for (std::size_t i = 0; i < island.size() && is_enclosed && island.size() <= largest_island; ++i)
      is_enclosed = add_around(island[i], island);
    return is_enclosed && island.size() <= largest_island ? island : std::vector<int>();
  }

 private:
  // Adds free neighbours; returns whether all neighbours belong to the island or its region.
  bool add_around(int facet, std::vector<int>& island) const {
    for (const int t : facets_.triangles_of(facet))
      for (const Side& side : facets_.sides[t]) {
        if (side.neighbour < 0) return false;
        const int other = facets_.facet_of[side.neighbour];
        if (other == facet || region_of_[other] == number_) continue;
        if (std::find(island.begin(), island.end(), other) != island.end()) continue;
        if (region_of_[other] >= 0 || !lies_on(facets_, other, region_)) return false;
        island.push_back(other);
      }
    return true;
  }

  const Facets& facets_;
  const std::vector<int>& region_of_;
  const Region& region_;
  int number_;
};

// Meshers for computations leave single facets many times as large as those around them. A flat of the part is never
// enclosed by a round face that has all its corners: its border would be a curve.
Regions take_islands(const Facets& facets, Regions found) {
  std::vector<int>& region_of = found.region_of;
  for (int f = 0; f < static_cast<int>(facets.facets.size()); ++f) {
    if (region_of[f] >= 0) continue;
    std::vector<int> beside;
    facets.for_sides(f, [&](int, int, int other) {
      const int number = region_of[other];
      if (number >= 0 && is_round(found.regions[number])) beside.push_back(number);
    });
    std::sort(beside.begin(), beside.end());
    beside.erase(std::unique(beside.begin(), beside.end()), beside.end());
    if (beside.size() != 1) continue;
    Region& region = found.regions[beside.front()];
    for (const int one : Island(facets, region_of, region, beside.front()).from(f)) {
      region_of[one] = beside.front();
      region = with_facet(facets, one, std::move(region));
    }
  }
  return found;
}

// Whether neither a facet nor its plane is deeper below a sphere than facets are, and no vertex above it.
bool is_below_sphere(const Facets& facets, int facet, const Region& region) {
  const PartSurface& surface = region.surface;
  const double allowance = allowance_of(facets, region.sagitta), deepest = 2 * region.sagitta + allowance;
  const auto vertices = facets.vertices_of(facet);
  return std::all_of(vertices.begin(), vertices.end(), [&](int v) {
    const Vec3 from = facets.points[v] - surface.origin;
    const double height =
        facets.is_sliver(facet) ? glm::length(from) : std::abs(glm::dot(from, facets.facets[facet].normal));
    return glm::length(from) <= surface.radius + allowance && height >= surface.radius - deepest;
  });
}

}  // namespace

bool are_chords(const Facets& facets, const Region& some, const Region& of, double allowance) {
  return std::all_of(some.facets.begin(), some.facets.end(),
                     [&](int f) { return is_chord(facets, f, of.surface, allowance, of.sagitta); });
}

bool are_chords(const Facets& facets, const Region& some, const Region& of) {
  return are_chords(facets, some, of, allowance_of(facets, of.sagitta));
}

bool are_left_of_sphere(const Facets& facets, const Region& some, const Region& of) {
  return of.surface.kind == SurfaceKind::sphere &&
         std::all_of(some.facets.begin(), some.facets.end(), [&](int f) { return is_below_sphere(facets, f, of); });
}

Regions take_chords(const Facets& facets, Regions found) {
  found = take_pieces(facets, std::move(found), is_piece);
  for (Region& region : found.regions) region.exact = region.exact_facets().size();
  found = take_pieces(facets, std::move(found), is_trimmed_piece);
  return take_islands(facets, std::move(found));
}

int region_around(const Facets& facets, int facet, const std::vector<int>& region_of,
                  const std::vector<Region>& regions) {
  const auto vertices = facets.vertices_of(facet);
  if (vertices.size() > corners_in_round) return -1;
  int nearest = -1;
  double least = HUGE_VAL;
  for (const int t : facets.triangles_of(facet))
    for (int side = 0; side < 3; ++side) {
      const int beyond = facets.sides[t][side].neighbour;
      if (beyond < 0) return -1;
      const int other = facets.facet_of[beyond], number = region_of[other];
      if (other == facet) continue;
      if (number < 0 || !is_round(regions[number]) || facets.fold_at(t, side) > coarse_fold) return -1;
      const Region& region = regions[number];
      double farthest = 0;
      for (const int v : vertices)
        farthest = std::max(farthest, std::abs(signed_distance(region.surface, facets.points[v])));
      if (farthest > region.sagitta / 2 || farthest >= least || !faces_along(facets, facet, region.surface)) continue;
      nearest = number;
      least = farthest;
    }
  return nearest;
}

}  // namespace epura::surfaces
