// SPDX-License-Identifier: Apache-2.0
#include "edges/graph_patches.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <tuple>
#include <utility>

#include "base/disjoint_sets.hpp"
#include "base/error.hpp"
#include "base/nearest.hpp"
#include "base/parallel.hpp"
#include "edges/limits.hpp"
#include "search/triangle_tree.hpp"

namespace epura::edges {

namespace {

// Smaller patches have few pairs of triangles to skip.
constexpr std::size_t min_of_patch = 1024;

/// The coordinate plane over which a triangle lies, and the side to which it faces: 0 to 5.
using Facing = std::int8_t;
constexpr Facing no_facing = -1;

// Coordinates on the plane, turned so that triangles that face its side are counterclockwise.
Vec2 on_plane(const Vec3& p, Facing facing) {
  const int axis = facing / 2;
  const Vec2 q(p[(axis + 1) % 3], p[(axis + 2) % 3]);
  return facing % 2 == 0 ? q : Vec2(q.y, q.x);
}

/// A side of a triangle at the boundary of its patch, with the patch on its left.
struct BoundarySide {
  int patch;
  std::array<int, 2> vertex;  ///< of the world, from start to end

  auto operator<=>(const BoundarySide&) const = default;
};

class GraphPatches {
 public:
  GraphPatches(const world::World& world, std::span<const Vec3> points, double contact,
               const std::vector<int>& triangles, const std::vector<int>& taken)
      : world_(world),
        points_(points),
        clearance_(contact),
        triangles_(triangles),
        facing_(world.triangles.size(), no_facing),
        patch_(world.triangles.size(), -1) {
    parallel_for(triangles.size(), grain::light, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i)
        if (taken.empty() || taken[i] < 0) facing_[triangles[i]] = facing_of(triangles[i]);
    });
  }

  std::vector<int> find() {
    number_patches();
    if (facing_of_patch_.empty()) return {};
    const std::vector<BoundarySide> boundary = find_boundary();
    std::vector<char> is_graph(facing_of_patch_.size(), 1);
    reject_touching(boundary, is_graph);
    for (auto begin = boundary.begin(); begin != boundary.end();) {
      const auto end =
          std::find_if(begin, boundary.end(), [&](const BoundarySide& s) { return s.patch != begin->patch; });
      if (is_graph[begin->patch] != 0 && !has_one_outline({begin, end})) is_graph[begin->patch] = 0;
      begin = end;
    }
    return patches_of_triangles(is_graph);
  }

 private:
  [[nodiscard]] Facing facing_of(int triangle) const {
    const auto& [a, b, c] = world_.triangles[triangle];
    const Vec3 area = glm::cross(points_[b] - points_[a], points_[c] - points_[a]);
    const Vec3 size = glm::abs(area);
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    return static_cast<Facing>(2 * axis + (area[axis] < 0 ? 1 : 0));
  }

  template <class Visit>
  void visit_edges(const Visit& visit) const {
    for (std::size_t model = 0; model < world_.models.size(); ++model) {
      const mesh::Mesh& mesh = *world_.models[model].mesh;
      if (mesh.polygon.size() < min_of_patch) continue;
      visit(mesh, world_.first_triangle[model], world_.first_vertex[model]);
    }
  }

  // Neighbours that face the same side of the same plane form a patch.
  void number_patches() {
    DisjointSets sets(world_.triangles.size());
    visit_edges([&](const mesh::Mesh& mesh, int first, int) {
      for (const mesh::MeshEdge& edge : mesh.edges) {
        const auto both = mesh.triangles_of(edge);
        if (both.size() != 2) continue;
        const int a = first + both[0], b = first + both[1];
        if (facing_[a] == facing_[b] && facing_[a] != no_facing) sets.join(a, b);
      }
    });
    const std::vector<int> roots = std::move(sets).roots();
    std::vector<int> count(world_.triangles.size(), 0);
    for (const int root : roots) ++count[root];
    std::vector<int> number(world_.triangles.size(), -1);
    for (std::size_t t = 0; t < roots.size(); ++t) {
      const int root = roots[t];
      if (static_cast<std::size_t>(count[root]) < min_of_patch) continue;
      if (number[root] < 0) {
        number[root] = static_cast<int>(facing_of_patch_.size());
        facing_of_patch_.push_back(facing_[root]);
      }
      patch_[t] = number[root];
    }
    check(facing_of_patch_.size() * min_of_patch <= world_.triangles.size(),
          "patches have many triangles of their own");
  }

