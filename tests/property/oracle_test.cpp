// SPDX-License-Identifier: Apache-2.0
// The program against brute force in rational numbers, over random scenes.
#include "oracle.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>

namespace epura::test {
namespace {

constexpr double goal = 1e-6;

using Random = std::mt19937;

double uniform(Random& random, double min, double max) {
  return min + (max - min) * (static_cast<double>(random()) / 4294967296.0);
}

// With `steps` > 0 coordinates lie on a coarse lattice, where everything is aligned, touching and coplanar.
Shape soup(Random& random, int triangles, int steps) {
  Shape shape;
  const auto coordinate = [&] {
    const double c = uniform(random, 0, 1);
    return steps > 0 ? std::round(c * steps) / steps : c;
  };
  for (int i = 0; i < 3 * triangles; ++i) shape.points.push_back({coordinate(), coordinate(), coordinate()});
  for (int i = 0; i < triangles; ++i) shape.faces.push_back({3 * i, 3 * i + 1, 3 * i + 2});
  return shape;
}

Shape boxes(Random& random, int count, int steps) {
  Shape shape;
  const auto side = [&] {
    const double a = uniform(random, 0, 1), b = uniform(random, 0, 1);
    return steps > 0 ? std::array{std::round(a * steps) / steps, std::round(b * steps) / steps + 1.0 / steps}
                     : std::array{std::min(a, b), std::max(a, b)};
  };
  for (int i = 0; i < count; ++i) {
    const auto x = side(), y = side(), z = side();
    shape.add(box({x[0], y[0], z[0]}, {x[1], y[1], z[1]}));
  }
  return shape;
}

std::vector<Projection> views(Random& random, bool axes) {
  std::vector<Projection> list{orthographic({1, 1, 1}),
                               orthographic({uniform(random, -1, 1), uniform(random, -1, 1), uniform(random, -1, 1)}),
                               perspective({4, -3, 3.5}, {0.5, 0.5, 0.5}, {4, -3, 3}, {0, 0, 1})};
  if (axes) {
    list.push_back(from_above());
    list.push_back(orthographic({0, -1, 0}));
    list.push_back(perspective({0.5, -2, 0.5}, {0, 0, 0}, {0, -1, 0}, {0, 0, 1}));
  }
  return list;
}

void expect_right(const Shape& shape, Random& random, bool axes, const std::string& name) {
  const World world = world_of(shape);
  for (const Projection& view : views(random, axes)) {
    const Verdict verdict = judge(draw(world, view));
    EXPECT_LT(verdict.longest_wrong, goal) << name << (view.central ? " central " : " parallel ") << view.n.x << ","
                                           << view.n.y << "," << view.n.z << " " << verdict.worst;
  }
}

TEST(Oracle, RandomTriangles) {
  for (unsigned seed = 1; seed <= 25; ++seed) {
    Random random(seed);
    expect_right(soup(random, 24, 0), random, false, "seed " + std::to_string(seed));
  }
}

TEST(Oracle, TrianglesOnALattice) {
  for (unsigned seed = 1; seed <= 25; ++seed) {
    Random random(seed);
    expect_right(soup(random, 16, 3), random, true, "seed " + std::to_string(seed));
  }
}

TEST(Oracle, RandomBoxes) {
  for (unsigned seed = 1; seed <= 12; ++seed) {
    Random random(seed);
    expect_right(boxes(random, 5, 0), random, true, "seed " + std::to_string(seed));
  }
}

TEST(Oracle, TouchingBoxes) {
  for (unsigned seed = 1; seed <= 12; ++seed) {
    Random random(seed);
    expect_right(boxes(random, 6, 4), random, true, "seed " + std::to_string(seed));
  }
}

TEST(Oracle, FindsAFlippedSpan) {
  Random random(1);
  Result result = draw(world_of(boxes(random, 4, 0)), orthographic({1, 2, 3}));
  ASSERT_LT(judge(result).longest_wrong, goal);
  ASSERT_FALSE(result.hidden.spans.empty());
  const auto span = result.hidden.spans[0];
  result.hidden.spans[0] = {span[0], span[0]};
  EXPECT_GT(judge(result).longest_wrong, 1e-3);
}

}  // namespace
}  // namespace epura::test
