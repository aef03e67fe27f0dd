// Scenes of any size whose lines are known in closed form, and the tests of them. Each builds its scene, draws it and
// compares; lengths are in model units.
#pragma once

#include "shapes.hpp"

namespace epura::test {

/// `n` strips of width `width` over `m` across them: the crossings hide 2 n m `width`, each in a piece of its own.
void expect_strips_over_strips(int n, int m, double width);

/// `n` unit plates one below the other, each `shift` further along the diagonal of the page.
void expect_stack_of_plates(int n, double shift);

/// A unit plate of `n` strips hides one piece, of length 1, of a line under it.
void expect_sliver_plate_to_hide_one_piece(int n);

/// The unit cube of 12 `cells` cells triangles, with every edge split into `parts` on one side only: parts - 1
/// triangles without area close each gap. It is drawn as the plain cube is.
void expect_triangles_without_area_to_change_nothing(int cells, int parts);

/// A disk of `n` triangles around its middle hides one piece, a chord, of a line under it.
void expect_fan_to_hide_chords(int n);

/// A sphere of `meridians` and `bands`, the poles on the z axis. Quadrilaterals, but for the triangles at the poles.
Shape uv_sphere(int meridians, int bands);

/// Along its axis a sphere is one closed chain: a regular polygon of `meridians` sides.
void expect_sphere_along_its_axis(int meridians, int bands);

/// From anywhere the outline of a sphere is the border of a convex polygon, all visible.
void expect_sphere_from_anywhere(int meridians, int bands);

/// The sum of `zones` random segments: a convex polytope of zones (zones - 1) parallelograms. All its edges are drawn.
/// Parallel edges form a ring; two of it lie on the outline, and of the rest one half lies before the other.
void expect_zonotope(int zones);

/// `n` plates seen edge on, one below the other, are one line.
void expect_stacked_copies_to_be_one_line(int n);

/// A sphere in a stadium of square steps that is `size` times as wide: from above, no line hides another.
void expect_sphere_in_a_stadium(int meridians, int bands, double size);

/// `n` long needles at different heights, each across most others. What is hidden is found a second time in the plane.
void expect_needles(int n);

}  // namespace epura::test
