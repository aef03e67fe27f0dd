// SPDX-License-Identifier: Apache-2.0
#include "drawing/symmetry.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/error.hpp"
#include "base/nearest.hpp"
#include "drawing/limits.hpp"
#include "search/lines_at.hpp"

namespace epura::drawing {

double length_without_mirror_image(const ViewDrawing& drawing, int axis, double at, double slack,
                                   const Progress& progress) {
  progress.begin("testing symmetry", drawing.segments.size());
  std::vector<search::LinesAt::Line> visible;
  for (const Segment& segment : drawing.segments)
    if (segment.visible) visible.push_back({segment.from, segment.to});
  if (visible.empty()) return 0;
  const search::LinesAt lines(visible, slack);
  const auto is_on_line = [&](const Vec2& place) {
    return std::ranges::any_of(lines(place), [&](int line) {
      return distance_to_segment(place, visible[line][0], visible[line][1]) <= slack;
    });
  };
  double missing = 0, all = 0;
  for (const Segment& segment : drawing.segments) {
    progress.expect_time();
    if (!segment.visible) continue;
    const double length = glm::distance(segment.from, segment.to);
    const int points = std::max(1, static_cast<int>(std::ceil(length / symmetry_step)));
    all += length;
    for (int i = 0; i < points; ++i) {
      Vec2 image = glm::mix(segment.from, segment.to, (i + 0.5) / points);
      image[axis] = 2 * at - image[axis];
      if (!is_on_line(image)) missing += length / points;
    }
  }
  check(missing <= all * (1 + on_line_part), "no more is missing than there is");
  return missing;
}

}  // namespace epura::drawing
