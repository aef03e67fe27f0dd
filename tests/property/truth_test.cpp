// SPDX-License-Identifier: Apache-2.0
// The program against brute force in rational numbers, over random scenes.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>

#include "at_length.hpp"
#include "shapes.hpp"
#include "wrong_span.hpp"

namespace epura::test::truth_test {
namespace {

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

std::vector<projection::Projection> views(Random& random, bool axes) {
  std::vector<projection::Projection> list{
      orthographic({1, 1, 1}), orthographic({uniform(random, -1, 1), uniform(random, -1, 1), uniform(random, -1, 1)}),
      perspective({4, -3, 3.5}, {0.5, 0.5, 0.5}, {4, -3, 3}, {0, 0, 1})};
  if (axes) {
    list.push_back(from_above());
    list.push_back(orthographic({0, -1, 0}));
    list.push_back(perspective({0.5, -2, 0.5}, {0, 0, 0}, {0, -1, 0}, {0, 0, 1}));
  }
  return list;
}

void expect_right(const Shape& shape, Random& random, bool axes, const std::string& name) {
  const world::World world = world_of(shape);
  for (const projection::Projection& view : views(random, axes)) {
    const WrongSpan wrong = longest_wrong(draw(world, view));
    EXPECT_LT(wrong.longest, most_wrong) << name << (view.central ? " central " : " parallel ") << view.n.x << ","
                                         << view.n.y << "," << view.n.z << " " << wrong.words;
  }
}

// Half of them at every change.
unsigned scenes(unsigned all) { return at_length() ? all : all / 2; }

TEST(Truth, RandomTriangles) {
  for (unsigned seed = 1; seed <= scenes(25); ++seed) {
    Random random(seed);
    expect_right(soup(random, 24, 0), random, false, "seed " + std::to_string(seed));
  }
}

TEST(Truth, TrianglesOnALattice) {
  for (unsigned seed = 1; seed <= scenes(25); ++seed) {
    Random random(seed);
    expect_right(soup(random, 16, 3), random, true, "seed " + std::to_string(seed));
  }
}

TEST(Truth, RandomBoxes) {
  for (unsigned seed = 1; seed <= scenes(12); ++seed) {
    Random random(seed);
    expect_right(boxes(random, 5, 0), random, true, "seed " + std::to_string(seed));
  }
}

TEST(Truth, TouchingBoxes) {
  for (unsigned seed = 1; seed <= scenes(12); ++seed) {
    Random random(seed);
    expect_right(boxes(random, 6, 4), random, true, "seed " + std::to_string(seed));
  }
}

TEST(Truth, FindsAFlippedSpan) {
  Random random(1);
  Result result = draw(world_of(boxes(random, 4, 0)), orthographic({1, 2, 3}));
  ASSERT_LT(longest_wrong(result).longest, most_wrong);
  ASSERT_FALSE(result.hidden.spans.empty());
  const auto span = result.hidden.spans[0];
  result.hidden.spans[0] = {span[0], span[0]};
  EXPECT_GT(longest_wrong(result).longest, 1e-3);
}

// It does not ask the view which triangles there are.
TEST(Truth, MissesATriangleThatTheViewHasLost) {
  Random random(1);
  Result result = draw(world_of(boxes(random, 4, 0)), orthographic({1, 2, 3}));
  result.view.triangles.clear();
  result.hidden = visibility::find_hidden(result.world, result.view, result.drawn);
  ASSERT_TRUE(result.hidden.spans.empty());
  EXPECT_GT(longest_wrong(result).longest, 1e-3);
}

}  // namespace
}  // namespace epura::test::truth_test
