// SPDX-License-Identifier: Apache-2.0
// Draws by one of the three arithmetics, and measures lengths.
#pragma once

#include "drawing/make_drawing.hpp"
#include "edges/find_edges.hpp"
#include "laboratory/arithmetic.hpp"
#include "laboratory/shapes.hpp"
#include "view/condition.hpp"
#include "visibility/spans.hpp"
#include "visibility/visibility.hpp"

namespace epura::laboratory {

/// Orthographic projection with `towards_viewer` pointing to the viewer; the plane passes through the origin.
projection::Projection orthographic(const Vec3& towards_viewer, const Vec3& up = {0, 0, 1});
/// The view from above: x right, y up, larger z nearer.
projection::Projection from_above();
/// Central projection from `eye` onto the plane through `point` with `normal`; u, v from `up`.
projection::Projection perspective(const Vec3& eye, const Vec3& point, const Vec3& normal, const Vec3& up);

/// All intermediate results of a drawing, in model units: page = plane coordinates.
struct Result {
  world::World world;
  view::ProjectedScene view;
  edges::FeatureEdges drawn;
  visibility::HiddenSpans hidden;
  drawing::ViewDrawing drawing;
  double unit;  ///< model length of a unit on the page
  view::Condition condition;

  [[nodiscard]] double visible() const { return length(true); }
  [[nodiscard]] double hidden_length() const { return length(false); }
  [[nodiscard]] int pieces(bool visible) const;
  /// Longest side of the drawing.
  [[nodiscard]] double extent() const { return view.extent * unit; }
  /// Lines closer to each other than this are merged.
  [[nodiscard]] double merge_width() const;

 private:
  [[nodiscard]] double length(bool visible) const;
};

/// The hidden parts of a straight line that belongs to no mesh.
struct HiddenLine {
  visibility::Spans spans;  ///< page parameters, 0 to 1
  double contact;           ///< the tolerance, model units
  double cell;              ///< of the page grid, model units
  double extent;            ///< of the drawing, model units

  /// Lines closer to each other than this are merged.
  [[nodiscard]] double merge_width() const { return std::max(contact, 4 * cell); }
};

struct Lab {
  Arithmetic arithmetic = Arithmetic::own;
  double size = 1;          ///< factor for the sizes of large scenes
  bool recognises = false;  ///< worlds have the faces of parts, where they can be recognised

  /// The same by epura's own arithmetic, for comparison.
  [[nodiscard]] Lab exact() const { return {Arithmetic::own, size, recognises}; }

  /// With the faces of parts if this recognises any.
  [[nodiscard]] world::World prepare(world::World world) const;
  [[nodiscard]] world::World world_of(const std::vector<Shape>& shapes) const;
  [[nodiscard]] world::World world_of(const Shape& shape) const { return world_of(std::vector<Shape>{shape}); }
  [[nodiscard]] Result draw(world::World world, const Camera& camera, const edges::EdgeOptions& options = {}) const;
  [[nodiscard]] HiddenLine hidden_of_line(const world::World& world, const projection::Projection& projection,
                                          const Vec3& from, const Vec3& to) const;
};

}  // namespace epura::laboratory
