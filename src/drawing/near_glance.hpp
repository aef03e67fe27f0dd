// SPDX-License-Identifier: Apache-2.0
// A first look at polylines that are taken one after the other: when the last line was taken that runs along a piece of
// one. What has none needs no search among the ink that stays, and others can be searched as soon as that one has its
// place.
#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

#include "base/progress.hpp"
#include "drawing/measured_polyline.hpp"
#include "drawing/polylines.hpp"

namespace epura::drawing {

/// When lines run along each other, mm.
struct AlongLimits {
  double distance;  ///< at most so far apart
  double touching;  ///< over more than that

  /// Lines that differ by less have about one direction: facets of rims with eight corners and more do.
  static constexpr double least_cosine = 0.9063;  // 25 degrees
  /// Pieces without a direction of their own, seen in that of the polyline, are no steeper than that.
  static constexpr double steepest = 2;
  /// So long are lines that have a direction of their own.
  [[nodiscard]] double with_direction() const { return 4 * distance; }
};

class NearGlance {
 public:
  /// Throws OutOfTime.
  NearGlance(const std::vector<Piece>& pieces, const Polylines& polylines, const AlongLimits& limits,
             const Progress& progress);

  /// The number of polylines.
  [[nodiscard]] std::size_t size() const { return closed_.size(); }
  /// The strongest first. Pieces are taken in the order of polylines, those of one along it.
  [[nodiscard]] MeasuredPolyline operator[](std::size_t line) const {
    return {*pieces_, std::span(members_).subspan(first(line), first(line + 1) - first(line))};
  }
  [[nodiscard]] bool is_closed(std::size_t line) const { return closed_[line] != 0; }
  /// Whose pieces are taken then.
  [[nodiscard]] std::size_t line_at(std::size_t turn) const {
    return static_cast<std::size_t>(std::upper_bound(first_.begin(), first_.end(), turn) - first_.begin()) - 1;
  }
  /// When the first piece of a polyline is taken.
  [[nodiscard]] std::size_t first(std::size_t line) const { return first_[line]; }

 private:
  struct Seen;

  void measure(const Polylines& polylines, const std::vector<std::size_t>& ranked, const AlongLimits& limits,
               const Progress& progress);
  void find_last_along(const AlongLimits& limits, const Progress& progress);

  const std::vector<Piece>* pieces_;
  std::vector<Member> members_;     ///< in the order in which they are taken
  std::vector<std::size_t> first_;  ///< by polyline, into members_
  std::vector<char> closed_;
};

}  // namespace epura::drawing
