// SPDX-License-Identifier: Apache-2.0
#include "sizes/radius_dimensions.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <map>
#include <numbers>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "base/error.hpp"
#include "base/portable_math.hpp"
#include "features/tolerances.hpp"
#include "sizes/axis_positions.hpp"
#include "sizes/equal_features.hpp"
#include "sizes/placed_balls.hpp"

namespace epura::sheet {

namespace {

using features::ArcFeature;
using features::are_parallel;
using features::are_same;
using features::BallFeature;
using features::RoundFeature;
using scene::DimensionDescription;

// As `times`, but nobody counts the corners of a hundred teeth, and one note gives the radius of all that look equal.
std::string times_of_radii(std::size_t count) { return count > max_of_a_kind ? "" : times(count); }

// The view that shows an arc, at either end of its face.
const NamedProjection* view_of(const ArcFeature& arc, const ViewChoice& views) {
  std::array<scene::FeatureCircle, 2> rims{scene::FeatureCircle{arc.centre, arc.axis, arc.radius, arc.points},
                                           {arc.other_end, arc.axis, arc.radius, arc.points}};
  for (Vec3& point : rims[1].arc) point += arc.other_end - arc.centre;
  return views.showing(rims);
}

// The view along most of some arcs, and these.
std::pair<const NamedProjection*, std::vector<const ArcFeature*>> view_of_most(
    const ViewChoice& views, const std::vector<const ArcFeature*>& arcs) {
  std::pair<const NamedProjection*, std::vector<const ArcFeature*>> best{};
  for (const NamedProjection* view : views.all()) {
    std::vector<const ArcFeature*> seen;
    std::copy_if(arcs.begin(), arcs.end(), std::back_inserter(seen),
                 [&](const ArcFeature* arc) { return view_of(*arc, views) == view; });
    if (seen.size() > best.second.size()) best = {view, std::move(seen)};
  }
  return best;
}

bool has_radius(std::span<const DimensionDescription> dimensions, double radius, double doubt,
                const Notation& notation) {
  return std::any_of(dimensions.begin(), dimensions.end(), [&](const DimensionDescription& dimension) {
    return *dimension.type == DimensionType::radius && (are_written_alike(dimension.circle->radius, radius, notation) ||
                                                        std::abs(dimension.circle->radius - radius) <= doubt);
  });
}

// Whether an overall dimension is the diameter of a ball.
bool is_overall_ball(const DimensionSubject& subject, const BallFeature& ball) {
  return std::any_of(subject.extents.begin(), subject.extents.end(), [&](const features::Extent& extent) {
    return extent.form == features::ExtentForm::sphere && are_same(extent.size(), 2 * ball.radius);
  });
}

// A short arc of the outline of a ball in a view.
scene::FeatureCircle outline_of(const BallFeature& ball, const projection::Projection& projection) {
  const Vec3 flat = ball.middle - glm::dot(ball.middle, projection.n) * projection.n;
  const Vec3 out = glm::normalize(glm::length(flat) > 0.1 ? flat : projection.u + projection.v);
  const Vec3 aside = glm::cross(projection.n, out);
  std::vector<Vec3> arc;
  for (const double turn : {-0.1, 0.0, 0.1})
    arc.push_back(ball.centre + ball.radius * glm::normalize(out + turn * aside));
  return {ball.centre, projection.n, ball.radius, std::move(arc)};
}

}  // namespace

Planned arc_positions(const Planning& plan) {
  Planned planned;
  const std::vector<ArcFeature>& arcs = plan.subject.features.arcs;
  const auto add = [&](int number) {
    const ArcFeature& arc = arcs[static_cast<std::size_t>(number)];
    planned.append(positions_of(plan, std::array{arc.centre}, arc.axis, view_of(arc, plan.views),
                                plan.group_of(SizeKind::arc, arcs, &arc)));
  };
  for (const RoundEnd& end : plan.table.round_ends)
    if (end.arc >= 0) add(end.arc);
  for (const RoundEnd& channel : plan.table.channels) add(channel.arc);
  return planned;
}

Planned ball_positions(const Planning& plan) {
  Planned planned;
  for (const int number : plan.table.balls) {
    check(number >= 0 && number < static_cast<int>(plan.subject.features.balls.size()), "a sphere is one of the part");
    const BallFeature& ball = plan.subject.features.balls[static_cast<std::size_t>(number)];
    const int group = static_cast<int>(plan.table.sizes.size()) + number;
    for (int axis = 0; axis < 3; ++axis) {
      if (ends_models(ball, axis, plan.extent(axis))) continue;
      // In a view across this axis that looks at most of the sphere.
      const int next = (axis + 1) % 3, last = (axis + 2) % 3;
      const Vec3 sight = Mat3(1)[std::abs(ball.middle[next]) > std::abs(ball.middle[last]) ? next : last];
      const Planned positions = positions_of(plan, std::array{ball.centre}, sight, plan.views.along(sight), group);
      for (const auto& place : positions.places)
        if (const auto* coordinate = std::get_if<Coordinate>(&place); coordinate != nullptr && coordinate->axis == axis)
          planned.places.emplace_back(*coordinate);
    }
  }
  return planned;
}

Planned arc_dimensions(const Planning& plan) {
  auto groups = equal_features(plan.table, SizeKind::arc, plan.subject.features.arcs);
  std::stable_sort(groups.begin(), groups.end(), [](const auto& a, const auto& b) {
    return double(a.size()) * a.front()->radius > double(b.size()) * b.front()->radius;
  });
  const Vec3 size = plan.box.size();
  const double largest = std::max({size.x, size.y, size.z});
  std::map<std::string, std::size_t> in_view;
  Planned planned;
  for (const auto& group : groups) {
    const auto [view, seen] = view_of_most(plan.views, group);
    if (view == nullptr || double(group.size()) * group.front()->radius < min_radius * largest) continue;
    if (in_view[view->name]++ >= max_radii) {
      ++planned.omitted.too_many[view->name];
      continue;
    }
    const auto* shown = uppermost<ArcFeature>(seen, *view, [](const ArcFeature& arc) {
      check(arc.radius > 0 && arc.points.size() > 4, "an arc has a radius and a middle");
      return arc.points[4];
    });
    planned.dimensions.push_back(plan.dimension(DimensionType::radius, *view, times_of_radii(group.size()) + "<>",
                                                {shown->centre, shown->axis, shown->radius, shown->points}));
  }
  return planned;
}

Planned round_dimensions(const Planning& plan, std::span<const DimensionDescription> so_far) {
  const auto equal = [](const RoundFeature& a, const RoundFeature& b) {
    return a.model == b.model && are_same(a.radius, b.radius) && are_parallel(a.axis, b.axis);
  };
  Planned planned;
  for (const auto& group : groups_of<RoundFeature>(plan.subject.features.rounds, equal)) {
    const RoundFeature& round = *group.front();
    std::optional<SeenSection> seen = seen_section(round, plan.views);
    if (!seen || has_radius(so_far, round.radius, 0, plan.notation) ||
        has_radius(planned.dimensions, round.radius, 0, plan.notation))
      continue;
    planned.dimensions.push_back(plan.dimension(DimensionType::radius, *seen->view, times_of_radii(group.size()) + "<>",
                                                std::move(seen->circle)));
  }
  return planned;
}

Planned ball_dimensions(const Planning& plan, std::span<const DimensionDescription> so_far) {
  const auto equal = [&](const BallFeature& a, const BallFeature& b) {
    return a.model == b.model && are_written_alike(a.radius, b.radius, plan.notation);
  };
  Planned planned;
  for (const auto& group : groups_of<BallFeature>(plan.subject.features.balls, equal)) {
    const BallFeature& ball = *group.front();
    check(ball.radius > 0, "a ball has a radius");
    if (has_radius(so_far, ball.radius, ball.doubt, plan.notation) ||
        has_radius(planned.dimensions, ball.radius, ball.doubt, plan.notation) || is_overall_ball(plan.subject, ball))
      continue;
    const auto& views = plan.views.all();
    const auto view = std::find_if(views.begin(), views.end(), [&](const NamedProjection* one) {
      return std::abs(glm::dot(ball.middle, one->projection.n)) < 0.5;
    });
    if (view == views.end()) continue;
    planned.dimensions.push_back(plan.dimension(DimensionType::radius, **view, times(group.size()) + "S<>",
                                                outline_of(ball, (*view)->projection)));
  }
  return planned;
}

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
