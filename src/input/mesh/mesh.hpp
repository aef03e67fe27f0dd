// SPDX-License-Identifier: Apache-2.0
// A model after reading and repair: its triangles and their edge table.
//
// Files contain polygon soups, non-manifold edges and flipped faces, whereas a half-edge structure needs consistently
// oriented two-manifolds. Decisions about edges therefore use the table of undirected edges with all their triangles;
// mesh/openmesh.hpp builds half-edges for algorithms that traverse them.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "base/unset_vector.hpp"
#include "base/vec.hpp"
#include "mesh/soup.hpp"

namespace epura::mesh {

/// The relation of an edge to a cutting plane.
enum class CutEdge : std::uint8_t {
  none,
  outline,  ///< outline of a section, or of the cut through an open surface
  inside    ///< divides a section, or the remains of a cut triangle: not drawn
};

/// An undirected edge between two vertices of the file, vertex[0] < vertex[1].
struct MeshEdge {
  std::array<int, 2> vertex;
  int first;      ///< start of its triangles in Mesh::edge_triangles
  int count;      ///< number of triangles that share it; 0: it is only a wire segment
  bool diagonal;  ///< lies inside a polygon of the file: drawn only as a contour
  CutEdge cut;
  bool wire;  ///< the file has a line here, with or without faces
};

/// A vertex created by a cutting plane.
struct CutVertex {
  std::array<int, 2> edge;  ///< edge of the file on which it lies, lower vertex first; {-1, -1} inside a section
  double t;                 ///< parameter on this edge, between 0 and 1
};

/// The edge of the file to which an edge belongs, as the whole or a part of it.
struct EdgeOrigin {
  std::array<int, 2> vertex;  ///< ends of the edge in the file; of the edge itself if the cutting plane created it
  std::array<double, 2> t;    ///< parameters of its ends along that edge
  bool in_file;
};

/// The defects found in the file, and their repairs.
struct MeshReport {
  std::string name;    ///< path of the file
  std::string format;  ///< "obj", "stl", "ply", "off"
  int vertices = 0;    ///< number in the file (STL: after welding)
  int faces = 0;       ///< polygons of the file that are drawn
  int triangles = 0;   ///< after triangulation
  int points = 0;      ///< points of the file that are drawn as crosses
  int point_arms = 0;  ///< wires of these crosses
  int wires = 0;       ///< segments of lines in the file, and arms of crosses
  int bodies = 0;      ///< named groups if there are at least two, otherwise parts connected through edges
  std::vector<std::string> body_names;              ///< empty for files without named groups
  std::string only_body;                            ///< the name of all bodies, if there is one named group
  std::vector<std::optional<Colour>> body_colours;  ///< of `body_names` or `only_body`; empty if the file has none
  int open_edges = 0;                               ///< edges with one face
  int non_manifold_edges = 0;                       ///< edges with three or more faces of one body
  int misoriented_edges = 0;                        ///< edges whose two faces have opposite orientations
  int welded_vertices = 0;         ///< vertices merged with another at the same position (STL: across cracks)
  int dropped_degenerate = 0;      ///< faces with fewer than three distinct corners
  int dropped_duplicates = 0;      ///< faces with the same corners as an earlier one
  int non_finite_vertices = 0;     ///< vertices with NaN or infinity; their faces are dropped
  int dropped_non_finite = 0;      ///< faces dropped because of such a vertex
  double weld_distance = 0;        ///< largest distance over which vertices were merged
  bool single_precision = false;   ///< the file stores 32-bit coordinates
  double resolution = 0;           ///< decimal place to which coordinates are rounded, 10^-d; 0: not rounded
  std::vector<std::string> notes;  ///< other facts that a user should know, one sentence each

  /// Facts that do not affect the drawing, one sentence each.
  std::vector<std::string> remarks{};
};

/// Whether more faces collapse than exporters and rounding can explain: details of the model may be lost.
constexpr bool are_many(int collapsed, int faces) { return collapsed > faces / 10; }

struct Mesh {
  Points points;                ///< of the file, including unused ones, followed by those of `cut_vertices`
  std::vector<int> corners;     ///< three vertices per triangle
  std::vector<int> polygon;     ///< triangle -> face number in the file
  std::vector<int> body;        ///< triangle -> body
  UnsetVector<MeshEdge> edges;  ///< sorted by their vertices
  UnsetVector<int> edge_triangles;
  std::vector<CutVertex> cut_vertices;  ///< of a cut mesh, numbered from `first_cut_vertex`
  int first_cut_vertex = 0;
  std::shared_ptr<const Mesh> uncut;  ///< the original of a cut mesh; null otherwise
  MeshReport report;

  [[nodiscard]] std::span<const int> triangles_of(const MeshEdge& edge) const {
    return {edge_triangles.data() + edge.first, static_cast<std::size_t>(edge.count)};
  }
  [[nodiscard]] EdgeOrigin origin_of(const MeshEdge& edge) const;
  /// Returns the edge between two vertices, given with the lower number first; null if there is none.
  [[nodiscard]] const MeshEdge* edge_between(const std::array<int, 2>& ends) const;
  /// Returns the uncut mesh.
  [[nodiscard]] const Mesh& whole() const { return uncut != nullptr ? *uncut : *this; }
  [[nodiscard]] int triangle_count() const { return static_cast<int>(polygon.size()); }
  [[nodiscard]] std::array<int, 3> triangle(int number) const {
    const std::size_t first = 3 * static_cast<std::size_t>(number);
    return {corners[first], corners[first + 1], corners[first + 2]};
  }
  [[nodiscard]] Vec3 point(int vertex) const { return {points[vertex][0], points[vertex][1], points[vertex][2]}; }
};

}  // namespace epura::mesh
