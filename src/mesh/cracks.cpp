#include "mesh/cracks.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <tuple>
#include <utility>

#include "base/vec.hpp"

namespace epura {

namespace {

// A 32-bit coordinate is off by half a rounding; two that were computed in different ways, by some more.
constexpr double roundings = 4 * 0x1p-23;

Vec3 place(const Points& points, int vertex) { return {points[vertex][0], points[vertex][1], points[vertex][2]}; }

double largest_coordinate(const Points& points, std::span<const int> corners) {
  double largest = 0;
  for (const int corner : corners)
    for (const double x : points[corner]) largest = std::max(largest, std::abs(x));
  return largest;
}

/// A vertex at the end of an open edge.
struct OpenEnd {
  double along;   ///< its place along the direction in which pairs are sought
  double radius;  ///< it may be joined with what is no farther away
  int vertex;
};

/// All of them, sorted along a direction in which models hardly ever have many vertices at one height.
std::vector<OpenEnd> open_ends(const Points& points, const EdgeTable& table, double tolerance) {
  const Vec3 direction = glm::normalize(Vec3(0.577, 0.331, 0.747));
  std::vector<OpenEnd> ends;
  for (const MeshEdge& edge : table.edges) {
    if (edge.count != 1) continue;
    const Vec3 a = place(points, edge.vertex[0]), b = place(points, edge.vertex[1]);
    // A quarter of the edge: cracks are much narrower than they are long, and real small edges survive.
    const double radius = std::min(tolerance, 0.25 * glm::distance(a, b));
    ends.push_back({glm::dot(a, direction), radius, edge.vertex[0]});
    ends.push_back({glm::dot(b, direction), radius, edge.vertex[1]});
  }
  // One entry a vertex, with its smallest radius.
  std::sort(ends.begin(), ends.end(), [](const OpenEnd& a, const OpenEnd& b) {
    return a.vertex != b.vertex ? a.vertex < b.vertex : a.radius < b.radius;
  });
  ends.erase(
      std::unique(ends.begin(), ends.end(), [](const OpenEnd& a, const OpenEnd& b) { return a.vertex == b.vertex; }),
      ends.end());
  std::stable_sort(ends.begin(), ends.end(), [](const OpenEnd& a, const OpenEnd& b) { return a.along < b.along; });
  return ends;
}

struct Pair {
  double distance;
  int a, b;  ///< a < b
};

/// Open ends near enough to each other, the nearest first.
std::vector<Pair> near_pairs(const Points& points, const std::vector<OpenEnd>& ends) {
  // Many corners at one place are joined through each other, so not every pair of them is needed.
  constexpr std::size_t most_looked_at = 64;
  std::vector<Pair> pairs;
  for (std::size_t i = 0; i < ends.size(); ++i)
    for (std::size_t j = i + 1; j < std::min(ends.size(), i + most_looked_at); ++j) {
      if (ends[j].along - ends[i].along > ends[i].radius) break;
      const auto [a, b] = std::minmax({ends[i].vertex, ends[j].vertex});
      const double distance = glm::distance(place(points, a), place(points, b));
      if (distance <= std::min(ends[i].radius, ends[j].radius)) pairs.push_back({distance, a, b});
    }
  std::sort(pairs.begin(), pairs.end(), [](const Pair& p, const Pair& q) {
    return std::tie(p.distance, p.a, p.b) < std::tie(q.distance, q.a, q.b);
  });
  return pairs;
}

/// Vertices joined so far. A cluster is named by its lowest vertex.
class Clusters {
 public:
  Clusters(std::size_t vertex_count, const EdgeTable& table) : table_(table), representative_(vertex_count) {
    std::iota(representative_.begin(), representative_.end(), 0);
  }

  void join(int a, int b) {
    const auto [low, high] = std::minmax({representative_[a], representative_[b]});
    if (low == high) return;
    auto& kept = members_.try_emplace(low, 1, low).first->second;
    auto& added = members_.try_emplace(high, 1, high).first->second;
    if (kept.size() + added.size() > most_members || linked(kept, added)) return;
    for (const int vertex : added) representative_[vertex] = low;
    kept.insert(kept.end(), added.begin(), added.end());
    members_.erase(high);
  }

  std::vector<int> take_representatives() { return std::move(representative_); }

 private:
  // More corners than ever meet at one place; keeps the search for edges between clusters short.
  static constexpr std::size_t most_members = 256;

  [[nodiscard]] bool linked(const std::vector<int>& one, const std::vector<int>& other) const {
    for (const int a : one)
      for (const int b : other) {
        const std::array<int, 2> wanted{std::min(a, b), std::max(a, b)};
        if (std::ranges::binary_search(table_.edges, wanted, {}, &MeshEdge::vertex)) return true;
      }
    return false;
  }

  const EdgeTable& table_;
  std::vector<int> representative_;
  std::map<int, std::vector<int>> members_;
};

}  // namespace

Mending mend_cracks(const Points& points, std::span<const int> corners, const EdgeTable& table) {
  const double tolerance = roundings * largest_coordinate(points, corners);
  const std::vector<Pair> pairs = near_pairs(points, open_ends(points, table, tolerance));
  if (pairs.empty()) return {};
  Clusters clusters(points.size(), table);
  for (const Pair& pair : pairs) clusters.join(pair.a, pair.b);

  Mending mending{.representative = clusters.take_representatives()};
  for (int vertex = 0; vertex < static_cast<int>(points.size()); ++vertex) {
    const int kept = mending.representative[vertex];
    if (kept == vertex) continue;
    ++mending.joined;
    mending.distance = std::max(mending.distance, glm::distance(place(points, kept), place(points, vertex)));
  }
  return mending;
}

}  // namespace epura
