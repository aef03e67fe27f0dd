// SPDX-License-Identifier: Apache-2.0
// The draughtsman's method: the vanishing points of the model's axes are chosen on the page, and determine eye and
// plane.
//
// Positions are in model units on the plane, u to the right and v up, from the image of the model's centre, through
// which the plane passes. With H the foot of the eye on the plane and e its distance, the axis that vanishes at V has
// the direction (V - H, -e) in (u, v, n); axes are perpendicular, so that (V1 - H).(V2 - H) = -e^2 for every pair:
//   three points  H is the orthocentre of their triangle, which must be acute;
//   two points    H is a point between them on their line (the horizon), the one nearest to `centre`;
//   one point     H is the point itself, and e is chosen.
// Each axis is directed so that z points upwards in the view and x to the right.
#include <optional>

#include "perspective.hpp"

using namespace perspective;

namespace {

using Place = std::array<double, 2>;

bool given(const Place& p) { return !std::isnan(p[0]); }
Place minus(const Place& a, const Place& b) { return {a[0] - b[0], a[1] - b[1]}; }
double dot(const Place& a, const Place& b) { return a[0] * b[0] + a[1] * b[1]; }

/// The position of the eye: its foot on the plane and its distance.
struct Eye {
  Place foot;
  double distance;
};

Eye eye_of_three(const std::array<Place, 3>& at) {
  const Place a = minus(at[1], at[0]), b = minus(at[2], at[0]), c = minus(at[2], at[1]);
  const double area = a[0] * b[1] - a[1] * b[0];
  if (!(std::abs(area) > 1e-9 * dot(c, c))) throw std::invalid_argument("the three vanishing points lie on one line");
  // (H - V0).(V2 - V1) = 0 and (H - V1).(V2 - V0) = 0, solved for h = H - V0.
  const double right = dot(a, b);
  const Place h{right * c[1] / area, -right * c[0] / area};
  const Place foot{at[0][0] + h[0], at[0][1] + h[1]};
  const double square = -dot(minus(at[0], foot), minus(at[1], foot));
  if (!(square > 0)) throw std::invalid_argument("the triangle of the three vanishing points must be acute");
  return {foot, std::sqrt(square)};
}

Eye eye_of_two(const Place& first, const Place& second, const Place& near) {
  const Place line = minus(second, first);
  const double along = dot(minus(near, first), line) / dot(line, line);
  if (!(along > 0 && along < 1))
    throw std::invalid_argument(
        "the foot of the eye must fall between the two vanishing points: move them to either side, or give centre");
  return {{first[0] + along * line[0], first[1] + along * line[1]},
          std::sqrt(along * (1 - along)) * std::sqrt(dot(line, line))};
}

Vec3 turned(Vec3 axis, double wanted, double otherwise) {
  return (std::abs(wanted) > 1e-12 ? wanted : otherwise) < 0 ? -axis : axis;
}

/// The model's axes in (u, v, n) of the plane: those with a vanishing point are directed at it, the others complete
/// them.
std::array<Vec3, 3> model_axes(const std::array<Place, 3>& at, const Eye& eye) {
  std::array<std::optional<Vec3>, 3> found;
  int count = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    if (!given(at[i])) continue;
    const Place v = minus(at[i], eye.foot);
    found[i] = unit({v[0], v[1], -eye.distance});
    ++count;
  }
  // With one point, the model could still rotate about the line of sight: height, or width seen from above, is made
  // straight.
  if (count == 1 && !found[2]) found[2] = Vec3{0, 1, 0};
  if (count == 1 && !found[0]) found[0] = Vec3{1, 0, 0};
  for (std::size_t i = 0; i < 3; ++i)
    if (!found[i]) found[i] = unit(cross(*found[(i + 1) % 3], *found[(i + 2) % 3]));
  const Vec3 z = turned(*found[2], found[2]->y, found[2]->z), x = turned(*found[0], found[0]->x, found[0]->z);
  return {x, cross(z, x), z};
}

}  // namespace

struct VanishingPoints {
  static constexpr auto name = "vanishing-points";
  static constexpr auto family = "perspective";
  static constexpr auto summary = "one, two or three vanishing points placed on the page";
  static constexpr auto reference = "descriptive geometry: the orthocentre is the principal point";
  static constexpr std::array parameters{
      vector<2>("x", "model units", "vanishing point of width, from the image of the model's centre"),
      vector<2>("y", "model units",
                "vanishing point of depth; by default x and y are to the left and right of the model"),
      vector<2>("z", "model units", "vanishing point of height"),
      vector<2>("centre", "model units",
                "with two points: foot of the eye, moved to the horizon; by default nearest to the model"),
      number("distance", "model units", "with one point or none: distance of the eye from the plane", from_box, 0,
             unlimited),
  };

  static View project(const Scene& scene, Place x, Place y, Place z, Place centre, double distance) {
    const int count = given(x) + given(y) + given(z);
    if (given(centre) && (count == 1 || count == 3))
      throw std::invalid_argument("centre belongs to two vanishing points: one or three fix the foot of the eye");
    if (!std::isnan(distance) && count > 1)
      throw std::invalid_argument("distance belongs to one vanishing point: two or three fix it");
    distance = given_or(distance, calm_distance * scene.diagonal());
    if (count == 0) {
      const double horizon = scene.diagonal() / 4;
      x = {-distance, horizon};
      y = {distance, horizon};
    }
    return view_of({x, y, z}, eye_of({x, y, z}, given(centre) ? centre : Place{0, 0}, distance), scene);
  }

  static Eye eye_of(const std::array<Place, 3>& at, const Place& near, double distance) {
    const int count = given(at[0]) + given(at[1]) + given(at[2]);
    if (count == 3) return eye_of_three(at);
    if (count == 2) return eye_of_two(given(at[0]) ? at[0] : at[1], given(at[2]) ? at[2] : at[1], near);
    return {given(at[0]) ? at[0] : given(at[1]) ? at[1] : at[2], distance};
  }

  static View view_of(const std::array<Place, 3>& at, const Eye& eye, const Scene& scene) {
    const auto [x, y, z] = model_axes(at, eye);
    const Vec3 u{x.x, y.x, z.x}, v{x.y, y.y, z.y}, n{x.z, y.z, z.z};
    const Vec3 size = scene.most - scene.least;
    const double reach = (std::abs(n.x) * size.x + std::abs(n.y) * size.y + std::abs(n.z) * size.z) / 2;
    if (!(eye.distance > reach))
      throw std::invalid_argument("the eye would be inside the model: move the vanishing points apart");
    return {.central = true,
            .point = scene.centre(),
            .normal = n,
            .up = v,
            .projector = scene.centre() + eye.foot[0] * u + eye.foot[1] * v + eye.distance * n};
  }
};
EPURA_PROJECTION(VanishingPoints)