  // Whether the triangle has the corners a, b in this order.
  [[nodiscard]] bool runs_from(int triangle, int a, int b) const {
    const auto& c = world_.triangles[triangle];
    return (c[0] == a && c[1] == b) || (c[1] == a && c[2] == b) || (c[2] == a && c[0] == b);
  }

  // Appends the sides that do not cancel.
  void add_sides(std::span<const int> triangles, int first, const std::array<int, 2>& ends,
                 std::vector<BoundarySide>& sides) const {
    const std::size_t begin = sides.size();
    for (const int t : triangles) {
      const int patch = patch_[first + t];
      if (patch < 0) continue;
      const BoundarySide side = runs_from(first + t, ends[0], ends[1]) ? BoundarySide{patch, {ends[0], ends[1]}}
                                                                       : BoundarySide{patch, {ends[1], ends[0]}};
      const BoundarySide reversed{patch, {side.vertex[1], side.vertex[0]}};
      const auto same = std::find(sides.begin() + static_cast<std::ptrdiff_t>(begin), sides.end(), reversed);
      if (same == sides.end())
        sides.push_back(side);
      else
        sides.erase(same);
    }
  }

  [[nodiscard]] std::vector<BoundarySide> find_boundary() const {
    std::vector<BoundarySide> all;
    visit_edges([&](const mesh::Mesh& mesh, int first, int first_vertex) {
      std::vector<std::vector<BoundarySide>> found(mesh.edges.size() / grain::light + 1);
      parallel_for(found.size(), 1, [&](std::size_t begin, std::size_t end) {
        for (std::size_t part = begin; part < end; ++part)
          for (std::size_t e = part * grain::light; e < std::min(mesh.edges.size(), (part + 1) * grain::light); ++e)
            add_sides(mesh.triangles_of(mesh.edges[e]), first,
                      {first_vertex + mesh.edges[e].vertex[0], first_vertex + mesh.edges[e].vertex[1]}, found[part]);
      });
      for (const std::vector<BoundarySide>& part : found) all.insert(all.end(), part.begin(), part.end());
    });
    std::sort(all.begin(), all.end());
    return all;
  }

  [[nodiscard]] std::array<Vec2, 2> line_of(const BoundarySide& side) const {
    const Facing facing = facing_of_patch_[side.patch];
    return {on_plane(points_[side.vertex[0]], facing), on_plane(points_[side.vertex[1]], facing)};
  }

  // The sides of each patch have a height of their own, where all their boxes lie.
  void reject_touching(const std::vector<BoundarySide>& boundary, std::vector<char>& is_graph) const {
    const search::TriangleTree tree(boundary.size(), [&](int i) {
      Box box;
      for (const Vec2& p : line_of(boundary[i])) {
        box.add(Vec3(p - clearance_, boundary[i].patch));
        box.add(Vec3(p + clearance_, boundary[i].patch));
      }
      return box;
    });
    const auto tasks = tree.tasks(64);
    for (const auto& task : tasks)
      tree.search(task, [&](int i, int j) {
        const BoundarySide &a = boundary[i], &b = boundary[j];
        if (a.patch == b.patch && is_graph[a.patch] != 0 && !are_apart(a, b)) is_graph[a.patch] = 0;
      });
  }

  [[nodiscard]] bool are_apart(const BoundarySide& a, const BoundarySide& b) const {
    const std::array<Vec2, 2> one = line_of(a), two = line_of(b);
    const auto is_far = [&](const Vec2& p, const std::array<Vec2, 2>& line) {
      return distance_to_segment(p, line[0], line[1]) > clearance_;
    };
    bool meet = false;
    for (std::size_t i = 0; i < 2; ++i)
      for (std::size_t j = 0; j < 2; ++j)
        if (a.vertex[i] == b.vertex[j]) {
          if (meet || !is_far(one[1 - i], two) || !is_far(two[1 - j], one)) return false;
          meet = true;
        }
    if (meet) return true;
    return is_far(one[0], two) && is_far(one[1], two) && is_far(two[0], one) && is_far(two[1], one) &&
           !sides_cross(one, two);
  }

  static bool sides_cross(const std::array<Vec2, 2>& a, const std::array<Vec2, 2>& b) {
    const auto is_left = [](const std::array<Vec2, 2>& line, const Vec2& p) {
      const Vec2 along = line[1] - line[0], to = p - line[0];
      return cross(along, to) > 0;
    };
    return is_left(a, b[0]) != is_left(a, b[1]) && is_left(b, a[0]) != is_left(b, a[1]);
  }

  /// A side as seen from a vertex at which it ends or begins.
  struct Ray {
    int vertex;
    double angle;
    int side;  ///< in the list of the patch
    bool leaves;
  };

