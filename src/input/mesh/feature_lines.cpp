// SPDX-License-Identifier: Apache-2.0
#include "mesh/feature_lines.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <span>
#include <tuple>
#include <utility>

#include "base/parallel.hpp"
#include "base/portable_math.hpp"
#include "base/vec.hpp"

namespace epura::mesh {

namespace {

// Triangles lower than this fraction of their longest side have no reliable normal.
constexpr double sliver = 1e-6;
constexpr double angle_rounding = 1e-6;  // degrees; a limit of 360/N takes either all edges of an N-sided prism or none
constexpr std::size_t max_at_a_vertex = 64;

// Normal vector, twice as long as the area; 0 for slivers.
Vec3 area_of(const PlacedMesh& placed, int triangle) {
  const std::array<int, 3>& c = placed.triangles[triangle];
  const Vec3 &a = placed.points[c[0]], &b = placed.points[c[1]], &d = placed.points[c[2]];
  const Vec3 area = glm::cross(b - a, d - a);
  const double longest = std::max({glm::length(b - a), glm::length(d - b), glm::length(a - d)});
  return glm::length(area) > sliver * longest * longest ? area : Vec3(0);
}

// For each triangle the normal of its face in the file, not normalised. A face that consists of slivers only has none.
std::vector<Vec3> normals_of(const PlacedMesh& placed) {
  std::vector<Vec3> normals(placed.mesh.polygon.size());
  parallel_for(normals.size(), grain::light, [&](std::size_t begin, std::size_t end) {
    for (std::size_t t = begin; t < end; ++t) normals[t] = area_of(placed, static_cast<int>(t));
  });
  // Triangles of one face are consecutive.
  for (std::size_t first = 0, end = 0; first < normals.size(); first = end) {
    Vec3 sum(0);
    for (; end < normals.size() && placed.mesh.polygon[end] == placed.mesh.polygon[first]; ++end) sum += normals[end];
    std::fill(normals.begin() + static_cast<std::ptrdiff_t>(first), normals.begin() + static_cast<std::ptrdiff_t>(end),
              sum);
  }
  return normals;
}

// Whether the triangle traverses the edge from its first vertex to its second one.
bool runs_along(const PlacedMesh& placed, const MeshEdge& edge, int triangle) {
  const std::array<int, 3>& c = placed.triangles[triangle];
  const auto at = std::find(c.begin(), c.end(), placed.first_vertex + edge.vertex[0]) - c.begin();
  return c[static_cast<std::size_t>(at + 1) % 3] == placed.first_vertex + edge.vertex[1];
}

bool is_feature(const PlacedMesh& placed, const MeshEdge& edge, std::span<const Vec3> normals, double min_fold) {
  if (edge.count != 2) return edge.count > 0;
  if (edge.diagonal) return false;
  const auto triangles = placed.mesh.triangles_of(edge);
  const Vec3& a = normals[triangles[0]];
  // If the neighbour has the opposite orientation, its normal is reversed.
  const bool turned = runs_along(placed, edge, triangles[0]) == runs_along(placed, edge, triangles[1]);
  const Vec3 b = turned ? -normals[triangles[1]] : normals[triangles[1]];
  if (a == Vec3(0) || b == Vec3(0)) return false;
  return portable_atan2(glm::length(glm::cross(a, b)), glm::dot(a, b)) >= min_fold;
}

// One end of an edge: 2 * edge + (0 or 1), where 0 or 1 is the index in MeshEdge::vertex.
using End = int;
constexpr End none = -1;
End other(End end) { return end ^ 1; }

/// Feature edges and their continuations.
struct Features {
  const PlacedMesh& placed;
  std::vector<char> wanted;  ///< by edge
  std::vector<End> partner;  ///< by end

