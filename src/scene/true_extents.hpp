// SPDX-License-Identifier: Apache-2.0
// Extents of the part along the axes of the world. The mesh has only vertices: a polygon around a circle is narrower
// than the circle unless a corner lies at its extreme.
#pragma once

#include <array>

#include "base/progress.hpp"
#include "scene/scene.hpp"

namespace epura::scene {

enum class ExtentForm : unsigned char { length, diameter, sphere };

struct Extent {
  double from = 0, to = 0;
  ExtentForm form = ExtentForm::length;  ///< what reaches farthest at both ends: anything, one shaft, one sphere
  Vec3 centre{0}, axis{0};               ///< of the shaft; of the sphere without axis

  [[nodiscard]] double size() const { return to - from; }
  /// Whether both are the diameter of one shaft or sphere.
  [[nodiscard]] bool is_same_as(const Extent& other) const;
};

/// Along x, y and z. A point of a recognised cylinder, cone, sphere or torus counts where facets of its face lie below
/// it; everywhere else vertices do.
std::array<Extent, 3> true_extents(const World& world);

/// The largest distance of facets from the surfaces that they represent, a length of the world; 0 where no round face
/// is recognised. Throws OutOfTime.
double tessellation_error(const World& world, const Progress& progress = {});

}  // namespace epura::scene
