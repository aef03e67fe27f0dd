// SPDX-License-Identifier: Apache-2.0
#include "sheet/dimensions/missing_views.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/error.hpp"
#include "base/text.hpp"
#include "features/tolerances.hpp"
#include "sheet/dimensions/coordinates.hpp"

namespace epura::sheet {

namespace {

bool is_seen_along(const Vec3& axis, std::span<const DimensionsInView> views) {
  return std::any_of(views.begin(), views.end(), [&](const DimensionsInView& view) {
    return is_orthographic(view.projection) && !view.turned_about && features::are_parallel(view.projection.n, axis);
  });
}

bool is_seen_beside(const Vec3& axis, std::span<const DimensionsInView> views) {
  return std::any_of(views.begin(), views.end(), [&](const DimensionsInView& view) {
    if (view.turned_about) return features::are_parallel(*view.turned_about, axis);
    return is_orthographic(view.projection) && std::abs(glm::dot(view.projection.n, axis)) <= features::parallel;
  });
}

std::string view_along(const Vec3& axis) {
  constexpr std::array views{"left", "front", "top"};
  if (const int along = world_axis(axis); along >= 0) return views[std::size_t(along)];
  const double largest = std::max({std::abs(axis.x), std::abs(axis.y), std::abs(axis.z)});
  check(largest > 0, "an axis has a direction");
  std::string name = "auxiliary:direction=";
  for (int i = 0; i < 3; ++i) name += (i > 0 ? "," : "") + format_rounded(axis[i] / largest, 6);
  return name;
}

}  // namespace

Remedy remedy_for(const Vec3& axis, bool only_along, std::span<const DimensionsInView> views) {
  if (is_seen_along(axis, views) || (!only_along && is_seen_beside(axis, views))) return {};
  const std::string view = view_along(axis);
  return {", which no view shows in its true form: add the view " + view, view};
}

Remedy remedy_beside(const Vec3& axis, std::span<const DimensionsInView> views) {
  for (const int normal : {1, 0, 2})
    if (const Vec3 n = Mat3(1)[normal]; std::abs(glm::dot(n, axis)) <= features::parallel && !is_seen_along(n, views))
      return {", whose section may be seen in the view " + view_along(n), view_along(n)};
  return {};
}

}  // namespace epura::sheet
