// SPDX-License-Identifier: Apache-2.0
// A first look at polylines that are taken one after the other: for each piece, when the last earlier line was taken
// that runs along it. If there is none, the ink that stays need not be searched; otherwise no ink that is placed after
// that line.
#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

#include "base/progress.hpp"
#include "drawing/limits.hpp"
#include "drawing/measured_polyline.hpp"
#include "drawing/polylines.hpp"

namespace epura::drawing {

/// When lines count as running along each other; lengths in mm.
struct AlongLimits {
  double distance;  ///< greatest distance between them
  double touching;  ///< they must be within it over more than this length

  /// The length from which lines have a direction of their own.
  [[nodiscard]] double with_direction() const { return with_direction_along * distance; }
};

class NearPrefilter {
 public:
  /// Throws OutOfTime.
  NearPrefilter(const std::vector<Piece>& pieces, const Polylines& polylines, const AlongLimits& limits,
                const Progress& progress);

  /// The number of polylines.
  [[nodiscard]] std::size_t size() const { return closed_.size(); }
  /// Polylines are in order of strength, the strongest first. Pieces are taken in this order, those of a polyline along
  /// it.
  [[nodiscard]] MeasuredPolyline operator[](std::size_t line) const {
    return {*pieces_, std::span(members_).subspan(first(line), first(line + 1) - first(line))};
  }
  [[nodiscard]] bool is_closed(std::size_t line) const { return closed_[line] != 0; }
  /// The polyline whose pieces are taken at this time.
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
