#include "forms.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <random>
#include <set>

#include "visibility/spans.hpp"

namespace epura::test {

void expect_strips_over_strips(int n, int m, double width) {
  Shape strips;
  for (int i = 0; i < n; ++i) strips.add(plate(i, 0, i + width, m, 1));
  for (int j = 0; j < m; ++j) strips.add(plate(-0.5, j + 0.2, n, j + 0.2 + width, 0));
  const Result result = draw(world_of(strips), from_above());
  const double crossings = 1.0 * n * m;
  EXPECT_NEAR(result.hidden_length(), 2 * crossings * width, 1e-8 * crossings);
  EXPECT_NEAR(result.visible(), 2 * n * (m + width) + 2 * m * (n + 0.5 + width) - 2 * crossings * width,
              1e-8 * crossings);
  EXPECT_EQ(result.pieces(false), 2 * n * m);
  EXPECT_EQ(result.pieces(true), 4 * n + 2 * m * (n + 1) + 2 * m);
}

void expect_stack_of_plates(int n, double shift) {
  Shape stack;
  for (int i = 0; i < n; ++i) stack.add(plate(-shift * i, -shift * i, 1 - shift * i, 1 - shift * i, i));
  const Result result = draw(world_of(stack), from_above());
  EXPECT_NEAR(result.visible(), 2 * n + 2 + 2 * shift * (n - 1), 4e-9 * n);
}

void expect_sliver_plate_to_hide_one_piece(int n) {
  Shape strips;
  for (int i = 0; i <= n; ++i) {
    strips.points.push_back({static_cast<double>(i) / n, 0, 1});
    strips.points.push_back({static_cast<double>(i) / n, 1, 1});
    if (i > 0) strips.faces.push_back({2 * i - 2, 2 * i, 2 * i + 1, 2 * i - 1});
  }
  const auto spans =
      hidden_of_line(world_of({strips, plate(-1, -1, 2, 2, 0)}), from_above(), {-1, 0.3, 0.5}, {2, 0.6, 0.5});
  ASSERT_EQ(spans.size(), 1U);
  EXPECT_NEAR(spans[0][0], 1.0 / 3, 1e-9);
  EXPECT_NEAR(spans[0][1], 2.0 / 3, 1e-9);
}

namespace {

// Every edge of the surface is split on one side only: there, the triangle becomes a fan around its middle. On the
// other it stays as it is, and a fan of triangles without area from one end fills the gap.
struct OneSidedSplit {
  int parts;
  Shape shape;
  std::set<std::array<int, 2>> done;

  int add(const Point& p) {
    shape.points.push_back(p);
    return static_cast<int>(shape.points.size()) - 1;
  }

  void split_side(int a, int b, std::vector<int>& border) {
    border.push_back(a);
    if (!done.insert({std::min(a, b), std::max(a, b)}).second) return;
    const Point p = shape.points[a], q = shape.points[b];
    for (int i = 1; i < parts; ++i) {
      const double t = static_cast<double>(i) / parts;
      border.push_back(add({p[0] + t * (q[0] - p[0]), p[1] + t * (q[1] - p[1]), p[2] + t * (q[2] - p[2])}));
      if (i > 1) shape.faces.push_back({a, border[border.size() - 2], border.back()});
    }
    shape.faces.push_back({a, border.back(), b});
  }

