// SPDX-License-Identifier: Apache-2.0
// Intersection lines of faces. They are not mesh edges, but are drawn like creases.
#pragma once

#include <array>
#include <vector>

#include "base/progress.hpp"
#include "scene/scene.hpp"

namespace epura::edges {

struct FaceCrossing {
  std::array<Vec3, 2> ends;      ///< in the world
  std::array<int, 2> triangles;  ///< of the world, first < second
  double angle;                  ///< at which their planes cross, 0 to 90 degrees

  bool operator<(const FaceCrossing& other) const { return triangles < other.triangles; }
};

struct FaceCrossings {
  std::vector<FaceCrossing> found;
  double searched = 1;  ///< part of the search that was done before time was over; 1: all of it
};

/// All crossings of two triangles without a common vertex, longer than `contact`, sorted by their triangles.
/// Faces that only touch (a corner or an edge within `contact` of the other's plane) do not cross; an edge that lies
/// in the other plane counts when its surface continues to the other side. `normalisation` is a power of two that
/// brings the world's size near 1; `contact` is a length normalised. Only triangles in `candidates` are searched,
/// ascending.
FaceCrossings find_intersections(const scene::World& world, double normalisation, double contact,
                                 const std::vector<int>& candidates, Progress progress = {});

/// The world's points as the search has them: normalised and moved to the middle of their box.
UnsetVector<Vec3> normalised_points(const scene::World& world, double normalisation);

/// Whether a triangle (its corners normalised) is so low that its normal is not a direction. Such a one crosses
/// nothing.
bool is_low(const Vec3& a, const Vec3& b, const Vec3& c, double contact);

/// Whether boxes have a place in common, touching included.
bool boxes_overlap(const Box& a, const Box& b);

}  // namespace epura::edges
