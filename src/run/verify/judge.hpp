// SPDX-License-Identifier: Apache-2.0
// Finds the true visibility of points on edges from all triangles of the world.
//
// A point is hidden if a triangle that does not contain its edge lies between it and the viewer, more than the contact
// tolerance in front of it. An answer is given only if it holds within the guaranteed tolerance.
#pragma once

#include <span>
#include <vector>

#include "base/progress.hpp"
#include "base/vec.hpp"
#include "verify/cover.hpp"
#include "verify/verify_input.hpp"

namespace epura::verify {

/// A point of a drawn edge.
struct Probe {
  int edge;  ///< in FeatureEdges::edges
  double t;  ///< parameter along the whole edge in space
};

enum class ProbeAnswer { visible, hidden, undecided };

struct ProbeVerdict {
  ProbeAnswer answer = ProbeAnswer::visible;
  int facet = -1;  ///< the nearest triangle that hides the point; -1 if not requested
};

/// Returns one verdict for each probe. With `name_facets`, work that the answer does not need is done, too, which takes
/// longer. Throws OutOfTime.
std::vector<ProbeVerdict> judge(const VerifyInput& input, const Tolerance& tolerance, std::span<const Probe> probes,
                                bool name_facets, const Progress& progress = {});

/// The corners of a convex polygon, in either direction.
using ConvexPolygon = std::vector<Vec2>;

/// Returns the area of the square from (-1, -1) to (1, 1) that none of the polygons covers, 0 to 4.
double uncovered(const std::vector<ConvexPolygon>& polygons);

}  // namespace epura::verify
