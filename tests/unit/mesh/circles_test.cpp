// SPDX-License-Identifier: Apache-2.0
// What would break if this were wrong: centre lines, diameters, and polygons taken for circles.
#include "mesh/circles.hpp"

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <numbers>
#include <random>

#include "support.hpp"

namespace epura::circles_test {
namespace {

using test::mesh_of;

constexpr double pi = std::numbers::pi;

std::vector<double> equal_angles(int n) {
  std::vector<double> angles;
  for (int i = 0; i < n; ++i) angles.push_back(2 * pi * i / n);
  return angles;
}

std::vector<Vec2> ring(double radius, const std::vector<double>& angles, Vec2 centre = {0, 0}) {
  std::vector<Vec2> points;
  for (const double a : angles) points.push_back(centre + radius * Vec2(std::cos(a), std::sin(a)));
  return points;
}

struct Shape {
  mesh::Points points;
  std::vector<std::vector<int>> faces;

  // The outline from z = 0 to z = height, with caps.
  void add_prism(const std::vector<Vec2>& outline, double height) {
    const int n = static_cast<int>(outline.size()), first = static_cast<int>(points.size());
    std::vector<int> top, bottom;
    for (int i = 0; i < 2 * n; ++i)
      points.push_back({outline[std::size_t(i % n)].x, outline[std::size_t(i % n)].y, i < n ? 0 : height});
    for (int i = 0; i < n; ++i) {
      bottom.insert(bottom.begin(), first + i);
      top.push_back(first + n + i);
      faces.push_back({first + i, first + (i + 1) % n, first + n + (i + 1) % n, first + n + i});
    }
    faces.push_back(top);
    faces.push_back(bottom);
  }
  void move(const std::function<Vec3(Vec3)>& where) {
    for (auto& p : points) {
      const Vec3 to = where({p[0], p[1], p[2]});
      p = {to.x, to.y, to.z};
    }
  }
  [[nodiscard]] std::vector<mesh::MeshCircle> circles(double tolerance = 1e-3) const {
    return mesh::find_circles(mesh_of(points, faces), 30, tolerance);
  }
};

Shape prism(const std::vector<Vec2>& outline, double height = 3) {
  Shape shape;
  shape.add_prism(outline, height);
  return shape;
}

class Shafts : public testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(Circles, Shafts, testing::Values(12, 13, 16, 24, 64, 200, 5000));

TEST_P(Shafts, HaveACircleAtBothEnds) {
  const auto circles = prism(ring(7, equal_angles(GetParam()), {20, -5})).circles();
  ASSERT_EQ(circles.size(), 2);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_TRUE(circles[i].whole);
    EXPECT_EQ(circles[i].vertices.size(), std::size_t(GetParam()));
    EXPECT_NEAR(circles[i].radius, 7, 1e-10);
    EXPECT_LT(glm::distance(circles[i].centre, Vec3(20, -5, 3 * double(i))), 1e-9);
    EXPECT_NEAR(std::abs(circles[i].axis.z), 1, 1e-12);
    EXPECT_LT(circles[i].deviation, 1e-10);
  }
  EXPECT_EQ(circles[0].vertices[0], 0);
  EXPECT_EQ(circles[0].vertices[1], 1);
}

TEST(Circles, FewerThanTwelveCornersAreAPolygon) {
  for (int n = 3; n < 12; ++n) EXPECT_TRUE(prism(ring(7, equal_angles(n))).circles().empty()) << n;
}

TEST(Circles, AreTheSameInTurnedFrames) {
  Shape shape = prism(ring(0.02, equal_angles(40)));
  const auto before = shape.circles();
  const Mat4 turn = glm::rotate(glm::translate(Mat4(1), Vec3(100, 50, -80)), 1.1, glm::normalize(Vec3(1, 2, -3)));
  shape.move([&](Vec3 p) { return Vec3(turn * Vec4(p, 1)); });
  const auto after = shape.circles();
  ASSERT_EQ(after.size(), before.size());
  for (std::size_t i = 0; i < before.size(); ++i) {
    EXPECT_EQ(after[i].vertices, before[i].vertices);
    EXPECT_LT(glm::distance(after[i].centre, Vec3(turn * Vec4(before[i].centre, 1))), 1e-10);
    EXPECT_LT(glm::distance(after[i].axis, Mat3(turn) * before[i].axis), 1e-9);
  }
}

TEST(Circles, HaveUnequalSteps) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> jitter(-0.3, 0.3);
  std::vector<double> angles = equal_angles(32);
  for (double& a : angles) a += jitter(random) * 2 * pi / 32;
  const auto circles = prism(ring(7, angles)).circles();
  ASSERT_EQ(circles.size(), 2);
  EXPECT_TRUE(circles[0].whole && circles[1].whole);
}

TEST(Circles, OfScansAreFoundWithinTheTolerance) {
  Shape shape = prism(ring(7, equal_angles(100)));
  std::mt19937 random(9);
  std::uniform_real_distribution<double> noise(-0.004, 0.004);
  shape.move([&](Vec3 p) { return p + Vec3(noise(random), noise(random), noise(random)); });
  EXPECT_TRUE(shape.circles(1e-4).empty());
  const auto circles = shape.circles(1.5e-3);
  ASSERT_EQ(circles.size(), 2);
  for (const mesh::MeshCircle& circle : circles) {
    EXPECT_TRUE(circle.whole);
    EXPECT_NEAR(circle.radius, 7, 0.004);
    EXPECT_GT(circle.deviation, 0.002);
    EXPECT_LE(circle.deviation, 1.5e-3 * circle.radius);
  }
}

