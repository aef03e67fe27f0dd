// SPDX-License-Identifier: Apache-2.0
#include "edges/smooth_contours.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>
#include <vector>

#include "base/error.hpp"
#include "base/groups.hpp"
#include "base/nearest.hpp"
#include "base/parallel.hpp"
#include "edges/limits.hpp"
#include "edges/own_hiding.hpp"

namespace epura::edges {

namespace {

using surfaces::SurfaceKind;

SurfaceKind kind_at(const world::Placed& placed, int triangle) {
  const int face = placed.part->face_of_triangle[triangle];
  return placed.part->faces[static_cast<std::size_t>(face)].surface.kind;
}

// Whether contours at a triangle are moved to the surface, wherever they end.
bool is_smoothed(const world::Placed& placed, int triangle) {
  const SurfaceKind kind = kind_at(placed, triangle);
  if (kind == SurfaceKind::free_form) return placed.mesh->report.misoriented_edges == 0;
  return kind == SurfaceKind::sphere || kind == SurfaceKind::torus;
}

// Whether contours at a triangle are edges of the mesh already (refine/refine_world.hpp).
bool is_refined(const world::Placed& placed, int triangle) {
  const SurfaceKind kind = kind_at(placed, triangle);
  return kind == SurfaceKind::cylinder || kind == SurfaceKind::cone;
}

double longest_side(const mesh::Mesh& mesh, int triangle) {
  const auto [a, b, c] = mesh.triangle(triangle);
  const Vec3 p = mesh.point(a), q = mesh.point(b), r = mesh.point(c);
  return std::max({glm::distance(p, q), glm::distance(q, r), glm::distance(r, p)});
}

// Whether one of the triangles is so small that which way it faces means nothing.
bool is_any_tiny(const world::Placed& placed, std::span<const int> triangles) {
  const double most = tiny_triangle * placed.part->tolerance;
  return std::ranges::any_of(triangles, [&](int t) { return longest_side(*placed.mesh, t) <= most; });
}

/// The contours of one model, in units of its file.
class ModelContours {
 public:
  ModelContours(const world::Placed& placed, const projection::Projection& projection, double part_angle)
      : placed_(placed),
        mesh_(*placed.mesh),
        part_(*placed.part),
        central_(projection.central),
        part_angle_(part_angle) {
    const Mat4 to_file = glm::inverse(placed.to_world);
    projector_ = Vec3(to_file * Vec4(projection.projector, central_ ? 1 : 0));
    check(central_ || glm::length(projector_) > 0, "parallel projectors have a direction");
    at_vertex_ = Groups<int>(mesh_.points.size(), [&](const auto& visit) {
      for (std::size_t i = 0; i < mesh_.corners.size(); ++i)
        visit(static_cast<std::size_t>(mesh_.corners[i]), static_cast<int>(i / 3));
    });
    // The largest angle between faces of the part at each vertex.
    angle_at_.assign(mesh_.points.size(), 0);
    for (std::size_t e = 0; e < mesh_.edges.size(); ++e) {
      const surfaces::PartBorder* border = part_.border_at(static_cast<std::ptrdiff_t>(e));
      if (mesh_.edges[e].count == 0) continue;
      const bool open = mesh_.edges[e].count != 2;
      if (border == nullptr && !open) continue;
      const double angle = open ? 180 : border->angle;
      for (const int v : mesh_.edges[e].vertex) angle_at_[v] = std::max(angle_at_[v], angle);
    }
  }

  /// Returns the point on the contour of the surface that is nearest to a vertex; nothing if the vertex is not moved.
  [[nodiscard]] std::optional<Vec3> moved(int vertex) const {
    if (angle_at_[vertex] > part_angle_) return std::nullopt;
    const Vec3 from = mesh_.point(vertex);
    std::optional<Vec3> nearest;
    int on_triangle = -1;
    for (const int t : sorted_triangles_at(vertex)) {
      if (is_refined(placed_, t)) continue;
      if (surface_of(t).kind == SurfaceKind::sphere) return on_sphere(vertex, t);
      const auto line = contour_across(t);
      if (!line) continue;
      const Vec3 place = nearest_on_segment(from, (*line)[0], (*line)[1]);
      if (glm::distance(place, from) > size_of(t)) continue;  // farther, it is no contour of these facets
      if (nearest && glm::distance(place, from) >= glm::distance(*nearest, from)) continue;
      nearest = place;
      on_triangle = t;
    }
    return nearest ? on_surface(*nearest, from, on_triangle) : std::nullopt;
  }

