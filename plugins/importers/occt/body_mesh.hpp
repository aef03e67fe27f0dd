// SPDX-License-Identifier: Apache-2.0
// The triangles of a body with common vertex numbers: faces that share an edge share its points, so that a closed body
// has a closed mesh.
#pragma once

#include <NCollection_IndexedDataMap.hxx>
#include <TopTools_ShapeMapHasher.hxx>
#include <TopoDS_Face.hxx>
#include <array>
#include <cstdint>
#include <epura/importer_plugin.hpp>
#include <vector>

namespace occt {

struct Facets {
  TopoDS_Face face;
  std::vector<std::array<std::uint32_t, 3>> triangles;  ///< counterclockwise as seen from outside
};

/// Points along an edge, in the direction of its curve.
struct Along {
  std::vector<std::uint32_t> points;
  std::vector<double> parameters{};  ///< of these on its curve; empty: not known
};

using PointsOfEdges = NCollection_IndexedDataMap<TopoDS_Shape, Along, TopTools_ShapeMapHasher>;

struct BodyMesh {
  std::vector<epura::plugin::Point> points;
  std::vector<Facets> faces;
  PointsOfEdges edges;
  std::size_t unmeshed_faces = 0;
  std::size_t inner_faces = 0;  ///< faces inside a solid that are not part of its boundary
  std::size_t gaps = 0;         ///< edges whose faces have different points
  double error = 0;             ///< mm: distance of faces that could not be refined to the tolerance
  bool is_turned = false;       ///< a solid whose faces pointed inward, and were reversed
};

/// Vertex numbers begin with `first_point`.
BodyMesh mesh_of(const TopoDS_Shape& body, std::uint32_t first_point, double tolerance);

}  // namespace occt
