// SPDX-License-Identifier: Apache-2.0
// Models placed in one world, with common indices.
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "base/unset_vector.hpp"
#include "base/vec.hpp"
#include "features/recognise.hpp"
#include "mesh/mesh.hpp"
#include "scene/description.hpp"

namespace epura::scene {

/// A model and its position.
struct Placed {
  std::shared_ptr<const mesh::Mesh> mesh;  ///< by worlds that are cut from one another
  Mat4 to_world{1.0};
  std::shared_ptr<const features::PartFaces> part{};  ///< of the mesh before it was cut; null where none is recognised
  std::vector<StyleDescription> styles{};             ///< by body of the mesh; empty if none matches a body
};

/// All models in one numbering: vertex v of model m is number first_vertex[m] + v, triangles likewise.
struct World {
  std::vector<Placed> models;
  UnsetVector<Vec3> points;  ///< world coordinates; the origin for vertices that no triangle and no wire uses
  UnsetVector<std::array<int, 3>> triangles;
  std::vector<std::array<int, 2>> wires;  ///< edges that no triangle has, lower vertex first, in order of their models
  std::vector<int> first_vertex, first_triangle;  ///< one more than there are models
  Box box;                                        ///< of all vertices that triangles or wires use
  double rounding = 0;   ///< largest shift of vertices by rounding in the files; 0: coordinates are exact
  Vec3 one_rounding{0};  ///< the same by a single rounding of each coordinate, along the axes of the world

  [[nodiscard]] int model_of_triangle(int triangle) const;
};

/// Adds those of a model whose vertices are counted from `first_vertex` on.
void append_wires(World& world, const mesh::Mesh& mesh, int first_vertex);

/// Throws Error{input} when a transform throws a model out of the range of doubles. Without
/// wires, those of models with faces do not widen the box, though their vertices have positions.
World make_world(std::vector<Placed> models, bool with_wires = true);

}  // namespace epura::scene
