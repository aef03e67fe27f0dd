// SPDX-License-Identifier: Apache-2.0
#include "drawing/clip_drawing.hpp"

#include <iterator>
#include <utility>
#include <vector>

#include "base/error.hpp"
#include "drawing/chains.hpp"
#include "drawing/limits.hpp"
#include "mesh/even_odd.hpp"

namespace epura::drawing {

namespace {

// A parallel view keeps ratios: the same parameters apply on paper, along the edge and in the world.
template <class Point>
std::array<Point, 2> part_of(const Point& from, const Point& to, const std::array<double, 2>& part) {
  const auto at = [&](double s) { return s == 0 ? from : s == 1 ? to : from + s * (to - from); };
  return {at(part[0]), at(part[1])};
}

using Parts = std::vector<std::array<double, 2>>;

// Keeps the parts of each line that `parts_of` returns, as parameters.
template <class PartsOf>
void clip_segments(ViewDrawing& drawing, const PartsOf& parts_of) {
  std::vector<Segment> segments;
  std::vector<CrossingSegment> crossings;
  for (const Segment& whole : drawing.segments)
    for (const std::array<double, 2>& part : parts_of(whole.from, whole.to)) {
      if ((part[1] - part[0]) * glm::distance(whole.from, whole.to) < rounding_mm) continue;
      check(part[0] >= 0 && part[0] <= part[1] && part[1] <= 1, "what is inside is a part of the line");
      Segment segment = whole;
      const auto [from, to] = part_of(whole.from, whole.to, part);
      segment.from = from;
      segment.to = to;
      if (!is_link(segment)) segment.t = part_of(whole.t[0], whole.t[1], part);
      if (segment.crossing >= 0) {
        CrossingSegment crossing = drawing.crossings[static_cast<std::size_t>(segment.crossing)];
        crossing.world = part_of(crossing.world[0], crossing.world[1], part);
        segment.crossing = static_cast<int>(crossings.size());
        crossings.push_back(crossing);
      }
      segments.push_back(segment);
    }
  drawing.segments = std::move(segments);
  drawing.crossings = std::move(crossings);
}

// What remains of the lines that bound broken-out sections.
template <class PartsOf>
void clip_bounds(BrokenOut& broken_out, const PartsOf& parts_of) {
  std::vector<std::vector<Vec2>> remaining;
  for (const std::vector<Vec2>& line : broken_out.lines) {
    bool goes_on = false;
    for (std::size_t i = 0; i + 1 < line.size(); ++i)
      for (const std::array<double, 2>& part : parts_of(line[i], line[i + 1])) {
        const auto [from, to] = part_of(line[i], line[i + 1], part);
        if (!goes_on || part[0] > 0) remaining.push_back({from});
        remaining.back().push_back(to);
        goes_on = part[1] == 1;
      }
  }
  broken_out.lines = std::move(remaining);
}

template <class Item>
void append(std::vector<Item>& all, std::vector<Item>& more) {
  std::move(more.begin(), more.end(), std::back_inserter(all));
}

void drop_empty_faces(ViewDrawing& drawing) {
  std::erase_if(drawing.cuts.faces, [](const CutFace& face) { return face.rings.empty(); });
}

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

void clip_to(ViewDrawing& drawing, const Boundary& boundary) {
  const auto parts_of = [&](const Vec2& from, const Vec2& to) {
    const auto part = part_inside(boundary, from, to);
    return part ? Parts{*part} : Parts();
  };
  clip_segments(drawing, parts_of);
  for (BrokenOut& broken_out : drawing.cuts.broken_out) clip_bounds(broken_out, parts_of);
  for (CutFace& face : drawing.cuts.faces) face.rings = area_inside(boundary, face.rings);
  drop_empty_faces(drawing);
}

void clip_to(ViewDrawing& drawing, const ClosedLine& line) {
  const auto parts_of = [&](const Vec2& from, const Vec2& to) { return line.parts(from, to, true); };
  clip_segments(drawing, parts_of);
  for (BrokenOut& broken_out : drawing.cuts.broken_out) clip_bounds(broken_out, parts_of);
  for (CutFace& face : drawing.cuts.faces) face.rings = line.area(face.rings);
  drop_empty_faces(drawing);
}

void clip_lines_outside(ViewDrawing& drawing, const ClosedLine& line) {
  clip_segments(drawing, [&](const Vec2& from, const Vec2& to) { return line.parts(from, to, false); });
}

void append_part(ViewDrawing& drawing, ViewDrawing part) {
  const auto crossings = static_cast<int>(drawing.crossings.size());
  for (Segment& segment : part.segments)
    if (segment.crossing >= 0) segment.crossing += crossings;
  append(drawing.segments, part.segments);
  append(drawing.crossings, part.crossings);
  for (const Segment& segment : drawing.segments)
    check(segment.crossing < static_cast<int>(drawing.crossings.size()), "a line has its crossing");
  append(drawing.cuts.faces, part.cuts.faces);
  append(drawing.cuts.before, part.cuts.before);
}

void clip_drawing(ViewDrawing& drawing, const DetailFrame& detail, const Progress& progress) {
  const Boundary& boundary = detail.boundary;
  progress.begin("clipping the detail", drawing.segments.size());
  clip_to(drawing, boundary);
  chain_lines(drawing, progress);
  const Boundary grown{boundary.centre, boundary.half + on_line_mm, false};
  for (const Segment& segment : drawing.segments)
    check(glm::all(glm::lessThanEqual(glm::abs(segment.from - grown.centre), grown.half)) &&
              glm::all(glm::lessThanEqual(glm::abs(segment.to - grown.centre), grown.half)),
          "a detail contains its lines");
  drawing.box.min = boundary.centre - boundary.half;
  drawing.box.max = boundary.centre + boundary.half;
  drawing.shown.detail = detail;
}

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
