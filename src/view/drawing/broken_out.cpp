// SPDX-License-Identifier: Apache-2.0
#include "drawing/broken_out.hpp"

#include <utility>
#include <vector>

#include "drawing/chains.hpp"
#include "drawing/clip_drawing.hpp"
#include "mesh/even_odd.hpp"

namespace epura::drawing {

namespace {

// What triangles have inside a line, again as triangles.
std::vector<PaperTriangle> inside(const ClosedLine& line, const std::vector<PaperTriangle>& triangles) {
  std::vector<PaperTriangle> found;
  for (const PaperTriangle& triangle : triangles) {
    mesh::Outlines outlines;
    for (const std::vector<Vec2>& ring : line.area({{triangle.begin(), triangle.end()}})) {
      const auto first = static_cast<int>(outlines.places.size()), count = static_cast<int>(ring.size());
      for (int i = 0; i < count; ++i) outlines.segments.push_back({first + i, first + (i + 1) % count});
      outlines.places.insert(outlines.places.end(), ring.begin(), ring.end());
    }
    for (const std::array<int, 3>& t : mesh::fill_even_odd(outlines))
      found.push_back({outlines.places[t[0]], outlines.places[t[1]], outlines.places[t[2]]});
  }
  return found;
}

}  // namespace

void break_out(ViewDrawing& drawing, ViewDrawing section, const ClosedLine& line,
               std::span<const PaperTriangle> removed, const Progress& progress) {
  progress.begin("breaking out", drawing.segments.size() + section.segments.size());
  std::erase_if(section.segments, [](const Segment& segment) { return !segment.visible; });
  clip_to(section, line);
  clip_lines_outside(drawing, line);
  progress.expect_time();
  drawing.cuts.broken_out.push_back({line.corners(), line.covered(removed, section.cuts.before)});
  section.cuts.before = inside(line, section.cuts.before);
  append_part(drawing, std::move(section));
  chain_lines(drawing, progress);
}

}  // namespace epura::drawing
