// SPDX-License-Identifier: Apache-2.0
// Recognition: faces of parts whose surfaces are known, from vertices with the precision of the file. By `float32`, the
// file holds 32-bit coordinates; the map has no influence.
#include <algorithm>
#include <cmath>

#include "base/angle.hpp"
#include "laboratory/shapes.hpp"
#include "study/stability/case.hpp"
#include "surfaces/recognise.hpp"

namespace epura::stability {

namespace {

using surfaces::PartFace;
using surfaces::PartFaces;
using surfaces::PartSurface;
using surfaces::SurfaceKind;

struct Recognised {
  mesh::Mesh mesh;
  PartFaces part;
};

Recognised recognise(const Lab& lab, const Shape& shape) {
  Recognised found{lab.arithmetic == Arithmetic::single ? mesh_of_floats(shape) : mesh_of(shape), {}};
  found.part = surfaces::recognise_faces(found.mesh);
  return found;
}

Quantity faces(const Recognised& found, int expected) {
  return count("faces", expected, static_cast<double>(found.part.faces.size()));
}

Quantity radius(double expected, const PartFace* face) {
  return length("radius", expected, face == nullptr ? NAN : face->surface.radius, expected);
}

std::vector<Vec2> arc(Vec2 centre, double r, double from, double to, int steps) {
  std::vector<Vec2> points;
  for (int i = 0; i <= steps; ++i) {
    const double a = (from + (to - from) * i / steps) * degree;
    points.push_back(centre + r * Vec2(std::cos(a), std::sin(a)));
  }
  return points;
}

// A unit square with its corner at (1, 1) rounded in `steps` facets, which end where tangents have turned by `sweep`
// degrees: with less than 90, a flat follows. The corners of the arc come first.
std::vector<Vec2> rounded_square(double r, double sweep, int steps) {
  std::vector<Vec2> outline = arc({1 - r, 1 - r}, r, 0, sweep, steps);
  if (sweep < 90) outline.emplace_back(outline.back().x - (1 - outline.back().y) * std::tan(sweep * degree), 1);
  outline.insert(outline.end(), {{0, 1}, {0, 0}, {1, 0}});
  return outline;
}

// The facets of an arc of `points` points at the beginning of an outline.
const PartFace* face_of_arc(const Recognised& found, int points, int outline) {
  for (std::size_t t = 0; t < found.part.face_of_triangle.size(); ++t) {
    const std::array<int, 3> corners = found.mesh.triangle(static_cast<int>(t));
    const auto on_arc = [&](int v) { return v % outline < points; };
    const bool upright = std::any_of(corners.begin(), corners.end(), [&](int v) { return v < outline; }) &&
                         std::any_of(corners.begin(), corners.end(), [&](int v) { return v >= outline; });
    if (upright && std::all_of(corners.begin(), corners.end(), on_arc) && found.part.face_of_triangle[t] >= 0)
      return &found.part.faces[found.part.face_of_triangle[t]];
  }
  return nullptr;
}

Measured rounded_corner(const Lab& lab, double r, double sweep, int steps) {
  const std::vector<Vec2> outline = rounded_square(r, sweep, steps);
  const Recognised found = recognise(lab, prism(outline, 1));
  return {faces(found, sweep < 90 ? 8 : 7), radius(r, face_of_arc(found, steps + 1, static_cast<int>(outline.size())))};
}

Measured fillet_of_a_radius(const Lab& lab, double r) { return rounded_corner(lab, r, 90, 8); }

Measured fillet_in_facets(const Lab& lab, double steps) {
  return rounded_corner(lab, 0.3, 90, static_cast<int>(steps));
}

Measured patch_of_facets(const Lab& lab, double steps) {
  return rounded_corner(lab, 0.3, 7.5 * steps, static_cast<int>(steps));
}

// The sides of a frustum are a cone, however close to a cylinder. The surface is compared at both ends.
Measured slender_cone(const Lab& lab, double half_angle) {
  constexpr int sides = 48;
  constexpr double r = 10, height = 20;
  const double top = r - height * std::tan(half_angle * degree);
  const Recognised found = recognise(lab, frustum(r, top, height, sides));
  Measured measured{faces(found, 3)};
  for (const PartFace& face : found.part.faces)
    if (face.surface.kind != SurfaceKind::plane)
      for (const Vec3& end : {Vec3(r, 0, 0), Vec3(top, 0, height)})
        measured.push_back(length("surface", 0, surfaces::signed_distance(face.surface, end), height));
  return measured;
}

// A plate whose top is an arc of a large circle. Where it cannot be told from a plane, it may be one.
Measured crowned_plate(const Lab& lab, double r) {
  constexpr int steps = 12;
  const double half = std::asin(0.5 / r) / degree, foot = 0.5 / std::tan(half * degree);
  std::vector<Vec2> outline = arc({0.5, 0.5 - foot}, r, 90 - half, 90 + half, steps);
  outline.insert(outline.end(), {{0, 0}, {1, 0}});
  const Recognised found = recognise(lab, prism(outline, 1));
  Measured measured{faces(found, 6)};
  const PartFace* face = face_of_arc(found, steps + 1, static_cast<int>(outline.size()));
  double off = face == nullptr ? NAN : 0;
  for (int i = 0; face != nullptr && i <= steps; ++i)
    off = std::max(off, std::abs(surfaces::signed_distance(face->surface, Vec3(outline[i].x, outline[i].y, 0.5))));
  measured.push_back(length("surface", 0, off, 1));
  return measured;
}

Shape tube_ring(double minor, int around, int across) {
  Shape shape;
  for (int i = 0; i < around; ++i)
    for (int k = 0; k < across; ++k) {
      const double a = 2 * M_PI * i / around, b = 2 * M_PI * (k + 0.3) / across, r = 1 + minor * std::cos(b);
      shape.points.push_back({r * std::cos(a), r * std::sin(a), minor * std::sin(b)});
      const int next = (i + 1) % around * across, other = (k + 1) % across;
      shape.faces.push_back({i * across + k, next + k, next + other, i * across + other});
    }
  return shape;
}

Measured thin_ring(const Lab& lab, double minor) {
  const Recognised found = recognise(lab, tube_ring(minor, 64, 16));
  Measured measured{faces(found, 1)};
  const PartFace* face = found.part.faces.empty() ? nullptr : &found.part.faces[0];
  measured.push_back(radius(1, face));
  measured.push_back(length("tube", minor, face == nullptr ? NAN : face->surface.minor, 1));
  return measured;
}

// What is known of the surface is known to the last digit of the file.
Measured ball_in_digits(const Lab& /*lab*/, double digits) {
  const Shape ball = uv_sphere(32, 16);
  const mesh::Mesh mesh = mesh_of(ball, static_cast<int>(digits));
  const PartFaces part = surfaces::recognise_faces(mesh);
  Quantity r = radius(1, part.faces.empty() ? nullptr : &part.faces[0]);
  r.allowed = std::max(r.allowed, std::pow(10.0, -digits));
  return {count("faces", 1, static_cast<double>(part.faces.size())), r};
}

// Coordinates far from the origin keep fewer digits of the part.
Measured shaft_far_away(const Lab& lab, double offset) {
  constexpr int sides = 48;
  std::vector<Vec2> outline = arc({offset, offset}, 1, 0, 360, sides);
  outline.pop_back();
  const Recognised found = recognise(lab, prism(outline, 3));
  const PartFace* face = face_of_arc(found, sides, sides);
  Quantity r = radius(1, face);
  r.rounding = offset * (lab.arithmetic == Arithmetic::single ? 0x1p-23 : 0x1p-52);
  return {faces(found, 3), r};
}

// Planes between which there is an angle are two faces, whatever it is.
Measured shallow_roof(const Lab& lab, double angle) {
  const Recognised found =
      recognise(lab, prism({{0, 0}, {2, 0}, {2, 1}, {1, 1 + std::tan(angle * degree)}, {0, 1}}, 1));
  return {count(
      "planes", 7,
      static_cast<double>(std::count_if(found.part.faces.begin(), found.part.faces.end(), [](const PartFace& face) {
        return face.surface.kind == SurfaceKind::plane;
      })))};
}

}  // namespace

std::vector<Case> recognition_cases() {
  return {
      {"R1", "cone of a small half-angle", "degrees", {20, 10, 3, 1, 1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6}, slender_cone},
      {"R2",
       "rounded edge of a unit cube",
       "radius",
       {0.5, 0.3, 1e-1, 3e-2, 1e-2, 5e-3, 2e-3, 1e-3},
       fillet_of_a_radius},
      {"R3", "crowned plate", "radius of the crown", {0.6, 1, 10, 1e2, 1e3, 1e4, 1e5, 1e6, 1e8}, crowned_plate},
      {"R4", "rounded edge in few facets", "facets", {32, 24, 16, 12, 8, 6, 5, 4, 3}, fillet_in_facets},
      {"R5", "arc of few facets before a flat", "facets", {11, 10, 9, 8, 7, 6, 5, 4}, patch_of_facets},
      {"R6", "thin ring", "radius of its tube", {0.5, 0.3, 0.1, 3e-2, 1e-2, 5e-3, 2e-3, 1e-3}, thin_ring},
      {"R7", "ball written with few digits", "digits", {16, 14, 12, 10, 8, 7, 6, 5}, ball_in_digits},
      {"R8", "shaft far from the origin", "offset", {1, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7}, shaft_far_away},
      {"R9", "shallow roof", "degrees", {30, 10, 3, 1, 0.3, 1e-1, 1e-2, 1e-3, 1e-4}, shallow_roof},
  };
}

}  // namespace epura::stability
