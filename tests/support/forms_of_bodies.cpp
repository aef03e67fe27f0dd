#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <random>

#include "forms.hpp"

namespace epura::test {

Shape uv_sphere(int meridians, int bands) {
  Shape sphere{{{0, 0, -1}}, {}, {}};
  for (int j = 1; j < bands; ++j)
    for (int i = 0; i < meridians; ++i) {
      const double b = M_PI * j / bands - M_PI / 2, a = 2 * M_PI * i / meridians;
      sphere.points.push_back({std::cos(b) * std::cos(a), std::cos(b) * std::sin(a), std::sin(b)});
    }
  const int top = static_cast<int>(sphere.points.size());
  sphere.points.push_back({0, 0, 1});
  const auto at = [&](int j, int i) { return 1 + (j - 1) * meridians + (i % meridians); };
  for (int i = 0; i < meridians; ++i) {
    sphere.faces.push_back({0, at(1, i + 1), at(1, i)});
    for (int j = 1; j + 1 < bands; ++j)
      sphere.faces.push_back({at(j, i), at(j, i + 1), at(j + 1, i + 1), at(j + 1, i)});
    sphere.faces.push_back({at(bands - 1, i), at(bands - 1, i + 1), top});
  }
  return sphere;
}

void expect_sphere_along_its_axis(int meridians, int bands) {
  const Result result = draw(world_of(uv_sphere(meridians, bands)), from_above());
  EXPECT_NEAR(result.visible(), 2 * meridians * std::sin(M_PI / meridians), 1e-8);
  EXPECT_NEAR(result.hidden_length(), 0, 1e-12);
  ASSERT_EQ(result.drawing.chains.size(), 1U);
  EXPECT_TRUE(result.drawing.chains[0].closed);
}

void expect_sphere_from_anywhere(int meridians, int bands) {
  const World world = world_of(uv_sphere(meridians, bands));
  // The mesh contains a sphere that is smaller by half the square of half a diagonal; in the nearest view below that
  // takes 1.8 times as much off the outline.
  const double half_diagonal = M_PI / meridians + M_PI / (2.0 * bands);
  const double lost = half_diagonal * half_diagonal;
  const auto expect_circle = [&](const Result& result, double radius) {
    EXPECT_NEAR(result.hidden_length(), 0, 1e-12);
    EXPECT_LT(result.visible(), 2 * M_PI * radius * (1 + 1e-8));
    EXPECT_GT(result.visible(), 2 * M_PI * radius * (1 - lost));
  };
  expect_circle(draw(world, orthographic({1, 0, 0})), 1);
  const Vec3 towards = glm::normalize(Vec3(0.3, -0.8, 0.5));
  expect_circle(draw(world, orthographic(towards)), 1);
  for (const double distance : {1.5, 10.0})
    expect_circle(draw(world, perspective(distance * towards, {0, 0, 0}, towards, {0, 0, 1})),
                  distance / std::sqrt(distance * distance - 1));
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

// Whole coordinates: corners are exact, and where faces meet they are the same.
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

void expect_zonotope(int zones) {
  const std::vector<Vec3> segments = random_segments(zones);
  const Shape shape = sum_of(segments);
  ASSERT_EQ(shape.points.size(), zones * (zones - 1) + 2);
  const Projection view = orthographic({0.3, -0.8, 0.5});
  double sum = 0;
  for (const Vec3& s : segments) sum += std::hypot(glm::dot(s, view.u), glm::dot(s, view.v));
  const Result result = draw(world_of(shape), view, {.smooth = true});
  EXPECT_NEAR(result.visible(), zones * sum, 1e-8 * zones * sum);
  EXPECT_NEAR(result.hidden_length(), (zones - 2) * sum, 1e-8 * zones * sum);
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
  for (const Segment& s : result.drawing.segments)
    if (s.visible && s.model == model) sum += result.unit * glm::length(s.to - s.from);
  return sum;
}

}  // namespace

void expect_sphere_in_a_stadium(int meridians, int bands, double size) {
  Shape stadium;
  double sides = 0;
  for (const double half : add_stadium(stadium, size)) sides += 8 * half;
  const Result result = draw(world_of({uv_sphere(meridians, bands), stadium}), from_above());
  EXPECT_NEAR(visible_length(result, 0), 2 * meridians * std::sin(M_PI / meridians), 1e-9 * size * meridians);
  EXPECT_NEAR(visible_length(result, 1), sides, 1e-9 * sides);
  EXPECT_NEAR(result.hidden_length(), 0, 1e-12);
}

}  // namespace epura::test
