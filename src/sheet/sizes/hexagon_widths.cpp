// SPDX-License-Identifier: Apache-2.0
#include "sizes/hexagon_widths.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "base/error.hpp"
#include "features/tolerances.hpp"
#include "sizes/axis_positions.hpp"
#include "sizes/equal_features.hpp"
#include "sizes/prism_dimensions.hpp"

namespace epura::sheet {

namespace {

using features::are_parallel;
using features::HexagonFeature;
using features::parallel;

bool are_same(double a, double b, double size) { return std::abs(a - b) <= size_agrees * size; }

/// A view, the normal of the flats between which it measures, and the direction in which the extension lines leave
/// their ends.
struct WidthView {
  const NamedProjection* view;
  Vec3 normal, end;
  std::optional<DimensionDirection> direction{};  ///< nothing: oblique
};

// In a view along the axis if possible, and there between flats that are horizontal or vertical.
std::optional<WidthView> view_of(const HexagonFeature& hexagon, const ViewChoice& views) {
  const auto straight = [&](const NamedProjection& view, double half) -> std::optional<WidthView> {
    for (const Vec3& normal : hexagon.normals) {
      if (are_parallel(normal, view.projection.u))
        return WidthView{&view, normal, -half * view.projection.v, DimensionDirection::horizontal};
      if (are_parallel(normal, view.projection.v))
        return WidthView{&view, normal, half * view.projection.u, DimensionDirection::vertical};
    }
    return std::nullopt;
  };
  if (const NamedProjection* along = views.along(hexagon.axis)) {
    const Vec3& normal = hexagon.normals.front();
    if (const auto found = straight(*along, hexagon.half_flat)) return found;
    return WidthView{along, normal, hexagon.half_flat * glm::cross(along->projection.n, normal)};
  }
  for (const NamedProjection* view : views.all())
    if (are_parallel(view->projection.u, hexagon.axis) || are_parallel(view->projection.v, hexagon.axis))
      if (const auto found = straight(*view, hexagon.half_height)) return found;
  return std::nullopt;
}

// Of its axis if it is as large as the models, and of its flats.
std::vector<KnownPlace> known_places(const HexagonFeature& hexagon, const DimensionSubject& subject) {
  std::vector<KnownPlace> places;
  for (int axis = 0; axis < 3; ++axis) {
    if (is_extent(hexagon, axis, subject, false)) places.push_back({axis, hexagon.centre[axis]});
    for (const Vec3& normal : hexagon.normals)
      if (world_axis(normal) == axis)
        for (const double side : {-0.5, 0.5})
          places.push_back({axis, hexagon.centre[axis] + side * hexagon.across_flats});
  }
  return places;
}

scene::DimensionDescription width_of(const Planning& plan, const HexagonFeature& hexagon, const WidthView& shown,
                                     std::size_t count) {
  scene::DimensionDescription dimension = plan.dimension(
      shown.direction ? DimensionType::linear : DimensionType::aligned, *shown.view, times(count) + "<>");
  if (shown.direction) dimension.direction = {*shown.direction, plan.wanted.where};
  for (const double side : {-0.5, 0.5}) {
    const Vec3 flat = hexagon.centre + side * hexagon.across_flats * shown.normal;
    dimension.anchors.emplace_back(flat + shown.end);
    if (shown.direction) dimension.opposite.push_back(flat - shown.end);
  }
  return dimension;
}

// Of flats that are along no axis of the world, nor along those of a turned part.
std::optional<scene::DimensionDescription> angle_of(const Planning& plan, const HexagonFeature& hexagon,
                                                    std::size_t count) {
  const NamedProjection* view = plan.views.along(hexagon.axis);
  const auto is_straight = [&](const Vec3& normal) {
    return features::axis_along(normal) >= 0 ||
           (plan.table.is_turned(hexagon.axis) && (are_parallel(normal, plan.table.turned->directions[0]) ||
                                                   are_parallel(normal, plan.table.turned->directions[1])));
  };
  if (view == nullptr || features::axis_along(hexagon.axis) < 0 || std::ranges::any_of(hexagon.normals, is_straight))
    return std::nullopt;
  check(hexagon.half_flat > 0, "a flat has a length");
  std::vector<Side> sides;
  for (const Vec3& normal : hexagon.normals)
    for (const double side : {-0.5, 0.5})
      for (const double way : {-1.0, 1.0}) {
        const Vec3 half = way * hexagon.half_flat * glm::cross(hexagon.axis, normal);
        sides.push_back({hexagon.centre + side * hexagon.across_flats * normal - half, 2.0 * half});
      }
  return angle_to_axis(plan, *view, sides, times(count) + "<>");
}

bool is_extent_across_flats(const HexagonFeature& hexagon, const DimensionSubject& subject) {
  for (int axis = 0; axis < 3; ++axis)
    if (is_extent(hexagon, axis, subject, true)) return true;
  return false;
}

}  // namespace

bool is_extent(const HexagonFeature& hexagon, int axis, const DimensionSubject& subject, bool across_flats) {
  const Vec3 direction = Mat3(1)[axis];
  if (hexagon.inwards || std::abs(hexagon.axis[axis]) > parallel) return false;
  if (across_flats && std::none_of(hexagon.normals.begin(), hexagon.normals.end(),
                                   [&](const Vec3& normal) { return are_parallel(normal, direction); }))
    return false;
  const features::Extent& extent = subject.extents[static_cast<std::size_t>(axis)];
  const double reach = hexagon.reach(direction);
  return are_same(extent.from, hexagon.centre[axis] - reach, reach) &&
         are_same(extent.to, hexagon.centre[axis] + reach, reach);
}

bool is_across_flats(const HexagonFeature& hexagon, const Vec3& along, const Vec3& from, const Vec3& to) {
  const double half = hexagon.across_flats / 2;
  if (std::none_of(hexagon.normals.begin(), hexagon.normals.end(),
                   [&](const Vec3& normal) { return are_parallel(normal, along); }))
    return false;
  const double a = glm::dot(from - hexagon.centre, along), b = glm::dot(to - hexagon.centre, along);
  return are_same(std::abs(a), half, half) && are_same(a, -b, half);
}

bool are_equal(const HexagonFeature& a, const HexagonFeature& b) {
  return a.model == b.model && a.inwards == b.inwards && are_same(a.across_flats, b.across_flats, a.across_flats) &&
         are_parallel(a.axis, b.axis) && std::any_of(b.normals.begin(), b.normals.end(), [&](const Vec3& normal) {
           return are_parallel(a.normals.front(), normal);
         });
}

bool is_across_corners(const Planning& plan, int axis) {
  const std::vector<HexagonFeature>& hexagons = plan.subject.features.hexagons;
  return std::any_of(hexagons.begin(), hexagons.end(), [&](const HexagonFeature& hexagon) {
    return view_of(hexagon, plan.views) && is_extent(hexagon, axis, plan.subject, false) &&
           !is_extent(hexagon, axis, plan.subject, true);
  });
}

Planned hexagon_dimensions(const Planning& plan) {
  const std::vector<HexagonFeature>& hexagons = plan.subject.features.hexagons;
  Planned planned;
  for (const HexagonFeature& hexagon : hexagons) {
    check(hexagon.across_flats > 0, "a hexagon has a width");
    if (!view_of(hexagon, plan.views)) continue;
    for (const KnownPlace& place : known_places(hexagon, plan.subject)) planned.places.emplace_back(place);
    if (const NamedProjection* view = plan.views.along(hexagon.axis))
      planned.append(positions_of(plan, std::array{hexagon.centre}, hexagon.axis, view,
                                  plan.group_of(SizeKind::hexagon, hexagons, &hexagon)));
  }
  for (const auto& group : equal_features(plan.table, SizeKind::hexagon, hexagons)) {
    const auto shown = view_of(*group.front(), plan.views);
    if (shown && (group.size() > 1 || !is_extent_across_flats(*group.front(), plan.subject)))
      planned.dimensions.push_back(width_of(plan, *group.front(), *shown, group.size()));
    if (auto angle = angle_of(plan, *group.front(), group.size())) planned.dimensions.push_back(std::move(*angle));
  }
  return planned;
}

}  // namespace epura::sheet
