// SPDX-License-Identifier: Apache-2.0
// Meshes: boxes and plates that touch, overlap and cross.
#include <cmath>
#include <random>
#include <utility>

#include "study/stability/case.hpp"
#include "study/stability/forms.hpp"

namespace epura::stability {

namespace {

// Both have the same coordinates at the touching faces.
Measured boxes_in_contact(const Lab& lab, double at) {
  Shape both = box({at, at, at}, {at + 1, at + 1, at + 1});
  both.add(box({at + 1, at, at}, {at + 2, at + 1, at + 1}));
  return lengths(lab.draw(lab.world_of(both), {orthographic(diagonal)}), 14 * isometric_edge, 5 * isometric_edge);
}

// The edges of the two faces beside the gap are parallel on the page.
Measured boxes_with_a_gap(const Lab& lab, double gap) {
  Shape both = box({0, 0, 0}, {1, 1, 1});
  both.add(box({1 + gap, 0, 0}, {2 + gap, 1, 1}));
  const Result result = lab.draw(lab.world_of(both), {orthographic(diagonal)});
  const bool apart = gap * isometric_edge * std::sqrt(0.75) > result.merge_width();
  return apart ? lengths(result, (16 + 2 * gap) * isometric_edge, (7 - gap) * isometric_edge)
               : lengths(result, 14 * isometric_edge, 5 * isometric_edge);
}

Measured cube_twice(const Lab& lab, double at) {
  Shape twice = triangulated_cube(false);
  twice.add(triangulated_cube(true));
  return lengths(lab.draw(lab.world_of(twice.moved(at, at, at)), {orthographic(diagonal)}), 9 * isometric_edge,
                 3 * isometric_edge);
}

Measured faces_flipped_at_random(const Lab& lab, double seed) {
  std::mt19937 random(static_cast<unsigned>(seed));
  Shape cube = triangulated_cube();
  for (auto& face : cube.faces)
    if (seed == 0 || random() % 2 == 0) std::swap(face[0], face[1]);
  return lengths(lab.draw(lab.world_of(cube), {orthographic(diagonal)}), 9 * isometric_edge, 3 * isometric_edge);
}

Measured cavity_in_a_cube(const Lab& lab, double at) {
  Measured measured;
  for (const bool outward : {false, true}) {
    const Shape cube = cube_with_a_cavity(outward).moved(at, at, at);
    append(measured,
           lengths(lab.draw(lab.world_of(cube), {orthographic(diagonal)}), 27 * isometric_edge, 15 * isometric_edge));
  }
  return measured;
}

// A tilted plate of 2 x 1 through the middle of a horizontal one of 4 x 2. The contact tolerance lengthens the visible
// parts of its two long sides.
Measured crossing_plates(const Lab& lab, double slope) {
  Shape plates = plate(0, 0, 4, 2, 0);
  plates.add({{{1, 0.5, slope}, {3, 0.5, -slope}, {3, 1.5, -slope}, {1, 1.5, slope}}, {{0, 1, 2, 3}}, {}});
  const Camera camera{from_above()};
  const Result without = lab.draw(lab.world_of(plates), camera, {.intersection = false});
  const Result with = lab.draw(lab.world_of(plates), camera);
  const double longer = 2 * without.view.contact.touching / without.view.map.unit * without.unit / slope;
  Measured measured = lengths(without, 15 + longer, 3 - longer);
  append(measured, lengths(with, 16 + longer, 3 - longer));
  return measured;
}

// Four bars, each over the next and under the previous one.
Measured weave(const Lab& lab, double tilt) {
  const double l = 8;
  const auto bar = [&](double x, double y, bool along_x, double from, double to) {
    from *= tilt, to *= tilt;
    if (along_x) return Shape{{{x, y, from}, {x + l, y, to}, {x + l, y + 1, to}, {x, y + 1, from}}, {{0, 1, 2, 3}}, {}};
    return Shape{{{x, y, from}, {x + 1, y, from}, {x + 1, y + l, to}, {x, y + l, to}}, {{0, 1, 2, 3}}, {}};
  };
  Shape bars = bar(0, 1, true, 0, 1);
  bars.add(bar(6, 0, false, 0, 1));
  bars.add(bar(0, 6, true, 1, 0));
  bars.add(bar(1, 0, false, 1, 0));
  return lengths(lab.draw(lab.world_of(bars), {from_above()}), 64, 8);
}

// Three triangles, with one side of the first split by a vertex of the others, rotated around that vertex.
Measured through_a_t_junction(const Lab& lab, double degrees) {
  const double c = std::cos(degrees * M_PI / 180), s = std::sin(degrees * M_PI / 180);
  const auto turned = [&](double x, double y, double z) { return Point{c * x - s * y, s * x + c * y, z}; };
  const Shape junction{{turned(0.5, -1, 1), turned(0.5, 1, 1), turned(-1, 0, 1), turned(0.5, 0, 1), turned(2, 0, 1)},
                       {{0, 1, 2}, {0, 4, 3}, {3, 4, 1}},
                       {}};
  const world::World world = lab.world_of({junction, plate(-4, -4, 4, 4, -1)});
  return one_span(lab.hidden_of_line(world, from_above(), {-2.5 * c, -2.5 * s, 0}, {3.5 * c, 3.5 * s, 0}), 0.25, 0.75);
}

// Square pages on a common spine, seen from above; a page at a right angle is a line.
Measured book(const Lab& lab, double pages) {
  const int k = static_cast<int>(pages);
  Shape all;
  double edges = 1;  // the spine, once
  for (int i = 1; i <= k; ++i) {
    const double a = M_PI * i / (k + 1), x = 2 * i == k + 1 ? 0 : std::cos(a), z = std::sin(a);
    all.add({{{0, 0, 0}, {x, 0, z}, {x, 1, z}, {0, 1, 0}}, {{0, 1, 2, 3}}, {}});
    if (x != 0) edges += 1;
  }
  return lengths(lab.draw(lab.world_of(all), {from_above()}), edges + 4 * std::cos(M_PI / (k + 1)), 0);
}

// Two bars with different diagonals that overlap over a part of their lengths, seen from the front.
Measured overlapping_bars(const Lab& lab, double overlap) {
  Shape left = triangulated_cube(false), right = triangulated_cube(true);
  for (Point& p : left.points) p[0] *= 2;
  for (Point& p : right.points) p[0] = p[0] == 0 ? 2 - overlap : 3;
  const Result result = lab.draw(lab.world_of({left, right}), {orthographic({0, -1, 0})});
  return lengths(result, 10, 0);
}

}  // namespace

std::vector<Case> body_cases() {
  const std::vector<double> places{0, 0.1, 1.0 / 3, 10, 1e2, 1e3, 1e4, 1e5, 1e6};
  return {
      {"M1", "two cubes that touch in a face", "offset of all coordinates", places, boxes_in_contact},
      {"M2",
       "two cubes with a gap",
       "gap",
       {1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-10, 1e-11, 1e-12, 1e-13, 1e-14, 1e-15},
       boxes_with_a_gap},
      {"M3", "cube twice, with other diagonals", "offset of all coordinates", places, cube_twice},
      {"M4", "cube inside out (0) or flipped at random", "seed", {0, 1, 2, 3, 4, 5, 6, 7}, faces_flipped_at_random},
      {"M5", "cube with a cavity, oriented either way", "offset of all coordinates", places, cavity_in_a_cube},
      {"M6",
       "crossing plates, with and without their line",
       "slope",
       {1, 1e1, 1e2, 1e3, 1e-1, 1e-2, 1e-3, 1e-4},
       crossing_plates},
      {"M7", "weave of four bars in a cycle", "tilt", {1, 1e1, 1e2, 1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6}, weave},
      {"M10", "line through a T-junction", "degrees", {0, 10, 20, 30, 45, 60, 70, 80}, through_a_t_junction},
      {"M14", "book of pages on one edge", "pages", {2, 3, 4, 5, 6, 8, 11, 16, 23}, book},
      {"M30",
       "overlapping bars with coplanar faces",
       "overlap",
       {1, 0.7, 0.5, 1e-1, 1e-2, 1e-3, 1e-4, 1e-5},
       overlapping_bars},
  };
}

}  // namespace epura::stability
