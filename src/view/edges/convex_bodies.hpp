// SPDX-License-Identifier: Apache-2.0
// Proves that closed bodies are convex: the whole body lies on one side of the plane of each face.
#pragma once

#include <span>
#include <vector>

#include "world/world.hpp"

namespace epura::edges {

/// The bodies of all models, numbered consecutively.
struct BodyTable {
  std::vector<int> of_triangle;  ///< by triangle of the world
  std::vector<Box> box;          ///< by body; empty if it has no triangles
};
BodyTable bodies_of(const world::World& world, std::span<const Vec3> points);

/// A body that is marked in `candidates` keeps its mark if it is closed, its surface encloses its middle exactly once,
/// and it extends at most `contact` in front of the plane of any of its triangles, with planes and distances computed
/// in double. `points` are those of the world, of about unit size and near the origin; `contact` is a length in the
/// same unit. A body that loses its mark may be convex nevertheless.
///
/// Local tests suffice. Let every triangle face the mean c of the corners with its inner side, with c at a distance of
/// at least rho from its plane, and let one ray from c meet only one triangle. Then radial projection from c is a
/// one-sheeted covering of the sphere. Cut the body by a plane through c, a point x of a triangle and a vertex v: the
/// outline is a polygon around c. Follow it from x to v the shorter way. As long as v can lie in front of the line of
/// x, the path has turned left by less than half a turn; hence it rises in front of that line only by right turns,
/// whose sum is R, and by no more than R times its length. The length is at most pi r^2 / rho, where r is the greatest
/// distance from c, and R is at most the sum over all inward folds of the angle times pi / 2 * r / rho, since a plane
/// crosses an edge only once. (Local tests: Mehlhorn, Naeher, Seel, Seidel, Schilz, Schirra, Uhrig. Checking geometric
/// programs. CGTA 1999.)
void keep_convex(const world::World& world, std::span<const Vec3> points, const BodyTable& bodies, double contact,
                 std::vector<char>& candidates);

}  // namespace epura::edges
