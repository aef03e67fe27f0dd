// SPDX-License-Identifier: Apache-2.0
#include "sheet/dimensions/rounded_edges.hpp"

#include <algorithm>
#include <numbers>
#include <utility>
#include <vector>

#include "base/error.hpp"
#include "base/portable_math.hpp"
#include "features/tolerances.hpp"

namespace epura::sheet {

namespace {

constexpr double max_turned = 16;  // degrees out of the paper

// The section nearest to the one in a direction on paper, `turned` out of it, where the view shows it.
scene::FeatureCircle section_beside(const features::RoundFeature& round, const Vec3& aside, double turned,
                                    const Vec3& normal) {
  const double cosine = portable_cos(std::max(turned, 0.0) * std::numbers::pi / 180);
  const Vec3 moved = (cosine - 1) * (round.ring + round.radius) * aside;
  std::vector<Vec3> arc = round.section(aside);
  check(arc.size() > 1, "a section has a length");
  for (Vec3& point : arc) point += moved;
  return {round.centre + round.ring * aside + moved, normal, round.radius, std::move(arc)};
}

}  // namespace

std::optional<SeenSection> seen_section(const features::RoundFeature& round, const ViewChoice& views) {
  for (const double most : {0.0, max_turned})
    for (const NamedProjection* view : views.all()) {
      const projection::Projection& projection = view->projection;
      for (const auto& [along, aside] : {std::pair(projection.u, projection.v), std::pair(projection.v, projection.u)})
        for (const double side : {1.0, -1.0})
          if (const double turned = round.turn_from(side * aside);
              features::are_parallel(along, round.axis) && turned <= most)
            return SeenSection{view, section_beside(round, side * aside, turned, projection.n)};
    }
  for (const NamedProjection* view : views.aligned()) {
    const projection::Projection& projection = view->projection;
    const Vec3 aside = features::are_parallel(projection.u, round.axis) ? projection.v : projection.u;
    if (shows_in_place(*view, round.centre, round.axis) && round.reaches(aside) && round.reaches(-aside))
      return SeenSection{view, section_beside(round, aside, 0, projection.n)};
  }
  return std::nullopt;
}

}  // namespace epura::sheet
