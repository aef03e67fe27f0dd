// SPDX-License-Identifier: Apache-2.0
#include "drawing/clip_drawing.hpp"

#include <utility>
#include <vector>

#include "drawing/chains.hpp"
#include "drawing/make_drawing.hpp"

namespace epura::drawing {

namespace {

// Pieces shorter than this are rounding errors at the boundary.
constexpr double least_mm = 1e-9;

// A parallel view keeps ratios: the same parameters apply on paper, along the edge and in the world.
template <class Point>
std::array<Point, 2> part_of(const Point& from, const Point& to, const std::array<double, 2>& part) {
  const auto at = [&](double s) { return s == 0 ? from : s == 1 ? to : from + s * (to - from); };
  return {at(part[0]), at(part[1])};
}

void clip_segments(ViewDrawing& drawing, const Boundary& boundary) {
  std::vector<Segment> segments;
  std::vector<CrossingSegment> crossings;
  for (Segment segment : drawing.segments) {
    const auto part = part_inside(boundary, segment.from, segment.to);
    if (!part || ((*part)[1] - (*part)[0]) * glm::distance(segment.from, segment.to) < least_mm) continue;
    const auto [from, to] = part_of(segment.from, segment.to, *part);
    segment.from = from;
    segment.to = to;
    if (!is_link(segment)) segment.t = part_of(segment.t[0], segment.t[1], *part);
    if (segment.crossing >= 0) {
      CrossingSegment crossing = drawing.crossings[static_cast<std::size_t>(segment.crossing)];
      crossing.world = part_of(crossing.world[0], crossing.world[1], *part);
      segment.crossing = static_cast<int>(crossings.size());
      crossings.push_back(crossing);
    }
    segments.push_back(segment);
  }
  drawing.segments = std::move(segments);
  drawing.crossings = std::move(crossings);
}

}  // namespace

void clip_to(ViewDrawing& drawing, const Boundary& boundary) {
  clip_segments(drawing, boundary);
  for (CutFace& face : drawing.cut_faces) face.rings = area_inside(boundary, face.rings);
  std::erase_if(drawing.cut_faces, [](const CutFace& face) { return face.rings.empty(); });
}

void clip_drawing(ViewDrawing& drawing, const DetailFrame& detail, const Progress& progress) {
  const Boundary& boundary = detail.boundary;
  progress.begin("clipping the detail", drawing.segments.size());
  clip_to(drawing, boundary);
  drawing.chains = chain_segments(drawing.segments, straight_mm, drawing.coincident, progress);
  drawing.min = boundary.centre - boundary.half;
  drawing.max = boundary.centre + boundary.half;
  drawing.detail = detail;
}

}  // namespace epura::drawing
