// SPDX-License-Identifier: Apache-2.0
// Computes extents of the part along the axes of the world. The vertices of the mesh do not suffice: a polygon around a
// circle is narrower than the circle unless a corner lies at its extreme.
#pragma once

#include <array>
#include <vector>

#include "world/world.hpp"

namespace epura::features {

enum class ExtentForm : unsigned char { length, diameter, sphere };

struct Extent {
  double from = 0, to = 0;
  ExtentForm form = ExtentForm::length;  ///< what determines both ends: anything, one shaft, one sphere
  Vec3 centre{0}, axis{0};               ///< of the shaft; a sphere has no axis
  bool interrupted = false;              ///< a slot or a gap between teeth is at an end, where nothing reaches as far
  std::array<std::vector<Vec3>, 2> at_ends{};  ///< corners of the triangles there, within what facets deviate

  [[nodiscard]] double size() const { return to - from; }
  /// Whether both are the diameter of one shaft or sphere.
  [[nodiscard]] bool is_same_as(const Extent& other) const;
};

/// Returns the vertices that triangles use, each once; all vertices if there are no triangles. Lines beside the faces,
/// such as those of annotations in the file, are not part of what has a size.
std::vector<Vec3> points_of_faces(const world::World& world);
/// The box of these.
Box box_of_faces(const world::World& world);

/// Returns the extents along x, y and z. Points of a recognised cylinder, cone, sphere or torus count if facets of its
/// face lie below them; elsewhere vertices count. A cylinder that slots or gaps between teeth interrupt counts as if it
/// were whole, unless it ends in a flat.
std::array<Extent, 3> true_extents(const world::World& world);

}  // namespace epura::features
