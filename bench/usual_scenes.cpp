// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <numbers>

#include "generators.hpp"

namespace epura::bench {

namespace {

constexpr double turn = 2 * std::numbers::pi;

/// Adds a point in coordinates rotated so that `axis` is the third.
int add_turned(Scene& scene, const Point& middle, int axis, const Point& p) {
  Point q{};
  for (int i = 0; i < 3; ++i) q[(axis + 1 + i) % 3] = middle[(axis + 1 + i) % 3] + p[i];
  return scene.add(q[0], q[1], q[2]);
}

void add_torus(Scene& scene, const Point& middle, int axis, int triangles) {
  const int n = static_cast<int>(std::sqrt(triangles / 2.0)), first = static_cast<int>(scene.points.size());
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) {
      const double a = turn * i / n, b = turn * j / n, radius = 100 + 40 * std::cos(b);
      add_turned(scene, middle, axis, {radius * std::cos(a), radius * std::sin(a), 40 * std::sin(b)});
    }
  const auto at = [=](int i, int j) { return first + i % n * n + j % n; };
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) scene.quad(at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1));
}

Scene sphere(int triangles) {
  Scene scene;
  add_sphere(scene, triangles);
  return scene;
}

Scene torus(int triangles) {
  Scene scene;
  add_torus(scene, {}, 2, triangles);
  return scene;
}

Scene tori(int triangles) {
  Scene scene;
  for (int i = 0; i < 16; ++i) add_torus(scene, {100.0 * (i % 4), 100.0 * (i / 4), 0}, i % 3, triangles / 16);
  return scene;
}

// The ring between a square cell and its round hole: each corner of the square is joined to a quarter of the hole.
void add_ring(Scene& scene, const std::array<int, 4>& square, const std::vector<int>& hole, bool up) {
  const auto triangle = [&](int a, int b, int c) {
    if (up)
      scene.triangles.push_back({a, b, c});
    else
      scene.triangles.push_back({a, c, b});
  };
  const int quarter = static_cast<int>(hole.size()) / 4;
  for (int corner = 0; corner < 4; ++corner) {
    for (int i = 0; i < quarter; ++i)
      triangle(square[corner], hole[(corner * quarter + i + 1) % hole.size()], hole[corner * quarter + i]);
    triangle(square[corner], square[(corner + 1) % 4], hole[(corner + 1) * quarter % hole.size()]);
  }
}

Scene plate(int k) {
  constexpr int sides = 32;
  Scene scene;
  for (const double z : {0.0, 4.0})
    for (int j = 0; j <= k; ++j)
      for (int i = 0; i <= k; ++i) scene.add(10 * i, 10 * j, z);
  const auto at = [k](int i, int j, int level) { return (level * (k + 1) + j) * (k + 1) + i; };
  for (int j = 0; j < k; ++j)
    for (int i = 0; i < k; ++i) {
      std::array<std::vector<int>, 2> hole;
      for (int level = 0; level < 2; ++level) {
        for (int s = 0; s < sides; ++s) {
          const double a = turn * s / sides - turn / 2;
          hole[level].push_back(scene.add(10 * i + 5 + 3 * std::cos(a), 10 * j + 5 + 3 * std::sin(a), 4.0 * level));
        }
        add_ring(scene, {at(i, j, level), at(i + 1, j, level), at(i + 1, j + 1, level), at(i, j + 1, level)},
                 hole[level], level == 1);
      }
      for (int s = 0; s < sides; ++s) {
        const int t = (s + 1) % sides;
        scene.quad(hole[0][s], hole[1][s], hole[1][t], hole[0][t]);
      }
    }
  for (int i = 0; i < k; ++i) {
    scene.quad(at(i, 0, 0), at(i + 1, 0, 0), at(i + 1, 0, 1), at(i, 0, 1));
    scene.quad(at(i, k, 1), at(i + 1, k, 1), at(i + 1, k, 0), at(i, k, 0));
    scene.quad(at(0, i, 1), at(0, i + 1, 1), at(0, i + 1, 0), at(0, i, 0));
    scene.quad(at(k, i, 0), at(k, i + 1, 0), at(k, i + 1, 1), at(k, i, 1));
  }
  return scene;
}

