// SPDX-License-Identifier: Apache-2.0
// The search for intersection lines among candidates finds, to the last bit, what it finds among all triangles.
#include "edges/crossing_candidates.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <set>

#include "edges/intersections.hpp"
#include "shapes.hpp"

namespace epura::test::crossing_candidates_test {
namespace {

class Bodies {
 public:
  explicit Bodies(unsigned seed) : random_(seed) {}

  double number() { return static_cast<double>(random_()) / 4294967296.0; }

  // Boxes, prisms and double pyramids, turned or not; a few are dented or open.
  Shape body() {
    Shape shape = random_() % 3 == 0 ? box({-0.5, -0.5, -0.5}, {0.5, 0.5, 0.5}) : round(3 + int(random_() % 40));
    if (random_() % 6 == 0) shape.faces.pop_back();
    if (random_() % 6 == 0) shape.points[random_() % shape.points.size()][2] *= 0.9;
    if (random_() % 2 == 0) turn(shape);
    const double size = std::pow(2.0, -static_cast<double>(random_() % 5));
    const double steps = random_() % 2 == 0 ? 2 : 0;  // so that some touch
    const auto place = [&] { return steps > 0 ? std::round(4 * steps * number()) / steps : 4 * number(); };
    return shape.scaled(size).moved(place(), place(), place());
  }

 private:
  Shape round(int sides) {
    Shape shape;
    const bool pointed = random_() % 2 == 0;
    for (int i = 0; i < sides; ++i) {
      const double a = 2 * M_PI * i / sides;
      shape.points.push_back({std::cos(a) / 2, std::sin(a) / 2, pointed ? 0 : -0.5});
      shape.points.push_back({std::cos(a) / 2, std::sin(a) / 2, 0.5});
    }
    const int below = static_cast<int>(shape.points.size());
    shape.points.push_back({0, 0, -0.5});
    shape.points.push_back({0, 0, 0.5});
    for (int i = 0; i < sides; ++i) {
      const int a = 2 * i, b = 2 * ((i + 1) % sides);
      shape.faces.push_back({b, a, below});
      shape.faces.push_back({a, b, b + 1, a + 1});
      shape.faces.push_back({a + 1, b + 1, below + 1});
    }
    return shape;
  }

  void turn(Shape& shape) {
    const double a = 6 * number(), b = 6 * number();
    for (Point& p : shape.points) {
      const auto [x, y, z] = p;
      const double u = std::cos(a) * x - std::sin(a) * y, v = std::sin(a) * x + std::cos(a) * y;
      p = {u, std::cos(b) * v - std::sin(b) * z, std::sin(b) * v + std::cos(b) * z};
    }
  }

  std::mt19937 random_;
};

TEST(Candidates, HaveAllIntersections) {
  int left_out = 0, crossings = 0;
  for (unsigned seed = 1; seed <= 300; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Bodies bodies(seed);
    std::vector<Shape> shapes;
    const int count = 1 + static_cast<int>(12 * bodies.number());
    for (int i = 0; i < count; ++i) shapes.push_back(bodies.body());
    const world::World world = world_of(shapes);
    for (const double contact : {0.0, 0x1p-40, 0x1p-29, 0x1p-20, 0x1p-8}) {
      const edges::CrossingCandidates all = edges::all_triangles(world);
      const edges::CrossingCandidates candidates = edges::crossing_candidates(world, 0x1p-2, contact);
      const edges::FaceCrossings expected = edges::find_intersections(world, 0x1p-2, contact, all);
      const edges::FaceCrossings found = edges::find_intersections(world, 0x1p-2, contact, candidates);
      left_out += candidates.triangles.size() < all.triangles.size() ? 1 : 0;
      crossings += static_cast<int>(expected.found.size());
      EXPECT_EQ(found.searched, 1);
      ASSERT_EQ(found.found.size(), expected.found.size());
      for (std::size_t i = 0; i < expected.found.size(); ++i) {
        ASSERT_EQ(found.found[i].triangles, expected.found[i].triangles);
        ASSERT_EQ(found.found[i].ends, expected.found[i].ends);
        ASSERT_EQ(found.found[i].angle, expected.found[i].angle);
      }
    }
  }
  EXPECT_GT(left_out, 300);
  EXPECT_GT(crossings, 1000);
}

// What a third copy crosses the first two cross in the same place.
TEST(Candidates, AreTwoOfAllCopies) {
  std::vector<Shape> shapes;
  for (int i = 0; i < 5; ++i) {
    shapes.push_back(box({0, 0, 0}, {2, 2, 2}));
    shapes.push_back(box({1, 1, 1}, {3, 3, 3}));
  }
  const world::World world = world_of(shapes);
  const edges::CrossingCandidates candidates = edges::crossing_candidates(world, 0x1p-2, 0x1p-29);
  EXPECT_EQ(candidates.triangles.size(), 2U * 24);
  const auto places = [&](const edges::CrossingCandidates& triangles) {
    std::set<std::array<double, 6>> found;
    for (const edges::FaceCrossing& crossing : edges::find_intersections(world, 0x1p-2, 0x1p-29, triangles).found) {
      const auto& [a, b] = crossing.ends;
      found.insert({a.x, a.y, a.z, b.x, b.y, b.z});
    }
    return found;
  };
  EXPECT_EQ(places(candidates), places(edges::all_triangles(world)));
  EXPECT_GE(places(candidates).size(), 6U);
}

}  // namespace
}  // namespace epura::test::crossing_candidates_test
