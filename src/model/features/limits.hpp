// SPDX-License-Identifier: Apache-2.0
// What recognition of a designer's features takes for parallel, equal and enough: its limits, by what they decide.
#pragma once

#include <cstddef>

namespace epura::features {

// Which directions and sizes are the same.

inline constexpr double parallel = 1e-4;  ///< sine of the angle between directions, cosine of that to a right one
inline constexpr double opposite_cosine = 0.99;  ///< of 8 degrees: the ends of a slot face each other
inline constexpr double same_size = 1e-4;        ///< relative
inline constexpr double same_point = 1e-6;       ///< relative to a radius, or to the size of the world
inline constexpr double on_axis = 1e-3;          ///< relative to a radius: distance from the axis
/// Tolerances of the part: faces of one axis, or the ends of two that continue each other, are no farther apart.
inline constexpr double together = 32;
inline constexpr double together_in_world = 1e-7;  ///< the same, relative to the size of the world
inline constexpr double near_cylinder = 0.02;      ///< relative to its radius: positions are written with few decimals
inline constexpr double same_level = 1e-5;         ///< relative to the size of the world

// Parts of a turn, degrees.

/// Arcs of less have no axis, and those of no less one around which a thread is looked for; slots may leave so much of
/// a rounded edge.
inline constexpr double half_turn = 179.5;
inline constexpr double half_slack = 2;     ///< of a half cylinder
inline constexpr double min_side = 90;      ///< of a side of a groove
inline constexpr double shortest_arc = 20;  ///< that has a radius,
inline constexpr double longest_arc = 200;  ///< and the longest one: a longer one has a diameter

// Holes, slots and chamfers.

inline constexpr double within_cavity = 1.002;  ///< relative to the radius of a hole or slot
inline constexpr double longest_chamfer = 0.5;  ///< relative to the radius
inline constexpr double groove_slack = 0.01;    ///< of its depth: by which its sides may differ
inline constexpr std::size_t fewest_holes = 3;  ///< of a pitch circle
inline constexpr double tube_height =
    1.0 / 3;  ///< of a quarter of a tube over its chord, relative to the radius, about

// Hexagons and letters.

inline constexpr double min_flat = 0.6;           ///< of a side: those of a regular polygon of twelve sides are shorter
inline constexpr std::size_t max_flats = 256;     ///< of one body; more, as in honeycombs, take too long
inline constexpr double largest_letter = 0.2;     ///< relative to the size of the part
inline constexpr double deepest_letter = 0.5;     ///< relative to its size
inline constexpr std::size_t fewest_letters = 2;  ///< of one depth in a plane
inline constexpr std::size_t usual_walls = 12;    ///< on average; a rectangle with rounded corners has eight

// Assemblies.

inline constexpr double min_part = 0.01;  ///< of the diagonal of the assembly
/// Along one axis: twelve on each of two sides of a view. Of more, nobody finds the part that a number is of.
inline constexpr std::size_t max_places = 24;
inline constexpr double off_axis = 0.1;  ///< between the axes of a hole and what is in it, in radii of the hole
inline constexpr double looks_into = 2;  ///< diameters of a hole without a certain depth

// Helical threads.

inline constexpr double smallest_thread = 0.8;          ///< mm, with room for play
inline constexpr double largest_thread = 110;           ///< mm, with room for play
inline constexpr double flattest_thread = 0.6;          ///< least ratio of the radii at roots and crests
inline constexpr double min_thread_depth = 0.005;       ///< relative to the radius
inline constexpr double max_to_one_side = 0.8;          ///< mean of the directions of vertices from the axis
inline constexpr double min_thread_facing = 0.05;       ///< of the area of a thread, seen from its axis
inline constexpr double crest_part = 0.1;               ///< of the depth of a thread, whose vertices tell the helix
inline constexpr std::size_t max_directions = 8;        ///< along which threads in plates are looked for
inline constexpr std::size_t fewest_helix_points = 48;  ///< of crests, and of a circle in their place
inline constexpr double min_turns = 2;                  ///< of a thread
inline constexpr double min_order = 0.85;    ///< of crests along a helix: 1 for a line, 0 for vertices at random
inline constexpr double widest_gap = 60;     ///< degrees without crests
inline constexpr double turns_off = 0.15;    ///< turns: a few suit a pitch about as large, too
inline constexpr double pitch_step = 0.1;    ///< turns, in which the pitch is searched
inline constexpr double points_of_turn = 8;  ///< fewest: more turns suit by chance
inline constexpr std::size_t max_helix_samples = 512;  ///< points of crests in a search
inline constexpr double clear_of_crests = 0.05;        ///< of the depth of a thread: where faces around it are cut
inline constexpr double backwards = 0.02;              ///< turns by which a line may run back around the axis

}  // namespace epura::features
