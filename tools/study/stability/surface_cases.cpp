// SPDX-License-Identifier: Apache-2.0
// Meshes: one-sided, round and wavy surfaces. If no closed form is known, the drawing is verified point by point in
// rational numbers (src/run/verify).
#include <algorithm>
#include <cmath>
#include <utility>

#include "study/stability/case.hpp"
#include "study/stability/forms.hpp"
#include "verify/verify.hpp"

namespace epura::stability {

namespace {

// Points of the drawing that are found wrong.
Quantity judged(const Result& result) {
  constexpr int samples = 300;
  const view::ViewLimits limits;
  const report::Verification found =
      verify::verify({result.world, result.view.projection, limits, result.drawn, result.hidden, result.drawing},
                     {result.view.extent, result.view.contact.touching}, samples, true);
  return count("wrong points", 0, found.wrong);
}

// The same surface with other numbers and orientations: vertices begin `first` later, and so do faces.
Shape renumbered(Shape shape, int first) {
  const int n = static_cast<int>(shape.points.size());
  first %= n;
  std::rotate(shape.points.begin(), shape.points.begin() + first, shape.points.end());
  for (auto& face : shape.faces) {
    for (int& v : face) v = (v - first + n) % n;
    if (face[0] % 3 == 0) std::swap(face[1], face[2]);
  }
  std::rotate(shape.faces.begin(), shape.faces.begin() + first % static_cast<int>(shape.faces.size()),
              shape.faces.end());
  return shape;
}

Measured renumbering(const Lab& lab, const Shape& shape, int first, int open_edges) {
  const Camera camera{orthographic({1, -2, 3})};
  const Result plain = lab.exact().draw(lab.world_of(shape), camera);
  const Result result = lab.draw(lab.world_of(renumbered(shape, first)), camera);
  Measured measured = lengths(result, plain.visible(), plain.hidden_length());
  measured.push_back(count("open edges", open_edges, result.world.models[0].mesh->report.open_edges));
  return measured;
}

Measured moebius_strip(const Lab& lab, double first) {
  return renumbering(lab, moebius(40), static_cast<int>(first), 80);
}

Measured klein(const Lab& lab, double first) {
  const Shape bottle = klein_bottle(24, 16);
  Measured measured = renumbering(lab, bottle, static_cast<int>(first), 0);
  measured.push_back(
      judged(lab.draw(lab.world_of(renumbered(bottle, static_cast<int>(first))), {orthographic({1, -2, 3})})));
  return measured;
}

// From above, no part of the hat hides another.
Measured hat(const Lab& lab, double elevation) {
  const double a = elevation * M_PI / 180;
  const Vec3 towards = elevation == 90 ? Vec3(0, 0, 1) : Vec3(0, -std::cos(a), std::sin(a));
  const Result result = lab.draw(lab.world_of(sombrero(3, 24)), {orthographic(towards, {0, 1, 1})}, {.smooth = true});
  Measured measured{judged(result)};
  if (elevation == 90) measured.push_back(length("hidden", 0, result.hidden_length(), result.extent()));
  return measured;
}

// Creases count from the threshold, which is exactly the angle between neighbouring sides: all or none.
Measured prism_at_the_threshold(const Lab& lab, double sides) {
  const int n = static_cast<int>(sides);
  Shape prism;
  for (int i = 0; i < n; ++i) {
    const double a = 2 * M_PI * i / n;
    prism.points.push_back({std::cos(a), std::sin(a), 0});
    prism.points.push_back({std::cos(a), std::sin(a), 1});
    prism.faces.push_back({2 * i, (2 * i + 2) % (2 * n), (2 * i + 3) % (2 * n), 2 * i + 1});
  }
  const edges::EdgeOptions creases{
      .contour = false, .boundary = false, .intersection = false, .crease_angle = 360.0 / n};
  const Result result = lab.draw(lab.world_of(prism), {orthographic({1, 0.3, 0.2})}, creases);
  return {count("edges beyond all or none", 0,
                static_cast<double>(result.drawn.edges.size() % static_cast<std::size_t>(n)))};
}

Measured sphere_on_its_axis(const Lab& lab, double meridians) {
  return sphere_along_its_axis(lab, static_cast<int>(meridians), static_cast<int>(meridians) / 2);
}

Measured sphere_at_a_distance(const Lab& lab, double distance) { return sphere_from_anywhere(lab, 64, 32, distance); }

}  // namespace

std::vector<Case> surface_cases() {
  return {
      {"M15",
       "Moebius strip under other numbers and orientations",
       "first vertex",
       {0, 7, 11, 23, 34, 46, 57, 71},
       moebius_strip,
       true},
      {"M16",
       "Klein bottle under other numbers and orientations",
       "first vertex",
       {0, 17, 60, 101, 150, 199, 277, 350},
       klein,
       true},
      {"M17", "sphere along its axis", "meridians", {16, 20, 24, 32, 48, 64, 128, 256}, sphere_on_its_axis},
      {"M18", "sphere from anywhere", "distance", {10, 5, 2, 1.5, 1.1, 1e2, 1e4, 1e6, 1e9}, sphere_at_a_distance},
      {"M19", "sombrero from above to grazing", "degrees", {90, 60, 30, 10, 3, 1, 1e-1, 1e-2, 1e-3}, hat},
      {"M20",
       "prism whose creases are exactly at the threshold",
       "sides",
       {6, 8, 10, 12, 18, 20, 24, 36, 72},
       prism_at_the_threshold},
      {"M21",
       "convex polytope: the sum of random segments",
       "segments",
       {3, 4, 6, 8, 12, 16, 24, 32},
       [](const Lab& lab, double n) { return zonotope(lab, static_cast<int>(n)); }},
  };
}

}  // namespace epura::stability