  // Whether exactly one loop of the boundary is counterclockwise. Where several loops touch, sides that come in go on
  // with the next one counterclockwise, across the outside of the patch, so that loops do not cross.
  [[nodiscard]] bool has_one_outline(std::span<const BoundarySide> sides) const {
    const auto next = successors(sides);
    if (next.empty()) return false;
    int outlines = 0;
    std::vector<char> used(sides.size(), 0);
    for (std::size_t start = 0; start < sides.size(); ++start) {
      if (used[start] != 0) continue;
      const Vec2 origin = line_of(sides[start])[0];
      double area = 0, reach = 0;
      std::size_t count = 0;
      std::size_t i = start;
      for (; used[i] == 0; i = static_cast<std::size_t>(next[i]), ++count) {
        used[i] = 1;
        const auto [p, q] = line_of(sides[i]);
        area += (p.x - origin.x) * (q.y - origin.y) - (p.y - origin.y) * (q.x - origin.x);
        reach = std::max(reach, glm::dot(q - origin, q - origin));
      }
      check(i == start, "an outline ends where it begins");
      if (std::abs(area) <= static_cast<double>(count) * product_rounding * reach) return false;
      outlines += area > 0 ? 1 : 0;
    }
    return outlines == 1;
  }

  // Returns the side after each one; nothing unless sides come in and leave in turn around each vertex.
  [[nodiscard]] std::vector<int> successors(std::span<const BoundarySide> sides) const {
    std::vector<Ray> rays;
    for (int i = 0; i < static_cast<int>(sides.size()); ++i) {
      const auto [p, q] = line_of(sides[i]);
      rays.push_back({sides[i].vertex[0], std::atan2(q.y - p.y, q.x - p.x), i, true});
      rays.push_back({sides[i].vertex[1], std::atan2(p.y - q.y, p.x - q.x), i, false});
    }
    std::sort(rays.begin(), rays.end(), [](const Ray& a, const Ray& b) {
      return std::tie(a.vertex, a.angle, a.side) < std::tie(b.vertex, b.angle, b.side);
    });
    std::vector<int> next(sides.size(), -1);
    for (std::size_t begin = 0; begin < rays.size();) {
      std::size_t end = begin;
      while (end < rays.size() && rays[end].vertex == rays[begin].vertex) ++end;
      for (std::size_t i = begin; i < end; ++i) {
        const Ray& after = rays[i + 1 < end ? i + 1 : begin];
        if (rays[i].leaves == after.leaves) return {};
        if (!rays[i].leaves) next[rays[i].side] = after.side;
      }
      begin = end;
    }
    check(std::find(next.begin(), next.end(), -1) == next.end(), "a side follows each side of an outline");
    return next;
  }

  [[nodiscard]] std::vector<int> patches_of_triangles(const std::vector<char>& is_graph) const {
    std::vector<int> number(is_graph.size(), -1);
    int count = 0;
    for (std::size_t p = 0; p < is_graph.size(); ++p)
      if (is_graph[p] != 0) number[p] = count++;
    if (count == 0) return {};
    std::vector<int> patches(triangles_.size(), -1);
    for (std::size_t i = 0; i < triangles_.size(); ++i)
      if (const int patch = patch_[triangles_[i]]; patch >= 0) patches[i] = number[patch];
    return patches;
  }

  const world::World& world_;
  std::span<const Vec3> points_;
  double clearance_;
  const std::vector<int>& triangles_;
  std::vector<Facing> facing_;  // by triangle of the world
  std::vector<int> patch_;      // by triangle of the world
  std::vector<Facing> facing_of_patch_;
};

// Patches hardly ever reach beyond a body.
bool has_large_body(const world::World& world) {
  return std::any_of(world.models.begin(), world.models.end(), [](const world::Placed& placed) {
    std::vector<std::size_t> count(static_cast<std::size_t>(placed.mesh->report.bodies) + 1, 0);
    for (const int body : placed.mesh->body)
      if (++count[static_cast<std::size_t>(body)] >= min_of_patch) return true;
    return false;
  });
}

}  // namespace

std::vector<int> graph_patches(const world::World& world, std::span<const Vec3> points, double contact,
                               const std::vector<int>& triangles, const std::vector<int>& taken) {
  if (triangles.size() < min_of_patch || contact < min_contact || !has_large_body(world)) return {};
  std::vector<int> patches = GraphPatches(world, points, contact, triangles, taken).find();
  check(patches.empty() || patches.size() == triangles.size(), "every triangle is of a patch or not");
  return patches;
}

}  // namespace epura::edges
