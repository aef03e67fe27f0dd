// SPDX-License-Identifier: Apache-2.0
#include "sheet/dimensions/rims.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/error.hpp"
#include "base/text.hpp"
#include "scene/placed_circles.hpp"

namespace epura::sheet {

namespace {

constexpr double roundness = 2e-3;  // of the radius: twice what find_circles grants to vertices

double distance(const Vec3& point, const WorldCircle& circle) {
  const Vec3 d = point - circle.centre;
  const double height = glm::dot(d, circle.axis);
  return std::hypot(glm::length(d - height * circle.axis) - circle.radius, height);
}

std::string text_of(const Vec3& p) {
  return format_fixed(p.x, 4) + "," + format_fixed(p.y, 4) + "," + format_fixed(p.z, 4);
}

}  // namespace

const std::vector<Rims::Rim>& Rims::of_model(int model) {
  const auto [at, first_time] = rims_.try_emplace(model);
  if (!first_time) return at->second;
  for (const mesh::MeshCircle& circle : scene::find_circles(world_, model)) {
    WorldCircle placed{circle.centre, circle.axis, circle.radius, {}, circle.whole};
    for (const int v : circle.vertices) placed.rim.push_back(world_.points[world_.first_vertex[model] + v]);
    at->second.push_back({circle.vertices, std::move(placed)});
  }
  return at->second;
}

std::vector<WorldCircle> Rims::through(const scene::Anchor& anchor, const Vec3& place, const std::string& where) {
  const auto* vertex = std::get_if<std::array<int, 2>>(&anchor);
  const int first = vertex ? (*vertex)[0] : 0;
  const int last = vertex ? first : static_cast<int>(world_.models.size()) - 1;
  std::vector<WorldCircle> circles;
  const Rim* nearest = nullptr;
  for (int model = first; model <= last; ++model) {
    for (const Rim& rim : of_model(model)) {
      const bool on_it = vertex ? std::count(rim.vertices.begin(), rim.vertices.end(), (*vertex)[1]) > 0
                                : distance(place, rim.circle) <= roundness * rim.circle.radius;
      if (on_it) circles.push_back(rim.circle);
      if (!nearest || distance(place, rim.circle) < distance(place, nearest->circle)) nearest = &rim;
    }
  }
  if (!circles.empty()) return circles;
  throw Error(ErrorKind::input, where, "wants a vertex on the rim of a circle, and there is none at " + text_of(place),
              nearest ? "the nearest circle has radius " + format_rounded(nearest->circle.radius, 6) + " around " +
                            text_of(nearest->circle.centre) + "; its vertex " +
                            std::to_string(nearest->vertices.front()) + " would do"
                      : "no circle was found: rims of holes, bosses and shafts are circles");
}

}  // namespace epura::sheet
