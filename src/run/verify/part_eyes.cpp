// SPDX-License-Identifier: Apache-2.0
#include "verify/part_eyes.hpp"

#include <algorithm>
#include <cmath>

#include "verify/ray_hits.hpp"

namespace epura::verify {

namespace {

// The part of a border's length over which its faces must fold, if it is drawn: as edges of parts are defined.
constexpr double sharp_part = 0.1;
// A fold between facets of round faces is one if it exceeds the turns on both sides of it by this factor.
constexpr double clearly_more = 1.5;
// The sine of the angle between a normal and the facets' plane below which a flat face is seen edge-on.
constexpr double seen_edge_on = 1e-6;

// From one plane to another, about an edge of both; in degrees, whichever way they face.
double angle_about(const Vec3& axis, const Vec3& a, const Vec3& b) {
  return angle_between_planes(a - glm::dot(a, axis) * axis, b - glm::dot(b, axis) * axis);
}

}  // namespace

PartEyes::PartEyes(const world::World& world, const projection::Projection& projection,
                   const edges::EdgeOptions& options)
    : world_(world), projection_(projection), options_(options), models_(world.models.size()) {
  for (std::size_t m = 0; m < models_.size(); ++m) {
    const world::Placed& placed = world.models[m];
    if (placed.part == nullptr || placed.part->faces.empty() || placed.mesh->uncut != nullptr) continue;
    Model& model = models_[m];
    model.mesh = placed.mesh.get();
    model.part = placed.part.get();
    model.to_file = glm::inverse(Mat3(placed.to_world));
    model.at_vertex = Groups<int>(placed.mesh->points.size(), [&](const auto& visit) {
      for (std::size_t i = 0; i < placed.mesh->corners.size(); ++i)
        visit(static_cast<std::size_t>(placed.mesh->corners[i]), static_cast<int>(i / 3));
    });
    for (const surfaces::PartBorder& border : placed.part->borders)
      model.sharp.push_back(is_sharp(model, border) ? 1 : 0);
  }
}

int PartEyes::face_of(int triangle) const {
  const int model = world_.model_of_triangle(triangle);
  const Model& of = models_[static_cast<std::size_t>(model)];
  if (of.mesh == nullptr) return -1;
  return of.part->face_of_triangle[static_cast<std::size_t>(triangle - world_.first_triangle[model])];
}

Vec3 PartEyes::normal_of(const Model& model, int triangle) const {
  const auto [a, b, c] = model.mesh->triangle(triangle);
  const Vec3 normal = glm::cross(model.point(b) - model.point(a), model.point(c) - model.point(a));
  const double length = glm::length(normal);
  return length > 0 ? normal / length : Vec3(0);
}

// Of a free form, the mean of its facets, weighted by their angles there.
Vec3 PartEyes::normal_at(const Model& model, int vertex, int face) const {
  const surfaces::PartSurface& surface = model.part->faces[static_cast<std::size_t>(face)].surface;
  const Vec3 at = model.point(vertex);
  if (surface.kind != surfaces::SurfaceKind::free_form) return normal_on(surface, at);
  std::vector<int> around;
  for (const int t : model.at_vertex[static_cast<std::size_t>(vertex)])
    if (model.part->face_of_triangle[static_cast<std::size_t>(t)] == face) around.push_back(t);
  std::ranges::sort(around);  // a sum in an order of its own would differ in its last digits
  Vec3 sum(0);
  for (const int t : around) {
    const auto corner = model.mesh->triangle(t);
    const std::size_t i = corner[0] == vertex ? 0 : corner[1] == vertex ? 1 : 2;
    const Vec3 one = model.point(corner[(i + 1) % 3]) - at, two = model.point(corner[(i + 2) % 3]) - at;
    sum += std::atan2(glm::length(glm::cross(one, two)), glm::dot(one, two)) * normal_of(model, t);
  }
  return sum;
}

bool PartEyes::is_sharp(const Model& model, const surfaces::PartBorder& border) const {
  double folded = 0, length = 0;
  for (const int number : border.edges) {
    const mesh::MeshEdge& edge = model.mesh->edges[static_cast<std::size_t>(number)];
    const double along = glm::distance(model.point(edge.vertex[0]), model.point(edge.vertex[1]));
    length += along;
    if (folds_at(model, edge)) folded += along;
  }
  return folded > sharp_part * length;
}

bool PartEyes::folds_at(const Model& model, const mesh::MeshEdge& edge) const {
  const auto triangles = model.mesh->triangles_of(edge);
  if (triangles.size() != 2) return true;
  const auto face = [&](int t) { return model.part->face_of_triangle[static_cast<std::size_t>(t)]; };
  const int one = face(triangles[0]), two = face(triangles[1]);
  double angle = 0;
  for (const int v : edge.vertex)
    angle = std::max(angle, angle_between_planes(normal_at(model, v, one), normal_at(model, v, two)));
  if (angle <= options_.part_angle) return false;
  return model.part->declared || is_fold_of_facets(model, edge);
}

// Whether facets fold at an edge by more than on both sides of it.
bool PartEyes::is_fold_of_facets(const Model& model, const mesh::MeshEdge& edge) const {
  const auto triangles = model.mesh->triangles_of(edge);
  const Vec3 axis = glm::normalize(model.point(edge.vertex[1]) - model.point(edge.vertex[0]));
  const double fold = angle_about(axis, normal_of(model, triangles[0]), normal_of(model, triangles[1]));
  const double beside = std::max(turn_beside(model, edge, triangles[0]), turn_beside(model, edge, triangles[1]));
  return fold > options_.part_angle && fold > clearly_more * beside;
}

// How much the face of a triangle turns beyond it, about an edge of the triangle: from facet to facet, to the second
// one, since the next may be the other half of a quadrilateral.
double PartEyes::turn_beside(const Model& model, const mesh::MeshEdge& edge, int triangle) const {
  const auto face = [&](int t) { return model.part->face_of_triangle[static_cast<std::size_t>(t)]; };
  const Vec3 axis = glm::normalize(model.point(edge.vertex[1]) - model.point(edge.vertex[0]));
  double turn = 0;
  std::vector<int> ring{triangle};
  for (int step = 0; step < 2; ++step) {
    std::vector<int> next;
    for (const int t : ring) {
      const auto corner = model.mesh->triangle(t);
      for (std::size_t i = 0; i < 3; ++i) {
        const auto [a, b] = std::minmax(corner[i], corner[(i + 1) % 3]);
        const mesh::MeshEdge* side = model.mesh->edge_between({a, b});
        if (side == nullptr || side == &edge || side->count != 2) continue;
        for (const int other : model.mesh->triangles_of(*side)) {
          if (other == t || face(other) != face(triangle)) continue;
          turn = std::max(turn, angle_about(axis, normal_of(model, t), normal_of(model, other)));
          next.push_back(other);
        }
      }
    }
    ring = std::move(next);
  }
  return turn;
}

// Whether the normal of a face becomes perpendicular to the projectors where a line crosses facets around a fold of
// theirs; with `visible`, such that the sheet of which the front triangle is part lies before the contour: where the
// cosine between normal and projector grows towards the viewer if it is positive on that sheet, and falls if it is
// negative.
bool PartEyes::has_contour(int model, const MetEdge& met, int face, bool visible) const {
  const Model& of = models_[static_cast<std::size_t>(model)];
  const int first = world_.first_vertex[model];
  const bool is_free = of.part->faces[static_cast<std::size_t>(face)].surface.kind == surfaces::SurfaceKind::free_form;
  double least = HUGE_VAL, most = -HUGE_VAL, grows = 0;
  Vec3 start(0), outwards(0), towards(0);
  for (const EdgePlace& place : met.path) {
    if (place.triangle >= 0 && face_of(place.triangle) != face) continue;  // beyond the face
    const auto [a, b] = place.edge;
    const Vec3 from = of.point(a - first), at = from + place.t * (of.point(b - first) - from);
    Vec3 normal(0);
    if (is_free)
      normal = (1 - place.t) * normal_at(of, a - first, face) + place.t * normal_at(of, b - first, face);
    else
      normal = normal_on(of.part->faces[static_cast<std::size_t>(face)].surface, at);
    const double length = glm::length(normal);
    if (!(length > 0)) return true;  // at an apex, any direction
    const Vec3 in_world = Vec3(world_.models[static_cast<std::size_t>(model)].to_world * Vec4(at, 1));
    const Vec3 way = projection_.central ? projection_.projector - in_world : projection_.projector;
    const Vec3 to_viewer = glm::normalize(of.to_file * way);
    const double facing = glm::dot(normal, to_viewer) / length;
    if (&place == met.path.data()) {
      start = at;
      outwards = normal;
      towards = to_viewer;
    }
    least = std::min(least, facing);
    most = std::max(most, facing);
    grows += facing * glm::dot(at - start, towards);
  }
  if (least > seen_edge_on || most < -seen_edge_on) return false;
  if (!visible) return true;
  const Vec3 flat = normal_of(of, met.front - world_.first_triangle[model]);
  const double faces = glm::dot(flat, towards);
  return (glm::dot(flat, outwards) < 0 ? -faces : faces) * grows >= 0;
}

Ground PartEyes::ground_at(const MetEdge& met, const std::array<int, 2>& triangles, bool visible) const {
  const int model = world_.model_of_triangle(triangles[0]);
  const Model& of = models_[static_cast<std::size_t>(model)];
  const int one = face_of(triangles[0]), two = face_of(triangles[1]);
  if (one == two) return met.front >= 0 && has_contour(model, met, one, visible) ? Ground::contour : Ground::none;
  if (met.front >= 0) return Ground::contour;
  const mesh::MeshEdge* found =
      of.mesh->edge_between({met.edge[0] - world_.first_vertex[model], met.edge[1] - world_.first_vertex[model]});
  if (found == nullptr) return Ground::edge;
  const int border = of.part->border_of_edge[static_cast<std::size_t>(found - of.mesh->edges.data())];
  return border < 0 || of.sharp[static_cast<std::size_t>(border)] != 0 ? Ground::edge : Ground::none;
}

}  // namespace epura::verify
