// SPDX-License-Identifier: Apache-2.0
// A model as read and repaired: its triangles and their edge table.
//
// Files contain soups, fans and flipped faces, whereas a half-edge structure needs consistently oriented two-manifolds.
// Decisions about edges therefore use the table of undirected edges with all their triangles; mesh/openmesh.hpp builds
// half-edges for algorithms that walk them.
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

/// What a cutting plane has to do with an edge.
enum class CutEdge : std::uint8_t {
  none,
  outline,  ///< of a cut face, or of the cut through an open surface
  inside    ///< divides a cut face, or what a cut left of a triangle: no line
};

/// An undirected edge between two vertices of the file, vertex[0] < vertex[1].
struct MeshEdge {
  std::array<int, 2> vertex;
  int first;      ///< where its triangles begin in Mesh::edge_triangles
  int count;      ///< how many triangles share it; none: it is a piece of a wire only
  bool diagonal;  ///< runs inside a polygon of the file: a line only where it is a contour
  CutEdge cut;
  bool wire;  ///< the file has a line here, whatever faces there are
};

/// A vertex that a cutting plane made.
struct CutVertex {
  std::array<int, 2> edge;  ///< of the file, on which it lies, lower vertex first; {-1, -1} inside a cut face
  double t;                 ///< where on it, between 0 and 1
};

/// The edge of the file that an edge is, or is a part of.
struct EdgeOrigin {
  std::array<int, 2> vertex;  ///< of the file's edge; of the edge itself where only the cutting plane made it
  std::array<double, 2> t;    ///< of its ends along that
  bool in_file;
};

/// What was found in the file and what was done about it.
struct MeshReport {
  std::string name;                     ///< the file
  std::string format;                   ///< "obj", "stl", "ply", "off"
  int vertices = 0;                     ///< of the file (STL: after welding)
  int faces = 0;                        ///< polygons of the file that are drawn
  int triangles = 0;                    ///< after triangulation
  int wires = 0;                        ///< straight pieces of lines that bound no face
  int bodies = 0;                       ///< named groups if there are two, otherwise parts connected through edges
  std::vector<std::string> body_names;  ///< empty for files without named groups
  int open_edges = 0;                   ///< edges with one face
  int non_manifold_edges = 0;           ///< edges with three or more faces of one body
  int misoriented_edges = 0;            ///< edges whose two faces run the same way round
  int welded_vertices = 0;              ///< vertices joined to another at the same place (STL: across cracks)
  int dropped_degenerate = 0;           ///< faces with fewer than three distinct corners
  int dropped_duplicates = 0;           ///< faces with the same corners as an earlier one
  int non_finite_vertices = 0;          ///< vertices with NaN or infinity; their faces are dropped
  int dropped_non_finite = 0;           ///< faces dropped for such a vertex
  double weld_distance = 0;             ///< largest distance over which corners were joined
  bool single_precision = false;        ///< the file stores 32-bit coordinates
  double resolution = 0;                ///< place to which the file's coordinates are rounded, 10^-d; 0: all digits
  std::vector<std::string> notes;       ///< what else a user should know, a sentence each

  /// What changes no drawing, a sentence each.
  std::vector<std::string> remarks{};
};

/// Whether more faces collapse than exporters and rounding account for: details of the model may be lost.
constexpr bool are_many(int collapsed, int faces) { return collapsed > faces / 10; }

struct Mesh {
  Points points;                ///< of the file, whether faces use them or not; behind them those of `cut_vertices`
  std::vector<int> corners;     ///< three vertices a triangle
  std::vector<int> polygon;     ///< triangle -> face number of the file
  std::vector<int> body;        ///< triangle -> body
  UnsetVector<MeshEdge> edges;  ///< sorted by their vertices
  UnsetVector<int> edge_triangles;
  std::vector<CutVertex> cut_vertices;  ///< of a mesh that was cut; they are numbered from `first_cut_vertex` on
  int first_cut_vertex = 0;
  std::shared_ptr<const Mesh> uncut;  ///< what a mesh that was cut is a part of; null for others
  MeshReport report;

  [[nodiscard]] std::span<const int> triangles_of(const MeshEdge& edge) const {
    return {edge_triangles.data() + edge.first, static_cast<std::size_t>(edge.count)};
  }
  [[nodiscard]] EdgeOrigin origin_of(const MeshEdge& edge) const;
  /// The edge between two vertices, the lower number first; null where there is none.
  [[nodiscard]] const MeshEdge* edge_between(const std::array<int, 2>& ends) const;
  /// Itself, or what it is a part of.
  [[nodiscard]] const Mesh& whole() const { return uncut != nullptr ? *uncut : *this; }
  [[nodiscard]] int triangle_count() const { return static_cast<int>(polygon.size()); }
  [[nodiscard]] std::array<int, 3> triangle(int number) const {
    const std::size_t first = 3 * static_cast<std::size_t>(number);
    return {corners[first], corners[first + 1], corners[first + 2]};
  }
  [[nodiscard]] Vec3 point(int vertex) const { return {points[vertex][0], points[vertex][1], points[vertex][2]}; }
};

}  // namespace epura::mesh
