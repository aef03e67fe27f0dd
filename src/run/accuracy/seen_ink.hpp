// SPDX-License-Identifier: Apache-2.0
// Visible lines of a view, found by the places that they pass.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

#include "base/nearest.hpp"
#include "base/vec.hpp"
#include "search/bounds_tree.hpp"

namespace epura::accuracy {

/// A straight line on paper, mm.
using PaperLine = std::array<Vec2, 2>;

class SeenInk {
 public:
  explicit SeenInk(std::vector<PaperLine> lines)
      : lines_(std::move(lines)), tree_(lines_.size(), [&](std::size_t i) {
          const Vec2 low = glm::min(lines_[i][0], lines_[i][1]), high = glm::max(lines_[i][0], lines_[i][1]);
          return search::Bounds<2>{{{low.x, high.x}, {low.y, high.y}}};
        }) {}

  /// Returns the distance of a place from the nearest line for which `counts(number)` holds, at most `most`, mm.
  template <class Counts>
  [[nodiscard]] double to_nearest(const Vec2& place, double most, const Counts& counts) const {
    double least = most;
    const auto may_be_nearer = [&](const search::Bounds<2>& box) {
      return box[0][0] <= place.x + least && box[0][1] >= place.x - least && box[1][0] <= place.y + least &&
             box[1][1] >= place.y - least;
    };
    tree_.visit_where(may_be_nearer, [&](std::size_t i) {
      if (counts(i)) least = std::min(least, distance_to_segment(place, lines_[i][0], lines_[i][1]));
      return true;
    });
    return least;
  }

  /// Returns the lines that pass a place within a distance, mm, ascending.
  [[nodiscard]] std::vector<std::size_t> lines_at(const Vec2& place, double within) const {
    std::vector<std::size_t> found;
    tree_.visit({{{place.x - within, place.x + within}, {place.y - within, place.y + within}}}, [&](std::size_t i) {
      if (distance_to_segment(place, lines_[i][0], lines_[i][1]) <= within) found.push_back(i);
      return true;
    });
    return found;
  }

  /// Returns a bound of how far a line is from those for which `counts(number)` holds: at least `known`, at most
  /// `most`, and otherwise at most a third too much. A distance changes by no more than the way: a stretch of the line
  /// is halved as long as it may have a farther place, and the bound would be more than a third too large.
  template <class Counts>
  [[nodiscard]] double farthest_from(const PaperLine& line, double known, double most, const Counts& counts) const {
    struct Stretch {
      double middle, half;  // in lengths of the line
    };
    double largest = known;
    std::vector<Stretch> left{{0.5, 0.5}};
    while (!left.empty() && largest < most) {
      const auto [middle, half] = left.back();
      left.pop_back();
      const double least = to_nearest(line[0] + middle * (line[1] - line[0]), most, counts);
      const double way = half * glm::distance(line[0], line[1]);
      if (!(least + way > largest)) continue;
      if (way <= std::max(least, largest) / 4) {
        largest = std::min(most, least + way);
        continue;
      }
      left.push_back({middle - half / 2, half / 2});
      left.push_back({middle + half / 2, half / 2});
    }
    return largest;
  }

 private:
  std::vector<PaperLine> lines_;
  search::BoundsTree<2> tree_;
};

}  // namespace epura::accuracy
