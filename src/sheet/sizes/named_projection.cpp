// SPDX-License-Identifier: Apache-2.0
#include "sizes/named_projection.hpp"

#include "features/tolerances.hpp"

namespace epura::sheet {

bool keeps(const NamedProjection& view, const Vec3& point) {
  return view.section == nullptr || cut::keeps(*view.section, point, view.slack);
}

std::optional<Vec3> shown_point(const NamedProjection& view, const Vec3& point) {
  if (!view.aligned()) return point;
  const std::optional<Mat4> turn = cut::turn_at(*view.section, point, view.slack);
  return turn ? std::optional(Vec3(*turn * Vec4(point, 1))) : std::nullopt;
}

bool shows_in_place(const NamedProjection& view, const Vec3& point, const Vec3& axis) {
  if (!view.aligned()) return true;
  const std::optional<Vec3> shown = shown_point(view, point);
  return shown && glm::distance(*shown, point) <= view.slack && features::are_parallel(view.section->axis(), axis);
}

bool keeps_positions(const NamedProjection& view, int axis) {
  return !view.aligned() || features::are_parallel(view.section->axis(), Mat3(1)[axis]);
}

}  // namespace epura::sheet
