// SPDX-License-Identifier: Apache-2.0
// Searching occluders by place and depth gives, to the last bit, what trying every triangle on every edge gives.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numeric>
#include <random>

#include "at_length.hpp"
#include "base/text.hpp"
#include "shapes.hpp"
#include "visibility/spans.hpp"

namespace epura::test::search_test {
namespace {

visibility::Spans by_brute_force(const Result& r, const edges::FeatureEdge& edge) {
  const visibility::PageEdge line{edge.vertex[0], edge.vertex[1]};
  visibility::Spans spans;
  for (const view::ViewTriangle& t : r.view.triangles) {
    const auto& [a, b, c] = t.vertex;
    if (view::cross(r.view.grid[a], r.view.grid[b], r.view.grid[c]) == 0 ||
        visibility::OwnTriangles(r.world, r.drawn, edge).contain(t.source))
      continue;
    if (const auto part = visibility::hidden_part(r.view, line, t)) visibility::add_span(spans, *part);
  }
  visibility::absorb_slivers(spans, visibility::min_span(r.view, line));
  return spans;
}

visibility::Spans spans_of(const visibility::HiddenSpans& hidden, std::size_t e) {
  return {hidden.spans.begin() + hidden.first[e], hidden.spans.begin() + hidden.first[e + 1]};
}

void expect_equal(const Result& r) {
  // What is done where there is no time for the search; of many edges it takes the test too long.
  const bool tries_all = r.drawn.edges.size() <= 500;
  const visibility::HiddenSpans directly =
      tries_all ? visibility::find_hidden_directly(r.world, r.view, r.drawn) : visibility::HiddenSpans();
  for (std::size_t e = 0; e < r.drawn.edges.size(); ++e) {
    const view::GridPoint &p = r.view.grid[r.drawn.edges[e].vertex[0]], &q = r.view.grid[r.drawn.edges[e].vertex[1]];
    if (p.x == q.x && p.y == q.y) continue;  // is a point on the page, and not drawn
    const visibility::Spans by_all = by_brute_force(r, r.drawn.edges[e]);
    ASSERT_EQ(spans_of(r.hidden, e), by_all) << "edge " << e;
    if (tries_all) {
      ASSERT_EQ(spans_of(directly, e), by_all) << "edge " << e;
    }
  }
}

Shape soup(unsigned seed) {
  std::mt19937 random(seed);
  const auto number = [&] { return static_cast<double>(random()) / 4294967296.0; };
  const int triangles = 4 + static_cast<int>(random() % 60);
  const double size = std::pow(2.0, -static_cast<double>(random() % 5));
  const double steps = random() % 3 == 0 ? 5 : 0;
  Shape shape;
  const auto place = [&](double c) { return steps > 0 ? std::round(c * steps) / steps : c; };
  for (int i = 0; i < triangles; ++i) {
    const Point at{number(), number(), number()};
    for (int k = 0; k < 3; ++k)
      shape.points.push_back(
          {place(at[0] + size * number()), place(at[1] + size * number()), place(at[2] + size * number())});
    shape.faces.push_back({3 * i, 3 * i + 1, 3 * i + 2});
  }
  return shape;
}

// $EPURA_SCENES of them in all, 1000 without it, in parts that can run at the same time.
class Scenes : public testing::TestWithParam<unsigned> {};

constexpr unsigned parts = 4;

unsigned scene_count() {
  const char* text = std::getenv("EPURA_SCENES");
  return text == nullptr ? 1000 : static_cast<unsigned>(parse_number(text).value());
}

TEST_P(Scenes, SearchEqualsBruteForce) {
  for (unsigned seed = 1 + GetParam(); seed <= scene_count(); seed += parts) {
    const world::World world = world_of(soup(seed));
    const std::vector<projection::Projection> views{
        orthographic({1, 1, 1}), orthographic({0.3, -1, 0.2}), from_above(),
        perspective({3, -2, 2}, {0, 0, 0}, {3, -2, 2}, {0, 0, 1}),
        perspective({0.5, -0.5, 0.5}, {0.5, 0, 0.5}, {0, -1, 0}, {0, 0, 1})};
    if (world.triangles.empty()) continue;  // all were rounded to nothing
    SCOPED_TRACE("seed " + std::to_string(seed));
    expect_equal(draw(world, views[seed % views.size()]));
    if (HasFatalFailure()) return;
  }
}

INSTANTIATE_TEST_SUITE_P(Random, Scenes, testing::Range(0U, parts));

// Half of them at every change.
unsigned scenes(unsigned all) { return at_length() ? all : (all + 1) / 2; }

TEST(Search, EqualsBruteForceFromInside) {
  for (unsigned seed = 1; seed <= 50; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    // A room around the soup, so that there is always something in front of the eye.
    const world::World world = world_of({soup(seed), box({-1, -1, -1}, {3, 3, 3})});
    expect_equal(draw(world, perspective({0.5, 0.5, 0.5}, {0.5, 0.7, 0.5}, {0.1, -1, 0.2}, {0, 0, 1})));
  }
}

TEST(Search, EqualsBruteForceOnAFineMesh) {
  const int n = 48;
  Shape torus;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) {
      const double a = 2 * M_PI * i / n, b = 2 * M_PI * j / n, radius = 1 + (0.4 + 0.1 * std::sin(5 * a)) * std::cos(b);
      torus.points.push_back({radius * std::cos(a), radius * std::sin(a), 0.4 * std::sin(b)});
      torus.faces.push_back({i * n + j, (i + 1) % n * n + j, (i + 1) % n * n + (j + 1) % n, i * n + (j + 1) % n});
    }
  expect_equal(draw(world_of(torus), orthographic({1, -2, 0.8})));
  expect_equal(draw(world_of(torus), orthographic({1, -2, 0.8}), {.smooth = true}));
}

// Uneven plates of several quadrilaterals over one another, so many that cells are divided and covered by sheets.
Shape stack(unsigned seed) {
  std::mt19937 random(seed);
  const auto number = [&] { return static_cast<double>(random()) / 4294967296.0; };
  constexpr int plates = 80, across = 3;
  const double shift = std::pow(10, -1 - 5 * number()), bumps = random() % 2 == 0 ? 0 : number();
  Shape shape;
  for (int k = 0; k < plates; ++k) {
    const int first = static_cast<int>(shape.points.size());
    for (int i = 0; i <= across; ++i)
      for (int j = 0; j <= across; ++j) shape.points.push_back({i + shift * k, j + shift * k, bumps * number() - k});
    for (int i = 0; i < across; ++i)
      for (int j = 0; j < across; ++j) {
        const int corner = first + i * (across + 1) + j;
        shape.faces.push_back({corner, corner + across + 1, corner + across + 2});
        if (random() % 16 > 0) shape.faces.push_back({corner, corner + across + 2, corner + 1});  // else a hole
      }
  }
  return shape;
}

TEST(Search, EqualsBruteForceOnStacks) {
  for (unsigned seed = 1; seed <= scenes(6); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const world::World world = world_of(stack(seed));
    expect_equal(draw(world, from_above()));
    expect_equal(draw(world, orthographic({0.1, -0.2, 1}), {.smooth = true}));
    expect_equal(draw(world, perspective({2, 1, 12}, {1.5, 1.5, 0}, {0.5, -0.5, 12}, {0, 1, 0})));
  }
}

// So many plates that cells get trees, in any order of numbers.
Shape slanted_stack(unsigned seed) {
  std::mt19937 random(seed);
  const auto number = [&] { return static_cast<double>(random()) / 4294967296.0; };
  constexpr int plates = 200;
  const double shift = std::pow(10, -7 + 4 * number()), wobble = random() % 2 == 0 ? 0 : shift * number();
  std::vector<int> order(plates);
  std::iota(order.begin(), order.end(), 0);
  if (random() % 2 == 0) std::shuffle(order.begin(), order.end(), random);
  Shape shape;
  for (const int k : order) {
    const double x = shift * k + wobble * number(), y = shift * k + wobble * number(), z = -shift * k;
    if (random() % 16 == 0)
      shape.add({{{x, y, z}, {x + 1, y, z}, {x + number(), y + number(), z + number()}}, {{0, 1, 2}}, {}});
    else
      shape.add(plate(x, y, x + 1, y + 1, z));
  }
  return shape;
}

TEST(Search, EqualsBruteForceOnSlantedStacks) {
  for (unsigned seed = 1; seed <= scenes(5); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const world::World world = world_of(slanted_stack(seed));
    expect_equal(draw(world, orthographic({1, -1, 1})));
    expect_equal(draw(world, orthographic({1, 1, 1}), {.smooth = true}));
    expect_equal(draw(world, orthographic({0.3, -0.8, 0.5})));
    expect_equal(draw(world, perspective({2, -1, 3}, {0.5, 0.5, 0}, {1.5, -1.5, 3}, {0, 0, 1})));
  }
}

// Equal frames on one another, others across them, and copies in their places: so many that cells get piles.
std::vector<Shape> equal_parts(unsigned seed) {
  std::mt19937 random(seed);
  Shape frame = box({0, 0, 0}, {4, 0.5, 0.2});
  frame.add(Shape(frame).moved(0, 2, 0));
  frame.add(box({1, -1, 0}, {1.5, 3, 0.2}));
  std::vector<Shape> all;
  for (int i = 0; i < 60; ++i) {
    const double step = random() % 4 == 0 ? 0 : 1;
    all.push_back(frame.moved(0, 0, 0.3 * step * i));
    if (i % 3 == 0) all.push_back(box({0.5, -2, 0.3 * i}, {3, 4, 0.3 * i + 0.1}));
  }
  return all;
}

// The same, leaning: corners behind one another differ by rounding.
std::vector<Shape> leaning(std::vector<Shape> all, double angle) {
  for (Shape& part : all)
    for (Point& p : part.points)
      p = {p[0], std::cos(angle) * p[1] - std::sin(angle) * p[2], std::sin(angle) * p[1] + std::cos(angle) * p[2]};
  return all;
}

// Two copies stand for all others.
TEST(Search, EqualsBruteForceOnCopies) {
  for (unsigned seed = 1; seed <= scenes(100); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const world::World world = world_of(std::vector<Shape>(4, soup(seed)));
    if (world.triangles.empty()) continue;  // all were rounded to nothing
    expect_equal(draw(world, orthographic({0.3, -1, 0.2})));
    expect_equal(draw(world, perspective({0.5, -0.5, 0.5}, {0.5, 0, 0.5}, {0, -1, 0}, {0, 0, 1})));
  }
}

TEST(Search, EqualsBruteForceOnEqualParts) {
  for (unsigned seed = 1; seed <= scenes(2); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const world::World world = world_of(equal_parts(seed)), slanted = world_of(leaning(equal_parts(seed), 0.7));
    expect_equal(draw(world, from_above()));
    expect_equal(draw(world, orthographic({1, -1, 1})));
    expect_equal(draw(world, perspective({2, 1, 40}, {2, 1, 0}, {0, 0, 1}, {0, 1, 0})));
    expect_equal(draw(slanted, orthographic({0, -std::sin(0.7), std::cos(0.7)})));
  }
}

// Thin triangles by hundreds, so that cells get trees with a hub, in one plane or on one line.
enum class Thin { burst, line, across, layers };

Shape thin_triangles(Thin kind, unsigned seed) {
  constexpr int count = 300;
  std::mt19937 random(seed);
  const auto number = [&] { return static_cast<double>(random()) / 4294967296.0; };
  const double width = std::pow(10, -1 - 9 * number());
  Shape shape;
  const auto add = [&](const Point& a, const Point& b, const Point& c) {
    const int first = static_cast<int>(shape.points.size());
    shape.points.insert(shape.points.end(), {a, b, c});
    shape.faces.push_back({first, first + 1, first + 2});
  };
  shape.points.push_back({0, 0, 0});
  for (int i = 0; i < count; ++i) {
    const double x = number() - 0.5, y = number() - 0.5, z = number() - 0.5;
    switch (kind) {
      case Thin::burst: {
        const int tip = static_cast<int>(shape.points.size());
        shape.points.insert(shape.points.end(), {{x, y, z}, {x + width * number(), y, z}});
        shape.faces.push_back({0, tip, tip + 1});
        break;
      }
      case Thin::line: {
        const int end = static_cast<int>(shape.points.size());
        shape.points.insert(shape.points.end(), {{x, 0.3 * x, 0}, {x + 0.1, 0.3 * (x + 0.1), i % 9 > 0 ? 0 : width}});
        shape.faces.push_back({i % 3 > 0 ? 0 : std::max(end - 2, 0), end, end + 1});
        break;
      }
      case Thin::across:
        add({-0.5, y, 0.2 * y}, {0.5, x, 0.2 * x}, {0.5, x + width, 0.2 * (x + width)});
        break;
      case Thin::layers: {  // leaning disks around one axis, each of ten needles
        const double angle = 0.6 * (i % 10), layer = 0.01 * (i / 10);
        add({0, 0, layer}, {std::cos(angle), std::sin(angle), layer},
            {std::cos(angle + 0.5), std::sin(angle + 0.5), layer});
        break;
      }
    }
  }
  shape.add(plate(-0.3, -0.3, 0.3, 0.3, -0.1));
  return shape;
}

class ThinTriangles : public testing::TestWithParam<Thin> {};

TEST_P(ThinTriangles, AreFoundAsByBruteForce) {
  for (unsigned seed = 1; seed <= 4; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const world::World world = world_of(thin_triangles(GetParam(), seed));
    expect_equal(draw(world, from_above(), {.intersection = false}));
    expect_equal(draw(world, orthographic({1, -1, 1}), {.intersection = false}));
    expect_equal(draw(world, orthographic({0.3, -0.8, 0.1}), {.smooth = true}));
    expect_equal(draw(world, perspective({2, -1, 3}, {0, 0, 0}, {2, -1, 3}, {0, 0, 1}), {.intersection = false}));
  }
}

INSTANTIATE_TEST_SUITE_P(Search, ThinTriangles, testing::Values(Thin::burst, Thin::line, Thin::across, Thin::layers));

}  // namespace
}  // namespace epura::test::search_test
