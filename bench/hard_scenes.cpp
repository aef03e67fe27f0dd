// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <numbers>

#include "generators.hpp"

namespace epura::bench {

namespace {

constexpr double turn = 2 * std::numbers::pi;

// The boxes shrink so that a line of sight meets about 44 of them whatever their number.
Scene boxes(int n) {
  const double side = 2 * std::sqrt(83000.0 / n);
  Scene scene;
  Random random;
  for (int i = 0; i < n; ++i) {
    Point min{}, max{};
    for (int k = 0; k < 3; ++k) {
      const double middle = random.between(0, 100), half = random.between(side / 4, side * 3 / 4);
      min[k] = middle - half;
      max[k] = middle + half;
    }
    add_box(scene, min, max);
  }
  return scene;
}

// From above, with strips half as wide as their pitch: N^2 of the long edges below are hidden, in 2 N^2 pieces.
Scene weave(int n) {
  Scene scene;
  for (int i = 0; i < n; ++i) {
    add_rectangle(scene, {i + 0.25, 0}, {i + 0.75, 1.0 * n}, 1);
    add_rectangle(scene, {0, i + 0.25}, {1.0 * n, i + 0.75}, 0);
  }
  return scene;
}

// From above: 2 N + 2 + 2 d (N - 1) is visible, in units of the plates' side.
Scene stack(int n) {
  constexpr double d = 1e-6;
  Scene scene;
  for (int i = 0; i < n; ++i) add_rectangle(scene, {d * i, d * i}, {1 + d * i, 1 + d * i}, -d * i);
  return scene;
}

Scene plates(int n) {
  Scene scene;
  for (int i = 0; i < n; ++i) add_box(scene, {0, 0, 0.5 * i}, {100, 60, 0.5 * i + 0.3});
  return scene;
}

Scene soup(int n) {
  Scene scene;
  Random random;
  for (int i = 0; i < n; ++i) {
    int corner = 0;
    for (int k = 0; k < 3; ++k) {
      const double x = random.number(), y = random.number(), z = random.number();
      corner = scene.add(x, y, z);
    }
    scene.triangles.push_back({corner - 2, corner - 1, corner});
  }
  return scene;
}

// From above, about every second pair crosses: N^2 pieces, half of them hidden.
Scene needles(int n) {
  Scene scene;
  Random random;
  for (int i = 0; i < n; ++i) {
    const double left = random.between(0, 100), right = random.between(0, 100), z = 100.0 * i / n;
    const int tip = scene.add(0, left, z);
    scene.add(100, right, z);
    scene.add(100, right + 0.01, z);
    scene.triangles.push_back({tip, tip + 1, tip + 2});
  }
  return scene;
}

// From one hub in all directions: all of them meet at the hub.
Scene burst(int n) {
  Scene scene;
  Random random;
  const int hub = scene.add(0, 0, 0);
  for (int i = 0; i < n; ++i) {
    const double height = random.between(-1, 1), angle = random.between(0, turn),
                 level = std::sqrt(1 - height * height);
    const Point tip{100 * level * std::cos(angle), 100 * level * std::sin(angle), 100 * height};
    const int first = scene.add(tip[0], tip[1], tip[2]);
    scene.add(tip[0] + 0.002, tip[1], tip[2]);
    scene.triangles.push_back({hub, first, first + 1});
  }
  return scene;
}

// 2563 needles have 11 211 triangles.
Scene pins(int n) {
  Scene scene = burst(n);
  add_sphere(scene, static_cast<int>(std::lround(3.548 * n)));
  return scene;
}

// Triangles without area in space, whose area on the page is only rounding error.
Scene line(int n) {
  Scene scene;
  const int end = scene.add(0, 0, 0);
  for (int i = 0; i <= n; ++i) scene.add(1 + 99.0 * i / n, 0, 0);
  for (int i = 0; i < n; ++i) scene.triangles.push_back({end, end + 1 + i, end + 2 + i});
  scene.add(50, 50, 0);
  scene.triangles.push_back({end, end + n + 1, end + n + 2});
  return scene;
}

// In one plane, none hides another, although every second pair crosses.
Scene across(int n) {
  Scene scene;
  Random random;
  for (int i = 0; i < n; ++i) {
    const double left = random.between(0, 100), right = random.between(0, 100);
    const int tip = scene.add(0, left, 0);
    scene.add(100, right, 0);
    scene.add(100, right + 0.01, 0);
    scene.triangles.push_back({tip, tip + 1, tip + 2});
  }
  return scene;
}

constexpr int along_knot = 49, around_knot = 8;  // points

// A tube of radius 4 along a trefoil, rotated around its axis.
void add_knot(Scene& scene, double turned) {
  const auto middle = [turned](double u) {
    const double radius = 30 + 10 * std::cos(3 * u), angle = 2 * u + turned;
    return Point{radius * std::cos(angle), radius * std::sin(angle), 10 * std::sin(3 * u)};
  };
  const int first = static_cast<int>(scene.points.size());
  for (int i = 0; i < along_knot; ++i) {
    const double u = turn * i / along_knot;
    const Point at = middle(u);
    const double angle = 2 * u + turned;
    for (int j = 0; j < around_knot; ++j) {
      const double outwards = 4 * std::cos(turn * j / around_knot), up = 4 * std::sin(turn * j / around_knot);
      scene.add(at[0] + outwards * std::cos(angle), at[1] + outwards * std::sin(angle), at[2] + up);
    }
  }
  const auto corner = [first](int i, int j) { return first + i % along_knot * around_knot + j % around_knot; };
  for (int i = 0; i < along_knot; ++i)
    for (int j = 0; j < around_knot; ++j)
      scene.quad(corner(i, j), corner(i, j + 1), corner(i + 1, j + 1), corner(i + 1, j));
}

// Each crosses all others nearly everywhere.
Scene knots(int n) {
  Scene scene;
  for (int i = 0; i < n; ++i) add_knot(scene, 1e-4 * i);
  return scene;
}

// All detail is in a thousandth of the page.
Scene stadium(int triangles) {
  constexpr int sides = 64, tiers = 8;
  Scene scene;
  add_sphere(scene, triangles);
  const int ground = scene.add(0, 0, -200);
  std::vector<int> loop;
  for (int level = 0; level <= 2 * tiers; ++level) {
    const double radius = 60000 + 5000.0 * ((level + 1) / 2), height = -200 + 4000.0 * (level / 2);
    std::vector<int> next;
    for (int i = 0; i < sides; ++i)
      next.push_back(scene.add(radius * std::cos(turn * i / sides), radius * std::sin(turn * i / sides), height));
    for (int i = 0; i < sides; ++i) {
      const int j = (i + 1) % sides;
      if (level == 0)
        scene.triangles.push_back({ground, next[i], next[j]});
      else
        scene.quad(loop[i], next[i], next[j], loop[j]);
    }
    loop = next;
  }
  return scene;
}

// An area hidden by many thin triangles together must be hidden in one piece.
void add_bar_below(Scene& scene) { add_box(scene, {-200, -1, -2}, {200, 1, -1}); }

Scene slivers(int n) {
  const int strips = std::max(1, n / 2);
  Scene scene;
  for (int i = 0; i <= strips; ++i) {
    scene.add(-100 + 200.0 * i / strips, -100, 0);
    scene.add(-100 + 200.0 * i / strips, 100, 0);
  }
  for (int i = 0; i < strips; ++i) scene.quad(2 * i, 2 * i + 2, 2 * i + 3, 2 * i + 1);
  add_bar_below(scene);
  return scene;
}

Scene fan(int n) {
  Scene scene;
  const int hub = scene.add(0, 0, 0);
  for (int i = 0; i < n; ++i) scene.add(100 * std::cos(turn * i / n), 100 * std::sin(turn * i / n), 0);
  for (int i = 0; i < n; ++i) scene.triangles.push_back({hub, hub + 1 + i, hub + 1 + (i + 1) % n});
  add_bar_below(scene);
  return scene;
}

}  // namespace

std::vector<Generator> hard_scenes() {
  return {{"boxes", "N boxes at random, running into each other, some 44 behind one another", boxes},
          {"weave", "N strips over N strips: from above, N^2 crossings", weave},
          {"stack", "N square plates on one another, each shifted by a millionth of its side", stack},
          {"plates", "N equal plates on one another, with gaps", plates},
          {"soup", "N large triangles at random in a cube: each runs through a tenth of all others", soup},
          {"needles", "N long needles across each other", needles},
          {"burst", "N long needles from one hub in all directions", burst},
          {"across", "N long needles across each other in one plane", across},
          {"pins", "N needles from the middle of a sphere of 3.5 N triangles to its surface", pins},
          {"line", "N triangles without area on one line", line},
          {"knots", "N trefoils of 784 triangles in one another, each turned by a ten-thousandth", knots},
          {"stadium", "a sphere of about N triangles in a stadium 1000 times as large", stadium},
          {"slivers", "a plate of N slivers over a bar", slivers},
          {"fan", "a disk of N triangles around one vertex, over a bar", fan}};
}

std::vector<Generator> all_scenes() {
  std::vector<Generator> all = usual_scenes();
  for (const Generator& generator : hard_scenes()) all.push_back(generator);
  return all;
}

}  // namespace epura::bench
