// SPDX-License-Identifier: Apache-2.0
// What small changes of its faces can make of a part, in linear terms.
//
// A face moves and turns like a rigid body about its anchor, and changes its sizes; what leaves its surface as it is,
// as sliding a plane in itself, is no unknown. All lengths are relative to the size of the part, angles in radians.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "definition/part.hpp"

namespace epura::definition {

enum class UnknownKind : std::uint8_t { move, turn, radius, minor, angle };

struct Unknown {
  int face;
  UnknownKind kind;
  Vec3 along{0};  ///< unit: direction of a move, axis of a turn
};

struct Term {
  int unknown;
  double factor;
};

/// A sum of unknowns, each of them at most once when it is `tidy`.
using Row = std::vector<Term>;

/// Adds factor · more.
void add(Row& row, const Row& more, double factor = 1);
/// Ascending by unknown, with one term each, without those that cancel to rounding.
Row tidy(Row row);

class Unknowns {
 public:
  Unknowns(const Part& part, const Directions& directions);

  [[nodiscard]] int count() const { return static_cast<int>(all_.size()); }
  [[nodiscard]] const Unknown& operator[](int number) const { return all_[static_cast<std::size_t>(number)]; }
  /// The same of a part whose faces have changed by these values, one for each. Then a row has one more term, whose
  /// unknown is count(): what the change has made of it, not in linear terms but by where the surfaces are.
  [[nodiscard]] Unknowns changed_by(std::vector<double> values) const;
  /// A face as the values have changed it.
  [[nodiscard]] surfaces::PartSurface changed(int face) const;

  /// Those of a face are from first(face) to first(face + 1).
  [[nodiscard]] int first(int face) const { return first_[static_cast<std::size_t>(face)]; }
  /// The point about which a face turns: of a plane, cylinder or cone beside its middle, or its centre.
  [[nodiscard]] const Vec3& anchor(int face) const { return anchors_[static_cast<std::size_t>(face)]; }

  /// How far the surface of a face comes at one of its points along its normal there, or against it.
  [[nodiscard]] Row surface_motion(int face, const Vec3& point, const Vec3& normal) const;
  /// How far a point of the axis, or the centre, goes along a direction; across the axis of a cylinder or cone.
  [[nodiscard]] Row axis_motion(int face, const Vec3& point, const Vec3& along) const;
  /// How far the normal or axis of a face turns about a vector across it, times its length.
  [[nodiscard]] Row turn(int face, const Vec3& about) const;
  /// How much a size grows.
  [[nodiscard]] Row growth(int face, UnknownKind size) const;
  /// How much a plane in which both lie changes the angle between a side of a cone and something fixed: as `turn`, at a
  /// point of its surface.
  [[nodiscard]] Row side_turn(int face, const Vec3& point, const Vec3& about) const;

  /// The value of an unknown as the whole part moves: along x, y, z, and turns about them.
  [[nodiscard]] std::array<double, 6> rigid(int number) const;

 private:
  [[nodiscard]] Row body_motion(int face, const Vec3& point, const Vec3& along) const;
  [[nodiscard]] Vec3 sum_of(int face, UnknownKind kind) const;
  [[nodiscard]] double size_of(int face, UnknownKind kind) const;
  [[nodiscard]] Vec3 turned(int face, const Vec3& direction) const;
  void add_change(Row& row, double change) const;
  [[nodiscard]] Vec3 radial(int face, const Vec3& point) const;
  [[nodiscard]] Vec3 size_motion(const Unknown& unknown, const Vec3& point) const;

  const Part& part_;
  Vec3 centre_{0};
  std::vector<Unknown> all_;
  std::vector<int> first_;
  std::vector<Vec3> anchors_;
  std::vector<double> values_{};  // by unknown; none: as the part is
};

}  // namespace epura::definition