  /// Judges where the face of a contour hides it, if both triangles are of one face, seen from outside only.
  void judge(std::span<const int> triangles, const std::array<Vec3, 2>& ends, FeatureEdge& contour) const {
    const bool is_solid = mesh_.report.open_edges == 0 && mesh_.report.misoriented_edges == 0;
    const int face = part_.face_of_triangle[triangles[0]];
    if (part_.face_of_triangle[triangles[1]] != face || !is_solid) return;
    const std::array<Vec3, 2> views{glm::normalize(towards_viewer(ends[0])), glm::normalize(towards_viewer(ends[1]))};
    judge_own_hiding(part_.faces[static_cast<std::size_t>(face)], ends, views, contour);
  }

  /// Whether an edge between two triangles of one face is a contour only because the tessellation turned one of them
  /// over: at their corners, the surface nowhere faces the other way. A facet of a free form that is seen edge-on is
  /// not turned over: it is a wall.
  [[nodiscard]] bool is_by_chance(std::span<const int> triangles) const {
    if (part_.face_of_triangle[triangles[0]] != part_.face_of_triangle[triangles[1]]) return false;
    if (std::ranges::any_of(triangles, [&](int t) { return is_wall(t); })) return false;
    bool front = false, back = false;
    for (const int t : triangles)
      for (const int corner : mesh_.triangle(t)) {
        const double facing = glm::dot(normal_at(corner, t), glm::normalize(towards_viewer(mesh_.point(corner))));
        front = front || facing > along_projector;
        back = back || facing < -along_projector;
      }
    return front != back;
  }

 private:
  // Moves a place on a facet onto the surface of the face; nothing if that is farther away than the facet is long: then
  // the facets do not represent this surface.
  [[nodiscard]] std::optional<Vec3> on_surface(const Vec3& place, const Vec3& vertex, int triangle) const {
    const surfaces::PartSurface& surface = surface_of(triangle);
    if (surface.kind == SurfaceKind::free_form) return place;
    const double distance = surfaces::signed_distance(surface, place), longest = longest_side(mesh_, triangle);
    if (!(std::abs(distance) <= longest)) return std::nullopt;
    const Vec3 moved = place - distance * surfaces::normal_near(surface, place);
    check(glm::distance(moved, vertex) <= 2.001 * longest, "a contour stays beside its facets");
    return moved;
  }

  // Returns the point nearest to a vertex of the circle in which projectors touch a sphere. Nothing if it is some
  // facets away, or on the page farther than the sphere falls over so many: four times its sagitta over one.
  [[nodiscard]] std::optional<Vec3> on_sphere(int vertex, int triangle) const {
    constexpr int rounds = 4;  // projectors through a centre depend on the place
    const surfaces::PartSurface& sphere = surface_of(triangle);
    const Vec3 from = mesh_.point(vertex), out = glm::normalize(from - sphere.origin);
    Vec3 place = from, view(0);
    for (int round = 0; round < (central_ ? rounds : 1); ++round) {
      view = glm::normalize(towards_viewer(place));
      const Vec3 normal = out - glm::dot(out, view) * view;
      if (!(glm::length(normal) > along_projector)) return std::nullopt;
      place = sphere.origin + sphere.radius * glm::normalize(normal);
    }
    double side = 0, sagitta = 0;
    for (const int t : sorted_triangles_at(vertex))
      for (const int corner : mesh_.triangle(t)) {
        side = std::max(side, glm::distance(mesh_.point(corner), from));
        sagitta = std::max(sagitta, -surfaces::signed_distance(sphere, (mesh_.point(corner) + from) / 2.0));
      }
    const Vec3 moved = place - from;
    const double on_page = glm::length(moved - glm::dot(moved, view) * view);
    const bool is_near =
        glm::length(moved) <= max_facets_away * side && on_page <= 4 * max_facets_away * max_facets_away * sagitta;
    return is_near ? std::optional(place) : std::nullopt;
  }

  [[nodiscard]] const surfaces::PartSurface& surface_of(int triangle) const {
    return part_.faces[static_cast<std::size_t>(part_.face_of_triangle[triangle])].surface;
  }

