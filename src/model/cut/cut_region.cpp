// SPDX-License-Identifier: Apache-2.0
#include "cut/cut_region.hpp"

#include <algorithm>
#include <array>
#include <iterator>
#include <utility>

namespace epura::cut {

namespace {

/// Clips the outlines of one body by one border after the other.
class OutlineClip {
 public:
  OutlineClip(GrowingCut cut, double slack) : cut_(cut), slack_(slack) {}

  void clip(std::vector<CutSegment>& segments, std::vector<CutSegment>& drawn, const CutBorder& border) {
    segments = inside(segments, border, false);
    drawn = inside(drawn, border, true);
    close(segments, border);
  }

  [[nodiscard]] std::vector<int>& ends() { return ends_; }

 private:
  // New vertices are those of closing segments and bridges: triangles are split.
  std::vector<CutSegment> inside(const std::vector<CutSegment>& segments, const CutBorder& border, bool with_border) {
    std::vector<CutSegment> kept;
    for (CutSegment segment : segments) {
      const std::array<int, 2> sides{side(segment.vertex[0], border), side(segment.vertex[1], border)};
      if (sides[0] * sides[1] < 0) {
        const int made = vertex_on(segment.vertex, border);
        segment.vertex = {sides[0] < 0 ? segment.vertex[0] : segment.vertex[1], made};
        if (sides[0] > 0) segment.sense = -segment.sense;
      } else if (sides[0] > 0 || sides[1] > 0 || (sides == std::array{0, 0} && !with_border)) {
        continue;
      }
      kept.push_back(segment);
    }
    std::sort(kept.begin(), kept.end());
    return kept;
  }

  void close(std::vector<CutSegment>& segments, const CutBorder& border) {
    if (segments.empty()) return;
    std::vector<int> ends;
    for (const CutSegment& segment : segments) ends.insert(ends.end(), segment.vertex.begin(), segment.vertex.end());
    std::sort(ends.begin(), ends.end());
    std::vector<int> odd;
    for (std::size_t begin = 0, end = 0; begin < ends.size(); begin = end) {
      while (end < ends.size() && ends[end] == ends[begin]) ++end;
      if ((end - begin) % 2 == 1 && side(ends[begin], border) == 0) odd.push_back(ends[begin]);
    }
    if (odd.size() < 2) return ends_.insert(ends_.end(), odd.begin(), odd.end()), void();
    sort_along(odd);
    for (std::size_t i = 0; i + 1 < odd.size(); i += 2) {
      const auto [low, high] = std::minmax(odd[i], odd[i + 1]);
      segments.push_back({segments.front().body, {low, high}});
    }
    if (odd.size() % 2 == 1) ends_.push_back(odd.back());
    std::sort(segments.begin(), segments.end());
  }

  // All are on one line: its direction is the longest distance from one of them.
  void sort_along(std::vector<int>& vertices) const {
    const CutPlaces places = cut_.places();
    const Vec3 start = places[vertices.front()];
    Vec3 along(0);
    for (const int v : vertices)
      if (glm::length(places[v] - start) > glm::length(along)) along = places[v] - start;
    std::stable_sort(vertices.begin(), vertices.end(),
                     [&](int a, int b) { return glm::dot(along, places[a]) < glm::dot(along, places[b]); });
  }

  int vertex_on(const std::array<int, 2>& ends, const CutBorder& border) {
    const auto known = std::find_if(made_.begin(), made_.end(), [&](const auto& one) {
      return one.first == ends && side(one.second, border) == 0;
    });
    if (known != made_.end()) return known->second;
    const CutPlaces places = cut_.places();
    const Vec3 a = places[ends[0]], b = places[ends[1]];
    const double at_a = glm::dot(border.normal, a - border.point), at_b = glm::dot(border.normal, b - border.point);
    const int made = static_cast<int>(cut_.file.size() + cut_.cut.points.size());
    cut_.cut.points.push_back(a + at_a / (at_a - at_b) * (b - a));
    cut_.cut.vertices.push_back({{-1, -1}, 0});
    made_.emplace_back(ends, made);
    return made;
  }

  [[nodiscard]] int side(int vertex, const CutBorder& border) const {
    return side_of(border, cut_.places()[vertex], slack_);
  }

  GrowingCut cut_;
  double slack_;
  std::vector<int> ends_;
  std::vector<std::pair<std::array<int, 2>, int>> made_;
};

}  // namespace

RegionOutlines clip_outlines(std::span<const CutSegment> segments, const std::vector<CutBorder>& borders,
                             GrowingCut cut, double slack) {
  RegionOutlines outlines{{segments.begin(), segments.end()}, {segments.begin(), segments.end()}, {}};
  OutlineClip clip(cut, slack);
  for (const CutBorder& border : borders) clip.clip(outlines.closed, outlines.drawn, border);
  outlines.ends = std::move(clip.ends());
  return outlines;
}

}  // namespace epura::cut
