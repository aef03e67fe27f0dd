// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <utility>

#include "base/convex_hull.hpp"
#include "study/stability/forms.hpp"
#include "world/facet_heights.hpp"

namespace epura::stability {

Measured sphere_along_its_axis(const Lab& lab, int meridians, int bands) {
  const Result result = lab.draw(lab.world_of(uv_sphere(meridians, bands)), {from_above()});
  Measured measured = lengths(result, 2 * meridians * std::sin(M_PI / meridians), 0);
  measured.push_back(count("chains", 1, static_cast<double>(result.drawing.chains.size())));
  measured.push_back(count("closed chains", 1, !result.drawing.chains.empty() && result.drawing.chains[0].closed));
  return measured;
}

namespace {

double perimeter_of_hull(std::vector<Vec2> points) {
  const std::vector<Vec2> hull = convex_hull(std::move(points), [](const Vec2& point) -> const Vec2& { return point; });
  double perimeter = 0;
  for (std::size_t i = 0; i < hull.size(); ++i) perimeter += glm::distance(hull[i], hull[(i + 1) % hull.size()]);
  return perimeter;
}

// Outlines of recognised surfaces lie on these: farther out than those of facets, by up to their height times
// `stretch`.
Measured convex_outline(const Result& result, double perimeter, double stretch) {
  const double height = world::tessellation_error(result.world) * stretch;
  return lengths(result, perimeter, 0, guaranteed_part + 2 * M_PI * height / perimeter);
}

}  // namespace

Measured outline_of(const Lab& lab, const Shape& convex) {
  const projection::Projection p = orthographic({0.3, -0.8, 0.5});
  std::vector<Vec2> corners;
  for (const Point& point : convex.points) {
    const Vec3 x(point[0], point[1], point[2]);
    corners.emplace_back(glm::dot(p.u, x), glm::dot(p.v, x));
  }
  return convex_outline(lab.draw(lab.world_of(convex), {p}), perimeter_of_hull(std::move(corners)), 1);
}

Measured sphere_from_anywhere(const Lab& lab, int meridians, int bands, double distance) {
  const Shape sphere = uv_sphere(meridians, bands);
  const Vec3 towards = glm::normalize(Vec3(0.3, -0.8, 0.5));
  const bool central = std::isfinite(distance);
  const projection::Projection p =
      central ? perspective(distance * towards, {0, 0, 0}, towards, {0, 0, 1}) : orthographic(towards);
  std::vector<Vec2> corners;
  for (const Point& point : sphere.points) {
    const Vec3 x(point[0], point[1], point[2]);
    const double grown = central ? 1 / (1 - glm::dot(p.n, x) / distance) : 1;
    corners.push_back(grown * Vec2(glm::dot(p.u, x), glm::dot(p.v, x)));
  }
  // Of the distance from the middle on the page, at the contour.
  const double stretch = central ? std::pow(1 - 1 / (distance * distance), -1.5) : 1;
  return convex_outline(lab.draw(lab.world_of(sphere), {p}), perimeter_of_hull(std::move(corners)), stretch);
}

namespace {

std::vector<Vec3> random_segments(int count) {
  std::mt19937 random(count);
  const auto coordinate = [&] { return static_cast<double>(random() % 20001) - 10000; };
  std::vector<Vec3> segments;
  for (int i = 0; i < count; ++i) {
    const double x = coordinate(), y = coordinate(), z = coordinate();
    segments.emplace_back(x, y, z);
  }
  return segments;
}

// Integer coordinates: corners are exact, and the same in all faces that meet there.
Shape sum_of(const std::vector<Vec3>& segments) {
  Shape shape;
  std::map<Point, int> places;
  const auto corner = [&](const Vec3& p) {
    const auto [place, made] = places.try_emplace({p.x, p.y, p.z}, static_cast<int>(shape.points.size()));
    if (made) shape.points.push_back({p.x, p.y, p.z});
    return place->second;
  };
  for (const Vec3& a : segments)
    for (const Vec3& b : segments) {
      if (&a == &b) continue;
      const Vec3 normal = glm::cross(a, b);
      Vec3 p(0);
      for (const Vec3& s : segments)
        if (&s != &a && &s != &b && glm::dot(s, normal) > 0) p += s;
      shape.faces.push_back({corner(p), corner(p + a), corner(p + a + b), corner(p + b)});
    }
  return shape;
}

}  // namespace

Measured zonotope(const Lab& lab, int zones) {
  const std::vector<Vec3> segments = random_segments(zones);
  const Shape shape = sum_of(segments);
  const projection::Projection view = orthographic({0.3, -0.8, 0.5});
  double sum = 0;
  for (const Vec3& s : segments) sum += std::hypot(glm::dot(s, view.u), glm::dot(s, view.v));
  Measured measured = lengths(lab.draw(lab.world_of(shape), {view}, {.smooth = true}), zones * sum, (zones - 2) * sum);
  measured.push_back(count("corners", zones * (zones - 1) + 2, static_cast<double>(shape.points.size())));
  return measured;
}

namespace {

// A square floor and frames around it, each higher than the one inside it. Returns half the sides of the squares.
std::vector<double> add_stadium(Shape& shape, double size) {
  const int steps = 20;
  std::vector<double> squares;
  const auto square = [&](double half, double z) {
    const int first = static_cast<int>(shape.points.size());
    shape.points.insert(shape.points.end(), {{-half, -half, z}, {half, -half, z}, {half, half, z}, {-half, half, z}});
    return first;
  };
  const auto band = [&](int inner, int outer) {
    for (int k = 0; k < 4; ++k) shape.faces.push_back({inner + k, outer + k, outer + (k + 1) % 4, inner + (k + 1) % 4});
  };
  int last = square(size / steps, -2);
  shape.faces.push_back({last, last + 1, last + 2, last + 3});
  for (int i = 1; i < steps; ++i) {
    squares.push_back(size * i / steps);
    const int raised = square(squares.back(), i);
    band(last, raised);
    last = square(size * (i + 1) / steps, i);
    band(raised, last);
  }
  squares.push_back(size);
  return squares;
}

double visible_length(const Result& result, int model) {
  double sum = 0;
  for (const drawing::Segment& s : result.drawing.segments)
    if (s.visible && s.model == model) sum += result.unit * glm::length(s.to - s.from);
  return sum;
}

}  // namespace

Measured sphere_in_a_stadium(const Lab& lab, int meridians, int bands, double size) {
  Shape stadium;
  double sides = 0;
  for (const double half : add_stadium(stadium, size)) sides += 8 * half;
  const Result result = lab.draw(lab.world_of({uv_sphere(meridians, bands), stadium}), {from_above()});
  const double outline = 2 * meridians * std::sin(M_PI / meridians);
  return {length("of the sphere", outline, visible_length(result, 0), result.extent()),
          length("of the stadium", sides, visible_length(result, 1), sides),
          length("hidden", 0, result.hidden_length(), result.extent())};
}

}  // namespace epura::stability
