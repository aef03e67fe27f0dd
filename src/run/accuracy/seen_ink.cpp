// SPDX-License-Identifier: Apache-2.0
#include "accuracy/seen_ink.hpp"

#include <algorithm>
#include <array>

#include "base/nearest.hpp"
#include "drawing/limits.hpp"

namespace epura::accuracy {

SeenInk::SeenInk(const ViewToJudge& judged) : JudgedView(judged) {
  for (std::size_t e = 0; e < judged.edges.edges.size(); ++e) {
    const edges::FeatureEdge& edge = judged.edges.edges[e];
    std::array<Vec2, 2> ends{};
    for (std::size_t end = 0; end < 2; ++end)
      ends[end] = place_of(edge.shown[end] >= 0 ? edge.shown[end] : edge.vertex[end]);
    judged.hidden.visit_parts(e, [&](double from, double to, bool visible) {
      if (visible) parts_.push_back({e, ends[0] + from * (ends[1] - ends[0]), ends[0] + to * (ends[1] - ends[0])});
    });
  }
  tree_ = search::BoundsTree<2>(parts_.size(), [&](std::size_t i) {
    const auto [left, right] = std::minmax(parts_[i].from.x, parts_[i].to.x);
    const auto [low, high] = std::minmax(parts_[i].from.y, parts_[i].to.y);
    return search::Bounds<2>{{{left, right}, {low, high}}};
  });
}

// A distance changes by no more than the way. A stretch of the line is halved as long as it may have a farther place,
// and the bound would be more than a third too large.
double SeenInk::farthest_from_others(const LineFrom& line, double known) const {
  struct Stretch {
    double middle, half;  // from the vertex, in lengths of the line
  };
  const Vec2 end = place_of(line.vertex);
  const double length = glm::length(line.along);
  double largest = std::max(known, drawing::on_line_mm);
  std::vector<Stretch> left{{0, 1}};
  while (!left.empty() && largest < length) {
    const auto [middle, half] = left.back();
    left.pop_back();
    const double least = to_others(end + middle * line.along, line), way = half * length;
    if (!(least + way > largest)) continue;
    if (way <= std::max(least, largest) / 4) {
      largest = std::min(length, least + way);
      continue;
    }
    left.push_back({middle - half / 2, half / 2});
    left.push_back({middle + half / 2, half / 2});
  }
  return std::max(known, std::min(largest, length));
}

// At most the line's length.
double SeenInk::to_others(const Vec2& place, const LineFrom& line) const {
  double least = glm::length(line.along);
  search::Bounds<2> wanted{};
  const auto narrow = [&] { wanted = {{{place.x - least, place.x + least}, {place.y - least, place.y + least}}}; };
  narrow();
  tree_.visit_where([&](const search::Bounds<2>& bounds) { return search::meet<2>(bounds, wanted); },
                    [&](std::size_t i) {
                      const std::array<int, 2>& ends = judged_.edges.edges[parts_[i].edge].vertex;
                      if (ends[0] == line.vertex || ends[1] == line.vertex) return true;
                      const double distance = distance_to_segment(place, parts_[i].from, parts_[i].to);
                      if (distance < least) {
                        least = distance;
                        narrow();
                      }
                      return true;
                    });
  return least;
}

}  // namespace epura::accuracy
