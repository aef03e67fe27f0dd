// SPDX-License-Identifier: Apache-2.0
// Every tolerance, angle and ratio that decides something in this stage. Lengths are millimetres on paper, other
// numbers have no unit, unless said otherwise. *The distance* is that at which lines are one to a person
// (NearLines::distance). Angles are told in degrees, those of constants in radians and by their sines and cosines, too.
// What is parallel stands in base/angle.hpp.
#pragma once

#include <cstddef>

#include "base/angle.hpp"
#include "refine/limits.hpp"

namespace epura::drawing {

// Rounding

inline constexpr double rounding_mm = 1e-9;  ///< about what the rounding of positions on a sheet amounts to
using refine::rounding_part;                 ///< the same, of chords seen edge-on as a part of a turn, too
/// Between a line and itself, computed in another way. Corners of chains that are no farther off a straight line are
/// left out, and points as close to a limit of a broken view are drawn (there, the unit of the world if there is no
/// scale yet).
inline constexpr double on_line_mm = 1e-6;
/// The same of lengths and turns, relative: of circles that are one, of parts of a line in neighbouring triangles, of a
/// search for lines that are parts of others.
inline constexpr double on_line_part = 1e-6;
/// A displacement that separates corners of areas: far below what a drawing shows, and above rounding_mm.
inline constexpr double aside_mm = 1e-8;
/// The part of what counts as touching to which a node lies on its surfaces.
inline constexpr double node_precision = 0.01;
/// Ends at a node differ by a few times what counts as touching: what hides the rest of a contour is in front of it by
/// so much.
inline constexpr double node_in_touching = 16;
inline constexpr double coincident_cells = 4;  ///< cells of the page between lines that coincide, at most
inline constexpr int newton_steps = 30;        ///< towards a crossing, at most

// What nobody sees, as a part of the distance

inline constexpr double unseen_up_to = 0.1;  ///< a gap in a single line
inline constexpr double seen_from = 2.5;     ///< a false change of visibility: half of the width of outlines
inline constexpr double on_one_line = 0.5;   ///< within it, a line goes back and forth on itself

// Directions

inline constexpr double crossing_sine = 0.02;  ///< 1.1 degrees; at less, contours run along each other
/// 25 degrees; at less, lines run along each other, as do facets of rims with eight or more corners.
inline constexpr double along_cosine = 0.9063;
inline constexpr double continuing_cosine = 0.85;  ///< 32 degrees, between ends that continue each other
/// 41 degrees: of lines that leave a point at a smaller angle, one turns back there; at 139 degrees or more, it goes on
/// in nearly the same direction.
inline constexpr double turning_back = 0.75;
inline constexpr double about_as_straight = 0.02;  ///< difference of such cosines
inline constexpr double steepest_along = 2;   ///< slope, 63 degrees, of pieces without a direction along a polyline
inline constexpr double seen_edge_on = 0.02;  ///< part of the area of a face that is seen, at most, if it is edge-on

// Near ink, in multiples of the distance

inline constexpr double longest_gap = 3;   ///< of a polyline, which is removed along with near parts beside it
inline constexpr double shortest_run = 5;  ///< from this length, a near part counts by itself
/// From the end of a near part to the contact up to which it is shortened. Within it, lines at 1.2 degrees or more
/// separate, and so does an arc with a radius of up to 1250 from its tangent: nobody mistakes one for the other.
inline constexpr double farthest_contact = 1 / crossing_sine;
/// Where lines do not meet, so much at the ends of a near part tells that they bend apart there, rather than that one
/// of them ends or has a corner; and so much is close.
inline constexpr double apart_at_ends = 0.9, close_between = 0.75;
inline constexpr double with_direction_along = 4;   ///< from this length, lines have a direction along others
inline constexpr double with_direction_at_end = 3;  ///< length over which the direction of an end is measured
inline constexpr double max_overlap = 16;           ///< of lines that continue each other
inline constexpr double max_approach = 1.5;         ///< of their distance: length over which one approaches the other
/// After so many other lines, the rest may be left out if those found cover the whole member.
inline constexpr std::size_t many_near = 4;
inline constexpr std::size_t max_ends_at_a_point = 64;  ///< with more, straightness is not worth a quadratic search
inline constexpr std::size_t max_reversed = 8;          ///< points that are passed in the opposite order at once

// Ends of lines, and contours that are moved to surfaces

/// How much farther than what it ends at is moved, a line is extended or cut off, at most: so far if they cross at 30
/// degrees.
inline constexpr double max_extension = 2;
/// The same for ends that facets have, of which both lines are off: at less than 6 degrees, facets do not tell which of
/// them ends.
inline constexpr double max_slant = 10;
inline constexpr double crossing_within = 4;        ///< of how far a contour is moved: to where it crosses another line
inline constexpr std::size_t max_walked = 12;       ///< pieces along a contour to each side, to that crossing
inline constexpr std::size_t places_in_doubt = 16;  ///< on a piece, at which other lines are looked for
inline constexpr double alone_in_gap = 1.0 / 3;     ///< the part of a run that is alone where it closes a gap
inline constexpr double max_heights = 4;            ///< mean ones of facets: how far a node may move
inline constexpr int max_halvings = 6;              ///< of a line between nodes

// Circles and arcs

inline constexpr int min_edges_of_arc = 7;           ///< chords, of a curve that is not known
inline constexpr std::size_t min_known_corners = 3;  ///< of a line: its ends do not count
inline constexpr std::size_t min_edges_of_rim = 2;   ///< fewer would be on a circle by chance
/// Between corners of an arc, at most; the shortest run that is tried turns as far.
inline constexpr double max_step = 30 * degree;
/// Between corners of a known circle; a piece that turns farther is no chord of a rim.
inline constexpr double max_known_step = 90 * degree;
inline constexpr double max_uneven = 3;                 ///< largest step of an arc over the usual one
inline constexpr double much_better = 5;                ///< how much closer an ellipse than a circle must be
inline constexpr double part_if_exact = 0.1;            ///< of the tolerance: lines on crossings of surfaces
inline constexpr double min_radius_in_tolerances = 10;  ///< of a curve that is not known, as is the next one
inline constexpr double min_radius = 0.05;              ///< mm; no line is narrower
inline constexpr double max_radius = 1e5;               ///< mm
inline constexpr double off_the_arc = 1e-4;             ///< mm, of chords along the boundary of a detail

// Freehand lines and symmetry

inline constexpr double freehand_wave = 0.7;      ///< mm; half the height of the waves
inline constexpr double long_wave = 13;           ///< mm, about
inline constexpr double short_wave = 7;           ///< mm, about; so that waves do not repeat visibly
inline constexpr double share_of_long = 0.6;      ///< of the height
inline constexpr double phase_of_short_wave = 1;  ///< radians

inline constexpr double wave_step = 0.25;    ///< mm between points: the chords are less than 0.005 mm off the waves
inline constexpr double on_freehand = 0.01;  ///< mm; more than those chords are off
inline constexpr double max_of_turn = 0.25;  ///< waves grow no higher than this part of a small line's size
inline constexpr double symmetry_step = 1;   ///< mm between tested points; there is one at least in each line

// Searches: what takes least time; the drawing is the same

inline constexpr double cells_a_part = 16;      ///< greatest length of a piece, in widths of the cells of its grid
inline constexpr double max_columns = 1 << 14;  ///< cells of a grid are numbered with ints
inline constexpr double cuts_a_piece = 2;       ///< by the grid of a prefilter, on average
inline constexpr double finest_cell = 2;        ///< in which ink is searched for, in multiples of the distance
/// Cells that tell where no dangles or doubts are, in multiples of the distance.
inline constexpr double dangle_cell = 8;
inline constexpr double worth_dividing = 0.85;  ///< a division that leaves at most this part of the work

}  // namespace epura::drawing
