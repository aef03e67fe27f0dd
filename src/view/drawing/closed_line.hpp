// SPDX-License-Identifier: Apache-2.0
// A closed polyline, and what lies inside it by the even-odd rule. Lengths in mm on paper.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "base/vec.hpp"

namespace epura::drawing {

/// A polyline whose last corner is joined to the first.
class ClosedLine {
 public:
  /// Needs three corners that do not lie on one line.
  explicit ClosedLine(std::vector<Vec2> corners);

  [[nodiscard]] const std::vector<Vec2>& corners() const { return corners_; }
  [[nodiscard]] const Vec2& min() const { return min_; }
  [[nodiscard]] const Vec2& max() const { return max_; }
  [[nodiscard]] bool contains(const Vec2& p) const;

  /// A side of the line that a given line crosses: its number, the parameters of the point on both, and the point.
  struct Crossing {
    double t;
    int side;
    double s;
    Vec2 at;
  };
  /// Ascending along the given line.
  [[nodiscard]] std::vector<Crossing> crossings(const Vec2& from, const Vec2& to) const;

  /// Whether an end of a given line lies on a side, or a corner on the line, up to rounding: then crossings may
  /// contradict each other.
  [[nodiscard]] bool touches(const Vec2& from, const Vec2& to) const;

  /// Returns the parts of a straight line inside or outside, as parameters in ascending order from 0 to 1.
  [[nodiscard]] std::vector<std::array<double, 2>> parts(const Vec2& from, const Vec2& to, bool inside) const;

  /// Returns the part of an area (even-odd rule) that is inside. Where corners lie on sides, the line is displaced by
  /// less than 1e-7 mm.
  [[nodiscard]] std::vector<std::vector<Vec2>> area(const std::vector<std::vector<Vec2>>& rings) const;

  using Triangles = std::span<const std::array<Vec2, 3>>;
  /// Returns the parts of the line that some triangles cover and others do not, as polylines. If that is all of it, the
  /// first point is repeated.
  [[nodiscard]] std::vector<std::vector<Vec2>> covered(Triangles by, Triangles not_by = {}) const;

 private:
  using Intervals = std::vector<std::array<double, 2>>;
  [[nodiscard]] std::vector<Intervals> covered_parts(Triangles triangles) const;
  [[nodiscard]] std::array<Vec2, 2> side(std::size_t i) const {
    return {corners_[i], corners_[i + 1 < corners_.size() ? i + 1 : 0]};
  }
  [[nodiscard]] std::size_t row(double y) const;
  /// Calls visit(number) for the sides that may lie between two heights, in ascending order of numbers, each once.
  template <class Visit>
  void visit_between(double low, double high, const Visit& visit) const;

  std::vector<Vec2> corners_;
  Vec2 min_, max_;
  std::vector<std::vector<int>> rows_;  ///< sides by strips of the same height
};

/// Whether two lines cross, or one is inside the other.
bool overlap(const ClosedLine& a, const ClosedLine& b);

}  // namespace epura::drawing
