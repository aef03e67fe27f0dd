// SPDX-License-Identifier: Apache-2.0
// Maps the window to the viewport (seed 003, step 10): the position of the view on paper.
#pragma once

#include "view/projected_scene.hpp"

namespace epura::view {

/// Converts page vertices to millimetres on paper: paper = origin + scale * (x, y).
struct PaperMap {
  double scale;  ///< mm per view unit
  Vec2 origin;   ///< position on paper of the origin of page vertices

  [[nodiscard]] Vec2 operator()(const PageVertex& v) const { return origin + scale * Vec2(v.x, v.y); }
};

/// Returns the drawn part of the plane as a box in units of the model, from the origin of page vertices.
projection::Window drawn_box(const ProjectedScene& view);

/// Returns the map paper = shift + scale * plane, with lengths in the plane as in drawn_box.
PaperMap make_paper_map(const ProjectedScene& view, double scale, const Vec2& shift);

/// Returns the whole transformation as one matrix: page = (row0/row3, row1/row3) in mm; row2/row3 grows towards the
/// viewer.
Mat4 world_to_page(const ProjectedScene& view, const PaperMap& paper);

/// Returns the images of the directions of the world axes on paper; nothing where lines along the axis stay parallel.
std::array<std::optional<Vec2>, 3> vanishing_points_on_page(const ProjectedScene& view, const PaperMap& paper);

}  // namespace epura::view
