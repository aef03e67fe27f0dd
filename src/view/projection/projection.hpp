// SPDX-License-Identifier: Apache-2.0
// A projection that is ready for use: a plane and projectors in world coordinates.
#pragma once

#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/angle.hpp"
#include "base/vec.hpp"

namespace epura::projection {

/// A rectangle of the projection plane, in coordinates (u, v) from the plane's point.
struct Window {
  Vec2 min;
  Vec2 max;
};

struct Projection {
  std::string name;
  /// The parameters with which it was made, except those derived from the model's box and limits without effect.
  std::vector<std::pair<std::string, std::vector<double>>> values;

  Vec3 point;    ///< origin of (u, v) in the plane
  Vec3 u, v, n;  ///< right, up and normal (towards the viewer): orthonormal, seed 003 (3.30)-(3.32)
  bool central = false;
  Vec3 projector;    ///< central: the centre; parallel: a direction towards the viewer with n . projector > 0
  double scale = 1;  ///< length on the page of a unit length in the plane
  std::optional<Window> window;
  double front = std::numeric_limits<double>::infinity();  ///< n-coordinate of the front clipping plane
  double back = -std::numeric_limits<double>::infinity();
};

/// Whether its projectors are parallel, and perpendicular to the plane: lengths in that are seen true.
inline bool is_orthographic(const Projection& projection) {
  const Vec3& along = projection.projector;
  return !projection.central && glm::length(glm::cross(along, projection.n)) <= parallel_sine * glm::length(along);
}

}  // namespace epura::projection
