// SPDX-License-Identifier: Apache-2.0
// Finds the faces of a part that dimensions measure, by the places at which these are attached.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "definition/statements.hpp"
#include "sheet/notation.hpp"
#include "sizes/drawn_part.hpp"

namespace epura::sheet {

/// It refers to what it is given.
class MeasuredFaces {
 public:
  MeasuredFaces(const DrawnPart& drawn, const definition::Directions& directions, const definition::Unknowns& unknowns,
                const Notation& notation);

  /// The length along a direction between two places: of corners, otherwise of planes, axes and centres that are at the
  /// same place along it, of sides of round faces and of edges. Nothing if faces hold none of these.
  [[nodiscard]] definition::Row length(const Vec3& from, const Vec3& to, const Vec3& along) const;
  /// The same of all edges in line with the places, if there is nothing else at them.
  [[nodiscard]] std::vector<definition::Row> lengths(const Vec3& from, const Vec3& to, const Vec3& along) const;
  /// The diameter of a circle that faces leave where they meet: the end of a cone, the ring of a torus.
  [[nodiscard]] definition::Row rim(const WorldCircle& circle) const;
  /// The circles of this radius on paper in which cones end, each once.
  [[nodiscard]] std::vector<WorldCircle> rims_of_cones(double radius) const;
  /// Where faces about a circle end.
  [[nodiscard]] std::vector<Vec3> rims_around(const WorldCircle& circle) const;
  /// What is drawn for the hexagon that has both faces as its sides; -1 if there is none.
  [[nodiscard]] int hexagon_of(int side, int other) const;
  /// The turn of a face in whose side a leg of an angle lies, seen along a direction, or of which it is the axis; of
  /// the line between two axes if it goes from one to the other.
  [[nodiscard]] definition::Row turn_of_leg(const Vec3& corner, const Vec3& end, const Vec3& sight) const;
  /// The size of a round face that this radius on paper may be.
  [[nodiscard]] definition::Row size(int face, double radius) const;
  /// Whether a face has the axis of a circle, or its centre on it.
  [[nodiscard]] bool is_around(int face, const WorldCircle& circle) const;
  /// A face whose axis goes along a direction through a point; -1 if there is none.
  [[nodiscard]] int axis_through(const Vec3& point, const Vec3& along) const;
  /// A face with this direction; -1 if there is none.
  [[nodiscard]] int face_along(const Vec3& along) const;
  /// Whether two lengths are the same on paper.
  [[nodiscard]] bool are_alike(double a, double b) const;

 private:
  [[nodiscard]] const surfaces::PartSurface& surface(int face) const {
    return part_.faces[static_cast<std::size_t>(face)].surface;
  }
  [[nodiscard]] int all_faces() const { return static_cast<int>(part_.faces.size()); }
  [[nodiscard]] std::optional<definition::End> place_at(const Vec3& point, const Vec3& along) const;
  [[nodiscard]] std::optional<definition::End> crossing_at(const Vec3& point) const;
  [[nodiscard]] std::optional<definition::End> side_at(const Vec3& point, const Vec3& along) const;
  [[nodiscard]] std::optional<definition::End> corner_at(const Vec3& point) const;
  [[nodiscard]] std::vector<definition::End> edges_at(const Vec3& point, const Vec3& along) const;

  const definition::Part& part_;
  const std::vector<definition::Hexagon>& hexagons_;
  const definition::Directions& directions_;
  const definition::Unknowns& unknowns_;
  const Notation& notation_;
  std::vector<Box> reaches_;  // of each contact
  double slack_;
};

}  // namespace epura::sheet
