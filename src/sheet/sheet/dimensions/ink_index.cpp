// SPDX-License-Identifier: Apache-2.0
#include "sheet/dimensions/ink_index.hpp"

#include <algorithm>

#include "drawing/drawing.hpp"

namespace epura::sheet {

namespace {

constexpr double min_cell = 1;  // mm

Rectangle box_of_ink(const drawing::ViewDrawing& drawing) {
  if (drawing.segments.empty()) return {Vec2(0), Vec2(0)};
  Rectangle box{drawing.segments.front().from, drawing.segments.front().from};
  for (const drawing::Segment& segment : drawing.segments)
    box = {glm::min(box.min, glm::min(segment.from, segment.to)),
           glm::max(box.max, glm::max(segment.from, segment.to))};
  return box;
}

}  // namespace

InkIndex::InkIndex(const drawing::ViewDrawing& drawing)
    : drawing_(drawing), cells_(box_of_ink(drawing).min, box_of_ink(drawing).max, min_cell) {
  for (const drawing::Segment& segment : drawing.segments) cells_.add(segment.from, segment.to);
}

// All of a box is within half its width of the line through its middle.
int InkIndex::in(const TurnedBox& box) const {
  const Vec2 half = box.half.x * box.along;
  const std::vector<int> near = cells_.find(box.centre - half, box.centre + half, box.half.y);
  return static_cast<int>(std::count_if(near.begin(), near.end(), [&](int number) {
    const drawing::Segment& segment = drawing_.segments[static_cast<std::size_t>(number)];
    return overlap(box, line_box(segment.from, segment.to));
  }));
}

}  // namespace epura::sheet
