// SPDX-License-Identifier: Apache-2.0
#include "features/turned_part.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "base/range.hpp"
#include "features/tolerances.hpp"

namespace epura::features {

int axis_beside(const Vec3& normal) {
  for (int axis = 0; axis < 3; ++axis)
    if (std::abs(normal[axis]) <= parallel) return axis;
  return -1;
}

namespace {

// The faces that end all points along a direction; null where none does.
std::array<const PlaneFeature*, 2> ends_along(const Vec3& direction, const std::vector<PlaneFeature>& planes,
                                              const std::vector<Vec3>& points) {
  Range all;
  for (const Vec3& p : points) all.add(glm::dot(p, direction));
  std::array<const PlaneFeature*, 2> ends{};
  for (const PlaneFeature& plane : planes)
    for (const std::size_t end : {0U, 1U})
      if (are_parallel(plane.normal, direction) && std::abs(glm::dot(plane.corners.front(), direction) -
                                                            (end == 0 ? all.from : all.to)) <= same_size * all.size())
        ends[end] = &plane;
  return ends;
}

}  // namespace

std::optional<TurnedPart> find_turned_part(const std::vector<PlaneFeature>& inclined, const std::vector<Vec3>& points,
                                           const FlatEnds& flat) {
  Box box;
  for (const Vec3& point : points) box.add(point);
  for (const PlaneFeature& plane : inclined) {
    const int world = axis_beside(plane.normal);
    if (world < 0) continue;
    bool is_flat = false;
    for (const int step : {1, 2}) {
      const auto other = static_cast<std::size_t>((world + step) % 3);
      is_flat = is_flat || flat[other][0] || flat[other][1];
    }
    // Most planes are no ends, which is soon seen: gears have thousands.
    const double at = glm::dot(plane.corners.front(), plane.normal) + same_size * glm::length(box.size());
    const auto is_beyond = [&](const Vec3& point) { return glm::dot(point, plane.normal) > at; };
    if (is_flat || std::ranges::any_of(points, is_beyond)) continue;
    const Vec3 axis = Mat3(1)[world];
    TurnedPart part{axis, {plane.normal, glm::cross(axis, plane.normal)}, {}};
    for (const std::size_t side : {0U, 1U}) part.ends[side] = ends_along(part.directions[side], inclined, points);
    const auto is_ended = [](const auto& ends) { return ends[0] != nullptr && ends[1] != nullptr; };
    if (is_ended(part.ends[0]) && is_ended(part.ends[1])) return part;
  }
  return std::nullopt;
}

}  // namespace epura::features
