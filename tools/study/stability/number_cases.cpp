// SPDX-License-Identifier: Apache-2.0
// Meshes with unusual coordinates (huge, tiny, far away, missing) and in any order.
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <random>

#include "base/error.hpp"
#include "base/parallel.hpp"
#include "study/stability/case.hpp"
#include "study/stability/exact_places.hpp"
#include "study/stability/forms.hpp"

namespace epura::stability {

namespace {

Measured scaled_cube(const Lab& lab, double factor) {
  const Result result = lab.draw(lab.world_of(box({0, 0, 0}, {1, 1, 1}).scaled(factor)), {orthographic(diagonal)});
  return lengths(result, 9 * isometric_edge * factor, 3 * isometric_edge * factor);
}

// A quarter unit survives in doubles up to 2^50.
Measured quarter_cube_far_away(const Lab& lab, double at) {
  const Shape cube = box({0, 0, 0}, {0.25, 0.25, 0.25}).moved(at, at, at);
  const Result result = lab.draw(lab.world_of(cube), {orthographic(diagonal)});
  Measured measured = lengths(result, 9 * isometric_edge / 4, 3 * isometric_edge / 4);
  measured.push_back(places(result));
  return measured;
}

// The window shows only the unit cube; the large cube is beside it on the page.
Measured small_beside_large(const Lab& lab, double ratio) {
  const Shape large = box({-4, 2, 0}, {-3, 3, 1}).scaled(ratio);
  const world::World world = lab.world_of({box({0, 0, 0}, {1, 1, 1}), large});
  projection::Projection p = orthographic(diagonal);
  p.window = projection::Window{{-1, -1}, {1, 1}};
  const Result result = lab.draw(world, {p});
  return lengths(result, 9 * isometric_edge, 3 * isometric_edge);
}

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

// A valid triangle, and beside it invalid faces.
Shape with_faults(int kind) {
  Shape shape{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}, {}};
  const auto add = [&shape](const Point& a, const Point& b, const Point& c) {
    const int first = static_cast<int>(shape.points.size());
    shape.points.insert(shape.points.end(), {a, b, c});
    shape.faces.push_back({first, first + 1, first + 2});
  };
  if (kind == 1) shape.faces.push_back({0, 1, 2});
  if (kind == 2) add({2, 2, 0}, {2, 2, 0}, {2, 2, 0});
  if (kind == 3) add({0, 0, 0}, {0.5, 0, 0}, {1, 0, 0});
  if (kind == 4) add({nan, 0, 0}, {3, 0, 0}, {3, 3, 0});
  if (kind == 5) add({0, infinity, 0}, {3, 0, 0}, {3, 3, 0});
  if (kind == 6) add({0, 0, -infinity}, {3, 0, 0}, {3, 3, nan});
  if (kind == 7) shape.points.assign(3, {1, 1, 1});
  if (kind == 8) shape = {};
  return shape;
}

// If there is nothing to draw, the result must be an error with a reason, or no ink.
Measured faults(const Lab& lab, double kind) {
  const bool empty = kind >= 7;
  const double expected = empty ? 0 : 2 + std::sqrt(2.0);
  double visible = 0;
  try {
    visible = lab.draw(lab.world_of(with_faults(static_cast<int>(kind))), {from_above()}).visible();
  } catch (const Error&) {
    if (!empty) throw;
  }
  return {length("visible", expected, visible, 1)};
}

// std::shuffle differs between libraries.
template <class Things>
void shuffle(Things& things, std::mt19937& random) {
  for (std::size_t i = things.size(); i > 1; --i) std::swap(things[i - 1], things[random() % i]);
}

Shape shuffled(const Shape& shape, std::mt19937& random) {
  std::vector<int> order(shape.points.size());
  std::iota(order.begin(), order.end(), 0);
  shuffle(order, random);
  Shape result = shape;
  for (std::size_t v = 0; v < order.size(); ++v) result.points[order[v]] = shape.points[v];
  for (auto& face : result.faces)
    for (int& v : face) v = order[v];
  shuffle(result.faces, random);
  return result;
}

Measured in_any_order(const Lab& lab, double seed) {
  std::mt19937 random(static_cast<unsigned>(seed));
  Shape shape = uv_sphere(24, 12);
  shape.add(box({-0.5, -3, -0.5}, {0.5, 3, 0.5}));
  const Camera camera{orthographic({1, -2, 1.5})};
  const Result plain = lab.exact().draw(lab.world_of(shape), camera);
  const ThreadLimit threads(static_cast<int>(seed));
  const Result result = lab.draw(lab.world_of(shuffled(shape, random)), camera);
  Measured measured = lengths(result, plain.visible(), plain.hidden_length(), 1e-9);
  measured.push_back(count("hidden pieces", plain.pieces(false), result.pieces(false)));
  return measured;
}

}  // namespace

std::vector<Case> number_cases() {
  return {
      {"M22",
       "cube along its diagonal, coordinates times a number",
       "factor",
       {1, 0x1p60, 0x1p-60, 1e100, 1e-100, 1e200, 1e-200, 1e300, 1e-300, 0x1p1000, 0x1p-1000},
       scaled_cube},
      {"M23",
       "cube of a quarter unit far from the origin",
       "offset",
       {1, 1e2, 1e4, 1e6, 1e7, 1e9, 1e11, 1e13, 1e15},
       quarter_cube_far_away},
      {"M24",
       "unit cube beside a large one, zoomed",
       "size of the large one",
       {1, 1e1, 1e2, 1e3, 1e4, 1e6, 1e8, 1e10, 1e12},
       small_beside_large},
      {"M28",
       "faces that are none: NaN, infinity, no area, nothing",
       "kind",
       {0, 1, 2, 3, 4, 5, 6, 7, 8},
       faults,
       true},
      {"M29",
       "faces and vertices in any order, on any number of threads",
       "seed and threads",
       {1, 2, 3, 4, 5, 6, 7, 8, 16},
       in_any_order,
       true},
  };
}

}  // namespace epura::stability
