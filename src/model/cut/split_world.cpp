// SPDX-License-Identifier: Apache-2.0
#include "cut/split_world.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <memory>
#include <tuple>
#include <utility>

#include "cut/cut_mesh.hpp"
#include "mesh/edge_table.hpp"

namespace epura::cut {

namespace {

/// The pieces of one model.
class Splitter {
 public:
  Splitter(const world::World& world, int model, const CuttingSurface& surface, const SplitWorld& split)
      : surface_(surface),
        slack_(split.slack),
        normalisation_(normalisation_of(world)),
        first_(world.first_vertex[model]),
        mesh_(*world.models[model].mesh) {
    const auto begin = world.points.begin() + first_, end = world.points.begin() + world.first_vertex[model + 1];
    points_.assign(begin, end);
  }

  mesh::Mesh split(const world::Placed& placed) {
    for (int t = 0; t < mesh_.triangle_count(); ++t) split_triangle(t);
    if (mesh_.report.wires > 0)
      for (const mesh::MeshEdge& edge : mesh_.edges)
        if (edge.wire) split_wire(edge.vertex);
    return make_mesh(placed);
  }

  [[nodiscard]] const std::vector<Vec3>& points() const { return points_; }
  [[nodiscard]] const std::vector<int>& regions() const { return regions_; }

 private:
  using Ring = std::vector<int>;

  [[nodiscard]] int side(const CutBorder& border, int vertex) const { return side_of(border, points_[vertex], slack_); }

  // The parts of a convex ring on both sides of a border: inside, outside. A ring within the border is inside if the
  // material is.
  std::array<Ring, 2> halves(const Ring& ring, const CutBorder& border, bool material_inside) {
    std::array<Ring, 2> parts;
    std::array<bool, 2> used{};
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const int a = ring[i], b = ring[(i + 1) % ring.size()];
      const int at_a = side(border, a), at_b = side(border, b);
      if (at_a != 0) used[at_a > 0 ? 1 : 0] = true;
      if (at_a <= 0) parts[0].push_back(a);
      if (at_a >= 0) parts[1].push_back(a);
      if (at_a * at_b >= 0) continue;
      const int made = vertex_on(a, b, border);
      for (Ring& part : parts) part.push_back(made);
    }
    if (!used[0] && !used[1]) used[material_inside ? 0 : 1] = true;
    for (std::size_t i = 0; i < 2; ++i)
      if (!used[i]) parts[i].clear();
    return parts;
  }

  int vertex_on(int a, int b, const CutBorder& border) {
    const auto [low, high] = std::minmax(a, b);
    // Borders of neighbouring regions are the same plane, and split an edge only once.
    const auto key = std::tuple(low, high, border.point.x, border.point.y, border.point.z);
    const auto [place, made] = made_.try_emplace(key, static_cast<int>(points_.size()));
    if (made) {
      const auto distance = [&](int v) {
        return glm::dot(border.normal, (points_[v] - border.point) * normalisation_);
      };
      const CutPoint cut =
          cut_point(points_[low], points_[high], std::array{distance(low), distance(high)}, normalisation_);
      points_.push_back(cut.point);
      vertices_.push_back(origin(low, high, cut.t));
    }
    return place->second;
  }

  // Of a vertex between two others, which may be split from edges of the file themselves.
  [[nodiscard]] mesh::CutVertex origin(int low, int high, double t) const {
    const int count = static_cast<int>(mesh_.points.size());
    if (high < count) return {{low, high}, t};
    const mesh::CutVertex& end = vertices_[high - count];
    double start = 0;
    if (low >= count) {
      if (vertices_[low - count].edge != end.edge) return {{-1, -1}, 0};
      start = vertices_[low - count].t;
    } else if (low == end.edge[0] || low == end.edge[1]) {
      start = low == end.edge[0] ? 0 : 1;
    } else {
      return {{-1, -1}, 0};
    }
    return end.edge[0] < 0 ? mesh::CutVertex{{-1, -1}, 0} : mesh::CutVertex{end.edge, start + t * (end.t - start)};
  }

  void split_triangle(int triangle) {
    const std::array<int, 3> corners = mesh_.triangle(triangle);
    const Vec3 normal =
        glm::cross(points_[corners[1]] - points_[corners[0]], points_[corners[2]] - points_[corners[0]]);
    std::vector<Ring> rest{{corners.begin(), corners.end()}};
    for (std::size_t r = 0; r < surface_.regions.size() && !rest.empty(); ++r) {
      std::vector<Ring> beyond;
      for (const Ring& ring : rest) {
        Ring inside = ring;
        for (const CutBorder& border : surface_.regions[r].borders) {
          if (inside.empty()) break;
          auto [within, out] = halves(inside, border, glm::dot(normal, border.normal) > 0);
          inside = std::move(within);
          if (!out.empty()) beyond.push_back(std::move(out));
        }
        if (!inside.empty()) add(triangle, inside, static_cast<int>(r));
      }
      rest = std::move(beyond);
    }
  }

