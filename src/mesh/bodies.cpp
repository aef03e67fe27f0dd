// SPDX-License-Identifier: Apache-2.0
#include "mesh/bodies.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

#include "base/disjoint_sets.hpp"
#include "base/portable_math.hpp"

namespace epura::mesh {

namespace {

constexpr double float_rounding = 0x1p-22, double_rounding = 0x1p-46;  // of the largest coordinate
constexpr double most_doubt = 0.05;       // radians by which a direction from an edge may be uncertain
constexpr double least_volume = 0x1p-40;  // of the cube around a shell: one of less has no inside

/// A triangle at an edge, as someone sees it who looks along the edge.
struct Leaf {
  int triangle;
  double angle, doubt;  ///< its direction from the edge, counterclockwise, and the uncertainty of that; radians
  bool ends_material;   ///< going counterclockwise; if not, it begins there
};

bool may_touch_another(const MeshEdge& edge) { return edge.count >= 4 && edge.count % 2 == 0; }

class Shells {
 public:
  Shells(const Mesh& mesh, const EdgeTable& table) : mesh_(mesh), table_(table) {
    double size = 0;
    for (const int v : mesh.corners)
      for (const double x : mesh.points[v]) size = std::max(size, std::abs(x));
    normalisation_ = size > 0 ? std::ldexp(1.0, -std::clamp(std::ilogb(size) + 1, -1000, 1000)) : 1;
    const double rounding = mesh.report.single_precision ? float_rounding : double_rounding;
    rounding_ = std::max(rounding, 2 * mesh.report.resolution * normalisation_);
    find_inside_out();
  }

  /// Calls `join(triangle, triangle)` for triangles that belong together at an edge of an even number of them.
  template <class Join>
  void pair(const MeshEdge& edge, const Join& join) const {
    const auto halfedges = table_.halfedges_of(edge);
    const std::optional<std::vector<Leaf>> leaves = leaves_around(edge);
    if (!leaves) {
      for (const int halfedge : halfedges.subspan(1)) join(halfedges[0] / 3, halfedge / 3);
      return;
    }
    const std::size_t first = leaves->front().ends_material ? 1 : 0;
    for (std::size_t i = first; i < leaves->size() + first; i += 2)
      join((*leaves)[i].triangle, (*leaves)[(i + 1) % leaves->size()].triangle);
  }

 private:
  [[nodiscard]] Vec3 point(int vertex) const { return mesh_.point(vertex) * normalisation_; }

  // Of all that is connected: by the sign of its volume. Of none where that is not certain.
  void find_inside_out() {
    DisjointSets parts(mesh_.polygon.size());
    for (const MeshEdge& edge : table_.edges) {
      const auto halfedges = table_.halfedges_of(edge);
      for (const int halfedge : halfedges.subspan(1)) parts.join(halfedges[0] / 3, halfedge / 3);
    }
    part_ = std::move(parts).roots();
    const std::size_t count = renumber_labels(part_).size();
    std::vector<Box> box(count);
    for (std::size_t t = 0; t < part_.size(); ++t)
      for (const int v : mesh_.triangle(static_cast<int>(t))) box[part_[t]].add(point(v));
    std::vector<double> volume(count, 0);
    for (std::size_t t = 0; t < part_.size(); ++t) {
      const auto [a, b, c] = mesh_.triangle(static_cast<int>(t));
      const Vec3& from = box[part_[t]].min;
      volume[part_[t]] += glm::dot(point(a) - from, glm::cross(point(b) - from, point(c) - from)) / 6;
    }
    for (std::size_t p = 0; p < count; ++p) {
      const Vec3 size = box[p].size();
      const double longest = std::max({size.x, size.y, size.z});
      const bool certain = std::abs(volume[p]) > least_volume * longest * longest * longest;
      sign_.push_back(static_cast<signed char>(!certain ? 0 : volume[p] > 0 ? 1 : -1));
    }
  }

