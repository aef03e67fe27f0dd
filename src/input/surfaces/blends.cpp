// SPDX-License-Identifier: Apache-2.0
#include "surfaces/blends.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "surfaces/limits.hpp"

namespace epura::surfaces {

namespace {

/// A side at which a region ends on a circle around its axis, and the facet beyond it.
struct RimSide {
  double height;
  int facet;
  Vec3 end;
};

/// The normal of a surface at a point, in the half-plane through that.
Vec2 profile_normal(const PartSurface& surface, const Vec3& point) {
  const Vec3 from = point - surface.origin, normal = normal_near(surface, point);
  const Vec3 across = from - glm::dot(from, surface.axis) * surface.axis;
  const double away = glm::length(across);
  return away > 0 ? Vec2(glm::dot(normal, across) / away, glm::dot(normal, surface.axis)) : Vec2(0);
}

class BlendGrower {
 public:
  BlendGrower(const Facets& facets, std::vector<int>& region_of, std::vector<Region>& regions)
      : facets_(facets), region_of_(region_of), regions_(regions), grower_(facets, region_of, regions) {}

  void grow() {
    // The tori that grow are looked at, too.
    for (std::size_t r = 0; r < regions_.size(); ++r) {
      const PartSurface surface = regions_[r].surface;
      if (!has_axis(surface.kind)) continue;
      const std::vector<RimSide> sides = rim_sides(regions_[r]);
      for (auto first = sides.begin(); first != sides.end();) {
        const auto last = std::find_if(first, sides.end(), [&](const RimSide& side) {
          return side.height > first->height + max_allowance * facets_.tolerance;
        });
        grow_from(surface, {first, last});
        first = last;
      }
    }
  }

 private:
  // By height.
  [[nodiscard]] std::vector<RimSide> rim_sides(const Region& region) const {
    std::vector<RimSide> sides;
    for (const int f : region.facets)
      facets_.for_sides(f, [&](int t, int side, int other) {
        if (region_of_[other] >= 0 || facets_.facets[other].is_plane) return;
        if (facets_.cosine_of_fold(t, side) < smooth_cosine) return;
        const auto [a, b] = facets_.ends_of(t, side);
        const double height = profile_of(region.surface, a).y;
        if (std::abs(height - profile_of(region.surface, b).y) <= max_allowance * facets_.tolerance)
          sides.push_back({height, other, a});
      });
    std::sort(sides.begin(), sides.end(), [](const RimSide& a, const RimSide& b) {
      return a.height != b.height ? a.height < b.height : a.facet < b.facet;
    });
    return sides;
  }

  void grow_from(const PartSurface& surface, const std::vector<RimSide>& sides) {
    std::vector<int> seeds;
    for (const RimSide& side : sides)
      if (region_of_[side.facet] < 0 && !facets_.is_sliver(side.facet)) seeds.push_back(side.facet);
    std::sort(seeds.begin(), seeds.end());
    seeds.erase(std::unique(seeds.begin(), seeds.end()), seeds.end());
    if (seeds.size() < fewest_seeds) return;
    const auto torus = tangent_torus(surface, sides.front().end, seeds);
    if (!torus) return;
    auto region = grower_.grow(*torus, seeds);
    if (!region || !grower_.is_evident(*region) || !is_blend(*region, *torus)) return;
    for (const int f : region->facets) region_of_[f] = static_cast<int>(regions_.size());
    regions_.push_back(std::move(*region));
  }

  [[nodiscard]] bool is_blend(const Region& region, const PartSurface& tangent) const {
    if (std::abs(region.surface.minor - tangent.minor) > same_blend_radius * tangent.minor) return false;
    std::vector<Vec3> points;
    for (const int f : region.facets)
      for (const int v : facets_.supports_of(f)) points.push_back(facets_.points[v]);
    const double allowance = allowance_of(facets_, region.sagitta);
    return places_of(region.surface, points, false, allowance).sweep >= min_blend &&
           places_of(region.surface, points, true, allowance).sweep >= min_blend && is_whole(region);
  }

  // Whether it ends at edges and at other surfaces, not anywhere in a free form.
  [[nodiscard]] bool is_whole(const Region& region) const {
    std::vector<int> own = region.facets;
    std::sort(own.begin(), own.end());
    double open = 0, all = 0;
    for (const int f : own)
      facets_.for_sides(f, [&](int t, int side, int other) {
        if (std::binary_search(own.begin(), own.end(), other)) return;
        const double length = facets_.length_of(t, side);
        all += length;
        const bool is_known = region_of_[other] >= 0 || facets_.facets[other].is_plane;
        if (!is_known && facets_.cosine_of_fold(t, side) >= smooth_cosine) open += length;
      });
    return open <= max_open * all;
  }

  // The circle through a point of the profile, tangent to it there, that comes nearest to the vertices of the seeds:
  // |d|^2 = 2 r (d . n) for its radius r and the way d from the point.
  [[nodiscard]] std::optional<PartSurface> tangent_torus(const PartSurface& surface, const Vec3& rim,
                                                         const std::vector<int>& seeds) const {
    const Vec2 at = profile_of(surface, rim), normal = profile_normal(surface, rim);
    double both = 0, squares = 0;
    for (const int f : seeds)
      for (const int v : facets_.supports_of(f)) {
        const Vec2 way = profile_of(surface, facets_.points[v]) - at;
        const double across = 2 * glm::dot(way, normal);
        both += glm::dot(way, way) * across;
        squares += across * across;
      }
    if (!(squares > 0) || both == 0) return std::nullopt;
    const double radius = both / squares;
    const Vec2 centre = at + radius * normal;
    if (!(centre.x > 0) || !std::isfinite(radius)) return std::nullopt;
    return PartSurface{SurfaceKind::torus, surface.origin + centre.y * surface.axis, surface.axis, centre.x,
                       std::abs(radius)};
  }

  const Facets& facets_;
  std::vector<int>& region_of_;
  std::vector<Region>& regions_;
  RegionGrower grower_;
};

}  // namespace

Regions grow_blends(const Facets& facets, Regions found) {
  BlendGrower(facets, found.region_of, found.regions).grow();
  return found;
}

}  // namespace epura::surfaces
