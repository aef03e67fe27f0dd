// SPDX-License-Identifier: Apache-2.0
#include "mesh/bodies.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <utility>

#include "base/angle.hpp"
#include "base/disjoint_sets.hpp"
#include "base/portable_math.hpp"

namespace epura::mesh {

namespace {

constexpr double float_rounding = 0x1p-22, double_rounding = 0x1p-46;  // as a fraction of the largest coordinate
constexpr double max_doubt = 0.05;      // greatest admissible uncertainty of a direction from an edge, radians
constexpr double min_volume = 0x1p-40;  // of the cube around a shell; a smaller shell has no inside

/// A triangle at an edge, viewed along the edge.
struct Leaf {
  int triangle;
  double angle, doubt;  ///< its direction from the edge, counterclockwise, and the uncertainty of this angle; radians
  bool forward;         ///< traverses the edge from its lower vertex
  bool ends_material = false;  ///< in counterclockwise order; otherwise material begins there
};
using Leaves = std::vector<Leaf>;

bool may_be_touched(const MeshEdge& edge) { return edge.count >= 4 && edge.count % 2 == 0; }

/// Groups of triangles with known relative orientation (disjoint sets with parity).
class WaysRound {
 public:
  explicit WaysRound(std::size_t count) : parent_(count), turned_(count, 0), contradictory_(count, 0) {
    std::iota(parent_.begin(), parent_.end(), 0);
  }

  struct Way {
    int root;
    bool turned;  ///< opposite to the root
  };
  Way of(int i) {
    Way way{i, false};
    for (; parent_[way.root] != way.root; way.root = parent_[way.root]) way.turned ^= turned_[way.root] != 0;
    for (bool turned = way.turned; parent_[i] != i;) {  // path compression
      const bool next_turned = turned ^ (turned_[i] != 0);
      turned_[i] = static_cast<char>(turned);
      turned = next_turned;
      i = std::exchange(parent_[i], way.root);
    }
    return way;
  }
  void relate(int i, int j, bool turned) {
    const Way a = of(i), b = of(j);
    const bool of_roots = a.turned ^ b.turned ^ turned;
    if (a.root == b.root) {
      if (of_roots) contradictory_[a.root] = 1;
      return;
    }
    const auto [low, high] = std::minmax(a.root, b.root);
    parent_[high] = low;
    turned_[high] = static_cast<char>(of_roots);
    if (contradictory_[high] != 0) contradictory_[low] = 1;
  }
  [[nodiscard]] bool is_contradictory(int root) const { return contradictory_[root] != 0; }

 private:
  std::vector<int> parent_;
  std::vector<char> turned_, contradictory_;
};

class Shells {
 public:
  Shells(const Mesh& mesh, const EdgeTable& table) : mesh_(mesh), table_(table), ways_(mesh.polygon.size()) {
    double size = 0;
    for (const int v : mesh.corners)
      for (const double x : mesh.points[v]) size = std::max(size, std::abs(x));
    normalisation_ = size > 0 ? std::ldexp(1.0, -std::clamp(std::ilogb(size) + 1, -1000, 1000)) : 1;
    const double rounding = mesh.report.single_precision ? float_rounding : double_rounding;
    rounding_ = std::max(rounding, 2 * mesh.report.resolution * normalisation_);
    for (const MeshEdge& edge : table.edges) {
      const auto halfedges = table.halfedges_of(edge);
      if (edge.count == 2)
        ways_.relate(halfedges[0] / 3, halfedges[1] / 3, !is_two_sided(table, edge, mesh.corners));
      else if (may_be_touched(edge))
        alternate(clusters_around(edge));
    }
    find_volumes();
  }

