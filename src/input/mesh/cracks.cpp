// SPDX-License-Identifier: Apache-2.0
#include "mesh/cracks.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/vector_relational.hpp>
#include <numeric>
#include <tuple>
#include <utility>

#include "base/vec.hpp"
#include "mesh/resolution.hpp"

namespace epura::mesh {

namespace {

// Of the largest coordinate: the last place of 32-bit floats. Kernels of CAD programs compute a vertex of two faces no
// more closely, even if they write it with all digits.
constexpr double relative_step = 0x1p-23;

double largest_of(const Vec3& v) { return std::max({v.x, v.y, v.z}); }

Vec3 place(const Points& points, int vertex) { return {points[vertex][0], points[vertex][1], points[vertex][2]}; }

/// Along each axis.
Vec3 largest_coordinates(const Points& points, std::span<const int> corners) {
  Vec3 largest(0);
  for (const int corner : corners) largest = glm::max(largest, glm::abs(place(points, corner)));
  return largest;
}

double length_of(const Points& points, const MeshEdge& edge) {
  return glm::distance(place(points, edge.vertex[0]), place(points, edge.vertex[1]));
}

bool is_made_by_rounding(const Points& points, const MeshEdge& edge, const CrackLimits& limits) {
  const Vec3 way = glm::abs(place(points, edge.vertex[1]) - place(points, edge.vertex[0]));
  const Vec3 rounded = glm::min(limits.largest, Vec3(largest_of(largest_coordinates(points, edge.vertex))));
  return glm::all(glm::lessThanEqual(way, limits.shortest_part * rounded));
}

double extent_of(const Points& points, std::span<const int> corners) {
  if (corners.empty()) return 0;
  Vec3 min = place(points, corners.front()), max = min;
  for (const int corner : corners) {
    min = glm::min(min, place(points, corner));
    max = glm::max(max, place(points, corner));
  }
  return glm::distance(min, max);
}

bool are_floats(const Points& points, std::span<const int> corners) {
  return std::all_of(corners.begin(), corners.end(), [&](int corner) {
    const auto& p = points[corner];
    return std::all_of(p.begin(), p.end(), [](double x) { return x == static_cast<float>(x); });
  });
}

/// A vertex at the end of an open edge.
struct OpenEnd {
  double along;   ///< its position along the sweep direction
  double radius;  ///< greatest distance over which it may be merged
  int vertex;
};

/// Returns all open ends, sorted along a direction in which models rarely have many vertices at one height.
std::vector<OpenEnd> open_ends(const Points& points, const EdgeTable& table, const CrackLimits& limits) {
  const Vec3 direction = glm::normalize(Vec3(0.577, 0.331, 0.747));
  std::vector<OpenEnd> ends;
  for (const MeshEdge& edge : table.edges) {
    if (edge.count != 1) continue;
    const double length = length_of(points, edge);
    const bool may_go = is_made_by_rounding(points, edge, limits);
    const double radius = may_go ? limits.width : std::min(limits.width, widest_crack * length);
    for (const int vertex : edge.vertex) ends.push_back({glm::dot(place(points, vertex), direction), radius, vertex});
  }
  // One entry per vertex, with its smallest radius.
  std::sort(ends.begin(), ends.end(), [](const OpenEnd& a, const OpenEnd& b) {
    return a.vertex != b.vertex ? a.vertex < b.vertex : a.radius < b.radius;
  });
  ends.erase(
      std::unique(ends.begin(), ends.end(), [](const OpenEnd& a, const OpenEnd& b) { return a.vertex == b.vertex; }),
      ends.end());
  std::stable_sort(ends.begin(), ends.end(), [](const OpenEnd& a, const OpenEnd& b) { return a.along < b.along; });
  return ends;
}

struct EndPair {
  double distance;
  int a, b;  ///< a < b
};

/// Pairs of open ends that are close enough to each other, nearest first.
std::vector<EndPair> near_pairs(const Points& points, const std::vector<OpenEnd>& ends) {
  // Where many vertices coincide, they are merged transitively, so not every pair of them is needed.
  constexpr std::size_t max_looked_at = 64;
  std::vector<EndPair> pairs;
  for (std::size_t i = 0; i < ends.size(); ++i)
    for (std::size_t j = i + 1; j < std::min(ends.size(), i + max_looked_at); ++j) {
      if (ends[j].along - ends[i].along > ends[i].radius) break;
      const auto [a, b] = std::minmax({ends[i].vertex, ends[j].vertex});
      const double distance = glm::distance(place(points, a), place(points, b));
      if (distance <= std::min(ends[i].radius, ends[j].radius)) pairs.push_back({distance, a, b});
    }
  std::sort(pairs.begin(), pairs.end(), [](const EndPair& p, const EndPair& q) {
    return std::tie(p.distance, p.a, p.b) < std::tie(q.distance, q.a, q.b);
  });
  return pairs;
}

/// Vertices merged so far. Two vertices with an edge between them that rounding did not make are never in one cluster.
class Clusters {
 public:
  Clusters(const Points& points, const std::vector<OpenEnd>& ends, const EdgeTable& table, const CrackLimits& limits)
      : cluster_(points.size()), members_(points.size()) {
    std::iota(cluster_.begin(), cluster_.end(), 0);
    for (const OpenEnd& end : ends) members_[end.vertex] = {end.vertex};
    for (const MeshEdge& edge : table.edges) {
      const auto [a, b] = edge.vertex;
      if (members_[a].empty() || members_[b].empty()) continue;  // one of them cannot be merged
      if (is_made_by_rounding(points, edge, limits)) continue;
      links_.push_back({a, b});
      links_.push_back({b, a});
    }
    std::sort(links_.begin(), links_.end());
  }