void add_gear(Scene& scene, const Point& middle, int axis) {
  constexpr int corners = 48;  // four per tooth
  const auto add = [&](double radius, int corner, double height) {
    const double a = turn * corner / corners;
    return add_turned(scene, middle, axis, {radius * std::cos(a), radius * std::sin(a), height});
  };
  std::array<std::vector<int>, 4> loops;  // outside below and above, bore below and above
  for (int c = 0; c < corners; ++c) {
    const double outside = c % 4 < 2 ? 4.5 : 3.6;
    loops[0].push_back(add(outside, c, -1));
    loops[1].push_back(add(outside, c, 1));
    loops[2].push_back(add(1.5, c, -1));
    loops[3].push_back(add(1.5, c, 1));
  }
  for (int c = 0; c < corners; ++c) {
    const int d = (c + 1) % corners;
    scene.quad(loops[0][c], loops[0][d], loops[1][d], loops[1][c]);
    scene.quad(loops[2][d], loops[2][c], loops[3][c], loops[3][d]);
    scene.quad(loops[1][c], loops[1][d], loops[3][d], loops[3][c]);
    scene.quad(loops[0][d], loops[0][c], loops[2][c], loops[2][d]);
  }
}

Scene shaft(int n) {
  Scene scene;
  for (int i = 0; i < n; ++i) add_gear(scene, {0, 0, 3.0 * i}, 2);
  return scene;
}

Scene gears(int n) {
  Scene scene;
  for (int k = 0; k < n; ++k)
    for (int j = 0; j < n; ++j)
      for (int i = 0; i < n; ++i) add_gear(scene, {10.0 * i, 10.0 * j, 10.0 * k}, (i + j + k) % 3);
  return scene;
}

Scene city(int n) {
  Scene scene;
  add_box(scene, {-10, -10, -2}, {10.0 * n + 4, 10.0 * n + 4, 0});
  Random random;
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i)
      add_box(scene, {10.0 * i, 10.0 * j, 0}, {10.0 * i + 6, 10.0 * j + 6, 4.0 + random.bits() % 40});
  return scene;
}

Scene crates(int n) {
  Scene scene;
  for (int k = 0; k < n * n * n; ++k) {
    const double x = 10.0 * (k % n), y = 10.0 * (k / n % n), z = 10.0 * (k / n / n);
    add_box(scene, {x, y, z}, {x + 6, y + 6, z + 6});
  }
  return scene;
}

// Steep enough for creases, but not so steep that an isometric view hides any.
Scene terrain(int triangles) {
  Scene scene;
  Random random;
  const int n = static_cast<int>(std::sqrt(triangles / 2.0));
  for (int j = 0; j <= n; ++j)
    for (int i = 0; i <= n; ++i) scene.add(i, j, random.between(0, 0.4));
  const auto at = [=](int i, int j) { return j * (n + 1) + i; };
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) scene.quad(at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1));
  return scene;
}

}  // namespace

void add_sphere(Scene& scene, int triangles) {
  const int bands = static_cast<int>(std::sqrt(triangles / 4.0)), n = 2 * bands;
  const int south = scene.add(0, 0, -100), north = scene.add(0, 0, 100);
  for (int j = 1; j < bands; ++j)
    for (int i = 0; i < n; ++i) {
      const double a = turn * i / n, b = turn / 2 * j / bands - turn / 4;
      scene.add(100 * std::cos(b) * std::cos(a), 100 * std::cos(b) * std::sin(a), 100 * std::sin(b));
    }
  const auto at = [=](int j, int i) { return north + 1 + (j - 1) * n + i % n; };
  for (int i = 0; i < n; ++i) {
    scene.triangles.push_back({south, at(1, i + 1), at(1, i)});
    for (int j = 1; j + 1 < bands; ++j) scene.quad(at(j, i), at(j, i + 1), at(j + 1, i + 1), at(j + 1, i));
    scene.triangles.push_back({north, at(bands - 1, i), at(bands - 1, i + 1)});
  }
}

std::vector<Generator> usual_scenes() {
  return {{"sphere", "a sphere of about N triangles", sphere},
          {"torus", "a torus of about N triangles", torus},
          {"tori", "sixteen tori through each other, about N triangles", tori},
          {"plate", "a plate of N x N cells, each with a through hole of 32 sides", plate},
          {"shaft", "N equal gears behind one another on an upright axis", shaft},
          {"gears", "N^3 separate gears of 12 teeth with a bore, in three orientations", gears},
          {"city", "N x N boxes of different heights on a ground plate", city},
          {"crates", "N^3 boxes that stand apart", crates},
          {"terrain", "a rough surface of about N triangles that hides nothing from above", terrain}};
}

}  // namespace epura::bench
