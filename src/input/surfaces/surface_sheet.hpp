// SPDX-License-Identifier: Apache-2.0
// Cones and tori that have two sheets: a cone on both sides of its apex, a torus whose tube is wider than its circle
// one around the other.
//
// The functions of part_surface.hpp take a cone for the sheet that has its radius at its origin, and a torus for the
// outer one.
#pragma once

#include <span>

#include "surfaces/part_surface.hpp"

namespace epura::surfaces {

/// Whether a surface is a cone or a torus whose tube is wider than its circle.
bool has_two_sheets(const PartSurface& surface);

/// Returns the same surface, described so that the points lie on the sheet that it is taken for; a free form if they
/// lie on the inner sheet of a torus.
PartSurface on_sheet_of(const PartSurface& surface, std::span<const Vec3> points);

}  // namespace epura::surfaces
