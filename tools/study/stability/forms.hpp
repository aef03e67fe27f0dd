// SPDX-License-Identifier: Apache-2.0
// Scenes of any size whose lines are known in closed form: each is built, drawn and measured. Lengths are in model
// units.
#pragma once

#include "laboratory/lab.hpp"
#include "laboratory/shapes.hpp"
#include "study/stability/measured.hpp"

namespace epura::stability {

using namespace laboratory;

/// Total lengths of the visible and the hidden lines, each within `allowed` of the larger of drawing and total.
Measured lengths(const Result& result, double visible, double hidden, double allowed = guaranteed_part);

/// A line that is hidden in one piece, between two of its parameters.
Measured one_span(const HiddenLine& line, double from, double to, double allowed = guaranteed_part);

/// `n` strips of width `width` over `m` across them: the crossings hide 2 n m `width`, each in a piece of its own.
Measured strips_over_strips(const Lab& lab, int n, int m, double width);

/// `n` unit plates one below the other, each `shift` further along the diagonal of the page.
Measured stack_of_plates(const Lab& lab, int n, double shift);

/// `n` unit plates, each `shift` to the right, behind and below the last, seen isometrically: two sides of all of them
/// fall on two lines of the page, along which a third one of each shows.
Measured plates_along_a_line(const Lab& lab, int n, double shift);

/// A unit plate of `n` strips hides one piece, of length 1, of a line under it.
Measured sliver_plate(const Lab& lab, int n);

/// The unit cube of 12 `cells` cells triangles, with every edge split into `parts` on one side only: parts - 1
/// triangles without area close each gap. It is drawn as the plain cube is.
Measured triangles_without_area(const Lab& lab, int cells, int parts);

/// A disk of `n` triangles around its middle hides one piece, a chord, of a line under it.
Measured fan_over_chords(const Lab& lab, int n);

/// Along its axis a sphere is one closed chain: a regular polygon of `meridians` sides.
Measured sphere_along_its_axis(const Lab& lab, int meridians, int bands);

/// The outline of a convex surface without creases, all visible, is the convex hull of its corners on the page.
Measured outline_of(const Lab& lab, const Shape& convex);

/// From a centre at `distance` from its middle (infinite: in parallel) the outline of a sphere, all visible, is the
/// convex hull of its corners on the page.
Measured sphere_from_anywhere(const Lab& lab, int meridians, int bands, double distance);

/// The sum of `zones` random segments: a convex polytope of zones (zones - 1) parallelograms. All its edges are drawn.
/// Parallel edges form a ring; two of it lie on the outline, and of the rest one half lies before the other.
Measured zonotope(const Lab& lab, int zones);

/// `n` plates seen edge on, one below the other, are one line.
Measured stacked_copies(const Lab& lab, int n);

/// A sphere in a stadium of square steps that is `size` times as wide: from above, no line hides another.
Measured sphere_in_a_stadium(const Lab& lab, int meridians, int bands, double size);

/// `n` long needles at different heights, each across most others. What is hidden is found a second time in the plane.
Measured needles(const Lab& lab, int n);

}  // namespace epura::stability