  void add(int triangle, const Ring& ring, int region) {
    for (std::size_t i = 2; i < ring.size(); ++i) {
      corners_.insert(corners_.end(), {ring[0], ring[i - 1], ring[i]});
      polygon_.push_back(mesh_.polygon[triangle]);
      body_.push_back(mesh_.body[triangle]);
      regions_.push_back(region);
    }
  }

  void split_wire(const std::array<int, 2>& ends) {
    std::vector<std::array<int, 2>> rest{ends};
    for (const CutRegion& region : surface_.regions)
      for (const CutBorder& border : region.borders) {
        std::vector<std::array<int, 2>> parts;
        for (const auto& [a, b] : rest) {
          if (side(border, a) * side(border, b) >= 0) {
            parts.push_back({a, b});
            continue;
          }
          const int made = vertex_on(a, b, border);
          parts.insert(parts.end(), {{a, made}, {made, b}});
        }
        rest = std::move(parts);
      }
    wires_.insert(wires_.end(), rest.begin(), rest.end());
  }

  mesh::Mesh make_mesh(const world::Placed& placed) {
    mesh::Mesh split;
    split.points = mesh_.points;
    const Mat4 to_file = glm::inverse(placed.to_world);
    for (std::size_t v = mesh_.points.size(); v < points_.size(); ++v) {
      const Vec3 p(to_file * Vec4(points_[v], 1));
      split.points.push_back({p.x, p.y, p.z});
    }
    split.corners = std::move(corners_);
    split.polygon = std::move(polygon_);
    mesh::make_edges(split, wires_);
    split.body = std::move(body_);
    split.report = mesh_.report;
    split.cut_vertices = std::move(vertices_);
    split.first_cut_vertex = static_cast<int>(mesh_.points.size());
    split.uncut = placed.mesh;
    return split;
  }

  const CuttingSurface& surface_;
  double slack_, normalisation_;
  int first_;
  const mesh::Mesh& mesh_;
  std::vector<Vec3> points_;
  std::vector<mesh::CutVertex> vertices_;
  std::vector<int> corners_, polygon_, body_, regions_;
  std::vector<std::array<int, 2>> wires_;
  std::map<std::tuple<int, int, double, double, double>, int> made_;  ///< edge and border -> vertex
};

}  // namespace

CutPoint cut_point(const Vec3& a, const Vec3& b, const std::array<double, 2>& distances, double normalisation) {
  const auto place_of = [](const Vec3& p) { return std::array{p.x, p.y, p.z}; };
  const auto [at_a, at_b] = distances;
  const bool forward = place_of(a) < place_of(b);
  const double part = forward ? at_a / (at_a - at_b) : at_b / (at_b - at_a);
  // Normalised first: the difference of two large coordinates may overflow.
  const Vec3 p = (forward ? a : b) * normalisation, q = (forward ? b : a) * normalisation;
  return {(p + part * (q - p)) / normalisation, at_a / (at_a - at_b)};
}

mesh::CutVertex cut_vertex_on(const mesh::Mesh& mesh, const std::array<int, 2>& edge, double t) {
  const mesh::EdgeOrigin origin = mesh.origin_of({edge, 0, 0, false, mesh::CutEdge::none, false});
  if (!origin.in_file) return {{-1, -1}, 0};
  return {origin.vertex, origin.t[0] + t * (origin.t[1] - origin.t[0])};
}

SplitWorld split_world(const world::World& world, const CuttingSurface& surface) {
  SplitWorld split{world::without_models(world), {}, slack_of(world)};
  world::World& result = split.world;
  for (int model = 0; model < static_cast<int>(world.models.size()); ++model) {
    const world::Placed& placed = world.models[model];
    Splitter splitter(world, model, surface, split);
    const auto mesh = std::make_shared<const mesh::Mesh>(splitter.split(placed));
    const int first = result.first_vertex.back();
    result.points.insert(result.points.end(), splitter.points().begin(), splitter.points().end());
    for (int t = 0; t < mesh->triangle_count(); ++t) {
      std::array<int, 3> corners = mesh->triangle(t);
      for (int& v : corners) v += first;
      result.triangles.push_back(corners);
    }
    split.region_of_triangle.insert(split.region_of_triangle.end(), splitter.regions().begin(),
                                    splitter.regions().end());
    result.first_vertex.push_back(static_cast<int>(result.points.size()));
    result.first_triangle.push_back(static_cast<int>(result.triangles.size()));
    result.models.push_back({mesh, placed.to_world, placed.part, placed.threads, placed.copy_of});
    if (!world.wires.empty()) world::append_wires(result, *mesh, first);
  }
  return split;
}

}  // namespace epura::cut
