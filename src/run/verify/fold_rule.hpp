// SPDX-License-Identifier: Apache-2.0
// Decides whether the shape of a mesh edge in space requires a line, and how certain that is.
//
// Written independently from the definition of the kinds, with margins: it uses nothing of the stage that chose the
// edges, except the recognised faces of the part. A needle (a triangle whose height is below the precision of the
// coordinates) has no plane: callers must skip it (line_marks.hpp).
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "edges/find_edges.hpp"
#include "world/world.hpp"

namespace epura::verify {

/// Whether a position needs a line.
enum class Need {
  none,      ///< a line would be wrong
  possible,  ///< too close to a limit, or a matter of taste
  asked      ///< a line is required
};

class FoldRule {
 public:
  /// `small` is the height of triangles that can hardly be seen, as a length in the world.
  FoldRule(const world::World& world, const edges::EdgeOptions& options, double small);

  /// The triangles that meet in an edge, by body.
  struct Sheets {
    const mesh::MeshEdge* edge = nullptr;  ///< null: the mesh has no such edge
    int model = -1;
    std::vector<std::vector<int>> bodies;
  };
  [[nodiscard]] Sheets sheets_at(const std::array<int, 2>& edge) const;

  /// Whether a cut has left only some of the triangles that meet in an edge of the file.
  [[nodiscard]] bool ends_at_cut(const Sheets& sheets) const;

  /// For two triangles on either side of an edge that meet there or are separated by needles only.
  [[nodiscard]] Need fold(const std::array<int, 2>& edge, int first, int second) const;
  /// For two triangles that cross without a common edge.
  [[nodiscard]] Need crossing(int first, int second, double contact) const;
  /// For an edge at which a surface ends in front of what lies behind it.
  [[nodiscard]] Need outline(const std::array<int, 2>& edge) const;

  /// Whether a triangle and those that meet in an edge are all of one face of a part.
  [[nodiscard]] bool are_one_face(const std::array<int, 2>& edge, int triangle) const;

  /// Whether a triangle is of a face of a part that is a torus.
  [[nodiscard]] bool is_of_torus(int triangle) const;

  /// How low a triangle is: certainly without a plane, perhaps without one, or hardly visible.
  enum class Needle { surely, perhaps, hardly_seen };
  [[nodiscard]] bool is_needle(int triangle, Needle needle) const;
  /// Over the longest side, as a length in the world.
  [[nodiscard]] double height(int triangle) const { return normalised_height(triangle) / normalisation_; }
  [[nodiscard]] const edges::EdgeOptions& options() const { return options_; }

 private:
  // Scaled to coordinates near 1, so that products of lengths stay in range.
  [[nodiscard]] Vec3 point(int vertex) const { return world_.points[vertex] * normalisation_; }
  [[nodiscard]] double normalised_height(int triangle) const;
  [[nodiscard]] Vec3 area(int triangle) const;
  [[nodiscard]] double fold_angle(const std::array<int, 2>& edge, int first, int second) const;
  [[nodiscard]] double doubt(int triangle) const;
  [[nodiscard]] double bend(int triangle) const;
  [[nodiscard]] double turn(int triangle) const;
  [[nodiscard]] bool same_polygon(int first, int second) const;
  [[nodiscard]] std::optional<Need> between_faces(const std::array<int, 2>& edge, int first, int second) const;

  const world::World& world_;
  edges::EdgeOptions options_;
  double normalisation_;
  double precision_, small_;  ///< normalised
};

}  // namespace epura::verify
