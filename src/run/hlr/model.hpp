// SPDX-License-Identifier: Apache-2.0
// The model of epura_hlr_finish: a world to draw, and which calls of the sink its faces and edges come from.
#pragma once

#include <epura/hlr.h>

#include <array>
#include <cstdint>
#include <tuple>
#include <vector>

#include "base/spline.hpp"
#include "importer/document.hpp"
#include "world/world.hpp"

namespace epura::hlr {

inline constexpr epura_hlr_face no_face{EPURA_NONE, EPURA_NONE, EPURA_NONE, EPURA_NONE};

/// For comparisons of faces.
inline auto key_of(const epura_hlr_face& face) { return std::tuple(face.node, face.shape, face.face, face.body); }

/// An edge or a wire of a shape where it stands.
struct SourceEdge {
  std::array<int, 2> vertex;  ///< ends of one piece, lower first
  std::uint32_t node, shape;
  std::uint32_t number;                ///< among the edges between faces of its shape, or among its wires
  int spline = -1;                     ///< in Model::splines; -1: none
  std::array<double, 2> parameters{};  ///< of the vertices on it
};

struct Model {
  world::World world;
  std::vector<epura_hlr_face> face_of_polygon;
  std::vector<SourceEdge> edges;  ///< by vertices
  std::vector<Spline> splines{};
};

/// Shapes at their places as one mesh, in the units of their points. Without `is_mesh`, faces are recognised if none
/// are declared. Throws Error{input}.
Model make_model(const importer::Document& document, bool is_mesh);

/// Returns the edge that a piece between two vertices belongs to, lower vertex first; null: none.
const SourceEdge* edge_at(const Model& model, const std::array<int, 2>& vertices);

/// Returns the faces that meet in an edge of the mesh, a second one only if it is another; those of `edge` first.
std::array<epura_hlr_face, 2> faces_at(const Model& model, const std::array<int, 2>& vertices, const SourceEdge* edge);

}  // namespace epura::hlr
