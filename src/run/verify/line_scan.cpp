// SPDX-License-Identifier: Apache-2.0
#include "verify/line_scan.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <tuple>

#include "base/parallel.hpp"
#include "drawing/drawing.hpp"
#include "verify/probe_grid.hpp"

namespace epura::verify {

namespace {

constexpr std::size_t chunk = 4096;
// Sine of the angle between ink and line above which the position of their crossing is known well enough.
constexpr double min_sine = 0.05;

bool lies_on_both_sides(const ScanLine& line, PageShape shape) {
  double min = HUGE_VAL, max = -HUGE_VAL;
  for (const Vec2& point : shape) {
    const double aside = cross(line.along, point - line.middle);
    min = std::min(min, aside);
    max = std::max(max, aside);
  }
  return min <= 0 && max >= 0;
}

struct Cut {
  double u;
  double sine;
  int segment;
};

std::optional<Cut> cut_of(const ScanLine& line, const std::array<Vec2, 2>& ends, int segment) {
  const Vec2 way = ends[1] - ends[0];
  const double from = cross(line.along, ends[0] - line.middle), to = cross(line.along, ends[1] - line.middle);
  if ((from >= 0) == (to >= 0)) return std::nullopt;
  const double u = glm::dot(line.along, ends[0] + from / (from - to) * way - line.middle);
  return Cut{u, std::abs(cross(line.along, way)) / glm::length(way), segment};
}

}  // namespace

LineScan::LineScan(const VerifyInput& input, const ScanScene& scene, const FoldRule& rule, const MarkLimits& limits,
                   const ScanWindow& window)
    : input_(input), scene_(scene), rule_(rule), limits_(limits), window_(window) {}

std::array<Vec2, 2> LineScan::segment(int number) const {
  const drawing::Segment& segment = input_.drawing.segments[number];
  return {segment.from - scene_.origin, segment.to - scene_.origin};
}

double LineScan::length_of_ink() const {
  double length = 0;
  for (const drawing::Segment& segment : input_.drawing.segments)
    if (segment.visible) length += glm::distance(segment.from, segment.to);
  return length;
}

// Finds the area that a triangle may occupy on the page: all of it if a part of the triangle lies behind the viewer.
// Returns false if it lies entirely behind the viewer.
bool LineScan::shape_of(int triangle, std::array<Vec2, 3>& shape) const {
  const auto& corner = scene_.world.triangles[triangle];
  std::size_t before = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    if (!scene_.is_before_viewer(corner[i])) continue;
    shape[i] = scene_.position(corner[i]);
    ++before;
  }
  if (before > 0 && before < 3) shape = {Vec2(-1e300), Vec2(1e300), Vec2(-1e300, 1e300)};
  return before > 0;
}

double LineScan::perimeter_of_triangles(double max) const {
  double sum = 0;
  std::array<Vec2, 3> p;
  for (std::size_t t = 0; t < scene_.world.triangles.size(); ++t)
    if (shape_of(static_cast<int>(t), p))
      sum += std::min(max, glm::distance(p[0], p[1]) + glm::distance(p[1], p[2]) + glm::distance(p[2], p[0]));
  return sum;
}

// Returns the mesh edge that a segment shows, as vertices of the world; {-1, -1} if it shows none.
std::array<int, 2> LineScan::edge_of(int segment) const {
  const drawing::Segment& s = input_.drawing.segments[segment];
  if (s.edge[0] < 0) return {-1, -1};
  const int first = scene_.world.first_vertex[s.model];
  return {first + s.edge[0], first + s.edge[1]};
}

LineFindings LineScan::judge(const ScanLine& line, const MetByLine& met, std::span<const int> segments) const {
  const LineMarks marks(scene_, rule_, line, limits_, met);
  LineFindings findings;
  const auto keep = [&](const std::vector<LineMark>& found, std::vector<AskedLine>& list) {
    for (const LineMark& mark : found) {
      const Vec2 place = line.position(mark.u);
      if (std::abs(mark.u) <= line.reach && window_.contains(place)) list.push_back({place, mark});
    }
  };
  keep(marks.asked(), findings.asked);
  keep(marks.jumps(), findings.jumps);
  std::vector<Cut> cuts;
  for (const int segment : segments) {
    if (scene_.is_hidden_by_facets(edge_of(segment))) continue;
    const auto cut = cut_of(line, this->segment(segment), segment);
    if (cut && std::abs(cut->u) <= line.reach && cut->sine >= min_sine && window_.contains(line.position(cut->u)))
      cuts.push_back(*cut);
  }
  std::ranges::sort(cuts,
                    [](const Cut& a, const Cut& b) { return std::tie(a.u, a.segment) < std::tie(b.u, b.segment); });
  for (const Cut& cut : cuts) {
    const EdgeKind kind = input_.drawing.segments[cut.segment].kind;
    const bool allowed = marks.allows(kind, cut.u, 2 * limits_.reach / cut.sine);
    findings.ink.push_back(
        {cut.u, line.position(cut.u), cut.segment, allowed ? InkVerdict::right : InkVerdict::unfounded});
  }
  find_doubled(marks, findings.ink);
  return findings;
}

