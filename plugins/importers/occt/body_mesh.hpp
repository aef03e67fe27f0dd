// SPDX-License-Identifier: Apache-2.0
// The triangles of a body with one numbering of points: faces that share an edge share its points, so that what is
// closed is closed.
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

/// The points along each edge, in the direction of its curve.
using PointsOfEdges = NCollection_IndexedDataMap<TopoDS_Shape, std::vector<std::uint32_t>, TopTools_ShapeMapHasher>;

struct BodyMesh {
  std::vector<epura::plugin::Point> points;
  std::vector<Facets> faces;
  PointsOfEdges edges;
  std::size_t unmeshed_faces = 0;
  std::size_t inner_faces = 0;  ///< faces inside a solid that bound nothing
  std::size_t gaps = 0;         ///< edges whose faces do not agree on their points
  double error = 0;             ///< mm: what faces are off by where they could not be refined to the tolerance
  bool is_turned = false;       ///< a solid whose faces looked inward, and were turned
};

/// Numbers of points begin with `first_point`.
BodyMesh mesh_of(const TopoDS_Shape& body, std::uint32_t first_point, double tolerance);

}  // namespace occt
