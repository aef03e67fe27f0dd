#include "scene/scene.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/error.hpp"

namespace epura {

namespace {

constexpr double float_rounding = 0x1p-22;

double largest_component(const Vec3& v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); }

// Of a placed model, in world lengths: of 32-bit floats by their size, of decimals by the last place of both of two
// vertices that should be equal.
double rounding_of(const Placed& model, const Box& box) {
  const Mat3 turn(model.to_world);
  const double stretch = std::max({glm::length(turn[0]), glm::length(turn[1]), glm::length(turn[2])});
  const double decimals = 2 * model.mesh->report.resolution * stretch;
  if (!model.mesh->report.single_precision) return decimals;
  const double size =
      std::max({largest_component(box.size()), largest_component(box.least), largest_component(box.most)});
  return std::max(decimals, float_rounding * size);
}

Vec3 place(const Mat4& to_world, const OpenMesh::Vec3d& p) {
  const Vec3 point(p[0], p[1], p[2]);
  // An unmoved model keeps its coordinates to the last bit, signed zeros and huge values included.
  return to_world == Mat4(1.0) ? point : Vec3(to_world * Vec4(point, 1.0));
}

void append(World& world, const Placed& model) {
  const int first_vertex = world.first_vertex.back();
  const int first_triangle = world.first_triangle.back();
  const int count = static_cast<int>(model.mesh->polygon.size());
  int vertices = 0;
  Box box;
  for (const int v : model.mesh->vertex_of) vertices = std::max(vertices, v + 1);
  world.points.resize(static_cast<std::size_t>(first_vertex + vertices), Vec3(0));
  world.triangles.resize(static_cast<std::size_t>(first_triangle + count));
  for (int f = 0; f < count; ++f) {
    std::array<int, 3> corners = model.mesh->corners(f);
    for (int& v : corners) {
      Vec3& point = world.points[first_vertex + v];
      point = place(model.to_world, model.mesh->point(v));
      if (!finite(point))
        throw Error(Trouble::input, model.mesh->report.name, "the transform moves vertices out of the range of numbers",
                    "use a smaller scale or translation");
      box.add(point);
      world.box.add(point);
      v += first_vertex;
    }
    world.triangles[first_triangle + f] = corners;
  }
  world.first_vertex.push_back(first_vertex + vertices);
  world.first_triangle.push_back(first_triangle + count);
  world.rounding = std::max(world.rounding, rounding_of(model, box));
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
