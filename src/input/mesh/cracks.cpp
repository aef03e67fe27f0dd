// SPDX-License-Identifier: Apache-2.0
#include "mesh/cracks.hpp"

#include <algorithm>
#include <array>
#include <cmath>
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

Vec3 place(const Points& points, int vertex) { return {points[vertex][0], points[vertex][1], points[vertex][2]}; }

double largest_coordinate(const Points& points, std::span<const int> corners) {
  double largest = 0;
  for (const int corner : corners)
    for (const double x : points[corner]) largest = std::max(largest, std::abs(x));
  return largest;
}

/// A vertex at the end of an open edge.
struct OpenEnd {
  double along;   ///< its position along the sweep direction
  double radius;  ///< greatest distance over which it may be merged
  int vertex;
};

/// Returns all open ends, sorted along a direction in which models rarely have many vertices at one height.
std::vector<OpenEnd> open_ends(const Points& points, const EdgeTable& table, double tolerance) {
  const Vec3 direction = glm::normalize(Vec3(0.577, 0.331, 0.747));
  std::vector<OpenEnd> ends;
  for (const MeshEdge& edge : table.edges) {
    if (edge.count != 1) continue;
    const Vec3 a = place(points, edge.vertex[0]), b = place(points, edge.vertex[1]);
    // At most a quarter of the edge: cracks are much narrower than they are long, and genuine small edges survive.
    const double radius = std::min(tolerance, 0.25 * glm::distance(a, b));
    ends.push_back({glm::dot(a, direction), radius, edge.vertex[0]});
    ends.push_back({glm::dot(b, direction), radius, edge.vertex[1]});
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

/// Vertices merged so far. Two vertices with an edge between them are never in one cluster.
class Clusters {
 public:
  Clusters(std::size_t vertex_count, const std::vector<OpenEnd>& ends, const EdgeTable& table)
      : cluster_(vertex_count), members_(vertex_count) {
    std::iota(cluster_.begin(), cluster_.end(), 0);
    for (const OpenEnd& end : ends) members_[end.vertex] = {end.vertex};
    for (const MeshEdge& edge : table.edges) {
      const auto [a, b] = edge.vertex;
      if (members_[a].empty() || members_[b].empty()) continue;  // one of them cannot be merged
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

Mending mend_cracks(const Points& points, std::span<const int> corners, const EdgeTable& table, double resolution) {
  const double tolerance = roundings * std::max(relative_step * largest_coordinate(points, corners), resolution / 2);
  const std::vector<OpenEnd> ends = open_ends(points, table, tolerance);
  const std::vector<EndPair> pairs = near_pairs(points, ends);
  if (pairs.empty()) return {};
  Clusters clusters(points.size(), ends, table);
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
