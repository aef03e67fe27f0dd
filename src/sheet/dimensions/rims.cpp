#include "sheet/dimensions/rims.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "base/error.hpp"
#include "base/text.hpp"
#include "mesh/circles.hpp"

namespace epura {

namespace {

constexpr double roundness = 2e-3;  // of the radius: twice what find_circles grants to vertices

// Nothing where the transform makes an ellipse of it.
std::optional<WorldCircle> in_world(const Placed& model, const MeshCircle& circle) {
  const Mat3 turn(model.to_world);
  const Vec3 other = std::abs(circle.axis.x) < 0.5 ? Vec3(1, 0, 0) : Vec3(0, 1, 0);
  const Vec3 u = glm::cross(circle.axis, other);
  const Vec3 axis = glm::cross(turn * u, turn * glm::cross(circle.axis, u));
  WorldCircle placed{Vec3(model.to_world * Vec4(circle.centre, 1)), glm::normalize(axis), 0, {}, circle.whole};
  for (const int v : circle.vertices) {
    const auto& p = model.mesh->point(v);
    placed.rim.emplace_back(model.to_world * Vec4(p[0], p[1], p[2], 1));
    placed.radius += glm::length(placed.rim.back() - placed.centre) / double(circle.vertices.size());
  }
  const auto round = [&placed](const Vec3& p) {
    return std::abs(glm::length(p - placed.centre) - placed.radius) <= roundness * placed.radius;
  };
  if (!std::all_of(placed.rim.begin(), placed.rim.end(), round)) return std::nullopt;
  // A turn or an even scale leaves the fitted radius as it is; vertices lie beside it by their rounding.
  placed.radius = circle.radius * std::sqrt(glm::length(axis) / glm::dot(u, u));
  return placed;
}

double distance(const Vec3& point, const WorldCircle& circle) {
  const Vec3 d = point - circle.centre;
  const double height = glm::dot(d, circle.axis);
  return std::hypot(glm::length(d - height * circle.axis) - circle.radius, height);
}

std::string text_of(const Vec3& p) {
  return format_rounded(p.x, 6) + "," + format_rounded(p.y, 6) + "," + format_rounded(p.z, 6);
}

}  // namespace

const std::vector<Rims::Rim>& Rims::of_model(int model) {
  const auto [at, first_time] = rims_.try_emplace(model);
  if (!first_time) return at->second;
  const Placed& placed = world_.models[std::size_t(model)];
  for (const MeshCircle& circle : find_circles(*placed.mesh))
    if (const auto in_place = in_world(placed, circle)) at->second.push_back({circle.vertices, *in_place});
  return at->second;
}

std::vector<WorldCircle> Rims::through(const Anchor& anchor, const Vec3& place, const std::string& where) {
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
  throw Error(Trouble::input, where, "wants a vertex on the rim of a circle, and there is none at " + text_of(place),
              nearest ? "the nearest circle has radius " + format_rounded(nearest->circle.radius, 6) + " around " +
                            text_of(nearest->circle.centre) + "; its vertex " +
                            std::to_string(nearest->vertices.front()) + " would do"
                      : "no circle was found: rims of holes, bosses and shafts are circles");
}

}  // namespace epura
