// SPDX-License-Identifier: Apache-2.0
// Proof that a closed body is convex: the whole body is on one side of the plane of each face.
#pragma once

#include <span>
#include <vector>

#include "scene/scene.hpp"

namespace epura::edges {

/// The bodies of all models in one numbering.
struct BodyTable {
  std::vector<int> of_triangle;  ///< of the world
  std::vector<Box> box;          ///< by body; empty where it has no triangles
};
BodyTable bodies_of(const scene::World& world, std::span<const Vec3> points);

/// Of the bodies that are marked in `candidates`, those keep their mark that are closed, run once around their middle,
/// and lie at most `contact` before the plane of any of their triangles, planes and distances computed in double.
/// `points` are the world's, of about unit size and near the origin; `contact` is a length there. A body that loses its
/// mark may be convex all the same.
///
/// Local tests suffice. Let every triangle show its inner side to the mean c of the corners, from a distance of at
/// least rho, and let one ray from c meet one triangle only. Radial projection from c is then a covering of the sphere
/// by one sheet. Cut the body by a plane through c, a place x of a triangle and a vertex v: the outline is a polygon
/// around c. Follow it from x to v by the shorter way. As long as v may lie before the line of x, the way has turned
/// left by less than half a turn; so it rises before that line only by right turns, which are R in all, and no higher
/// than R times its length. The length is at most pi r^2 / rho where r is the greatest distance from c, and R at most
/// the sum over all edges that are folded inwards of the angle times pi / 2 * r / rho: a plane crosses an edge once.
/// (Local tests: Mehlhorn, Naeher, Seel, Seidel, Schilz, Schirra, Uhrig. Checking geometric programs. CGTA 1999.)
void keep_convex(const scene::World& world, std::span<const Vec3> points, const BodyTable& bodies, double contact,
                 std::vector<char>& candidates);

}  // namespace epura::edges
