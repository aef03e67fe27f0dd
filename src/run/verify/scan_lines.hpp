// SPDX-License-Identifier: Apache-2.0
// Lines across the page, and the triangles and ink that they may cut.
//
// For lines with random direction and position, the number of cuts measures length (Cauchy; Crofton 1868): with K
// evenly spread directions, parallel lines at distance d in each direction, and N cuts, the length is pi d N / (2 K).
#pragma once

#include <span>
#include <utility>
#include <vector>

#include "verify/scan_scene.hpp"

namespace epura::verify {

/// Points of the page in order: two for a line, three for a triangle.
using PageShape = std::span<const Vec2>;

/// The part of the page that is examined, mm from ScanScene::origin.
struct ScanWindow {
  Vec2 min{HUGE_VAL}, max{-HUGE_VAL};

  [[nodiscard]] bool contains(const Vec2& place) const {
    return place.x >= min.x && place.x <= max.x && place.y >= min.y && place.y <= max.y;
  }
  void add(const Vec2& place) {
    min = glm::min(min, place);
    max = glm::max(max, place);
  }
};

/// Parallel lines over a box: one at a random position in each strip of width `distance`.
class LineBundle {
 public:
  /// `direction` in radians; `seed` determines the positions of the lines in their strips.
  LineBundle(const ScanWindow& box, double direction, double distance, unsigned seed);

  [[nodiscard]] const std::vector<ScanLine>& lines() const { return lines_; }

  /// Calls `meet(line)` for the lines that pass through a shape.
  template <class Meet>
  void through(PageShape shape, const Meet& meet) const {
    double min = HUGE_VAL, max = -HUGE_VAL;
    for (const Vec2& point : shape) {
      const double offset = glm::dot(across_, point);
      min = std::min(min, offset);
      max = std::max(max, offset);
    }
    for (std::size_t i = strip_of(min); i < lines_.size() && offset_[i] <= max; ++i)
      if (offset_[i] >= min) meet(static_cast<int>(i));
  }

 private:
  [[nodiscard]] std::size_t strip_of(double offset) const {
    const double strip = (offset - first_) / distance_;
    return strip > 0 ? static_cast<std::size_t>(std::min(strip, static_cast<double>(lines_.size()))) : 0;
  }

  Vec2 across_;
  double first_, distance_;
  std::vector<double> offset_;
  std::vector<ScanLine> lines_;
};

/// Things grouped by the lines that may meet them: those of line i are items[first[i]] to items[first[i + 1]],
/// ascending.
struct ItemsOfLines {
  std::vector<int> first, items;

  /// `pairs` consist of a line and an item.
  ItemsOfLines(std::size_t lines, const std::vector<std::vector<std::pair<int, int>>>& pairs);

  [[nodiscard]] std::span<const int> of(std::size_t line) const {
    return {items.data() + first[line], static_cast<std::size_t>(first[line + 1] - first[line])};
  }
};

}  // namespace epura::verify