// Two half circles and two lines; the ring begins in the middle of one of the arcs.
TEST(Circles, EndsOfASlotAreArcs) {
  std::vector<Vec2> outline;
  const int n = 16;
  for (int i = n / 2; i <= n; ++i)
    outline.push_back(Vec2(10, 0) + 4.0 * Vec2(std::sin(pi * i / n), -std::cos(pi * i / n)));
  for (int i = 0; i <= n; ++i)
    outline.push_back(Vec2(-10, 0) - 4.0 * Vec2(std::sin(pi * i / n), -std::cos(pi * i / n)));
  for (int i = 0; i < n / 2; ++i)
    outline.push_back(Vec2(10, 0) + 4.0 * Vec2(std::sin(pi * i / n), -std::cos(pi * i / n)));
  const auto arcs = prism(outline).circles();
  ASSERT_EQ(arcs.size(), 4);
  for (const mesh::MeshCircle& arc : arcs) {
    EXPECT_FALSE(arc.whole);
    EXPECT_EQ(arc.vertices.size(), std::size_t(n + 1));
    EXPECT_NEAR(arc.radius, 4, 1e-9);
    EXPECT_NEAR(std::abs(arc.centre.x), 10, 1e-9);
    EXPECT_LT(arc.vertices.front(), arc.vertices.back());
  }
}

TEST(Circles, AFlatOfAShaftIsNoPartOfItsCircle) {
  std::vector<double> angles;
  for (int i = 0; i <= 100; ++i) angles.push_back(2 * pi * (0.05 + 0.9 * i / 100));
  const auto arcs = prism(ring(7, angles)).circles();
  ASSERT_EQ(arcs.size(), 2);
  EXPECT_FALSE(arcs[0].whole);
  EXPECT_EQ(arcs[0].vertices.size(), angles.size());
}

TEST(Circles, EllipsesAndSpiralsAreNone) {
  std::vector<Vec2> ellipse, spiral;
  for (const double a : equal_angles(120)) {
    ellipse.emplace_back(10 * std::cos(a), 7 * std::sin(a));
    spiral.push_back((5 + 2 * a) * Vec2(std::cos(a), std::sin(a)));
  }
  EXPECT_TRUE(prism(ellipse).circles().empty());
  EXPECT_TRUE(prism(spiral).circles().empty());
}

TEST(Circles, ArcsOfAQuarterAreFoundBetweenLines) {
  std::vector<Vec2> outline;
  const std::array<Vec2, 4> corners{Vec2(30, 20), Vec2(-30, 20), Vec2(-30, -20), Vec2(30, -20)};
  for (int c = 0; c < 4; ++c)
    for (int i = 0; i <= 6; ++i) {
      const double a = pi / 2 * (c + i / 6.0);
      outline.push_back(corners[std::size_t(c)] + 5.0 * Vec2(std::cos(a), std::sin(a)));
    }
  const auto arcs = prism(outline).circles();
  ASSERT_EQ(arcs.size(), 8);
  for (const mesh::MeshCircle& arc : arcs) {
    EXPECT_EQ(arc.vertices.size(), 7);
    EXPECT_NEAR(arc.radius, 5, 1e-9);
  }
}

// Found from the whole line again and again, this would take minutes.
TEST(Circles, AreFoundBehindLongLinesOfManyPieces) {
  std::vector<Vec2> outline;
  for (int i = 0; i < 50000; ++i) outline.emplace_back(i * 0.001, 0);
  for (int i = 0; i <= 40; ++i)
    outline.push_back(Vec2(50, 5) + 5.0 * Vec2(std::sin(pi * i / 40), -std::cos(pi * i / 40)));
  outline.emplace_back(0, 10);
  Shape shape = prism(outline);
  shape.faces.resize(shape.faces.size() - 2);  // open: its caps would take longer than what is tested
  const auto arcs = shape.circles();
  ASSERT_EQ(arcs.size(), 2);
  EXPECT_NEAR(arcs[0].radius, 5, 0.001);
}

struct Sample {
  const char* file;
  int whole, arcs;
};

std::ostream& operator<<(std::ostream& out, const Sample& sample) { return out << sample.file; }

class Samples : public testing::TestWithParam<Sample> {};
// Counted in the sources of the models (samples/make), not by the program.
INSTANTIATE_TEST_SUITE_P(Circles, Samples,
                         testing::Values(Sample{"flange.obj", 24, 0}, Sample{"bearing.obj", 34, 4},
                                         Sample{"bracket.obj", 6, 10}, Sample{"shaft.obj", 12, 0},
                                         Sample{"gear.stl", 14, 2}, Sample{"sombrero.obj", 0, 0}));

TEST_P(Samples, HaveTheirCircles) {
  const mesh::Mesh mesh = mesh::read_mesh(std::string(EPURA_TEST_SAMPLES "/models/") + GetParam().file);
  int whole = 0, arcs = 0;
  for (const mesh::MeshCircle& circle : mesh::find_circles(mesh)) ++(circle.whole ? whole : arcs);
  EXPECT_EQ(whole, GetParam().whole);
  EXPECT_EQ(arcs, GetParam().arcs);
}

}  // namespace
}  // namespace epura::circles_test
