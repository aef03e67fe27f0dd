// SPDX-License-Identifier: Apache-2.0
// What stands behind a diameter says of faces around its axis: depths, counterbores, countersinks and threads.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "definition/statements.hpp"
#include "sizes/measured_faces.hpp"
#include "sizes/stated_values.hpp"

namespace epura::sheet {

/// It refers to what it is given.
class NotedFaces {
 public:
  NotedFaces(const DrawnPart& drawn, const definition::Unknowns& unknowns, const MeasuredFaces& measured);

  /// The circle of a dimension, of a thread that of its bore, and for "4×" those about other axes: of the same size, or
  /// if there are none, of any; a row of a table is of one axis. Fillets are not equal to holes.
  [[nodiscard]] std::vector<WorldCircle> equal_circles(const AnchoredDimension& dimension, bool is_thread) const;
  /// What a number may mean around a circle: each row is another thing; of depths, the one that is farthest along the
  /// axis of the circle comes first.
  [[nodiscard]] std::vector<definition::Row> rows_of(const NotedNumber& number, const WorldCircle& circle) const;
  /// The circles around which all numbers of a note may mean something, whatever those without a sign are.
  [[nodiscard]] std::vector<WorldCircle> with_all(std::vector<WorldCircle> circles,
                                                  std::span<const NotedNumber> numbers) const;
  /// Whether a cylinder is part of a round: a face goes on from it along a line, as beside a fillet or an end of a
  /// slot.
  [[nodiscard]] bool is_part(int face) const { return are_parts_[static_cast<std::size_t>(face)] != 0; }
  /// Whether the circle of a dimension is that of such a part.
  [[nodiscard]] bool is_of_part(const WorldCircle& circle) const;
  /// A standard thread gives the hole that is drilled for it, whose circle this is.
  [[nodiscard]] std::vector<definition::Row> thread(const WorldCircle& bore) const;

 private:
  [[nodiscard]] const surfaces::PartSurface& surface(int face) const {
    return part_.faces[static_cast<std::size_t>(face)].surface;
  }
  // A depth from one place along an axis to another.
  struct Depth {
    definition::Row row;
    double low, high;
  };

  [[nodiscard]] WorldCircle bore_of(WorldCircle thread) const;
  [[nodiscard]] std::vector<Depth> depths(const WorldCircle& circle, double depth) const;
  void add_depths_below_round_faces(std::vector<Depth>& found, const WorldCircle& circle, double depth) const;
  [[nodiscard]] std::vector<Depth> along_walls(std::vector<Depth> all, const WorldCircle& circle, double radius) const;
  [[nodiscard]] bool reaches(int face, const Vec3& place) const;
  [[nodiscard]] bool is_on_round_face(const Vec3& place, const Vec3& along) const;
  void add_diameters(std::vector<definition::Row>& rows, const WorldCircle& circle, double diameter) const;
  void add_angles(std::vector<definition::Row>& rows, const WorldCircle& circle, const NotedNumber& angle) const;
  [[nodiscard]] bool has_rim(int face, const WorldCircle& circle, double radius) const;

  const definition::Part& part_;
  std::size_t count_;  // of faces of the model
  const definition::Unknowns& unknowns_;
  const MeasuredFaces& measured_;
  double slack_;
  std::vector<char> are_parts_;  // of each face
};

}  // namespace epura::sheet
