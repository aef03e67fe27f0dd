// SPDX-License-Identifier: Apache-2.0
// What recognition takes for smooth, near and enough: its limits, by what they decide.
//
// An angle stands in degrees beside its limit, which is what inner loops compare: a cosine, or for folds between facets
// the tangent of half of the angle (Facets::fold_at). Results depend on the digits, so these are not computed from the
// degrees. "Tolerances" are Facets::tolerance, "sagittas" the mean sagitta of a face, "allowances" allowance_of().
#pragma once

#include <cstddef>

#include "base/angle.hpp"

namespace epura::surfaces {

// Which folds lie inside a face.

/// Cosine of 45.6 degrees, about an eighth of a turn: coarse tessellations have such folds inside faces, and a facet
/// faces no farther away from its surface.
inline constexpr double smooth_cosine = 0.7;
inline constexpr double coarse_fold = 0.185;  ///< 21 degrees: folds inside faces are rarely larger
inline constexpr double max_smooth = 0.277;   ///< 31 degrees: folds of free forms are no larger
/// Of 51.7 degrees: neither a region nor a paraboloid extends over a sharper fold.
inline constexpr double min_fold_cosine = 0.62;
inline constexpr double fading_cosine = 0.766;     ///< of 40 degrees: sharper edges inside a free form fade out at ends
inline constexpr double tangent_cosine = 0.99966;  ///< of 1.5 degrees: a neighbour continues an arc without an edge
inline constexpr double certain_edge_tangent = 1;  ///< of 45 degrees: a sharper mesh edge is one of the part

// How facets lie on a round surface.

/// Cosine of 24 degrees: a facet spans 45, of which a corner sees half.
inline constexpr double min_agreement = 0.913;
/// Cosine of 4 degrees: a facet that tilts more may span a large angle.
inline constexpr double tilted_facing = 0.9976;
/// Cosine of 60 degrees: facets face no farther away from their surface; those farthest are at the border of a face.
inline constexpr double min_facing = 0.5;
inline constexpr double max_sagittas = 16;            ///< height of the highest facets, in sagittas
inline constexpr double max_relative_sagitta = 0.09;  ///< of the radius: that of a facet that spans 49 degrees
inline constexpr double widest_chord = 46;            ///< degrees: a facet spans at most 45, a wider gap none
inline constexpr std::size_t corners_in_ring = 6;     ///< most corners of a facet that is a flat ring of a torus
inline constexpr std::size_t corners_in_round = 5;    ///< most corners of a flat facet enclosed by a round face
inline constexpr std::size_t largest_island = 64;     ///< facets of a coarse spot of a mesh
inline constexpr double whole_turn = 359;             ///< degrees: a face that sweeps more is closed

// How finely an arc must be divided to be one: mean turns are from a facet to its farthest corner.

inline constexpr double max_mean_turn = 15.5 * degree;            ///< twelve facets per turn or more, on average
inline constexpr double max_mean_turn_both_ways = 21.5 * degree;  ///< of spheres and tubes: a facet turns both ways
inline constexpr double max_step = 33 * degree;                   ///< between adjacent positions
inline constexpr double max_of_sweep = 0.6;                       ///< part of an arc that a single facet may span

// How far vertices may lie off a surface.

/// Precision to which CAD kernels keep the positions of vertices, as a fraction of the size of the model.
inline constexpr double min_tolerance = 3e-7;
/// Tolerances by which vertices may lie off a face whose facets allow for it; tolerance of cylinders of which no facet
/// has all its vertices on them.
inline constexpr double usual_slack = 4;
inline constexpr double max_allowance = 16;  ///< tolerances: in files of low precision; heights of one circle
/// Tolerances. CAD kernels trim faces along inexact curves: vertices there may lie off both surfaces, by less than the
/// sagitta of the tessellation.
inline constexpr double max_trimmed = 64;
inline constexpr double still_open = 8;  ///< allowances from the axis of a cone at which a vertex has no normal yet

// Which surfaces are one, or of a simpler kind.

inline constexpr double same_surface = 1e-6;  ///< sine of the angle of axes; lengths as a part of the radius
inline constexpr double min_stretch = 1e-9;   ///< relative: surfaces of a model that is stretched by less are kept
/// Of 0.6 degrees: a steeper cone is no inexact cylinder, and three points at a smaller angle have no plane.
inline constexpr double min_sine = 0.01;
/// Damping below which a step of the fit (Levenberg, Marquardt) is a whole one.
inline constexpr double whole_step = 1e-3;

// How much evidence proves a surface.

/// Bits: the binary logarithm of how unlikely it is that vertices lie on the surface by chance. Each vertex beyond
/// those that determine the surface contributes that of the sagitta over its distance from the surface.
inline constexpr double min_bits = 40;
/// Positions around a surface, including ends at which a neighbour is tangent to it: three would always lie on some.
inline constexpr int min_places = 5;
inline constexpr std::size_t max_fitted = 192;     ///< vertices to which a surface is fitted
inline constexpr std::size_t max_near_arc = 16;    ///< vertices of a region among which a plane arc is looked for
inline constexpr std::size_t fewest_seeds = 3;     ///< facets beside a rim from which a blend grows
inline constexpr double min_blend = 20 * degree;   ///< of its circle and of its tube, over which a blend extends
inline constexpr double same_blend_radius = 0.02;  ///< relative to that by which it is tangent
inline constexpr double max_open = 0.1;            ///< part of its border beyond which facets may continue a blend

// When the search for round surfaces gives up, as in free forms.

inline constexpr int min_seeds = 256;              ///< are tried before the search is abandoned,
inline constexpr int seeds_for_one = 192;          ///< if fewer than one in so many has grown,
inline constexpr int seeds_for_one_cylinder = 64;  ///< where only cylinders are wanted
inline constexpr int patience = 512;               ///< seeds in vain after which facets are tried less often
inline constexpr char enough_failures = 8;         ///< of guesses at a facet, after which it is no seed
inline constexpr std::size_t max_nearby = 24;      ///< facets around a seed, from which surfaces are guessed

// Which loose facets form a free form.

inline constexpr double fold_ratio = 3;       ///< of a fold to the largest ones beside it,
inline constexpr double fold_slack = 0.0175;  ///< and 2 degrees
/// Facets of one tessellation have about the same sagitta, so their widths differ little.
inline constexpr double width_ratio = 8;
/// Above coarse_fold, folds may also be those between flats of a polygon and narrow chamfers: there, widths must be
/// more similar, and so they must be across the long sides of a strip.
inline constexpr double similar_width_ratio = 3;
inline constexpr double narrow = 8;  ///< length of the side of a narrow triangle, in its widths
/// Narrow triangles between one and its face; more are no chance of a tessellation.
inline constexpr int max_between = 8;
inline constexpr std::size_t enough_vertices = 14;    ///< for a paraboloid (five unknowns): rings are added up to here
inline constexpr std::size_t min_vertices = 7;        ///< fewer give no normal of a free form
inline constexpr std::size_t max_normal_facets = 48;  ///< from which a normal is estimated

// Which strips of round surfaces are rows of a free form's tessellation.

inline constexpr double max_row_sweep = 50;  ///< degrees, of inexact ones; fillets, which may be inexact, turn farther
inline constexpr double min_row_fold = 0.0087;  ///< 1 degree: a smaller fold is not typical of tessellations
inline constexpr double row_fold_ratio = 1.5;   ///< of the folds of a strip, if they are of similar size
inline constexpr int min_rows = 4;              ///< with folds of similar size: designers make two or three in a row
inline constexpr int min_rows_turning = 8;      ///< with any folds,
inline constexpr int max_turned_back = 4;       ///< if at most one in so many turns back

// What counts along a border, and of a part.

inline constexpr double max_of_border = 0.9;  ///< of its length: at a corner, a third face may interfere
/// The same where normals of free forms are estimates: if these are not farther apart than twice the greatest angle
/// between tangent faces, so much of a border need not exceed that angle for it to be tangent.
inline constexpr double max_of_estimated = 0.75;
inline constexpr double min_recognised = 0.25;  ///< of a part's area; less is a scan or an artist's mesh
inline constexpr std::size_t max_alone = 256;   ///< facets of a mesh in which a single triangle may be a plane

}  // namespace epura::surfaces
