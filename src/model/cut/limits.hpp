// SPDX-License-Identifier: Apache-2.0
// Every tolerance, angle and ratio that decides something in this stage. Numbers have no unit unless said otherwise;
// angles are told in degrees, those of constants by their sines and tangents, too. What is parallel stands in
// base/angle.hpp.
#pragma once

#include <cstddef>

#include "base/angle.hpp"

namespace epura::cut {

// Rounding

/// Of computed distances, as a part of the world's size. Narrower gaps are rounding errors, and are not reported.
inline constexpr double rounding_part = 0x1p-44;
/// Of corners of a path or of outlines in a plane, as a part of its size: nearer ones are one.
inline constexpr double rounding_of_corners = 1e-9;

// Outlines on surfaces

/// Tangent surfaces halve the distance with each step, others square it.
inline constexpr int newton_steps = 40;

// Gaps in outlines

/// The mean height of a surface above the middles of its facets is half to two thirds of the largest height.
inline constexpr double highest_in_sagittas = 2;
inline constexpr int joints_at_end = 4;  ///< vertices from an end, used to estimate the fineness of tessellation
/// Tangent of half of 45 degrees; chords with a larger turn form no arc.
inline constexpr double max_turn_of_arc = 0.4143;
inline constexpr double min_outline = 50;  ///< length of the outline at each end, as a multiple of the gap
inline constexpr double min_room = 3;      ///< distance to the next end, as a multiple of the gap

// Bodies that overlap

/// Of the smaller cut face, in common: facets of a shaft and of its bore overlap by less.
inline constexpr double least_overlap = 0.005;
/// From an outline, in roundings of corners: where it is asked on which side an area is.
inline constexpr double beside_outline = 10;

// Paths of sections

/// Each plane of a path cuts all models, split at all steps: time and memory grow with the square.
inline constexpr std::size_t max_points_of_path = 400;

// What open outlines bound

inline constexpr std::size_t max_ends = 1024;  ///< per body; with more, the area that they bound is unknown
inline constexpr double area_of_line = 1e-3;   ///< of the squared length: an outline around a smaller area is a line
inline constexpr double one_sense = 0.5;       ///< of an area: the part that must have one orientation

}  // namespace epura::cut