  /// Calls `join(triangle, triangle)` for triangles that belong together at an edge with four or more.
  template <class Join>
  void pair(const MeshEdge& edge, const Join& join) {
    const Leaves leaves = in_turns(edge);
    if (leaves.empty()) {
      const auto halfedges = table_.halfedges_of(edge);
      for (const int halfedge : halfedges.subspan(1)) join(halfedges[0] / 3, halfedge / 3);
    }
    for (std::size_t i = 0; i < leaves.size(); ++i)
      if (!leaves[i].ends_material) join(leaves[i].triangle, leaves[(i + 1) % leaves.size()].triangle);
  }

 private:
  [[nodiscard]] Vec3 point(int vertex) const { return mesh_.point(vertex) * normalisation_; }

  // The triangles in order around an edge; those in one cluster coincide. Empty if the order is uncertain.
  [[nodiscard]] std::vector<Leaves> clusters_around(const MeshEdge& edge) const;

  // Going around an edge, one leaves and enters material alternately, also where two faces coincide.
  void alternate(const std::vector<Leaves>& clusters) {
    std::vector<Leaf> alone;
    const auto differ = [&](const Leaf& a, const Leaf& b) {
      ways_.relate(a.triangle, b.triangle, a.forward == b.forward);
    };
    for (const Leaves& cluster : clusters) {
      if (cluster.size() == 1) alone.push_back(cluster[0]);
      if (cluster.size() == 2) differ(cluster[0], cluster[1]);
    }
    for (std::size_t i = 1; i < alone.size(); ++i) differ(alone[i - 1], alone[i]);
  }

  // Volumes of consistently oriented groups: the sign determines the outside.
  void find_volumes() {
    const int count = mesh_.triangle_count();
    std::vector<Box> box(static_cast<std::size_t>(count));
    for (int t = 0; t < count; ++t)
      for (const int v : mesh_.triangle(t)) box[ways_.of(t).root].add(point(v));
    volume_.assign(box.size(), 0);
    for (int t = 0; t < count; ++t) {
      const auto [root, turned] = ways_.of(t);
      const auto [a, b, c] = mesh_.triangle(t);
      const Vec3& from = box[root].min;
      const double part = glm::dot(point(a) - from, glm::cross(point(b) - from, point(c) - from)) / 6;
      volume_[root] += turned ? -part : part;
    }
    double enclosed = 0;
    for (std::size_t root = 0; root < box.size(); ++root) {
      const Vec3 size = box[root].size();
      const double longest = std::max({size.x, size.y, size.z});
      if (ways_.is_contradictory(static_cast<int>(root)) ||
          !(std::abs(volume_[root]) > min_volume * longest * longest * longest))
        volume_[root] = 0;
      enclosed += volume_[root];
    }
    // Faces at which two bodies touch all around, as a shaft and its bearing do, enclose nothing by themselves. Which
    // of two coincident ones belongs to which body makes no difference, as long as it is the same everywhere.
    for (std::size_t root = 0; root < box.size(); ++root)
      if (volume_[root] == 0 && !ways_.is_contradictory(static_cast<int>(root))) volume_[root] = enclosed;
  }

  // The triangles in order around the edge, where material alternately begins and ends; empty if there is no such
  // order. Coincident faces of two bodies enclose nothing: one body ends before the other begins.
  [[nodiscard]] Leaves in_turns(const MeshEdge& edge) {
    Leaves leaves;
    for (Leaves& cluster : clusters_around(edge)) {
      for (Leaf& leaf : cluster) {
        const auto [root, turned] = ways_.of(leaf.triangle);
        if (volume_[root] == 0) return {};
        leaf.ends_material = (leaf.forward ^ turned) == (volume_[root] > 0);
      }
      std::stable_partition(cluster.begin(), cluster.end(), [](const Leaf& leaf) { return leaf.ends_material; });
      leaves.insert(leaves.end(), cluster.begin(), cluster.end());
    }
    for (std::size_t i = 0; i < leaves.size(); ++i)
      if (leaves[i].ends_material == leaves[(i + 1) % leaves.size()].ends_material) return {};
    return leaves;
  }