  [[nodiscard]] int vertex(End end) const {
    return placed.mesh.edges[static_cast<std::size_t>(end / 2)].vertex[static_cast<std::size_t>(end % 2)];
  }
  [[nodiscard]] Vec3 leaving(End end) const {
    return glm::normalize(placed.point(vertex(other(end))) - placed.point(vertex(end)));
  }
  void pair_up(std::span<const End> ends, double min_straightness);
  [[nodiscard]] FeatureLine follow(End start, std::vector<char>& used) const;
};

// Pairs edges in order of straightness, the cosine of their turn.
void Features::pair_up(std::span<const End> ends, double min_straightness) {
  if (ends.size() > max_at_a_vertex) return;
  std::vector<std::tuple<double, End, End>> pairs;
  for (std::size_t i = 0; i < ends.size(); ++i)
    for (std::size_t j = i + 1; j < ends.size(); ++j) {
      const double straightness = -glm::dot(leaving(ends[i]), leaving(ends[j]));
      if (straightness >= min_straightness) pairs.emplace_back(-straightness, ends[i], ends[j]);
    }
  std::sort(pairs.begin(), pairs.end());
  for (const auto& [order, a, b] : pairs) {
    if (partner[a] != none || partner[b] != none) continue;
    partner[a] = b;
    partner[b] = a;
  }
}

// Starts at the end `start` and proceeds to the other end of its edge.
FeatureLine Features::follow(End start, std::vector<char>& used) const {
  FeatureLine line{{vertex(start)}, false};
  End at = start;
  for (; at != none && used[at / 2] == 0; at = partner[other(at)]) {
    used[at / 2] = 1;
    line.vertices.push_back(vertex(other(at)));
  }
  line.closed = at == start;
  if (line.closed) line.vertices.pop_back();
  return line;
}

// Ends of the feature edges, sorted by vertex.
std::vector<End> ends_by_vertex(const Features& features) {
  std::vector<End> ends;
  for (std::size_t e = 0; e < features.wanted.size(); ++e)
    if (features.wanted[e] != 0) ends.insert(ends.end(), {static_cast<End>(2 * e), static_cast<End>(2 * e + 1)});
  std::sort(ends.begin(), ends.end(),
            [&](End a, End b) { return std::pair(features.vertex(a), a) < std::pair(features.vertex(b), b); });
  return ends;
}

Features find_features(const PlacedMesh& placed, double crease_angle) {
  const std::vector<Vec3> normals = normals_of(placed);
  const double min_fold = (crease_angle - angle_rounding) * std::numbers::pi / 180;
  Features features{placed, std::vector<char>(placed.mesh.edges.size()),
                    std::vector<End>(2 * placed.mesh.edges.size(), none)};
  parallel_for(placed.mesh.edges.size(), grain::light, [&](std::size_t begin, std::size_t end) {
    for (std::size_t e = begin; e < end; ++e)
      features.wanted[e] = is_feature(placed, placed.mesh.edges[e], normals, min_fold) ? 1 : 0;
  });
  return features;
}

}  // namespace

std::vector<FeatureLine> find_feature_lines(const PlacedMesh& placed, double crease_angle, double max_turn) {
  Features features = find_features(placed, crease_angle);
  const std::vector<End> ends = ends_by_vertex(features);
  const double min_straightness = portable_cos(max_turn);
  for (std::size_t begin = 0, end = 0; begin < ends.size(); begin = end) {
    while (end < ends.size() && features.vertex(ends[end]) == features.vertex(ends[begin])) ++end;
    features.pair_up(std::span(ends).subspan(begin, end - begin), min_straightness);
  }
  std::vector<FeatureLine> lines;
  std::vector<char> used(placed.mesh.edges.size(), 0);
  for (const End end : ends)
    if (features.partner[end] == none && used[end / 2] == 0) lines.push_back(features.follow(end, used));
  // The remaining lines are closed.
  for (const End end : ends)
    if (used[end / 2] == 0) lines.push_back(features.follow(end, used));
  return lines;
}

}  // namespace epura::mesh
