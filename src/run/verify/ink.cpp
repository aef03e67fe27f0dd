// SPDX-License-Identifier: Apache-2.0
#include "verify/ink.hpp"

#include <algorithm>
#include <atomic>

#include "base/nearest.hpp"
#include "base/parallel.hpp"
#include "drawing/drawing.hpp"
#include "verify/probe_grid.hpp"

namespace epura::verify {

namespace {

constexpr std::size_t grain = 4096;

}  // namespace

std::vector<bool> find_ink(const drawing::ViewDrawing& drawing, const std::vector<Expected>& places, double reach) {
  std::vector<Extent> extents;
  for (const Expected& expected : places) extents.push_back({expected.place, expected.place, 0, 0});
  const ProbeGrid grid(extents);
  std::vector<std::atomic<bool>> found(places.size());
  parallel_for(drawing.segments.size(), grain, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) {
      const drawing::Segment& segment = drawing.segments[i];
      const Extent extent{glm::min(segment.from, segment.to) - reach, glm::max(segment.from, segment.to) + reach, 0, 0};
      grid.overlapping(extent, [&](int place) {
        if (places[place].visible && !segment.visible) return;
        if (distance_to_segment(places[place].place, segment.from, segment.to) <= reach)
          found[place].store(true, std::memory_order_relaxed);
      });
    }
  });
  return {found.begin(), found.end()};
}

}  // namespace epura::verify
