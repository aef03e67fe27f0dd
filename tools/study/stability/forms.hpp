// SPDX-License-Identifier: Apache-2.0
// Scenes of any size with lines known in closed form: each is built, drawn and measured. Lengths are in model units.
#pragma once

#include <cmath>

#include "laboratory/lab.hpp"
#include "laboratory/shapes.hpp"
#include "study/stability/measured.hpp"

namespace epura::stability {

using namespace laboratory;

/// The direction in which all edges of a cube have the same length on the page, and that of the edges of a unit cube.
inline const Vec3 diagonal(1, 1, 1);
inline const double isometric_edge = std::sqrt(2.0 / 3.0);

/// Total lengths of the visible and the hidden lines; errors up to `allowed`, relative to the larger of drawing and
/// total.
Measured lengths(const Result& result, double visible, double hidden, double allowed = guaranteed_part);

/// A line that is hidden in one piece, between two of its parameters.
Measured one_span(const HiddenLine& line, double from, double to, double allowed = guaranteed_part);

/// `n` strips of width `width` across `m` others: the crossings hide 2 n m `width`, each in a separate piece.
Measured strips_over_strips(const Lab& lab, int n, int m, double width);

/// `n` unit plates below each other, each shifted by `shift` along the diagonal of the page.
Measured stack_of_plates(const Lab& lab, int n, double shift);

/// `n` unit plates, each `shift` to the right of, behind and below the previous one, in an isometric view: two sides of
/// all of them coincide with two lines on the page, and a third side of each is visible along these lines.
Measured plates_along_a_line(const Lab& lab, int n, double shift);

/// A unit plate of `n` strips hides one piece, of length 1, of a line below it.
Measured sliver_plate(const Lab& lab, int n);

/// The unit cube of 12 `cells` cells triangles, with every edge split into `parts` on one side only: parts - 1
/// degenerate triangles close each gap. Its drawing is that of the plain cube.
Measured triangles_without_area(const Lab& lab, int cells, int parts);

/// A disk of `n` triangles around its middle hides one piece, a chord, of a line below it.
Measured fan_over_chords(const Lab& lab, int n);

/// Seen along its axis, a sphere is one closed chain: a regular polygon of `meridians` sides.
Measured sphere_along_its_axis(const Lab& lab, int meridians, int bands);

/// The outline of a convex surface without creases is entirely visible: the convex hull of its corners on the page.
/// That of a recognised surface may be longer, within the height of its facets.
Measured outline_of(const Lab& lab, const Shape& convex);

/// From a centre at `distance` from its middle (infinite: in parallel projection), the outline of a sphere is entirely
/// visible: the convex hull of its corners on the page.
Measured sphere_from_anywhere(const Lab& lab, int meridians, int bands, double distance);

/// The sum of `zones` random segments: a convex polytope of zones (zones - 1) parallelograms. All its edges are drawn.
/// Parallel edges form a ring; two of them lie on the outline, and half of the others lie in front of the other half.
Measured zonotope(const Lab& lab, int zones);

/// `n` plates seen edge-on, one below the other, appear as one line.
Measured stacked_copies(const Lab& lab, int n);

/// A sphere in a stadium of square steps that is `size` times as wide: from above, no line hides another.
Measured sphere_in_a_stadium(const Lab& lab, int meridians, int bands, double size);

/// `n` long needles at different heights, each across most others. Hidden lines are found a second time in the plane.
Measured needles(const Lab& lab, int n);

}  // namespace epura::stability
