#include "scene/placed_circles.hpp"

#include <cmath>
#include <cstddef>
#include <numbers>

namespace epura {

namespace {

constexpr double slack = 1e-6;

Vec3 point_of(const Mesh& mesh, int vertex) {
  const auto& p = mesh.point(vertex);
  return {p[0], p[1], p[2]};
}

double sweep_of(const Mesh& mesh, const MeshCircle& circle) {
  double sweep = 0;
  for (std::size_t i = 1; i < circle.vertices.size(); ++i) {
    const Vec3 a = point_of(mesh, circle.vertices[i - 1]) - circle.centre;
    const Vec3 b = point_of(mesh, circle.vertices[i]) - circle.centre;
    sweep += std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
  }
  return sweep;
}

// Whether it is still a circle.
bool place(MeshCircle& circle, const Mat4& to_world) {
  const Mat3 turn(to_world);
  const Vec3 u = glm::normalize(glm::cross(circle.axis, std::abs(circle.axis.x) < 0.5 ? Vec3(1, 0, 0) : Vec3(0, 1, 0)));
  const Vec3 to_u = turn * u, to_v = turn * glm::cross(circle.axis, u);
  const double scale = glm::length(to_u);
  if (!(std::abs(glm::length(to_v) - scale) <= slack * scale)) return false;
  if (!(std::abs(glm::dot(to_u, to_v)) <= slack * scale * scale)) return false;
  circle.centre = Vec3(to_world * Vec4(circle.centre, 1));
  circle.axis = glm::normalize(glm::cross(to_u, to_v));
  circle.radius *= scale;
  circle.deviation *= scale;
  return true;
}

}  // namespace

std::vector<PlacedCircle> find_placed_circles(const World& world, double crease_angle) {
  std::vector<PlacedCircle> placed;
  for (std::size_t model = 0; model < world.models.size(); ++model) {
    const Mesh& mesh = *world.models[model].mesh;
    for (MeshCircle& circle : find_circles(mesh, crease_angle)) {
      if (!circle.whole && sweep_of(mesh, circle) < std::numbers::pi * (1 - slack)) continue;
      if (place(circle, world.models[model].to_world)) placed.push_back({static_cast<int>(model), std::move(circle)});
    }
  }
  return placed;
}

}  // namespace epura
