// SPDX-License-Identifier: Apache-2.0
#include "view/paper_map.hpp"

#include "projection/matrices.hpp"

namespace epura::view {

namespace {

// Converts a row of the map to a row for absolute world points: constant + r . (k x - k origin), k = normalisation.
Vec4 absolute(const ViewMap& map, const Vec3& row, double constant) {
  const Vec3 r = row * map.normalisation;
  return {r.x, r.y, r.z, constant - glm::dot(row, map.origin * map.normalisation)};
}

}  // namespace

projection::Window drawn_box(const ProjectedScene& view) {
  return {(view.window.min - view.middle) / view.map.normalisation,
          (view.window.max - view.middle) / view.map.normalisation};
}

PaperMap make_paper_map(const ProjectedScene& view, double scale, const Vec2& shift) {
  return {scale / view.map.normalisation, shift};
}

Mat4 world_to_page(const ProjectedScene& view, const PaperMap& paper) {
  const ViewMap& map = view.map;
  const Vec4 w = absolute(map, map.w, map.w_constant);
  const Vec2 shift = paper.origin - paper.scale * view.middle;
  return rows(paper.scale * absolute(map, map.u, 0) + shift.x * w, paper.scale * absolute(map, map.v, 0) + shift.y * w,
              paper.scale * absolute(map, map.z, map.z_constant), w);
}

std::array<std::optional<Vec2>, 3> vanishing_points_on_page(const ProjectedScene& view, const PaperMap& paper) {
  std::array<std::optional<Vec2>, 3> points = projection::vanishing_points(view.projection);
  const double unit = view.projection.scale * view.map.normalisation;
  for (auto& point : points)
    if (point) point = paper.origin + paper.scale * (*point * unit - view.map.image - view.middle);
  return points;
}

}  // namespace epura::view
