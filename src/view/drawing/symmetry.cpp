// SPDX-License-Identifier: Apache-2.0
#include "drawing/symmetry.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <vector>

#include "drawing/limits.hpp"

namespace epura::drawing {

namespace {

double distance_to(const Segment& segment, const Vec2& p) {
  const Vec2 d = segment.to - segment.from;
  const double length = glm::dot(d, d);
  const double t = length > 0 ? std::clamp(glm::dot(p - segment.from, d) / length, 0.0, 1.0) : 0;
  return glm::distance(p, segment.from + t * d);
}

/// Visible lines by square cells of the paper.
class Lines {
 public:
  Lines(const std::vector<Segment>& segments, double slack) : segments_(segments), slack_(slack) {
    for (std::size_t i = 0; i < segments.size(); ++i)
      if (segments[i].visible) add(i);
  }

  [[nodiscard]] bool are_at(const Vec2& p) const {
    const auto found = cells_.find(cell_of(p));
    return found != cells_.end() && std::any_of(found->second.begin(), found->second.end(),
                                                [&](std::size_t i) { return distance_to(segments_[i], p) <= slack_; });
  }

 private:
  using Cell = std::array<int, 2>;
  static Cell cell_of(const Vec2& p) {
    return {static_cast<int>(std::floor(p.x / symmetry_cell)), static_cast<int>(std::floor(p.y / symmetry_cell))};
  }

  // A piece of a line no longer than a cell lies in few cells.
  void add(std::size_t i) {
    const Vec2 &from = segments_[i].from, &to = segments_[i].to;
    const int pieces = std::max(1, static_cast<int>(std::ceil(glm::distance(from, to) / symmetry_cell)));
    for (int k = 0; k < pieces; ++k) {
      const Vec2 p = glm::mix(from, to, double(k) / pieces), q = glm::mix(from, to, double(k + 1) / pieces);
      const Cell min = cell_of(glm::min(p, q) - slack_), max = cell_of(glm::max(p, q) + slack_);
      for (int x = min[0]; x <= max[0]; ++x)
        for (int y = min[1]; y <= max[1]; ++y) {
          std::vector<std::size_t>& here = cells_[{x, y}];
          if (here.empty() || here.back() != i) here.push_back(i);
        }
    }
  }

  const std::vector<Segment>& segments_;
  double slack_;
  std::map<Cell, std::vector<std::size_t>> cells_;
};

}  // namespace

double length_without_mirror_image(const ViewDrawing& drawing, int axis, double at, double slack,
                                   const Progress& progress) {
  progress.begin("testing symmetry", drawing.segments.size());
  const Lines lines(drawing.segments, slack);
  double missing = 0;
  for (const Segment& segment : drawing.segments) {
    progress.expect_time();
    if (!segment.visible) continue;
    const double length = glm::distance(segment.from, segment.to);
    const int points = std::max(1, static_cast<int>(std::ceil(length / symmetry_step)));
    for (int i = 0; i < points; ++i) {
      Vec2 image = glm::mix(segment.from, segment.to, (i + 0.5) / points);
      image[axis] = 2 * at - image[axis];
      if (!lines.are_at(image)) missing += length / points;
    }
  }
  return missing;
}

}  // namespace epura::drawing
