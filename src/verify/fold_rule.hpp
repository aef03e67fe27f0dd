// SPDX-License-Identifier: Apache-2.0
// Whether the shape of a mesh edge in space requires a line, and how certain that is.
//
// Written independently from the definition of the kinds, with margins: it uses nothing of the stage that chose the
// edges, except the recognised faces of the part. A needle, a triangle lower than the precision of the coordinates, has
// no plane: callers must skip it (line_marks.hpp).
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "edges/find_edges.hpp"
#include "scene/scene.hpp"

namespace epura::verify {

/// Whether a line belongs to a place.
enum class Need {
  none,      ///< one would be wrong
  possible,  ///< too close to a limit, or a matter of taste
  asked      ///< it must be there
};

class FoldRule {
 public:
  /// `small` is the height of triangles that can hardly be seen, as a length of the world.
  FoldRule(const scene::World& world, const edges::EdgeOptions& options, double small);

  /// The triangles of one body that meet in an edge.
  struct Sheets {
    const mesh::MeshEdge* edge = nullptr;  ///< null: the mesh has no such edge
    int model = -1;
    std::vector<std::vector<int>> bodies;
  };
  [[nodiscard]] Sheets sheets_at(const std::array<int, 2>& edge) const;

  /// Two triangles on either side of an edge that meet there, or would but for needles between them.
  [[nodiscard]] Need fold(const std::array<int, 2>& edge, int first, int second) const;
  /// Two triangles that cross, with no edge in common.
  [[nodiscard]] Need crossing(int first, int second, double contact) const;
  /// An edge at which a surface ends before what lies behind it.
  [[nodiscard]] Need outline(const std::array<int, 2>& edge) const;

  /// How low triangles are that surely have no plane, that may have none, and that can hardly be seen.
  enum class Needle { surely, perhaps, hardly_seen };
  [[nodiscard]] bool is_needle(int triangle, Needle needle) const;
  /// Over its longest side, as a length of the world.
  [[nodiscard]] double height(int triangle) const { return normalised_height(triangle) / normalisation_; }
  [[nodiscard]] const edges::EdgeOptions& options() const { return options_; }

 private:
  // Brought near 1, so that products of lengths stay in range.
  [[nodiscard]] Vec3 point(int vertex) const { return world_.points[vertex] * normalisation_; }
  [[nodiscard]] double normalised_height(int triangle) const;
  [[nodiscard]] Vec3 area(int triangle) const;
  [[nodiscard]] double fold_angle(const std::array<int, 2>& edge, int first, int second) const;
  [[nodiscard]] double doubt(int triangle) const;
  [[nodiscard]] double bend(int triangle) const;
  [[nodiscard]] double turn(int triangle) const;
  [[nodiscard]] bool same_polygon(int first, int second) const;
  [[nodiscard]] std::optional<Need> between_faces(const std::array<int, 2>& edge, int first, int second) const;

  const scene::World& world_;
  edges::EdgeOptions options_;
  double normalisation_;
  double precision_, small_;  ///< normalised
};

}  // namespace epura::verify