  const Mesh& mesh_;
  const EdgeTable& table_;
  double normalisation_ = 1, rounding_ = 0;
  WaysRound ways_;
  std::vector<double> volume_;  ///< by root; 0: the outside is unknown
};

std::vector<Leaves> clusters_of(Leaves leaves) {
  std::sort(leaves.begin(), leaves.end(), [](const Leaf& a, const Leaf& b) {
    return std::pair(a.angle, a.triangle) < std::pair(b.angle, b.triangle);
  });
  const auto gap_before = [&](std::size_t i) {
    return i > 0 ? leaves[i].angle - leaves[i - 1].angle : leaves[0].angle - leaves.back().angle + full_turn;
  };
  std::size_t widest = 0;
  for (std::size_t i = 1; i < leaves.size(); ++i)
    if (gap_before(i) > gap_before(widest)) widest = i;
  for (std::size_t i = 0; i < widest; ++i) leaves[i].angle += full_turn;
  std::rotate(leaves.begin(), leaves.begin() + static_cast<std::ptrdiff_t>(widest), leaves.end());
  std::vector<Leaves> clusters;
  for (std::size_t i = 0; i < leaves.size(); ++i) {
    if (i == 0 || gap_before(i) > leaves[i - 1].doubt + leaves[i].doubt) clusters.emplace_back();
    clusters.back().push_back(leaves[i]);
  }
  const bool certain = std::all_of(clusters.begin(), clusters.end(), [](const Leaves& c) { return c.size() <= 2; });
  return certain ? clusters : std::vector<Leaves>{};
}

std::vector<Leaves> Shells::clusters_around(const MeshEdge& edge) const {
  const Vec3 from = point(edge.vertex[0]);
  const Vec3 along = point(edge.vertex[1]) - from;
  const double length = glm::length(along);
  if (!(length > rounding_)) return {};
  const Vec3 axis = along / length;
  const double x = std::abs(axis.x), y = std::abs(axis.y), z = std::abs(axis.z);
  const Vec3 across = x <= y && x <= z ? Vec3(1, 0, 0) : y <= z ? Vec3(0, 1, 0) : Vec3(0, 0, 1);
  const Vec3 right = glm::normalize(glm::cross(axis, across)), up = glm::cross(axis, right);
  Leaves leaves;
  for (const int halfedge : table_.halfedges_of(edge)) {
    const Vec3 to_apex = point(mesh_.corners[next_in_triangle(next_in_triangle(halfedge))]) - from;
    const Vec2 out(glm::dot(to_apex, right), glm::dot(to_apex, up));
    const double doubt = 2 * rounding_ / glm::length(out);
    if (!(doubt < max_doubt)) return {};
    leaves.push_back({halfedge / 3, portable_atan2(out.y, out.x), doubt, mesh_.corners[halfedge] == edge.vertex[0]});
  }
  return clusters_of(std::move(leaves));
}

}  // namespace

std::vector<int> connected_parts(const Mesh& mesh, const EdgeTable& table) {
  DisjointSets parts(mesh.polygon.size());
  std::optional<Shells> shells;
  for (const MeshEdge& edge : table.edges) {
    if (may_be_touched(edge)) {
      if (!shells) shells.emplace(mesh, table);
      shells->pair(edge, [&](int a, int b) { parts.join(a, b); });
      continue;
    }
    const auto halfedges = table.halfedges_of(edge);
    for (const int halfedge : halfedges.subspan(1)) parts.join(halfedges[0] / 3, halfedge / 3);
  }
  std::vector<int> labels = std::move(parts).roots();
  renumber_labels(labels);
  return labels;
}

std::vector<int> renumber_labels(std::vector<int>& labels) {
  std::vector<int> found;
  if (labels.empty()) return found;
  std::vector<int> number(static_cast<std::size_t>(*std::max_element(labels.begin(), labels.end())) + 1, -1);
  for (int& label : labels) {
    if (number[label] < 0) {
      number[label] = static_cast<int>(found.size());
      found.push_back(label);
    }
    label = number[label];
  }
  return found;
}

}  // namespace epura::mesh
