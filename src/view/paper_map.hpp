// SPDX-License-Identifier: Apache-2.0
// Window -> viewport (seed 003, step 10): position of the view on paper.
#pragma once

#include "view/projected_scene.hpp"

namespace epura::view {

/// Millimetres of paper from page vertices: paper = origin + scale * (x, y).
struct PaperMap {
  double scale;  ///< mm per view unit
  Vec2 origin;   ///< where the origin of page vertices lands

  [[nodiscard]] Vec2 operator()(const PageVertex& v) const { return origin + scale * Vec2(v.x, v.y); }
};

/// What is drawn, as a box of the plane in the model's own lengths, from the origin of page vertices.
projection::Window drawn_box(const ProjectedScene& view);

/// The map for paper = shift + scale * plane, with lengths of the plane as in drawn_box.
PaperMap make_paper_map(const ProjectedScene& view, double scale, const Vec2& shift);

/// The whole way as one matrix: page = (row0/row3, row1/row3) in mm, row2/row3 grows towards the viewer.
Mat4 world_to_page(const ProjectedScene& view, const PaperMap& paper);

/// Images of the directions of the world axes on the paper; nothing where lines along the axis stay parallel.
std::array<std::optional<Vec2>, 3> vanishing_points_on_page(const ProjectedScene& view, const PaperMap& paper);

}  // namespace epura::view
