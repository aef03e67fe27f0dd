// SPDX-License-Identifier: Apache-2.0
// Meshes as modellers write them: poles and seams of cos and sin, sweeps, mirror images, T-junctions, rounded text.
#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include "study/stability/case.hpp"
#include "study/stability/forms.hpp"

namespace epura::stability {

namespace {

Measured as_a_cube(const Lab& lab, const Shape& shape) {
  const Result result = lab.draw(lab.world_of(shape), {orthographic(diagonal)});
  Measured measured = lengths(result, 9 * isometric_edge, 3 * isometric_edge);
  measured.push_back(count("open edges", 0, result.world.models[0].mesh->report.open_edges));
  return measured;
}

// The profile of a unit sphere with this number of bands and its poles on z.
std::vector<std::array<double, 2>> meridian(int bands, double pole) {
  std::vector<std::array<double, 2>> profile;
  for (int i = 0; i <= bands; ++i) {
    const double a = M_PI * i / bands - M_PI / 2;
    profile.push_back({i == 0 || i == bands ? pole : std::cos(a), std::sin(a)});
  }
  return profile;
}

// The ring at each pole is closed by a polygon.
Measured poles_of_rings(const Lab& lab, double radius) {
  const int sides = 48, bands = 24;
  Shape sphere = revolved(meridian(bands, radius), sides);
  std::vector<int> bottom, top;
  for (int i = 0; i < sides; ++i) {
    bottom.insert(bottom.begin(), i);
    top.push_back(bands * sides + i);
  }
  sphere.faces.push_back(bottom);
  sphere.faces.push_back(top);
  return outline_of(lab, sphere);
}

Measured seam_of_a_full_turn(const Lab& lab, double sides) {
  return outline_of(lab, revolved(meridian(24, 0), static_cast<int>(sides), true));
}

// The unit cube as a square swept in steps.
Measured swept_square(const Lab& lab, double steps) {
  const int n = static_cast<int>(steps);
  Shape cube;
  for (int i = 0; i <= n; ++i)
    for (const auto& [x, y] : {std::pair(0.0, 0.0), {1.0, 0.0}, {1.0, 1.0}, {0.0, 1.0}})
      cube.points.push_back({x, y, i / steps});
  for (int i = 0; i < n; ++i)
    for (int k = 0; k < 4; ++k)
      cube.faces.push_back({4 * i + k, 4 * i + (k + 1) % 4, 4 * i + 4 + (k + 1) % 4, 4 * i + 4 + k});
  cube.faces.push_back({3, 2, 1, 0});
  cube.faces.push_back({4 * n, 4 * n + 1, 4 * n + 2, 4 * n + 3});
  return as_a_cube(lab, cube);
}

// One half of the unit cube, and its image in the plane x + y = 1, in which rounding displaces the points of that
// plane.
Measured mirrored_half(const Lab& lab, double at) {
  Shape half{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {0, 1, 1}},
             {{0, 2, 1}, {3, 4, 5}, {0, 1, 4, 3}, {2, 0, 3, 5}},
             {}};
  half = half.moved(at, at, at);
  const double part = std::sqrt(0.5), offset = (2 * at + 1) * part;
  Shape image = half;
  for (Point& p : image.points) {
    const double ahead = 2 * (part * p[0] + part * p[1] - offset);
    p[0] -= ahead * part;
    p[1] -= ahead * part;
  }
  for (auto& face : image.faces) std::swap(face[0], face[2]);
  half.add(image);
  return as_a_cube(lab, half);
}

// The top of the unit cube has additional corners on its border that the sides do not have.
Measured t_junctions(const Lab& lab, double parts) {
  const int n = static_cast<int>(parts);
  Shape cube = box({0, 0, 0}, {1, 1, 1});
  std::vector<int>* top = nullptr;
  for (auto& face : cube.faces)
    if (std::all_of(face.begin(), face.end(), [&](int v) { return cube.points[v][2] == 1; })) top = &face;
  std::vector<int> border;
  for (std::size_t i = 0; i < 4; ++i) {
    const Point a = cube.points[(*top)[i]], b = cube.points[(*top)[(i + 1) % 4]];
    border.push_back((*top)[i]);
    for (int k = 1; k < n; ++k) {
      const double t = k / parts;
      border.push_back(static_cast<int>(cube.points.size()));
      cube.points.push_back({a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1]), a[2] + t * (b[2] - a[2])});
    }
  }
  *top = border;
  return as_a_cube(lab, cube);
}

// Five digits of text: their rounding dents a unit sphere.
Measured five_digits(const Lab& lab, double sides) {
  const int n = static_cast<int>(sides);
  const Shape sphere = revolved(meridian(n / 2, 0), n);
  const Result exact = lab.exact().draw(lab.world_of(sphere), {orthographic({0.3, -0.8, 0.5})});
  world::World world = world::make_world({{std::make_shared<const mesh::Mesh>(mesh_of(sphere, 5)), Mat4(1.0)}});
  const Result result = lab.draw(lab.prepare(std::move(world)), {orthographic({0.3, -0.8, 0.5})});
  return lengths(result, exact.visible(), 0, 1e-3);
}

}  // namespace

std::vector<Case> modeller_cases() {
  return {
      {"M31",
       "sphere whose poles are rings of cos and sin",
       "radius of the rings",
       {1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10, 1e-12, 1e-14, 1e-15, 1e-16, 1e-17, 1e-18},
       poles_of_rings},
      {"M32",
       "sphere with a seam at the full turn",
       "meridians",
       {12, 24, 36, 50, 77, 100, 150, 200},
       seam_of_a_full_turn},
      {"M33", "cube swept in steps", "steps", {1, 3, 7, 10, 30, 100, 333, 1000}, swept_square},
      {"M34",
       "half a cube and its mirror image",
       "offset of all coordinates",
       {0, 0.1, 1.0 / 3, 10, 1e2, 1e3, 1e4, 1e5, 1e6},
       mirrored_half},
      {"M35", "cube with T-junctions around one face", "parts of an edge", {2, 3, 5, 7, 10, 11, 23, 100}, t_junctions},
      {"M36", "sphere written with five digits", "meridians", {16, 20, 24, 32, 48, 64, 96, 128}, five_digits},
  };
}

}  // namespace epura::stability
