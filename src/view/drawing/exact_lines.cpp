// SPDX-License-Identifier: Apache-2.0
#include "drawing/exact_lines.hpp"

#include <vector>

#include "drawing/curve_part.hpp"
#include "drawing/ends_on_paper.hpp"
#include "drawing/exact_crossings.hpp"
#include "drawing/known_circles.hpp"
#include "drawing/limits.hpp"
#include "drawing/part_edges.hpp"

namespace epura::drawing {

namespace {

void widen_box(ViewDrawing& drawing) {
  for (const Chain& chain : drawing.chains) {
    const auto add = [&](const Vec2& place) {
      drawing.box.min = glm::min(drawing.box.min, place);
      drawing.box.max = glm::max(drawing.box.max, place);
    };
    for (const Vec2& point : chain.points) add(point);
    for (const CurvePart& curve : chain.curves)
      for (const Vec2& place : outermost_places(curve)) add(place);
  }
}

}  // namespace

CurveReport draw_exactly(const world::World& world, ViewDrawing& drawing, CurveLimits limits,
                         const Progress& progress) {
  const PartEdges edges(world);
  const ExactCrossings crossings(edges, drawing);
  std::vector<EndsOnFacets> ends;
  for (Chain& chain : drawing.chains) {
    ends.push_back({chain.points.front(), chain.points.back()});
    limits.exact.push_back(crossings.refine(chain, part_if_exact * limits.tolerance) ? 1 : 0);
  }
  const KnownCircles known = known_circles(edges, drawing);
  const CurveReport found = find_curves(drawing.chains, limits, known, progress);
  move_ends(crossings, ends, limits.tolerance, drawing);
  widen_box(drawing);
  return found;
}

}  // namespace epura::drawing
