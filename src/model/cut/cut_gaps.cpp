// SPDX-License-Identifier: Apache-2.0
#include "cut/cut_gaps.hpp"

#include <algorithm>
#include <cmath>

#include "base/disjoint_sets.hpp"
#include "cut/limits.hpp"
#include "mesh/resolution.hpp"

namespace epura::cut {

namespace {

/// The outline from one end to the next end or branch.
struct Chain {
  double length = 0;
  double arc = 0;  ///< largest height of an arc above its chords near the end
};

struct End {
  int vertex;  ///< its index in the list
  double arc;
  std::optional<double> sagitta;
  double reach;  ///< greatest width of a gap at this end
  int nearest = -1;
  double distance = HUGE_VAL, next_distance = HUGE_VAL;
};

class Outline {
 public:
  Outline(std::span<const CutSegment> segments, const CutPlaces& places, const PlaneFrame& frame)
      : segments_(segments.begin(), segments.end()), flat_(flatten(segments, places, frame)) {
    at_.resize(flat_.vertices.size());
    for (std::size_t s = 0; s < segments_.size(); ++s)
      for (const int v : flat_.outlines.segments[s]) at_[v].push_back(static_cast<int>(s));
  }

  std::vector<Bridge> bridge(const GapLimits& limits) {
    std::vector<End> ends = find_ends(limits);
    find_nearest(ends);
    std::vector<Bridge> bridges;
    for (std::size_t i = 0; i < ends.size(); ++i) {
      const int j = ends[i].nearest;
      if (j <= static_cast<int>(i) || ends[j].nearest != static_cast<int>(i)) continue;
      const End &one = ends[i], &other = ends[j];
      const double width = one.distance;
      const double room = std::min(one.next_distance, other.next_distance);
      if (width > explained(one, other, limits.rounding) || room < min_room * width) continue;
      const auto [low, high] = std::minmax(one.vertex, other.vertex);
      for (const int v : {low, high}) at_[v].push_back(static_cast<int>(segments_.size()));
      segments_.push_back({segments_.front().body, {flat_.vertices[low], flat_.vertices[high]}});
      flat_.outlines.segments.push_back({low, high});
      bridges.push_back({segments_.back().vertex, width});
    }
    return bridges;
  }

  // Returns for each segment whether it belongs to closed outlines.
  std::vector<char> closed() const {
    std::vector<char> kept(segments_.size(), 1);
    std::vector<std::size_t> degree;
    std::vector<int> next;
    for (std::size_t v = 0; v < at_.size(); ++v) {
      degree.push_back(at_[v].size());
      if (degree[v] == 1) next.push_back(static_cast<int>(v));
    }
    while (!next.empty()) {
      const int v = next.back();
      next.pop_back();
      for (const int s : at_[v]) {
        if (kept[s] == 0) continue;
        kept[s] = 0;
        --degree[v];
        const int other = other_end(s, v);
        if (--degree[other] == 1) next.push_back(other);
      }
    }
    DisjointSets joined(at_.size());
    for (std::size_t s = 0; s < segments_.size(); ++s)
      if (kept[s] != 0) joined.join(flat_.outlines.segments[s][0], flat_.outlines.segments[s][1]);
    std::vector<char> branches(at_.size(), 0);
    for (std::size_t v = 0; v < at_.size(); ++v)
      if (degree[v] % 2 == 1) branches[joined.root(static_cast<int>(v))] = 1;
    for (std::size_t s = 0; s < segments_.size(); ++s)
      if (branches[joined.root(flat_.outlines.segments[s][0])] != 0) kept[s] = 0;
    return kept;
  }

  [[nodiscard]] const std::vector<CutSegment>& segments() const { return segments_; }
  // Vertices at which an odd number of segments meets.
  [[nodiscard]] std::vector<int> odd_vertices() const {
    std::vector<int> odd;
    for (std::size_t v = 0; v < at_.size(); ++v)
      if (at_[v].size() % 2 == 1) odd.push_back(flat_.vertices[v]);
    return odd;
  }

 private:
  [[nodiscard]] int other_end(int segment, int vertex) const {
    const auto& [a, b] = flat_.outlines.segments[segment];
    return a == vertex ? b : a;
  }
  [[nodiscard]] Vec2 place(int vertex) const { return flat_.outlines.places[vertex]; }

  [[nodiscard]] Chain chain_from(int vertex) const {
    Chain chain;
    int segment = at_[vertex][0];
    Vec2 last(0.0);
    for (int i = 0;; ++i) {
      const int next = other_end(segment, vertex);
      const Vec2 along = place(next) - place(vertex);
      chain.length += glm::length(along);
      if (0 < i && i <= joints_at_end) chain.arc = std::max(chain.arc, arc_height(last, along));
      if (at_[next].size() != 2) return chain;
      last = along;
      segment = at_[next][at_[next][0] == segment ? 1 : 0];
      vertex = next;
    }
  }

