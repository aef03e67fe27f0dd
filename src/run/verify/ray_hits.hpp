// SPDX-License-Identifier: Apache-2.0
// Where straight lines meet the surfaces of parts, in closed form.
//
// A surface is the set where a polynomial of the position is zero: of degree 1 for planes, 2 for cylinders, cones and
// spheres, 4 for tori. Along a line, it is a polynomial of one variable. Nothing is shared with the functions of
// surfaces/part_surface.hpp, which recognise faces and move lines onto them.
#pragma once

#include <span>
#include <vector>

#include "surfaces/part_surface.hpp"

namespace epura::verify {

/// The line through `from`; `along` has length 1.
struct Ray {
  Vec3 from, along;
};

/// Returns where a polynomial changes its sign, ascending. Coefficients are those of 1, x, x^2, ...
std::vector<double> sign_changes(std::span<const double> coefficients);

/// Returns the lengths along the line, ascending, at which it goes through the whole surface, of which faces are parts;
/// nothing for free forms. A cone has the sheet on which its radius is positive.
std::vector<double> ray_hits(const surfaces::PartSurface& surface, const Ray& ray);

/// Returns the unit normal at a point of a surface, away from the axis or centre; zero where there is none, as at an
/// apex and for free forms.
Vec3 normal_on(const surfaces::PartSurface& surface, const Vec3& point);

/// Between planes with these normals, of any length, whichever way they face; in degrees, 0 to 90.
double angle_between_planes(const Vec3& a, const Vec3& b);

}  // namespace epura::verify