  // In order around the edge, beginning and ending material by turns; nothing where there is no such order.
  [[nodiscard]] std::optional<std::vector<Leaf>> leaves_around(const MeshEdge& edge) const {
    const auto halfedges = table_.halfedges_of(edge);
    const int sign = sign_[part_[halfedges[0] / 3]];
    const Vec3 from = point(edge.vertex[0]);
    const Vec3 along = point(edge.vertex[1]) - from;
    const double length = glm::length(along);
    if (sign == 0 || !(length > rounding_)) return std::nullopt;
    const Vec3 axis = along / length;
    const Vec3 flattest = std::abs(axis.x) <= std::abs(axis.y) && std::abs(axis.x) <= std::abs(axis.z) ? Vec3(1, 0, 0)
                          : std::abs(axis.y) <= std::abs(axis.z)                                       ? Vec3(0, 1, 0)
                                                                                                       : Vec3(0, 0, 1);
    const Vec3 right = glm::normalize(glm::cross(axis, flattest)), up = glm::cross(axis, right);
    std::vector<Leaf> leaves;
    for (const int halfedge : halfedges) {
      const Vec3 to_apex = point(mesh_.corners[next_in_triangle(next_in_triangle(halfedge))]) - from;
      const Vec2 out(glm::dot(to_apex, right), glm::dot(to_apex, up));
      const double doubt = 2 * rounding_ / glm::length(out);
      if (!(doubt < most_doubt)) return std::nullopt;
      const bool forward = mesh_.corners[halfedge] == edge.vertex[0];
      leaves.push_back({halfedge / 3, portable_atan2(out.y, out.x), doubt, forward == (sign > 0)});
    }
    std::sort(leaves.begin(), leaves.end(), [](const Leaf& a, const Leaf& b) {
      return std::pair(a.angle, a.triangle) < std::pair(b.angle, b.triangle);
    });
    order_coincident(leaves);
    for (std::size_t i = 0; i < leaves.size(); ++i)
      if (leaves[i].ends_material == leaves[(i + 1) % leaves.size()].ends_material) return std::nullopt;
    return leaves;
  }

  // Faces of two bodies that lie on each other enclose nothing: there one body ends before the other begins.
  static void order_coincident(std::vector<Leaf>& leaves) {
    const auto gap_before = [&](std::size_t i) {
      return i > 0 ? leaves[i].angle - leaves[i - 1].angle
                   : leaves[0].angle - leaves.back().angle + 2 * std::numbers::pi;
    };
    std::size_t widest = 0;
    for (std::size_t i = 1; i < leaves.size(); ++i)
      if (gap_before(i) > gap_before(widest)) widest = i;
    for (std::size_t i = 0; i < widest; ++i) leaves[i].angle += 2 * std::numbers::pi;
    std::rotate(leaves.begin(), leaves.begin() + static_cast<std::ptrdiff_t>(widest), leaves.end());
    for (std::size_t begin = 0, end = 0; begin < leaves.size(); begin = end) {
      end = begin + 1;
      while (end < leaves.size() && gap_before(end) <= leaves[end - 1].doubt + leaves[end].doubt) ++end;
      std::stable_sort(leaves.begin() + static_cast<std::ptrdiff_t>(begin),
                       leaves.begin() + static_cast<std::ptrdiff_t>(end),
                       [](const Leaf& a, const Leaf& b) { return a.ends_material && !b.ends_material; });
    }
  }

  const Mesh& mesh_;
  const EdgeTable& table_;
  double normalisation_ = 1, rounding_ = 0;
  std::vector<int> part_;          ///< of each triangle, all joined
  std::vector<signed char> sign_;  ///< of the volume of each part
};

}  // namespace

std::vector<int> connected_parts(const Mesh& mesh, const EdgeTable& table) {
  DisjointSets parts(mesh.polygon.size());
  std::optional<Shells> shells;
  for (const MeshEdge& edge : table.edges) {
    if (may_touch_another(edge)) {
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
