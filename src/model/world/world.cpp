// SPDX-License-Identifier: Apache-2.0
#include "world/world.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <span>
#include <utility>

#include "base/error.hpp"
#include "base/parallel.hpp"

namespace epura::world {

namespace {

constexpr double float_rounding = 0x1p-22;
constexpr double half_last_place = 0x1p-24;  // of a 32-bit float, relative

double largest_component(const Vec3& v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); }

double size_of(const Box& box) {
  return std::max({largest_component(box.size()), largest_component(box.min), largest_component(box.max)});
}

// The rounding of a placed model, in units of the world. For 32-bit floats it is relative to the model's size in the
// world or, if larger, in the file; for decimals it is the last place of each of two vertices that should be equal.
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

Vec3 place(const Mat4& to_world, const Vec3& point) {
  // An unmoved model keeps its coordinates to the last bit, signed zeros and huge values included.
  return to_world == Mat4(1.0) ? point : Vec3(to_world * Vec4(point, 1.0));
}

// By vertex: 1 if a triangle uses it, or a wire if these count.
std::vector<char> used_vertices(const mesh::Mesh& mesh, bool by_wires) {
  std::vector<char> used(mesh.points.size(), 0);
  for (const int vertex : mesh.corners) used[vertex] = 1;
  if (by_wires && mesh.report.wires > 0)
    for (const mesh::MeshEdge& edge : mesh.edges)
      for (const int vertex : edge.vertex) used[vertex] = 1;
  return used;
}

// Computes world positions of used vertices; false if one exceeds the range of doubles.
bool place_vertices(const Placed& model, const std::vector<char>& used, std::span<Vec3> points) {
  std::atomic<bool> all_finite = true;
  parallel_for(points.size(), grain::light, [&](std::size_t begin, std::size_t end) {
    for (std::size_t v = begin; v < end; ++v) {
      points[v] = used[v] != 0 ? place(model.to_world, model.mesh->point(static_cast<int>(v))) : Vec3(0);
      if (!finite(points[v])) all_finite = false;
    }
  });
  return all_finite;
}

// The box of the used vertices at their positions `place(v)`.
template <class Place>
Box box_of(const std::vector<char>& used, const Place& place) {
  Box box;
  for (std::size_t v = 0; v < used.size(); ++v)
    if (used[v] != 0) box.add(place(static_cast<int>(v)));
  return box;
}

void append_triangles(World& world, const mesh::Mesh& mesh) {
  const int first_vertex = world.first_vertex.back();
  const auto first_triangle = static_cast<std::size_t>(world.first_triangle.back());
  const std::size_t count = mesh.polygon.size();
  world.triangles.resize(first_triangle + count);
  parallel_for(count, grain::light, [&](std::size_t begin, std::size_t end) {
    for (std::size_t t = begin; t < end; ++t) {
      std::array<int, 3> corners = mesh.triangle(static_cast<int>(t));
      for (int& v : corners) v += first_vertex;
      world.triangles[first_triangle + t] = corners;
    }
  });
}

void append(World& world, const Placed& placed, bool with_wires) {
  const mesh::Mesh& mesh = *placed.mesh;
  const auto first_vertex = static_cast<std::size_t>(world.first_vertex.back());
  const std::vector<char> used = used_vertices(mesh, true);
  world.points.resize(first_vertex + mesh.points.size());
  const std::span<Vec3> points(world.points.data() + first_vertex, mesh.points.size());
  if (!place_vertices(placed, used, points))
    throw Error(ErrorKind::input, mesh.report.name, "the transform moves vertices beyond the range of numbers",
                "use a smaller scale or translation");
  append_triangles(world, mesh);
  if (with_wires) append_wires(world, mesh, static_cast<int>(first_vertex));
  world.first_vertex.push_back(static_cast<int>(world.points.size()));
  world.first_triangle.push_back(static_cast<int>(world.triangles.size()));

  const std::vector<char> in_box = with_wires ? used : used_vertices(mesh, false);
  const Box box = box_of(in_box, [&](int v) { return points[v]; });
  if (box.empty()) return;
  world.box.add(box.min);
  world.box.add(box.max);
  const bool unmoved = placed.to_world == Mat4(1.0);
  const Box in_file = unmoved ? box : box_of(in_box, [&](int v) { return mesh.point(v); });
  world.rounding = std::max(world.rounding, rounding_of(placed, box, in_file));
  world.one_rounding = glm::max(world.one_rounding, one_rounding_of(placed, in_file));
}

}  // namespace

int World::model_of_triangle(int triangle) const {
  const auto next = std::upper_bound(first_triangle.begin(), first_triangle.end(), triangle);
  return static_cast<int>(next - first_triangle.begin()) - 1;
}

void append_wires(World& world, const mesh::Mesh& mesh, int first_vertex) {
  if (mesh.report.wires == 0) return;
  for (const mesh::MeshEdge& edge : mesh.edges)
    if (edge.count == 0) world.wires.push_back({first_vertex + edge.vertex[0], first_vertex + edge.vertex[1]});
}

World without_models(const World& world) {
  World empty;
  empty.first_vertex = {0};
  empty.first_triangle = {0};
  empty.box = world.box;
  empty.rounding = world.rounding;
  empty.one_rounding = world.one_rounding;
  empty.styles = world.styles;
  return empty;
}

World make_world(std::vector<Placed> models, bool with_wires) {
  const auto has_faces = [](const Placed& model) { return model.mesh->triangle_count() > 0; };
  const bool any_faces = std::any_of(models.begin(), models.end(), has_faces);
  World world;
  world.first_vertex = {0};
  world.first_triangle = {0};
  for (const Placed& model : models) append(world, model, with_wires || !any_faces);
  world.models = std::move(models);
  return world;
}

}  // namespace epura::world
