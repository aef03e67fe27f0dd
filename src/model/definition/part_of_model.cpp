// SPDX-License-Identifier: Apache-2.0
#include "definition/part_of_model.hpp"

#include <algorithm>
#include <cstddef>

#include "world/placed_part.hpp"

namespace epura::definition {

namespace {

constexpr std::size_t points_of_border = 6;  // more than its unknowns need, if it is a circle

// The mean of the middles of its triangles, by area.
void set_middles(Part& part, const world::World& world, int model, const std::vector<int>& face_of_triangle) {
  std::vector<double> areas(part.faces.size(), 0.0);
  const int first = world.first_triangle[static_cast<std::size_t>(model)];
  for (std::size_t t = 0; t < face_of_triangle.size(); ++t) {
    const auto face = static_cast<std::size_t>(face_of_triangle[t]);
    if (face_of_triangle[t] < 0) continue;
    const auto& corners = world.triangles[static_cast<std::size_t>(first) + t];
    const Vec3 a = world.points[static_cast<std::size_t>(corners[0])],
               b = world.points[static_cast<std::size_t>(corners[1])],
               c = world.points[static_cast<std::size_t>(corners[2])];
    const double area = glm::length(glm::cross(b - a, c - a));
    part.faces[face].at += area * (a + b + c) / 3.0;
    areas[face] += area;
  }
  for (std::size_t i = 0; i < areas.size(); ++i)
    part.faces[i].at = areas[i] > 0 ? part.faces[i].at / areas[i] : part.faces[i].surface.origin;
}

std::vector<Vec3> points_of(const surfaces::PartBorder& border, const world::World& world, int model) {
  const world::Placed& placed = world.models[static_cast<std::size_t>(model)];
  const auto& edges = placed.mesh->whole().edges;
  std::vector<Vec3> points;
  const std::size_t count = border.edges.size(), step = std::max<std::size_t>(1, count / points_of_border);
  const auto add = [&](std::size_t edge, std::size_t end) {
    const int vertex = edges[static_cast<std::size_t>(border.edges[edge])].vertex[end];
    points.emplace_back(placed.to_world * Vec4(placed.mesh->whole().point(vertex), 1));
  };
  for (std::size_t i = 0; i < count; i += step) add(i, 0);
  for (const std::size_t end : {0, 1}) add(count - 1, end);
  return points;
}

}  // namespace

std::optional<Part> part_of_model(const world::World& world, int model) {
  const world::Placed& placed = world.models[static_cast<std::size_t>(model)];
  const auto faces = world::place_part(placed);
  if (!faces) return std::nullopt;
  Part part{{}, {}, glm::length(world.box.size())};
  for (const surfaces::PartFace& face : faces->faces) part.faces.push_back({face.surface, Vec3(0), face.area});
  set_middles(part, world, model, faces->face_of_triangle);
  for (const surfaces::PartBorder& border : placed.part->borders)
    if (border.faces[0] >= 0 && border.faces[0] != border.faces[1] && !border.edges.empty())
      part.contacts.push_back(
          {border.faces, points_of(border, world, model), border.kind == surfaces::BorderKind::tangent});
  return part;
}

}  // namespace epura::definition
