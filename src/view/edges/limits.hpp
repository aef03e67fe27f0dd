// SPDX-License-Identifier: Apache-2.0
// What counts as flat, low, near and rounding where edges are found: the limits of this stage, by what they decide.
// Angles are in degrees, beside the limit where inner loops compare a sine or a cosine; what is parallel stands in
// base/angle.hpp. "World" is the size of the scene, about 1; "cells" are those of the page grid, "contacts" the
// distance at which bodies touch.
#pragma once

#include <cstddef>

#include "refine/limits.hpp"

namespace epura::edges {

// Errors of double precision.

/// Of products of two lengths, relative: lower triangles keep too few digits, and outlines of smaller areas none.
inline constexpr double product_rounding = 0x1p-48;
/// Of a determinant of three differences, as a part of the sum of the absolute values of its products: each product has
/// been rounded eight times.
inline constexpr double determinant_rounding = 9 * 0x1p-53;
/// Of a unit normal, times longest side / height of its triangle; of the distance between a plane and a point of about
/// unit size.
inline constexpr double normal_rounding = 0x1p-49;
inline constexpr double angle_rounding = 1e-6;  ///< degrees: of an N-sided prism, all or no edges are creases at 360/N
inline constexpr double place_rounding = 0x1p-40;  ///< relative: a vertex of a cut farther off its edge was moved
/// The same of bends (curvatures times a factor).
using refine::rounding_part;
inline constexpr double min_contact = 1e-12;  ///< world: beside smaller contacts, rounding of points matters

// Which folds are flat, which directions parallel or edge-on.

inline constexpr double flat_fold = 0.05;     ///< degrees: tolerates rounded coordinates
inline constexpr double flatness = 0x1p-29;   ///< world: a triangle that deviates less lies in its neighbour's plane
inline constexpr double fold_unit = 0x1p-60;  ///< radians: folds are summed as integers, in any order
inline constexpr double step_angle = 30;      ///< degrees, between two walls that are faces of a step
inline constexpr double nearly_parallel = 0.996;  ///< cosine of 5 degrees: sides across which a facet extends
inline constexpr double along_projector = 1e-5;   ///< cosine of 90 - 6e-4 degrees: a face is seen edge-on
inline constexpr double join_contacts = 4;        ///< contacts: neighbours of one flat face are no farther off a plane
inline constexpr double on_both = 1e-6;           ///< of the length of facets: a nearer point is on both surfaces

// Which triangles are slivers.

/// Resolutions of the page: slivers are lower on it, so that no other triangle becomes a line on the grid.
inline constexpr double lowest_on_page = 2;
/// Times that limit: triangles higher in space are not slivers, but seen edge-on,
inline constexpr double edge_on = 1024;
inline constexpr double slender = 1.0 / 64;  ///< and so are those with a greater part of height over length.
inline constexpr double known_height = 16;   ///< roundings: a higher triangle has a known normal, and may be a wall
inline constexpr int longest_row = 256;      ///< adjacent slivers; a longer row is not a surface any more

// Where smooth contours and edges lie.

inline constexpr double max_facets_away = 2;  ///< facets from which the contour of a sphere is no farther
inline constexpr double tiny_triangle = 8;    ///< tolerances of the part: which way a smaller one faces means nothing
/// A fillet begins with half a fold, which counts less than a whole one.
inline constexpr double curvature_ratio = 2.5;
inline constexpr std::size_t max_sides = 64;  ///< of larger facets only the size is considered, for the time it takes

// How threads are drawn.

inline constexpr double arc_begin = 95;       ///< degrees: the open part of a circle is in the upper right quadrant,
inline constexpr double arc_sweep = 270;      ///< degrees: and its ends do not meet centre lines
inline constexpr double at_end = 1e-3;        ///< lengths of a thread from its end, or radii from its axis: is at it
inline constexpr double largest_depth = 0.5;  ///< of a thread in the drawing, relative to its radius
inline constexpr double min_chamfer = 0.8;    ///< end of a chamfer, relative to the root: others are their own cones
inline constexpr double widest_countersink = 1.15;  ///< the same inside

// How much time is spent.

inline constexpr double part_for_search = 0.4;  ///< of what remains, for each of two steps; the lines need the rest
/// Crossings of faces, besides one for each face: more are found where copies lie in one another, of which each crosses
/// all others. Their lines would take minutes, and 300 bytes each.
inline constexpr std::size_t most_crossings = 1 << 21;
inline constexpr std::size_t pairs_a_crossing = 256;  ///< pairs of faces that take as long to reject as one crossing

}  // namespace epura::edges