  // Sorted because their order in the groups differs from run to run.
  [[nodiscard]] std::vector<int> sorted_triangles_at(int vertex) const {
    const auto there = at_vertex_[static_cast<std::size_t>(vertex)];
    std::vector<int> triangles(there.begin(), there.end());
    std::sort(triangles.begin(), triangles.end());
    return triangles;
  }

  [[nodiscard]] Vec3 towards_viewer(const Vec3& point) const { return central_ ? projector_ - point : projector_; }

  [[nodiscard]] bool is_wall(int triangle) const {
    if (surface_of(triangle).kind != SurfaceKind::free_form) return false;
    const Vec3 normal = normal_of(triangle), view = towards_viewer(mesh_.point(mesh_.triangle(triangle)[0]));
    return std::abs(glm::dot(normal, view)) <= along_projector * glm::length(normal) * glm::length(view);
  }

  // Its length is twice the area.
  [[nodiscard]] Vec3 normal_of(int triangle) const {
    const auto [a, b, c] = mesh_.triangle(triangle);
    return glm::cross(mesh_.point(b) - mesh_.point(a), mesh_.point(c) - mesh_.point(a));
  }

  // Height above the longest side; that side itself on tori, near whose cusps a contour of facets takes detours.
  [[nodiscard]] double size_of(int triangle) const {
    const double longest = longest_side(mesh_, triangle);
    if (is_ring_torus(surface_of(triangle))) return longest;
    return longest > 0 ? glm::length(normal_of(triangle)) / longest : 0;
  }

  // The normal of the face to which a triangle belongs, at one of its corners; for a free form the mean of its facets
  // there.
  [[nodiscard]] Vec3 normal_at(int vertex, int triangle) const {
    const surfaces::PartSurface& surface = surface_of(triangle);
    if (surface.kind != SurfaceKind::free_form) return surfaces::normal_near(surface, mesh_.point(vertex));
    Vec3 sum(0);
    for (const int t : sorted_triangles_at(vertex))
      if (part_.face_of_triangle[t] == part_.face_of_triangle[triangle]) sum += normal_of(t);
    const double length = glm::length(sum);
    return length > 0 ? sum / length : sum;
  }

  // The segment across a triangle along which interpolated normals are perpendicular to the projectors.
  [[nodiscard]] std::optional<std::array<Vec3, 2>> contour_across(int triangle) const {
    const std::array<int, 3> corners = mesh_.triangle(triangle);
    std::array<double, 3> facing{};
    for (std::size_t i = 0; i < 3; ++i)
      facing[i] = glm::dot(normal_at(corners[i], triangle), towards_viewer(mesh_.point(corners[i])));
    std::array<Vec3, 3> met{};
    std::size_t count = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t j = (i + 1) % 3;
      if ((facing[i] < 0) == (facing[j] < 0)) continue;
      const double t = facing[i] / (facing[i] - facing[j]);
      check(t >= 0 && t <= 1, "a contour crosses a side between its ends");
      met[count++] = mesh_.point(corners[i]) + t * (mesh_.point(corners[j]) - mesh_.point(corners[i]));
    }
    // A contour that only touches a corner leads nowhere.
    const bool crosses = count == 2 && glm::distance(met[0], met[1]) > on_both * longest_side(mesh_, triangle);
    return crosses ? std::optional(std::array{met[0], met[1]}) : std::nullopt;
  }

  const world::Placed& placed_;
  const mesh::Mesh& mesh_;
  const surfaces::PartFaces& part_;
  bool central_;
  double part_angle_;
  Vec3 projector_;  ///< the centre of projection, or a direction towards the viewer
  Groups<int> at_vertex_;
  std::vector<double> angle_at_;
};

/// Moves ends of contours.
class MovedEnds {
 public:
  MovedEnds(const world::World& world, view::ProjectedScene& view, FeatureEdges& drawn)
      : world_(world), view_(view), drawn_(drawn) {}

