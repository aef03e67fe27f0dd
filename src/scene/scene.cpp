// SPDX-License-Identifier: Apache-2.0
#include "scene/scene.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <span>
#include <utility>

#include "base/error.hpp"
#include "base/parallel.hpp"

namespace epura {

namespace {

constexpr double float_rounding = 0x1p-22;
constexpr double half_last_place = 0x1p-24;  // of a 32-bit float, relative
constexpr std::size_t grain = 8192;

double largest_component(const Vec3& v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); }

double size_of(const Box& box) {
  return std::max({largest_component(box.size()), largest_component(box.min), largest_component(box.max)});
}

// Of a placed model, in world lengths: of 32-bit floats by their size in the world or, where that is larger, in the
// file; of decimals by the last place of both of two vertices that should be equal.
double rounding_of(const Placed& model, const Box& box, const Box& in_file) {
  const Mat3 turn(model.to_world);
  const double stretch = std::max({glm::length(turn[0]), glm::length(turn[1]), glm::length(turn[2])});
  const double decimals = 2 * model.mesh->report.resolution * stretch;
  if (!model.mesh->report.single_precision) return decimals;
  return std::max(decimals, float_rounding * std::max(size_of(box), size_of(in_file) * stretch));
}

Vec3 one_rounding_of(const Placed& model, const Box& box) {
  Vec3 half(model.mesh->report.resolution / 2);
  if (model.mesh->report.single_precision)
    half = glm::max(half, half_last_place * glm::max(glm::abs(box.min), glm::abs(box.max)));
  const Mat3 turn(model.to_world);
  return glm::abs(turn[0]) * half.x + glm::abs(turn[1]) * half.y + glm::abs(turn[2]) * half.z;
}

Vec3 place(const Mat4& to_world, const OpenMesh::Vec3d& p) {
  const Vec3 point(p[0], p[1], p[2]);
  // An unmoved model keeps its coordinates to the last bit, signed zeros and huge values included.
  return to_world == Mat4(1.0) ? point : Vec3(to_world * Vec4(point, 1.0));
}

// The places in the world of the vertices that triangles use; false when one leaves the range of doubles. The vertices
// of the file come first in the surface, their copies behind them.
bool place_vertices(const Placed& model, std::span<Vec3> points) {
  const Surface& surface = model.mesh->surface;
  std::atomic<bool> all_finite = true;
  parallel_for(points.size(), grain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t v = begin; v < end; ++v) {
      const OpenMesh::VertexHandle vertex(static_cast<int>(v));
      points[v] = surface.is_isolated(vertex) ? Vec3(0) : place(model.to_world, surface.point(vertex));
      if (!finite(points[v])) all_finite = false;
    }
  });
  return all_finite;
}

// Of the first `count` vertices of a surface, where `place(v)` has them.
template <class Place>
Box box_of(const Surface& surface, std::size_t count, const Place& place) {
  Box box;
  for (std::size_t v = 0; v < count; ++v) {
    const OpenMesh::VertexHandle vertex(static_cast<int>(v));
    if (!surface.is_isolated(vertex)) box.add(place(vertex));
  }
  return box;
}

// As its file has it, where it stands; `box` as the world has it.
Box box_in_file(const Placed& model, std::size_t vertices, const Box& box) {
  if (model.to_world == Mat4(1.0)) return box;
  const Surface& surface = model.mesh->surface;
  return box_of(surface, vertices, [&](OpenMesh::VertexHandle v) { return place(Mat4(1.0), surface.point(v)); });
}

void append(World& world, const Placed& placed) {
  const Mesh& mesh = *placed.mesh;
  const int first_vertex = world.first_vertex.back();
  const int first_triangle = world.first_triangle.back();
  int vertices = 0;
  for (const int v : mesh.vertex_of) vertices = std::max(vertices, v + 1);
  world.points.resize(static_cast<std::size_t>(first_vertex + vertices));
  const std::span<Vec3> points(world.points.data() + first_vertex, static_cast<std::size_t>(vertices));
  if (!place_vertices(placed, points))
    throw Error(ErrorKind::input, mesh.report.name, "the transform moves vertices out of the range of numbers",
                "use a smaller scale or translation");
  const Box box = box_of(mesh.surface, points.size(), [&](OpenMesh::VertexHandle v) { return points[v.idx()]; });
  if (!box.empty()) {
    world.box.add(box.min);
    world.box.add(box.max);
  }
  const int count = static_cast<int>(mesh.polygon.size());
  world.triangles.resize(static_cast<std::size_t>(first_triangle + count));
  parallel_for(mesh.polygon.size(), grain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t f = begin; f < end; ++f) {
      std::array<int, 3> corners = mesh.corners(static_cast<int>(f));
      for (int& v : corners) v += first_vertex;
      world.triangles[static_cast<std::size_t>(first_triangle) + f] = corners;
    }
  });
  world.first_vertex.push_back(first_vertex + vertices);
  world.first_triangle.push_back(first_triangle + count);
  if (box.empty()) return;
  const Box in_file = box_in_file(placed, points.size(), box);
  world.rounding = std::max(world.rounding, rounding_of(placed, box, in_file));
  world.one_rounding = glm::max(world.one_rounding, one_rounding_of(placed, in_file));
}

}  // namespace

int World::model_of_triangle(int triangle) const {
  const auto next = std::upper_bound(first_triangle.begin(), first_triangle.end(), triangle);
  return static_cast<int>(next - first_triangle.begin()) - 1;
}

World make_world(std::vector<Placed> models) {
  World world;
  world.first_vertex = {0};
  world.first_triangle = {0};
  for (const Placed& model : models) append(world, model);
  world.models = std::move(models);
  return world;
}

}  // namespace epura
