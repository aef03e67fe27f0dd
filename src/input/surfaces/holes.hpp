// SPDX-License-Identifier: Apache-2.0
// Holes of a part: round faces around one axis with the material outside.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "surfaces/recognise.hpp"

namespace epura::surfaces {

struct Hole {
  std::vector<int> faces;         ///< round faces around its axis: bores, countersinks, the tip of a drill hole
  std::vector<double> diameters;  ///< of its bores, smallest first
  Vec3 from, to;                  ///< ends of its axis
  bool through;                   ///< open at both ends
  std::array<bool, 2> closed{};   ///< at `from` and `to`
};

/// Finds full bores, and joins successive bores on one axis into one hole. Ordered by their lowest face.
std::vector<Hole> find_holes(const mesh::Mesh& mesh, const PartFaces& part);

/// Returns where the axis through the origin meets a triangle, along the axis; nothing if it passes by, or lies in its
/// plane. What is within `slack` of its sides is met: an apex or the middle of a bottom, a corner of several triangles,
/// is beside the axis by the rounding of the file.
std::optional<double> height_on_axis(const std::array<Vec3, 3>& corners, const Vec3& axis, double slack);

}  // namespace epura::surfaces