  void move(int model, double part_angle) {
    const world::Placed& placed = world_.models[model];
    const std::vector<int> edges = smoothed_edges(model, part_angle);
    if (edges.empty()) return;
    const ModelContours contours(placed, view_.projection, part_angle);
    for (const int e : edges) drawn_.edges[e].by_chance = contours.is_by_chance(triangles_at(drawn_.edges[e]));
    for (const int e : around_single_facets(model, part_angle)) drawn_.edges[e].by_chance = true;
    const int first = world_.first_vertex[model];
    std::vector<int> vertices;
    for (const int e : edges)
      for (const int v : drawn_.edges[e].vertex) vertices.push_back(v);
    const std::vector<int> fixed = fixed_ends(model, edges);
    std::sort(vertices.begin(), vertices.end());
    vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
    check(vertices.front() >= first && vertices.back() < static_cast<int>(view_.vertices.size()),
          "whole contours end at vertices of their model");
    std::vector<std::optional<Vec3>> places(vertices.size());
    parallel_for(vertices.size(), grain::heavy, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) places[i] = contours.moved(vertices[i] - first);
    });
    const auto number = [&](int v) {
      return static_cast<std::size_t>(std::lower_bound(vertices.begin(), vertices.end(), v) - vertices.begin());
    };
    std::vector<int> shown(vertices.size(), -1);
    for (std::size_t i = 0; i < vertices.size(); ++i)
      if (places[i] && !std::binary_search(fixed.begin(), fixed.end(), vertices[i]))
        shown[i] = add(Vec3(placed.to_world * Vec4(*places[i], 1)));
    const Groups<int> edges_at(vertices.size(), [&](const auto& visit) {
      for (const int e : edges)
        for (const int v : drawn_.edges[e].vertex) visit(number(v), e);
    });
    for (const int e : edges) {
      FeatureEdge& edge = drawn_.edges[e];
      std::array<Vec3, 2> ends;
      for (std::size_t end = 0; end < 2; ++end) {
        const std::size_t i = number(edge.vertex[end]);
        edge.shown[end] = shown[i];
        ends[end] = shown[i] < 0 ? placed.mesh->point(edge.vertex[end] - first) : *places[i];
      }
      contours.judge(triangles_at(edge), ends, edge);
    }
    for (std::size_t i = 0; i < vertices.size(); ++i) {
      if (shown[i] < 0) continue;
      std::vector<int> around;
      for (const int e : edges_at[i])
        for (const int v : drawn_.edges[e].vertex)
          around.insert(around.end(), edges_at[number(v)].begin(), edges_at[number(v)].end());
      drawn_.moved = std::max(drawn_.moved, distance_moved(vertices[i], shown[i], around));
    }
  }

 private:
  // Contours of the model inside smoothed faces, if they are entirely in the window.
  [[nodiscard]] std::vector<int> smoothed_edges(int model, double part_angle) const {
    const world::Placed& placed = world_.models[model];
    std::vector<int> found;
    const auto [first, last] = edges_of(model);
    for (int e = first; e < last; ++e) {
      const FeatureEdge& edge = drawn_.edges[e];
      if (edge.kind != EdgeKind::contour || edge.t != std::array<double, 2>{0, 1}) continue;
      const surfaces::PartBorder* border = placed.part->border_at(edge.mesh_edge);
      if (border != nullptr && border->angle > part_angle) continue;
      const std::span<const int> triangles = triangles_at(edge);
      if (triangles.size() != 2) continue;
      if (is_smoothed_at_ends(edge)) found.push_back(e);
    }
    return found;
  }

  // Contours around a facet that alone faces the other way than all its neighbours, to which it is joined smoothly, if
  // no other contour meets them: of a part of the surface that faces the other way, there would be more facets.
  [[nodiscard]] std::vector<int> around_single_facets(int model, double part_angle) const {
    const world::Placed& placed = world_.models[model];
    const int first_vertex = world_.first_vertex[model];
    std::vector<int> smooth;
    std::vector<signed char> sides(static_cast<std::size_t>(placed.mesh->triangle_count()), 0);
    std::vector<int> contours_at(placed.mesh->points.size(), 0);
    const auto [first, last] = edges_of(model);
    for (int e = first; e < last; ++e) {
      const FeatureEdge& edge = drawn_.edges[e];
      if (edge.kind != EdgeKind::contour || edge.t != std::array<double, 2>{0, 1}) continue;
      for (const int v : edge.vertex) ++contours_at[v - first_vertex];
      const surfaces::PartBorder* border = placed.part->border_at(edge.mesh_edge);
      const std::span<const int> triangles = triangles_at(edge);
      if (triangles.size() != 2 || (border != nullptr && border->angle > part_angle)) continue;
      for (const int t : triangles) check(++sides[t] <= 3, "a triangle has three sides");
      smooth.push_back(e);
    }
    const auto is_alone = [&](int t) {
      return sides[t] == 3 && std::ranges::all_of(placed.mesh->triangle(t), [&](int v) { return contours_at[v] == 2; });
    };
    std::erase_if(smooth, [&](int e) { return std::ranges::none_of(triangles_at(drawn_.edges[e]), is_alone); });
    return smooth;
  }

  [[nodiscard]] bool is_smoothed_at_ends(const FeatureEdge& edge) const {
    const std::span<const int> triangles = triangles_at(edge);
    return std::any_of(triangles.begin(), triangles.end(),
                       [&](int t) { return is_smoothed(world_.models[edge.model], t); });
  }

  [[nodiscard]] std::span<const int> triangles_at(const FeatureEdge& edge) const {
    const mesh::Mesh& mesh = *world_.models[edge.model].mesh;
    return mesh.triangles_of(mesh.edges[static_cast<std::size_t>(edge.mesh_edge)]);
  }

  // Edges are sorted by model.
  [[nodiscard]] std::array<int, 2> edges_of(int model) const {
    const auto begin = std::ranges::lower_bound(drawn_.edges, model, {}, &FeatureEdge::model);
    const auto end = std::ranges::upper_bound(drawn_.edges, model, {}, &FeatureEdge::model);
    return {static_cast<int>(begin - drawn_.edges.begin()), static_cast<int>(end - drawn_.edges.begin())};
  }

  // The ends of other contours of the model, which are not moved, in ascending order.
  [[nodiscard]] std::vector<int> fixed_ends(int model, const std::vector<int>& smoothed) const {
    std::vector<int> ends;
    const auto [first, last] = edges_of(model);
    for (int e = first; e < last; ++e) {
      const FeatureEdge& edge = drawn_.edges[e];
      if (edge.kind == EdgeKind::contour && !std::binary_search(smoothed.begin(), smoothed.end(), e))
        ends.insert(ends.end(), edge.vertex.begin(), edge.vertex.end());
    }
    std::sort(ends.begin(), ends.end());
    return ends;
  }

  [[nodiscard]] Vec2 on_page(int vertex) const { return {view_.vertices[vertex].x, view_.vertices[vertex].y}; }

  // Adds a vertex to the view; -1 if it is behind the viewer.
  int add(const Vec3& place) {
    const view::Mapped mapped = view_.map(place);
    return mapped.w > 0 ? view::add_mapped_point(view_, mapped) : -1;
  }

  // The greater of two distances: of a vertex from the contours drawn around it, and of its drawn position from those
  // of the mesh.
  [[nodiscard]] double distance_moved(int vertex, int shown, const std::vector<int>& around) const {
    double from_drawn = HUGE_VAL, from_mesh = HUGE_VAL;
    for (const int e : around) {
      const FeatureEdge& edge = drawn_.edges[e];
      std::array<Vec2, 2> in_mesh{}, drawn{};
      for (std::size_t end = 0; end < 2; ++end) {
        in_mesh[end] = on_page(edge.vertex[end]);
        drawn[end] = on_page(edge.drawn_vertex(end));
      }
      from_drawn = std::min(from_drawn, distance_to_segment(on_page(vertex), drawn[0], drawn[1]));
      from_mesh = std::min(from_mesh, distance_to_segment(on_page(shown), in_mesh[0], in_mesh[1]));
    }
    return std::max(from_drawn, from_mesh);
  }

  const world::World& world_;
  view::ProjectedScene& view_;
  FeatureEdges& drawn_;
};

}  // namespace

void smooth_contours(const world::World& world, view::ProjectedScene& view, const EdgeOptions& options,
                     FeatureEdges& drawn) {
  MovedEnds ends(world, view, drawn);
  for (int model = 0; model < static_cast<int>(world.models.size()); ++model) {
    const world::Placed& placed = world.models[model];
    // Contours of a cut mesh must end in the cutting plane.
    if (placed.part != nullptr && placed.mesh->uncut == nullptr) ends.move(model, options.part_angle);
  }
  std::erase_if(drawn.edges, [&](const FeatureEdge& edge) {
    if (!edge.by_chance) return false;
    const world::Placed& placed = world.models[edge.model];
    return is_any_tiny(placed, placed.mesh->triangles_of(placed.mesh->edges[static_cast<std::size_t>(edge.mesh_edge)]));
  });
}

}  // namespace epura::edges
