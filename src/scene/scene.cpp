#include "scene/scene.hpp"

#include <algorithm>
#include <utility>

#include "base/error.hpp"

namespace epura {

namespace {

constexpr double float_rounding = 0x1p-22;

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
      world.box.add(point);
      v += first_vertex;
    }
    world.triangles[first_triangle + f] = corners;
  }
  world.first_vertex.push_back(first_vertex + vertices);
  world.first_triangle.push_back(first_triangle + count);
  if (model.mesh->report.single_precision) world.precision = float_rounding;
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
