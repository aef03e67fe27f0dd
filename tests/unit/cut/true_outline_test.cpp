// SPDX-License-Identifier: Apache-2.0
#include "cut/true_outline.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>
#include <vector>

#include "../features/recognised.hpp"
#include "cut/cut_world.hpp"

namespace epura::test::true_outline_test {
namespace {

using Distance = std::function<double(const Vec3&)>;

struct Plane {
  Vec3 point, normal;
};

cut::CutWorld cut(const world::World& world, const Plane& plane) {
  return cut::cut_world(world, scene::make_cutting_plane({{"A", "--section"}, plane.point, plane.normal}));
}

std::vector<Vec3> outline_of(const cut::CutWorld& cut) {
  std::vector<Vec3> points;
  for (const cut::WorldCutFace& face : cut.faces)
    for (const auto& ring : face.rings)
      for (const int v : ring) points.push_back(cut.world.points[v]);
  return points;
}

/// The largest distance from the nearest surface of a part, and from the plane.
double error_of(const std::vector<Vec3>& outline, const Plane& plane, const std::vector<Distance>& surfaces) {
  double error = 0;
  for (const Vec3& p : outline) {
    double nearest = HUGE_VAL;
    for (const Distance& distance : surfaces) nearest = std::min(nearest, std::abs(distance(p)));
    error = std::max({error, nearest, std::abs(glm::dot(p - plane.point, glm::normalize(plane.normal)))});
  }
  return error;
}

double area_of(const cut::CutWorld& cut) {
  double sum = 0;
  for (const cut::WorldCutFace& face : cut.faces)
    for (const auto& ring : face.rings) {
      Vec3 twice(0);
      for (std::size_t i = 0; i < ring.size(); ++i)
        twice += glm::cross(cut.world.points[ring[i]] - cut.world.points[ring[0]],
                            cut.world.points[ring[(i + 1) % ring.size()]] - cut.world.points[ring[0]]);
      sum += glm::length(twice) / 2;
    }
  return sum;
}

bool is_closed(const cut::CutWorld& cut) {
  for (const world::Placed& model : cut.world.models)
    for (const mesh::MeshEdge& edge : model.mesh->edges)
      if (edge.count != 2 && edge.cut == mesh::CutEdge::none) return false;
  return true;
}

double from_axis(const Vec3& p) { return std::hypot(p.x, p.y); }

Distance sphere(double radius) {
  return [=](const Vec3& p) { return glm::length(p) - radius; };
}
Distance cylinder(double radius) {
  return [=](const Vec3& p) { return from_axis(p) - radius; };
}
Distance torus(double radius, double minor, double height = 0) {
  return [=](const Vec3& p) { return std::hypot(from_axis(p) - radius, p.z - height) - minor; };
}
Distance cone(double radius, double slope) {
  return [=](const Vec3& p) { return (from_axis(p) - radius - slope * p.z) / std::hypot(1, slope); };
}
Distance level(double z) {
  return [=](const Vec3& p) { return p.z - z; };
}

Part ball(double radius, int bands) {
  std::vector<Vec2> profile = arc({0, 0}, radius, -90, 90, bands);
  profile.front().x = profile.back().x = 0;
  return revolved(profile, 2 * bands).triangulate();
}

Part ring(double radius, double minor, int steps) {
  std::vector<Vec2> profile = arc({radius, 0}, minor, -180, 180, steps);
  Part part = revolved(profile, 2 * steps);
  // The ends of the profile are one.
  const int last = static_cast<int>(part.points.size()) - 2 * steps;
  for (auto& face : part.faces)
    for (int& v : face)
      if (v >= last) v -= last;
  part.points.resize(static_cast<std::size_t>(last));
  return part.triangulate();
}

Vec3 direction(std::mt19937& random) {
  std::normal_distribution<double> normal;
  return glm::normalize(Vec3(normal(random), normal(random), normal(random)));
}

void expect_on(const world::World& world, const Plane& plane, const std::vector<Distance>& surfaces) {
  const cut::CutWorld result = cut(world, plane);
  const std::vector<Vec3> outline = outline_of(result);
  ASSERT_FALSE(outline.empty());
  EXPECT_LT(error_of(outline, plane, surfaces), 1e-9);
  EXPECT_TRUE(is_closed(result));
  EXPECT_TRUE(result.open.empty());
  EXPECT_TRUE(result.bridged.empty());
}

TEST(TrueOutline, OfABallIsItsCircle) {
  constexpr double radius = 45.83;
  std::mt19937 random(1);
  for (const int bands : {10, 60}) {
    const world::World world = world_of(ball(radius, bands));
    const double sagitta = radius * (1 - std::pow(std::cos(pi / bands / 2), 2));
    for (int i = 0; i < 20; ++i) {
      const Vec3 normal = direction(random);
      const double height = radius * i / 25;
      const Plane plane{height * normal, normal};
      expect_on(world, plane, {sphere(radius)});
      const cut::CutWorld result = cut(world, plane);
      const double circle = std::sqrt(radius * radius - height * height);
      EXPECT_LE(result.moved, 1.01 * sagitta * radius / circle);
      EXPECT_LT(area_of(result), pi * circle * circle);
      EXPECT_GT(area_of(result), area_of(cut(world::make_world({{world.models[0].mesh}}), plane)));
    }
  }
}

TEST(TrueOutline, OfAnObliquelyCutShaftIsAnEllipse) {
  std::mt19937 random(2);
  for (const int sides : {12, 90})
    for (const double turn : {0.0, 0.1}) {
      const world::World world = world_of(prism(regular_polygon(sides, 20), 50)
                                              .move([&](const Vec3& p) {
                                                return Vec3(std::cos(turn) * p.x - std::sin(turn) * p.y,
                                                            std::sin(turn) * p.x + std::cos(turn) * p.y, p.z);
                                              })
                                              .triangulate());
      const std::vector<Distance> surfaces{cylinder(20), level(0), level(50)};
      expect_on(world, {{0, 0, 25}, {0.5, 0.2, 1}}, surfaces);
      // Through the end, through both ends, and beside the axis.
      expect_on(world, {{0, 0, 45}, {1, 0.3, 1}}, surfaces);
      expect_on(world, {{0, 0, 25}, {3, 0.4, 1}}, surfaces);
      expect_on(world, {{7, 3, 25}, {2, 1, 0}}, surfaces);
      for (int i = 0; i < 10; ++i) expect_on(world, {{0, 0, 25}, direction(random)}, surfaces);
    }
}

TEST(TrueOutline, OfAConeIsAConicSection) {
  for (const int steps : {12, 80}) {
    const world::World world =
        world_of(revolved(std::vector<Vec2>{{0, 0}, {30, 0}, {10, 40}, {0, 40}}, steps).triangulate());
    const std::vector<Distance> surfaces{cone(30, -0.5), level(0), level(40)};
    expect_on(world, {{0, 0, 20}, {0, 0, 1}}, surfaces);       // a circle
    expect_on(world, {{0, 0, 20}, {0.2, 0.1, 1}}, surfaces);   // an ellipse
    expect_on(world, {{1, 2, 20}, {2, 0.3, 1}}, surfaces);     // a parabola
    expect_on(world, {{8, 3, 0}, {1, 0.2, 0}}, surfaces);      // a hyperbola
    expect_on(world, {{0, 0, 0}, {0.97, 0.13, 0}}, surfaces);  // two generators
  }
}

TEST(TrueOutline, OfARingByPlanesThroughAndBesideItsAxis) {
  for (const int steps : {12, 40}) {
    const world::World world = world_of(ring(30, 8, steps));
    for (const Plane& plane : std::vector<Plane>{{{0, 0, 0}, {0.9, 0.37, 0}},  // two circles
                                                 {{0, 0, 0}, {0, 0, 1}},       // two others
                                                 {{0, 0, 3}, {0, 0, 1}},
                                                 {{0, 12, 0}, {0.1, 1, 0}},  // two ovals
                                                 {{0, 30, 0}, {0.1, 1, 0}},  // one
                                                 {{0, 0, 0}, {0.1, 0.2, 1}}})
      expect_on(world, plane, {torus(30, 8)});
  }
}

// A plane, a tube and a cylinder that touch in circles.
TEST(TrueOutline, TangentFacesStayJoined) {
  for (const int steps : {4, 12}) {
    std::vector<Vec2> profile = joined({{{0, 0}, {20, 0}}, arc({20, 5}, 5, -90, 0, steps), {{25, 30}, {0, 30}}});
    const world::World world = world_of(revolved(profile, 8 * steps).triangulate());
    const std::vector<Distance> surfaces{cylinder(25), torus(20, 5, 5), level(0), level(30)};
    for (const Plane& plane : std::vector<Plane>{{{0, 0, 0}, {0.9, 0.37, 0}}, {{0, 4, 0}, {0.2, 1, 0}}})
      // Where they touch, a point is on one of them, and nearly on the other.
      expect_on(world, plane, surfaces);
  }
}

TEST(TrueOutline, OfABoreLiesBetweenItsEnds) {
  const world::World world = world_of(plate_with_hole({{15, 15}, {-15, 15}, {-15, -15}, {15, -15}}, 10, 6, 5));
  const Distance wall = [](const Vec3& p) { return std::max(std::abs(p.x), std::abs(p.y)) - 15; };
  const Plane plane{{2.5, 0, 0}, {1, 0.2, 0}};
  expect_on(world, plane, {cylinder(6), level(0), level(10), wall});
  EXPECT_GT(cut(world, plane).moved, 0);
}

TEST(TrueOutline, OfAMeshIsThatOfItsFacets) {
  const world::World mesh = world::make_world({{std::make_shared<const mesh::Mesh>(ball(10, 12).mesh())}});
  const Plane plane{{0, 0, 1}, {0.3, 0.2, 1}};
  const cut::CutWorld result = cut(mesh, plane);
  EXPECT_EQ(result.moved, 0);
  EXPECT_GT(error_of(outline_of(result), plane, {sphere(10)}), 0.05);
}

TEST(TrueOutline, SteppedCutsAndOtherUnitsAreAlike) {
  for (const char* transform : {"scale:1", "scale:1e-3", "scale:1e4"}) {
    const world::World world = world_of(ball(10, 12), transform);
    const double unit = scene::parse_transform(transform)[0][0];
    const std::vector<Vec3> path{unit * Vec3(-12, 1, 0), unit * Vec3(2, 1, 0), unit * Vec3(2, -3, 0),
                                 unit * Vec3(12, -3, 0)};
    const scene::SectionDescription section{{"A", "--section"}, Vec3(0), Vec3(0, -1, 0), {path, "a.toml:4:8"}};
    const cut::CutWorld stepped = cut::cut_world(world, cut::make_cutting_surface(section));
    int on = 0;
    for (const Vec3& p : outline_of(stepped)) {
      const double off = std::abs(glm::length(p) - 10 * unit);
      if (off < 1e-10 * unit) ++on;
    }
    EXPECT_GT(on, 20);
    EXPECT_GT(stepped.moved, 0);
  }
}

}  // namespace
}  // namespace epura::test::true_outline_test