// Of several crossings for one line, the correct one is kept; of several correct ones, the first.
void LineScan::find_doubled(const LineMarks& marks, std::vector<InkCrossing>& ink) const {
  const auto rank = [](const InkCrossing& one) { return std::tuple(one.verdict, one.segment); };
  const auto settle = [&](InkCrossing& one, InkCrossing& two) {
    (rank(one) < rank(two) ? two : one).verdict = InkVerdict::doubled;
  };
  // A line crosses a straight edge once.
  std::map<std::array<int, 4>, std::size_t> first;
  for (std::size_t i = 0; i < ink.size(); ++i) {
    const drawing::Segment& segment = input_.drawing.segments[ink[i].segment];
    const auto [known, is_new] =
        first.try_emplace({segment.model, segment.edge[0], segment.edge[1], segment.crossing}, i);
    if (is_new) continue;
    settle(ink[known->second], ink[i]);
    if (ink[i].verdict != InkVerdict::doubled) known->second = i;
  }
  const double near = 2 * limits_.reach;
  for (std::size_t i = 0; i < ink.size(); ++i)
    for (std::size_t j = i; j-- > 0 && ink[i].u - ink[j].u <= near;)
      if (ink[i].verdict == InkVerdict::right && ink[j].verdict == InkVerdict::right &&
          marks.same_line(edge_of(ink[j].segment), edge_of(ink[i].segment), ink[i].u, near))
        settle(ink[i], ink[j]);
}

// Calls `through(shape, meet)` for all triangles and segments, and `judge(line, met, segments)` for the lines that they
// meet.
template <class Through, class Judge>
auto LineScan::scan(const std::vector<ScanLine>& lines, const Through& through, const Judge& judge,
                    const Progress& progress) const {
  const auto gather = [&](std::size_t count, const auto& visit) {
    std::vector<std::vector<std::pair<int, int>>> pairs((count + chunk - 1) / chunk);
    parallel_for(pairs.size(), 1, progress, [&](std::size_t first, std::size_t last) {
      for (std::size_t part = first; part < last; ++part)
        for (std::size_t i = part * chunk; i < std::min((part + 1) * chunk, count); ++i)
          visit(static_cast<int>(i), [&](int line) { pairs[part].emplace_back(line, static_cast<int>(i)); });
    });
    return ItemsOfLines(lines.size(), pairs);
  };
  const ItemsOfLines triangles = gather(scene_.world.triangles.size(), [&](int triangle, const auto& meet) {
    std::array<Vec2, 3> shape;
    if (shape_of(triangle, shape)) through(shape, meet);
  });
  const ItemsOfLines wires = gather(scene_.world.wires.size(), [&](int number, const auto& meet) {
    if (const auto shape = scene_.line_of(scene_.world.wires[static_cast<std::size_t>(number)])) through(*shape, meet);
  });
  const ItemsOfLines segments = gather(input_.drawing.segments.size(), [&](int number, const auto& meet) {
    const drawing::Segment& ink = input_.drawing.segments[number];
    if (ink.visible && !drawing::is_link(ink)) through(segment(number), meet);
  });
  std::vector<decltype(judge(lines[0], MetByLine{}, segments.of(0)))> findings(lines.size());
  parallel_for(lines.size(), 1, progress, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i)
      findings[i] = judge(lines[i], MetByLine{triangles.of(i), wires.of(i)}, segments.of(i));
  });
  return findings;
}

template <class Judge>
auto LineScan::scan_short(const std::vector<ScanLine>& lines, const Judge& judge, const Progress& progress) const {
  std::vector<Extent> extents;
  for (const ScanLine& line : lines) {
    const Vec2 half = line.reach * glm::abs(line.along);
    extents.push_back({line.middle - half, line.middle + half, 0, 0});
  }
  const ProbeGrid grid(extents);
  return scan(
      lines,
      [&](PageShape shape, const auto& meet) {
        Extent extent{Vec2(HUGE_VAL), Vec2(-HUGE_VAL), 0, 0};
        for (const Vec2& point : shape) {
          extent.min = glm::min(extent.min, point);
          extent.max = glm::max(extent.max, point);
        }
        grid.overlapping(extent, [&](int line) {
          if (lies_on_both_sides(lines[line], shape)) meet(line);
        });
      },
      judge, progress);
}

std::vector<LineFindings> LineScan::along(const LineBundle& bundle, const Progress& progress) const {
  return scan(
      bundle.lines(), [&](PageShape shape, const auto& meet) { bundle.through(shape, meet); },
      [&](const auto&... met) { return judge(met...); }, progress);
}

std::vector<LineFindings> LineScan::along(const std::vector<ScanLine>& lines, const Progress& progress) const {
  return scan_short(
      lines, [&](const auto&... met) { return judge(met...); }, progress);
}

std::vector<Around> LineScan::around(const std::vector<ScanLine>& lines, double reach, const Progress& progress) const {
  return scan_short(
      lines,
      [&](const ScanLine& line, const MetByLine& met, std::span<const int>) {
        return LineMarks(scene_, rule_, line, limits_, met).around(0, reach);
      },
      progress);
}

}  // namespace epura::verify
