// SPDX-License-Identifier: Apache-2.0
#include "study/stability/forms.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <random>
#include <set>

#include "visibility/limits.hpp"
#include "visibility/spans.hpp"

namespace epura::stability {

Measured one_span(const HiddenLine& line, double from, double to, double allowed) {
  const std::array<double, 2> got = line.spans.empty() ? std::array<double, 2>{NAN, NAN} : line.spans.front();
  return {count("hidden pieces", 1, static_cast<double>(line.spans.size())), length("from", from, got[0], 1, allowed),
          length("to", to, got[1], 1, allowed)};
}

Measured lengths(const Result& result, double visible, double hidden, double allowed) {
  const double scale = std::max(result.extent(), visible + hidden);
  Measured measured{length("visible", visible, result.visible(), scale, allowed),
                    length("hidden", hidden, result.hidden_length(), scale, allowed)};
  for (Quantity& q : measured) q.rounding = 4 * result.condition.number * 0x1p-53;
  return measured;
}

Measured strips_over_strips(const Lab& lab, int n, int m, double width) {
  Shape strips;
  for (int i = 0; i < n; ++i) strips.add(plate(i, 0, i + width, m, 1));
  for (int j = 0; j < m; ++j) strips.add(plate(-0.5, j + 0.2, n, j + 0.2 + width, 0));
  const Result result = lab.draw(lab.world_of(strips), {from_above()});
  const double crossings = 1.0 * n * m;
  const double all = 2 * n * (m + width) + 2 * m * (n + 0.5 + width);
  Measured measured = lengths(result, all - 2 * crossings * width, 2 * crossings * width);
  measured.push_back(count("hidden pieces", 2 * crossings, result.pieces(false)));
  measured.push_back(count("visible pieces", 4 * n + 2 * m * (n + 1) + 2 * m, result.pieces(true)));
  return measured;
}

Measured stack_of_plates(const Lab& lab, int n, double shift) {
  Shape stack;
  for (int i = 0; i < n; ++i) stack.add(plate(-shift * i, -shift * i, 1 - shift * i, 1 - shift * i, i));
  const Result result = lab.draw(lab.world_of(stack), {from_above()});
  const double visible = 2 * n + 2 + 2 * shift * (n - 1);
  return {length("visible", visible, result.visible(), visible)};
}

Measured plates_along_a_line(const Lab& lab, int n, double shift) {
  Shape stack;
  for (int i = 0; i < n; ++i) stack.add(plate(shift * i, shift * i, 1 + shift * i, 1 + shift * i, -shift * i));
  const Result result = lab.draw(lab.world_of(stack), {orthographic({1, -1, 1})});
  const double side = std::sqrt(2.0 / 3), step = shift * std::sqrt(8.0 / 3);
  const double visible = (n + 3) * side + 2 * step * (n - 1);
  return {length("visible", visible, result.visible(), visible)};
}

Measured sliver_plate(const Lab& lab, int n) {
  Shape strips;
  for (int i = 0; i <= n; ++i) {
    strips.points.push_back({static_cast<double>(i) / n, 0, 1});
    strips.points.push_back({static_cast<double>(i) / n, 1, 1});
    if (i > 0) strips.faces.push_back({2 * i - 2, 2 * i, 2 * i + 1, 2 * i - 1});
  }
  const world::World world = lab.world_of({strips, plate(-1, -1, 2, 2, 0)});
  return one_span(lab.hidden_of_line(world, from_above(), {-1, 0.3, 0.5}, {2, 0.6, 0.5}), 1.0 / 3, 2.0 / 3);
}

namespace {

// Every edge of the surface is split on one side only: there, the triangle becomes a fan around its middle. On the
// other side, the triangle is unchanged, and a fan of degenerate triangles from one end fills the gap.
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

}  // namespace

Measured triangles_without_area(const Lab& lab, int cells, int parts) {
  const Shape cube = fine_cube(cells);
  OneSidedSplit split{parts, {cube.points, {}, {}}, {}};
  for (const auto& triangle : cube.faces) split.split(triangle);
  const world::World world = lab.world_of(split.shape);
  Measured measured{count("open edges", 0, world.models[0].mesh->report.open_edges)};
  const Vec3 towards = glm::normalize(Vec3(3, -2, 1));
  double all = 0;  // four edges along each axis, one of them hidden
  for (int axis = 0; axis < 3; ++axis) all += std::sqrt(1 - towards[axis] * towards[axis]);
  for (const Quantity& q : lengths(lab.draw(world, {orthographic(towards)}), 3 * all, all)) measured.push_back(q);
  for (const Quantity& q : lengths(lab.draw(world, {orthographic({1, 1, 1})}), 9 * isometric_edge, 3 * isometric_edge))
    measured.push_back(q);
  return measured;
}

namespace {

// The ends of the horizontal line at height y in a polygon around the origin: minimum and maximum x.
std::array<double, 2> chord(const std::vector<Point>& corners, double y) {
  std::array<double, 2> ends{HUGE_VAL, -HUGE_VAL};
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Point& a = corners[i];
    const Point& b = corners[(i + 1) % corners.size()];
    if ((a[1] < y && b[1] < y) || (a[1] > y && b[1] > y)) continue;
    const double t = a[1] == b[1] ? 0 : (y - a[1]) / (b[1] - a[1]);
    const double x = a[0] + t * (b[0] - a[0]);
    ends = {std::min(ends[0], x), std::max(ends[1], x)};
  }
  return ends;
}

}  // namespace

