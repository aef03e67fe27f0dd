// SPDX-License-Identifier: Apache-2.0
// Sorts probes by their position on the page, to find those that a triangle may cover.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "verify/sight.hpp"

namespace epura::verify {

/// Bounds of the position of something in the view: a box of the page, and the least and greatest depth.
struct Extent {
  Vec2 min{HUGE_VAL}, max{-HUGE_VAL};
  double back = HUGE_VAL, front = -HUGE_VAL;
};

/// One frame for all probes and triangles: page and depth as seen from a point of reference.
class PageFrame {
 public:
  /// Every extent is widened by `margin` mm.
  PageFrame(Sight<Bounded> sight, double margin) : sight_(std::move(sight)), margin_(margin) {}

  [[nodiscard]] Extent extent_of(const Triple<Bounded>& point) const;
  /// Ignores what lies behind the centre of projection; returns nothing if all of it does.
  [[nodiscard]] std::optional<Extent> extent_of(const std::array<Vec3, 3>& corners) const;
  /// The middle of the box of a point, mm from the point of reference.
  [[nodiscard]] Vec2 to_page(const Triple<Bounded>& point) const;

 private:
  void add(Extent& extent, const Triple<double>& local, double error) const;

  Sight<Bounded> sight_;
  double margin_;
};

class ProbeGrid {
 public:
  explicit ProbeGrid(std::vector<Extent> probes);

  /// Calls `meet(probe)` once for each probe whose box overlaps the extent and that does not lie entirely in front of
  /// it.
  template <class Meet>
  void overlapping(const Extent& extent, const Meet& meet) const {
    if (!overlap(extent, box_)) return;
    const std::array<int, 2> from = cell_of(extent.min - reach_), to = cell_of(extent.max + reach_);
    for (int y = from[1]; y <= to[1]; ++y)
      for (int i = first_[y * side_ + from[0]]; i < first_[y * side_ + to[0] + 1]; ++i)
        if (overlap(extent, probes_[order_[i]])) meet(order_[i]);
  }

 private:
  static bool overlap(const Extent& a, const Extent& probe) {
    return a.min.x <= probe.max.x && probe.min.x <= a.max.x && a.min.y <= probe.max.y && probe.min.y <= a.max.y &&
           a.front >= probe.back;
  }
  [[nodiscard]] std::array<int, 2> cell_of(const Vec2& place) const;

  std::vector<Extent> probes_;
  Extent box_;        ///< of the probes
  double reach_ = 0;  ///< half the side of the largest box: probes are sorted by the middles of their boxes
  int side_;
  std::vector<int> first_, order_;
};

}  // namespace epura::verify