  // Height of the arc above the shorter of two chords of a circle: for small turns t between them, a quarter of its
  // length times tan(t / 2).
  static double arc_height(const Vec2& a, const Vec2& b) {
    const double product = glm::length(a) * glm::length(b) + glm::dot(a, b);
    const double turn = product > 0 ? std::abs(cross(a, b)) / product : HUGE_VAL;
    return turn <= max_turn_of_arc ? std::min(glm::length(a), glm::length(b)) * turn / 4 : 0;
  }

  [[nodiscard]] std::vector<End> find_ends(const GapLimits& limits) const {
    std::vector<End> ends;
    for (std::size_t v = 0; v < at_.size(); ++v) {
      if (at_[v].size() != 1) continue;
      const Chain chain = chain_from(static_cast<int>(v));
      ends.push_back(
          {static_cast<int>(v), chain.arc, limits.sagitta(segments_[at_[v][0]].triangle), chain.length / min_outline});
    }
    std::sort(ends.begin(), ends.end(), [&](const End& a, const End& b) {
      return std::pair(along_sweep(a), a.vertex) < std::pair(along_sweep(b), b.vertex);
    });
    return ends;
  }

  // Position along a direction in which ends of regular meshes do not line up.
  [[nodiscard]] double along_sweep(const End& end) const {
    return 0.8507 * place(end.vertex).x + 0.5257 * place(end.vertex).y;
  }

  // Considers only ends within three times the reach.
  void find_nearest(std::vector<End>& ends) const {
    const auto look = [&](End& end, std::size_t j) {
      const double distance = glm::distance(place(end.vertex), place(ends[j].vertex));
      if (distance < end.distance) {
        end.next_distance = end.distance;
        end.distance = distance;
        end.nearest = static_cast<int>(j);
      } else {
        end.next_distance = std::min(end.next_distance, distance);
      }
    };
    for (std::size_t i = 0; i < ends.size(); ++i) {
      const double at = along_sweep(ends[i]), reach = min_room * ends[i].reach;
      for (std::size_t j = i; j-- > 0 && at - along_sweep(ends[j]) <= reach;) look(ends[i], j);
      for (std::size_t j = i + 1; j < ends.size() && along_sweep(ends[j]) - at <= reach; ++j) look(ends[i], j);
    }
  }

  // The widest gap between two ends that tessellation or rounding can explain.
  static double explained(const End& one, const End& other, double rounding) {
    const auto height = [](const End& end) { return end.sagitta ? highest_in_sagittas * *end.sagitta : end.arc; };
    return std::min({std::max({mesh::roundings * rounding, height(one), height(other)}), one.reach, other.reach});
  }

  std::vector<CutSegment> segments_;
  FlatOutlines flat_;
  std::vector<std::vector<int>> at_;  ///< segments at each vertex
};

bool is_even_everywhere(std::span<const CutSegment> segments) {
  std::vector<int> ends;
  for (const CutSegment& segment : segments) ends.insert(ends.end(), segment.vertex.begin(), segment.vertex.end());
  std::sort(ends.begin(), ends.end());
  for (std::size_t begin = 0, end = 0; begin < ends.size(); begin = end) {
    while (end < ends.size() && ends[end] == ends[begin]) ++end;
    if ((end - begin) % 2 == 1) return false;
  }
  return true;
}

}  // namespace

ToldApart tell_apart(std::span<const CutSegment> segments, const CutPlaces& places, const PlaneFrame& frame,
                     const GapLimits& limits) {
  ToldApart apart;
  if (is_even_everywhere(segments)) {
    apart.closed.assign(segments.begin(), segments.end());
    return apart;
  }
  Outline outline(segments, places, frame);
  const std::vector<Bridge> bridges = outline.bridge(limits);
  const std::vector<char> closed = outline.closed();
  apart.ends = outline.odd_vertices();
  for (std::size_t s = 0; s < closed.size(); ++s) {
    if (closed[s] != 0)
      apart.closed.push_back(outline.segments()[s]);
    else if (s < segments.size())
      apart.loose.push_back(outline.segments()[s]);
    if (closed[s] != 0 && s >= segments.size()) apart.bridges.push_back(bridges[s - segments.size()]);
  }
  std::sort(apart.closed.begin(), apart.closed.end());
  return apart;
}

}  // namespace epura::cut