  void join(int a, int b) {
    int small = cluster_[a], large = cluster_[b];
    if (members_[small].size() > members_[large].size()) std::swap(small, large);
    if (small == large || linked(small, large)) return;
    for (const int vertex : members_[small]) cluster_[vertex] = large;
    members_[large].insert(members_[large].end(), members_[small].begin(), members_[small].end());
    members_[small] = {};
  }

  /// Returns for each vertex the lowest one of its cluster.
  [[nodiscard]] std::vector<int> representatives() const {
    constexpr int none = -1;
    std::vector<int> lowest(cluster_.size(), none), found(cluster_.size());
    for (int vertex = 0; vertex < static_cast<int>(found.size()); ++vertex) {
      int& first = lowest[cluster_[vertex]];
      if (first == none) first = vertex;
      found[vertex] = first;
    }
    return found;
  }

 private:
  [[nodiscard]] bool linked(int small, int large) const {
    for (const int vertex : members_[small]) {
      auto link = std::lower_bound(links_.begin(), links_.end(), std::array<int, 2>{vertex, 0});
      for (; link != links_.end() && (*link)[0] == vertex; ++link)
        if (cluster_[(*link)[1]] == large) return true;
    }
    return false;
  }

  std::vector<int> cluster_;               // cluster of each vertex, identified by one of its members
  std::vector<std::vector<int>> members_;  // members of each cluster; empty for vertices that are not open ends
  std::vector<std::array<int, 2>> links_;  // edges between open ends, in both directions
};

}  // namespace

CrackLimits limits_of_cracks(const Points& points, std::span<const int> corners, double resolution) {
  const Vec3 largest = largest_coordinates(points, corners);
  const double step = relative_step * largest_of(largest);
  // Of a model that is lost in rounding, nothing would be left to tell so.
  const bool may_drop = extent_of(points, corners) > roundings * step && are_floats(points, corners);
  return {roundings * std::max(step, resolution / 2), largest, may_drop ? roundings * relative_step : 0};
}

Mending mend_cracks(const Points& points, const EdgeTable& table, const CrackLimits& limits) {
  const std::vector<OpenEnd> ends = open_ends(points, table, limits);
  const std::vector<EndPair> pairs = near_pairs(points, ends);
  if (pairs.empty()) return {};
  Clusters clusters(points, ends, table, limits);
  for (const EndPair& pair : pairs) clusters.join(pair.a, pair.b);

  Mending mending{.representative = clusters.representatives()};
  for (int vertex = 0; vertex < static_cast<int>(points.size()); ++vertex) {
    const int kept = mending.representative[vertex];
    if (kept == vertex) continue;
    ++mending.joined;
    mending.distance = std::max(mending.distance, glm::distance(place(points, kept), place(points, vertex)));
  }
  return mending;
}

}  // namespace epura::mesh
