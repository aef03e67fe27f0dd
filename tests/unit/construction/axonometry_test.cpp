// SPDX-License-Identifier: Apache-2.0
#include "construction/axonometry.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "projection/matrices.hpp"

namespace epura::construction::axonometry_test {
namespace {

PicturePlane parallel(const Vec3& u, const Vec3& v, const Vec3& projector) {
  projection::Projection p;
  p.u = u;
  p.v = v;
  p.n = glm::cross(u, v);
  p.projector = projector;
  return picture_plane(p, projection::view_matrix(p), 1);
}

PicturePlane isometric() {
  const Vec3 n = glm::normalize(Vec3(1, -1, 1)), u = glm::normalize(Vec3(1, 1, 0));
  return parallel(u, glm::cross(n, u), n);
}

// On the front face: x and z in true length, y at 45 degrees with this ratio.
PicturePlane oblique(double ratio) {
  const double half = ratio * std::sqrt(0.5);
  return parallel({1, 0, 0}, {0, 0, 1}, Vec3(half, -1, half));
}

Figure key(const PicturePlane& plane, const std::string& kind, double factor = 1) {
  const std::vector<Request> requests{{scene::parse_construction(kind, "test"), "test"}};
  const Figure figure = axonometry_figure(plane, factor, requests);
  return figure.keys.at(0);
}

bool has(const Figure& figure, const std::string& symbol) {
  const auto is_symbol = [&](const auto& of) { return of.symbol.text() == symbol; };
  return std::any_of(figure.points.begin(), figure.points.end(), is_symbol) ||
         std::any_of(figure.curves.begin(), figure.curves.end(), is_symbol);
}

TEST(Axonometry, IsometricAxesAreEquallyShortenedAt30Degrees) {
  for (const Vec2& image : axis_images(isometric(), 1)) EXPECT_NEAR(glm::length(image), std::sqrt(2.0 / 3), 1e-12);
  const Figure axes = key(isometric(), "axes");
  EXPECT_TRUE(has(axes, "x 0.816"));
  EXPECT_TRUE(has(axes, "z 0.816"));
  EXPECT_TRUE(has(axes, "30°"));
  EXPECT_TRUE(has(key(isometric(), "axes", std::sqrt(1.5)), "y 1")) << "drawn with a factor, as is usual";
}

TEST(Axonometry, ObliqueAxesHaveTheirRatioAngleAndSlope) {
  const Figure cavalier = key(oblique(1), "axes"), cabinet = key(oblique(0.5), "axes");
  for (const char* symbol : {"x 1", "y 1", "z 1", "45°", "projectors 45° to the picture"})
    EXPECT_TRUE(has(cavalier, symbol)) << symbol;
  for (const char* symbol : {"x 1", "y 0.5", "45°", "projectors 63.4° to the picture"})
    EXPECT_TRUE(has(cabinet, symbol)) << symbol;
}

// Each angle at its axis: the arc runs from the horizontal line to the axis and bears the angle between both.
TEST(Axonometry, AnglesAreAtTheirAxes) {
  const Vec3 n = glm::normalize(Vec3(0.7, -0.5, 0.4)), u = glm::normalize(glm::cross(Vec3(0, 0, 1), n));
  for (const PicturePlane& plane :
       {isometric(), oblique(0.5), parallel(u, glm::cross(n, u), n),
        parallel(glm::normalize(u + 0.3 * glm::cross(n, u)), glm::normalize(glm::cross(n, u) - 0.3 * u), n)}) {
    std::size_t oblique_axes = 0;
    const Figure axes = key(plane, "axes");
    for (const Vec2& image : axis_images(plane, 1)) {
      const double degrees = std::atan2(std::abs(image.y), std::abs(image.x)) * 180 / std::numbers::pi;
      if (degrees < 0.01 || degrees > 89.99) continue;
      ++oblique_axes;
      const auto is_its = [&](const Curve& arc) {
        const double along = std::atan2(image.y, image.x);
        const auto is_along = [&](double angle) {
          return std::abs(std::remainder(angle - along, 2 * std::numbers::pi)) < 1e-9;
        };
        const double other = is_along(arc.from) ? arc.to : arc.from;
        return (is_along(arc.from) || is_along(arc.to)) && std::abs(std::sin(other)) < 1e-9 &&
               std::abs((arc.to - arc.from) * 180 / std::numbers::pi - degrees) < 1e-9 &&
               std::abs(std::stod(arc.symbol.base) - degrees) < 0.05;
      };
      EXPECT_EQ(std::count_if(axes.curves.begin(), axes.curves.end(), is_its), 1) << degrees;
    }
    EXPECT_EQ(axes.curves.size(), oblique_axes);
  }
}

// Points of the projected circle satisfy the equation of the ellipse.
TEST(Axonometry, EllipsesAreProjectedCircles) {
  for (const PicturePlane& plane : {isometric(), oblique(1), oblique(0.5)}) {
    const auto images = axis_images(plane, 1);
    for (int i = 0; i < 3; ++i) {
      const Vec2 &p = images[static_cast<std::size_t>(i)], &q = images[static_cast<std::size_t>((i + 1) % 3)];
      const Curve ellipse = ellipse_of({3, 4}, p, q);
      EXPECT_NEAR(glm::dot(ellipse.u, ellipse.v), 0, 1e-12);
      EXPECT_GE(glm::length(ellipse.u), glm::length(ellipse.v));
      for (int a = 0; a < 360; a += 11) {
        const double t = a * std::numbers::pi / 180;
        const Vec2 on_circle = std::cos(t) * p + std::sin(t) * q;
        const double x = glm::dot(on_circle, ellipse.u) / glm::dot(ellipse.u, ellipse.u);
        const double y = glm::dot(on_circle, ellipse.v) / glm::dot(ellipse.v, ellipse.v);
        EXPECT_NEAR(x * x + y * y, 1, 1e-12);
      }
    }
  }
}

// Isometric circles are as long as the circle and 1/sqrt 3 as wide; the front circle of an oblique view stays one.
TEST(Axonometry, EllipsesHaveTheirAxes) {
  const Figure faces = key(isometric(), "ellipses");
  ASSERT_EQ(faces.curves.size(), 3U);
  for (const Curve& ellipse : faces.curves)
    EXPECT_NEAR(glm::length(ellipse.v) / glm::length(ellipse.u), 1 / std::sqrt(3.0), 1e-12);
  EXPECT_TRUE(has(faces, "1:0.577"));
  EXPECT_TRUE(has(key(oblique(1), "ellipses"), "1:1"));
}

// In orthographic views, the axes are the altitudes of the triangle.
TEST(Axonometry, TheOriginIsTheOrthocentreOfTheTraceTriangle) {
  const Vec3 n = glm::normalize(Vec3(0.7, -0.5, 0.4)), u = glm::normalize(glm::cross(Vec3(0, 0, 1), n));
  const Figure triangle = key(parallel(u, glm::cross(n, u), n), "trace-triangle");
  std::vector<Vec2> traces;
  for (const Point& point : triangle.points)
    if (point.symbol.base == "T") traces.push_back(point.at);
  ASSERT_EQ(traces.size(), 3U);
  for (std::size_t i = 0; i < 3; ++i)
    EXPECT_NEAR(glm::dot(traces[i], traces[(i + 1) % 3] - traces[(i + 2) % 3]), 0, 1e-9);
  EXPECT_THROW(key(oblique(1), "trace-triangle"), Error) << "x and z are parallel to the picture";
}

}  // namespace
}  // namespace epura::construction::axonometry_test
