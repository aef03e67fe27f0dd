// SPDX-License-Identifier: Apache-2.0
// How near, how thin and how many: the limits of this stage, by what they decide. "Cells" are those of the page grid.
#pragma once

namespace epura::visibility {

// Errors of double precision.

inline constexpr double depth_rounding = 0x1p-40;  ///< of depths, relative
inline constexpr double turn_rounding = 0x1p-48;   ///< of directions, radians (2e-13 degrees)
inline constexpr double cell_slack = 0x1p-12;      ///< of the side of an occluder cell: segments may reach beyond it

// What is a line or nothing on the page.

/// Height over length: a triangle that is lower on the page is a line there.
inline constexpr double thinnest = 0x1p-40;
inline constexpr double min_piece = 1e-7;  ///< of the drawing: shorter pieces of lines are rounding, not geometry

// How far rounding to the page grid moves things.

inline constexpr double hidden_cells = 8;   ///< cells within which everything lies that a triangle hides
inline constexpr double behind_cells = 12;  ///< the same, of directions around a hub
/// Cells between an edge and the place of a triangle whose depth is compared with that of the edge, at most: crossings
/// of sides lie within 2 cells of both, and rounding moves edge and side by 0.7 cells each.
inline constexpr double depth_cells = 3;
inline constexpr double crossing_cells = 2;  ///< cells beyond the ends of a side within which a crossing is on it
/// Cells by which a side must extend across the line of an edge for rounding to have turned that line off it.
inline constexpr double min_turn = 64;

// Which parts of a contour its own facets hide.

inline constexpr double off_contour = 1.0 / 64;  ///< of the width of its facets, from the contour to the tested line,
inline constexpr double min_cells = 4;           ///< cells, and at least so many
/// Facets, in depth, from a contour that goes on beyond a cusp to the tested line: the surface is about as far behind
/// as from one facet to the next.
inline constexpr double beyond_cusp = 2;
/// Of a contour that is not drawn at the ends of a fold either: there, it is too narrow to lie beside the tested line.
inline constexpr double narrow_end = 0.25;
inline constexpr int rings = 2;  ///< facets from a contour to those of its own face that hide it

// How much time is spent: the lines are the same for any of these.

/// Of a cell of the page: most cells of a triangle cost nothing, since no line runs through them.
inline constexpr double triangles_of_cell = 5;
/// Of edge and triangle: a cell with more is divided, and so are its parts.
inline constexpr double max_pairs = 1 << 15;
/// With which any number of divisions may be idle, until cells are small.
inline constexpr double many_pairs = 1 << 22;
/// Part of the pairs: a division that leaves more is idle.
inline constexpr double worthwhile = 0.5;
/// Of the time for hiding, after which a search goes on only if it will end in the rest: at about its speed, it does.
inline constexpr double first_part_of_the_time = 7.0 / 9;

}  // namespace epura::visibility
