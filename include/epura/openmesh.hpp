// SPDX-License-Identifier: Apache-2.0
// OpenMesh meshes as models: any TriMesh or PolyMesh, with any traits.
//
//   epura::Scene scene{.models = {{.polygons = epura::polygons_of(mesh)}}};
//
// Needs neither the library nor OpenMesh itself, only a mesh.
#pragma once

#include <cstddef>
#include <epura/scene_types.hpp>
#include <type_traits>

namespace epura {

/// The faces of a mesh. Vertices keep their numbers, so `Line::edge` contains indices of OpenMesh handles. Deleted
/// faces are omitted.
template <class HalfedgeMesh>
[[nodiscard]] Polygons polygons_of(const HalfedgeMesh& mesh) {
  using Coordinate = std::decay_t<decltype(mesh.point(typename HalfedgeMesh::VertexHandle())[0])>;
  Polygons polygons;
  polygons.single_precision = std::is_same_v<Coordinate, float>;
  polygons.points.reserve(mesh.n_vertices());
  for (const auto vertex : mesh.all_vertices()) {
    const auto& p = mesh.point(vertex);
    polygons.points.push_back({double(p[0]), double(p[1]), double(p[2])});
  }
  polygons.faces.reserve(mesh.n_faces());
  for (const auto face : mesh.faces()) {
    polygons.faces.emplace_back();
    for (const auto vertex : mesh.fv_range(face)) polygons.faces.back().push_back(vertex.idx());
  }
  return polygons;
}

}  // namespace epura