  void split(const std::vector<int>& triangle) {
    std::vector<int> border;
    Point middle{};
    for (int k = 0; k < 3; ++k) {
      split_side(triangle[k], triangle[(k + 1) % 3], border);
      for (int i = 0; i < 3; ++i) middle[i] += shape.points[triangle[k]][i] / 3;
    }
    const int centre = add(middle);
    for (std::size_t k = 0; k < border.size(); ++k)
      shape.faces.push_back({border[k], border[(k + 1) % border.size()], centre});
  }
};

// The unit cube of 12 `cells` cells triangles.
Shape fine_cube(int cells) {
  Shape cube;
  std::map<Point, int> places;
  const auto corner = [&](const Point& p) {
    const auto [place, made] = places.try_emplace(p, static_cast<int>(cube.points.size()));
    if (made) cube.points.push_back(p);
    return place->second;
  };
  for (int axis = 0; axis < 3; ++axis)
    for (const double height : {0.0, 1.0})
      for (int i = 0; i < cells; ++i)
        for (int j = 0; j < cells; ++j) {
          const auto at = [&](int di, int dj) {
            Point p{};
            p[axis] = height;
            p[(axis + 1) % 3] = static_cast<double>(i + di) / cells;
            p[(axis + 2) % 3] = static_cast<double>(j + dj) / cells;
            return corner(p);
          };
          cube.faces.push_back({at(0, 0), at(1, 0), at(1, 1)});
          cube.faces.push_back({at(0, 0), at(1, 1), at(0, 1)});
        }
  return cube;
}

}  // namespace

void expect_triangles_without_area_to_change_nothing(int cells, int parts) {
  const Shape cube = fine_cube(cells);
  OneSidedSplit split{parts, {cube.points, {}, {}}, {}};
  for (const auto& triangle : cube.faces) split.split(triangle);
  const World world = world_of(split.shape);
  ASSERT_EQ(world.models[0].mesh->report.open_edges, 0);
  for (const Vec3& towards_viewer : {Vec3(3, -2, 1), Vec3(1, 1, 1)}) {
    const Result plain = draw(world_of(triangulated_cube()), orthographic(towards_viewer));
    const Result result = draw(world, orthographic(towards_viewer));
    EXPECT_NEAR(result.visible(), plain.visible(), 1e-8);
    EXPECT_NEAR(result.hidden_length(), plain.hidden_length(), 1e-8);
  }
}

void expect_fan_to_hide_chords(int n) {
  Shape fan{{{0, 0, 1}}, {}, {}};
  for (int i = 0; i < n; ++i) {
    const double a = 2 * M_PI * i / n;
    fan.points.push_back({std::cos(a), std::sin(a), 1});
    fan.faces.push_back({0, i + 1, (i + 1) % n + 1});
  }
  const World world = world_of({fan, plate(-2, -2, 2, 2, -1)});
  for (const double c : {0.0, 0.25, 0.9}) {
    const auto spans = hidden_of_line(world, from_above(), {-2, c, 0}, {2, c, 0});
    ASSERT_EQ(spans.size(), 1U) << c;
    EXPECT_NEAR(4 * (spans[0][1] - spans[0][0]), 2 * std::sqrt(1 - c * c), 1e-6) << c;
  }
}

void expect_stacked_copies_to_be_one_line(int n) {
  Shape scene = plate(-1, -1, 2, 1, -2);
  for (int i = 0; i < n; ++i) {
    const double top = -static_cast<double>(i) / n, bottom = top - 0.5 / n;
    scene.add({{{0, 0, top}, {1, 0, top}, {1, 0, bottom}, {0, 0, bottom}}, {{0, 1, 2, 3}}, {}});
  }
  const Result result = draw(world_of(scene), from_above());
  EXPECT_EQ(result.pieces(true), 5);
  EXPECT_NEAR(result.visible(), 10 + 1, 1e-8);
  EXPECT_EQ(result.pieces(false), 0);
}

namespace {

using Flat = std::array<Vec2, 3>;

std::vector<Flat> random_needles(int n) {
  std::mt19937 random(n);
  const auto on_the_circle = [&] {
    const double angle = 2 * M_PI * (static_cast<double>(random()) / 4294967296.0);
    return Vec2(std::cos(angle), std::sin(angle));
  };
  std::vector<Flat> needles;
  while (static_cast<int>(needles.size()) < n) {
    const Vec2 from = on_the_circle(), to = on_the_circle();
    const Vec2 along = to - from;
    if (glm::length(along) < 0.5) continue;
    const Vec2 side = 5e-5 / glm::length(along) * Vec2(-along.y, along.x);
    needles.push_back({from, to - side, to + side});
  }
  return needles;
}

double cross(const Vec2& a, const Vec2& b) { return a.x * b.y - a.y * b.x; }

// The part of the segment from p to q inside a triangle, which turns left.
std::optional<std::array<double, 2>> part_inside(const Vec2& p, const Vec2& q, const Flat& triangle) {
  double from = 0, to = 1;
  for (int k = 0; k < 3; ++k) {
    const Vec2& a = triangle[k];
    const Vec2 side = triangle[(k + 1) % 3] - a;
    const double at_p = cross(side, p - a), at_q = cross(side, q - a);
    if (at_p < 0 && at_q < 0) return std::nullopt;
    if (at_p < 0) from = std::max(from, at_p / (at_p - at_q));
    if (at_q < 0) to = std::min(to, at_p / (at_p - at_q));
  }
  if (from >= to) return std::nullopt;
  return std::array{from, to};
}

// Needle i lies below all needles after it. Of every edge in turn, what they hide of it.
std::vector<Spans> hidden_in_the_plane(const std::vector<Flat>& needles) {
  std::vector<Spans> hidden;
  for (std::size_t i = 0; i < needles.size(); ++i)
    for (int k = 0; k < 3; ++k) {
      const Vec2 p = needles[i][k], q = needles[i][(k + 1) % 3];
      Spans spans;
      for (std::size_t j = i + 1; j < needles.size(); ++j)
        if (const auto part = part_inside(p, q, needles[j])) add_span(spans, *part);
      // The drawing is as large as the circle.
      absorb_slivers(spans, 2 * least_piece / glm::distance(p, q));
      hidden.push_back(spans);
    }
  return hidden;
}

double hidden_before_merging(const Result& result) {
  double sum = 0;
  for (std::size_t e = 0; e < result.drawn.edges.size(); ++e) {
    const PageVertex& p = result.view.vertices[result.drawn.edges[e].vertex[0]];
    const PageVertex& q = result.view.vertices[result.drawn.edges[e].vertex[1]];
    for (std::size_t i = result.hidden.first[e]; i < result.hidden.first[e + 1]; ++i)
      sum += (result.hidden.spans[i][1] - result.hidden.spans[i][0]) * std::hypot(q.x - p.x, q.y - p.y);
  }
  return sum * result.unit;
}

}  // namespace

void expect_needles(int n) {
  const std::vector<Flat> needles = random_needles(n);
  Shape shape;
  for (const Flat& needle : needles) {
    const int first = static_cast<int>(shape.points.size());
    for (const Vec2& p : needle) shape.points.push_back({p.x, p.y, first / (3.0 * n)});
    shape.faces.push_back({first, first + 1, first + 2});
  }
  double length = 0;
  int pieces = 0;
  const std::vector<Spans> expected = hidden_in_the_plane(needles);
  for (std::size_t e = 0; e < expected.size(); ++e) {
    const Flat& needle = needles[e / 3];
    for (const auto& [from, to] : expected[e])
      length += (to - from) * glm::distance(needle[e % 3], needle[(e + 1) % 3]);
    pieces += static_cast<int>(expected[e].size());
  }
  const Result result = draw(world_of(shape), from_above());
  // Before lines are merged: near its tip, the two sides of a needle are one line.
  EXPECT_NEAR(hidden_before_merging(result), length, 1e-6 * length);
  EXPECT_NEAR(static_cast<double>(result.hidden.spans.size()), pieces, 1e-4 * pieces);
}

}  // namespace epura::test