Measured fan_over_chords(const Lab& lab, int n) {
  const Shape disk = fan(n);
  const world::World world = lab.world_of({disk, plate(-2, -2, 2, 2, -1)});
  Measured measured;
  for (const double c : {0.0, 0.25, 0.45}) {
    const auto [left, right] = chord({disk.points.begin() + 1, disk.points.end()}, c);
    const HiddenLine line = lab.hidden_of_line(world, from_above(), {-2, c, 0}, {2, c, 0});
    for (const Quantity& q : one_span(line, (left + 2) / 4, (right + 2) / 4)) measured.push_back(q);
  }
  return measured;
}

Measured stacked_copies(const Lab& lab, int n) {
  Shape scene = plate(-1, -1, 2, 1, -2);
  for (int i = 0; i < n; ++i) {
    const double top = -static_cast<double>(i) / n, bottom = top - 0.5 / n;
    scene.add({{{0, 0, top}, {1, 0, top}, {1, 0, bottom}, {0, 0, bottom}}, {{0, 1, 2, 3}}, {}});
  }
  const Result result = lab.draw(lab.world_of(scene), {from_above()});
  Measured measured = lengths(result, 11, 0);
  measured.push_back(count("visible pieces", 5, result.pieces(true)));
  return measured;
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

// The part of the segment from p to q inside a counterclockwise triangle.
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

// Needle i lies below all needles after it. For every edge in turn, the spans that they hide.
std::vector<visibility::Spans> hidden_in_the_plane(const std::vector<Flat>& needles) {
  std::vector<visibility::Spans> hidden;
  for (std::size_t i = 0; i < needles.size(); ++i)
    for (int k = 0; k < 3; ++k) {
      const Vec2 p = needles[i][k], q = needles[i][(k + 1) % 3];
      visibility::Spans spans;
      for (std::size_t j = i + 1; j < needles.size(); ++j)
        if (const auto part = part_inside(p, q, needles[j])) visibility::add_span(spans, *part);
      // The drawing is as large as the circle.
      visibility::absorb_slivers(spans, 2 * visibility::min_piece / glm::distance(p, q));
      hidden.push_back(spans);
    }
  return hidden;
}

double hidden_before_merging(const Result& result) {
  double sum = 0;
  for (std::size_t e = 0; e < result.drawn.edges.size(); ++e) {
    const view::PageVertex& p = result.view.vertices[result.drawn.edges[e].vertex[0]];
    const view::PageVertex& q = result.view.vertices[result.drawn.edges[e].vertex[1]];
    for (std::size_t i = result.hidden.first[e]; i < result.hidden.first[e + 1]; ++i)
      sum += (result.hidden.spans[i][1] - result.hidden.spans[i][0]) * std::hypot(q.x - p.x, q.y - p.y);
  }
  return sum * result.unit;
}

}  // namespace

Measured needles(const Lab& lab, int n) {
  const std::vector<Flat> needles = random_needles(n);
  Shape shape;
  for (const Flat& needle : needles) {
    const int first = static_cast<int>(shape.points.size());
    for (const Vec2& p : needle) shape.points.push_back({p.x, p.y, first / (3.0 * n)});
    shape.faces.push_back({first, first + 1, first + 2});
  }
  double expected = 0;
  std::size_t pieces = 0;
  const std::vector<visibility::Spans> hidden = hidden_in_the_plane(needles);
  for (std::size_t e = 0; e < hidden.size(); ++e) {
    const Flat& needle = needles[e / 3];
    for (const auto& [from, to] : hidden[e])
      expected += (to - from) * glm::distance(needle[e % 3], needle[(e + 1) % 3]);
    pieces += hidden[e].size();
  }
  const Result result = lab.draw(lab.world_of(shape), {from_above()});
  // Compared before lines are merged: near its tip, the two sides of a needle are one line.
  const auto found = static_cast<double>(result.hidden.spans.size()), wanted = static_cast<double>(pieces);
  return {length("hidden", expected, hidden_before_merging(result), std::max(expected, result.extent())),
          length("hidden pieces", wanted, found, std::max(wanted, 1.0), 1e-4)};
}

}  // namespace epura::stability
