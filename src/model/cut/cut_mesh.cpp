// SPDX-License-Identifier: Apache-2.0
#include "cut/cut_mesh.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <unordered_map>
#include <utility>

#include "base/parallel.hpp"
#include "cut/limits.hpp"
#include "cut/split_world.hpp"

namespace epura::cut {

namespace {

class Knife {
 public:
  Knife(const world::World& world, int model, const Sides& sides, std::optional<std::vector<bool>> whole)
      : world_(world), sides_(sides), first_(world.first_vertex[model]), mesh_(*world.models[model].mesh) {
    file_vertices_ = world.first_vertex[model + 1] - first_;
    is_uncut_ =
        whole ? std::move(*whole) : whole_bodies(world, model, [this](int, int vertex) { return -side(vertex); });
  }

  CutMesh cut(int first_triangle) {
    for (int t = 0; t < static_cast<int>(mesh_.polygon.size()); ++t) {
      const std::array<int, 3>& corners = world_.triangles[first_triangle + t];
      const auto side = [&](int i) { return sides_.of[corners[i]]; };
      if (!is_uncut_.empty() && is_uncut_[mesh_.body[t]]) {
        keep_triangle(t, {corners[0] - first_, corners[1] - first_, corners[2] - first_});
      } else if (side(0) == 0 && side(1) == 0 && side(2) == 0) {
        result_.in_plane.push_back(t);
      } else if (side(0) < 0 || side(1) < 0 || side(2) < 0) {
        cut_triangle(t, {corners[0] - first_, corners[1] - first_, corners[2] - first_});
      }
    }
    if (mesh_.report.wires > 0)
      for (const mesh::MeshEdge& edge : mesh_.edges)
        if (edge.wire) cut_wire(edge.vertex);
    return std::move(result_);
  }

 private:
  void keep_triangle(int triangle, const std::array<int, 3>& corners) {
    result_.uncut.push_back(static_cast<int>(result_.triangles.size()));
    result_.triangles.push_back(corners);
    result_.polygon.push_back(mesh_.polygon[triangle]);
    result_.body.push_back(mesh_.body[triangle]);
    result_.source.push_back(triangle);
  }

  [[nodiscard]] int side(int vertex) const { return vertex < file_vertices_ ? sides_.of[first_ + vertex] : 0; }

  void cut_triangle(int triangle, const std::array<int, 3>& corners) {
    std::vector<int> ring;
    for (std::size_t i = 0; i < 3; ++i) {
      const int a = corners[i], b = corners[(i + 1) % 3];
      if (side(a) <= 0) ring.push_back(a);
      if (side(a) * side(b) < 0) ring.push_back(cut_edge(std::min(a, b), std::max(a, b)));
    }
    for (std::size_t i = 2; i < ring.size(); ++i) {
      result_.triangles.push_back({ring[0], ring[i - 1], ring[i]});
      result_.polygon.push_back(mesh_.polygon[triangle]);
      result_.body.push_back(mesh_.body[triangle]);
      result_.source.push_back(triangle);
    }
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const int a = ring[i], b = ring[(i + 1) % ring.size()];
      if (side(a) == 0 && side(b) == 0)
        result_.segments.push_back({mesh_.body[triangle], {std::min(a, b), std::max(a, b)}, a > b ? 1 : -1, triangle});
    }
  }

  // A segment in the plane is kept.
  void cut_wire(const std::array<int, 2>& vertex) {
    const auto [a, b] = vertex;
    if (side(a) <= 0 && side(b) <= 0) return result_.wires.push_back(vertex);
    if (side(a) * side(b) >= 0) return;
    result_.wires.push_back({side(a) < 0 ? a : b, cut_edge(a, b)});
    result_.cuts_wires = true;
  }

  int cut_edge(int a, int b) {
    const std::uint64_t key = (static_cast<std::uint64_t>(a) << 32) | static_cast<std::uint32_t>(b);
    const auto [place, made] = made_.try_emplace(key, file_vertices_ + static_cast<int>(result_.points.size()));
    if (made) {
      // The numbering of vertices does not matter.
      const std::array<double, 2> distances{sides_.distance[first_ + a], sides_.distance[first_ + b]};
      const CutPoint cut =
          cut_point(world_.points[first_ + a], world_.points[first_ + b], distances, sides_.normalisation);
      result_.points.push_back(cut.point);
      result_.vertices.push_back(cut_vertex_on(mesh_, {a, b}, cut.t));
    }
    return place->second;
  }

  const world::World& world_;
  const Sides& sides_;
  int first_, file_vertices_;
  const mesh::Mesh& mesh_;
  std::vector<bool> is_uncut_;  ///< by body; empty if all are cut
  CutMesh result_;
  std::unordered_map<std::uint64_t, int> made_;  ///< edge -> vertex; never iterated, so its order does not matter
};

}  // namespace

double normalisation_of(const world::World& world) {
  const Vec3 reach = glm::max(glm::abs(world.box.min), glm::abs(world.box.max));
  const double size = std::max({reach.x, reach.y, reach.z});
  return size > 0 ? std::ldexp(1.0, -std::clamp(std::ilogb(size) + 1, -1000, 1000)) : 1.0;
}

double slack_of(const world::World& world) { return std::max(rounding_part / normalisation_of(world), world.rounding); }

Sides find_sides(const world::World& world, const scene::CuttingPlane& plane) {
  Sides sides{normalisation_of(world), {}, {}};
  sides.of.resize(world.points.size());
  sides.distance.resize(world.points.size());
  const Vec3 foot = plane.point * sides.normalisation;
  const double slack = std::max(rounding_part, world.rounding * sides.normalisation);
  parallel_for(world.points.size(), grain::light, [&](std::size_t begin, std::size_t end) {
    for (std::size_t v = begin; v < end; ++v) {
      const double distance = glm::dot(plane.normal, world.points[v] * sides.normalisation - foot);
      sides.distance[v] = distance;
      sides.of[v] = static_cast<signed char>(distance > slack ? 1 : distance < -slack ? -1 : 0);
    }
  });
  return sides;
}

CutMesh cut_mesh(const world::World& world, int model, const Sides& sides, std::optional<std::vector<bool>> whole) {
  return Knife(world, model, sides, std::move(whole)).cut(world.first_triangle[model]);
}

void keep_odd(std::vector<CutSegment>& segments) {
  std::sort(segments.begin(), segments.end());
  std::size_t kept = 0;
  for (std::size_t begin = 0, end = 0; begin < segments.size(); begin = end) {
    while (end < segments.size() && segments[end] == segments[begin]) ++end;
    if ((end - begin) % 2 == 0) continue;
    CutSegment one = segments[begin];
    int sense = 0;
    for (std::size_t i = begin; i < end; ++i) {
      sense += segments[i].sense;
      one.triangle = std::min(one.triangle, segments[i].triangle);
    }
    one.sense = std::clamp(sense, -1, 1);
    segments[kept++] = one;
  }
  segments.resize(kept);
}

}  // namespace epura::cut
