// SPDX-License-Identifier: Apache-2.0
// Models placed in one world, with common indices.
#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "base/unset_vector.hpp"
#include "base/vec.hpp"
#include "mesh/mesh.hpp"
#include "scene/style.hpp"
#include "scene/threads.hpp"
#include "surfaces/recognise.hpp"

namespace epura::world {

/// A model and its position.
struct Placed {
  std::shared_ptr<const mesh::Mesh> mesh;  ///< shared by worlds cut from each other
  Mat4 to_world{1.0};
  std::shared_ptr<const surfaces::PartFaces> part{};  ///< of the uncut mesh; null if no faces are recognised
  std::vector<scene::ThreadedFace> threads{};         ///< of the part, in the order of the scene
  int copy_of = -1;  ///< the model of the scene of which this is a turned part, in aligned sections; -1: itself
};

/// All models with common numbering: vertex v of model m has the number first_vertex[m] + v; likewise for triangles.
struct World {
  std::vector<Placed> models;
  UnsetVector<Vec3> points;  ///< in the world; the origin for vertices that no triangle or wire uses
  UnsetVector<std::array<int, 3>> triangles;
  std::vector<std::array<int, 2>> wires;  ///< edges without triangles, lower vertex first, in order of models
  /// By model of the scene, by body of its mesh; empty if none matches a body.
  std::vector<std::vector<scene::StyleDescription>> styles{};
  std::vector<int> first_vertex, first_triangle;  ///< one element more than there are models
  Box box;                                        ///< box of all vertices that triangles or wires use
  double rounding = 0;   ///< largest displacement of vertices by rounding in the files; 0: coordinates are exact
  Vec3 one_rounding{0};  ///< the same for a single rounding of each coordinate, along the axes of the world

  [[nodiscard]] int model_of_triangle(int triangle) const;
  /// The number in the scene of a model of this world.
  [[nodiscard]] int number_in_scene(int model) const {
    const int copied = models[static_cast<std::size_t>(model)].copy_of;
    return copied < 0 ? model : copied;
  }
  /// The styles of a model's bodies; empty if none matches a body.
  [[nodiscard]] std::span<const scene::StyleDescription> styles_of(int model) const {
    if (styles.empty()) return {};
    return styles[static_cast<std::size_t>(number_in_scene(model))];
  }
};

/// Adds the wires of a model whose vertices are numbered from `first_vertex`.
void append_wires(World& world, const mesh::Mesh& mesh, int first_vertex);

/// Returns a world without models, with the box, the rounding and the styles of another, for what is cut from that one.
World without_models(const World& world);

/// Throws Error{input} if a transform moves a model out of the range of doubles. Without
/// wires, those of models with faces do not widen the box, though their vertices have positions.
World make_world(std::vector<Placed> models, bool with_wires = true);

}  // namespace epura::world
