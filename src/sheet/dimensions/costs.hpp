// SPDX-License-Identifier: Apache-2.0
// How much each thing makes the place of a dimension worse. Faults that make a drawing hard to read outweigh all that
// only makes it less tidy.
#pragma once

#include <cstddef>

namespace epura::sheet {

// Of what is around a dimension.
inline constexpr double cost_of_zone = 1000;   ///< two dimensions at the same position, or one inside another view
inline constexpr double cost_of_text = 300;    ///< a line through a text, or a leader along a dimension line
inline constexpr double cost_of_letter = 100;  ///< a line that is interrupted at a letter or too near to a parallel
                                               ///< one, a leader through another
inline constexpr double cost_of_other = 20;    ///< a line through something else on the sheet, a leader along a line,
                                               ///< through a hole or dimension, or to the wrong hole
inline constexpr double cost_of_crossing = 3;
inline constexpr double cost_of_ink = 0.3;  ///< a line of the drawing that a leader crosses

/// Dimensions, or equal features, whose less usual places are tried: more take too long.
inline constexpr std::size_t max_in_crowd = 12;
/// A place whose text so many lines cross is as hard to read as any other.
inline constexpr double cost_in_crowd = max_in_crowd * cost_of_text;

// Of lengths and rows of them.
inline constexpr double cost_of_level = 1;         ///< each dimension line further out
inline constexpr double cost_of_extension = 0.02;  ///< a millimetre of extension lines
inline constexpr double cost_of_text_place = 0.1;  ///< a text that is not in the middle, by its number
inline constexpr double cost_of_shift = 0.1;       ///< a millimetre along a row, of its texts
inline constexpr double cost_of_beside = 1;        ///< a text beside its length
inline constexpr double cost_of_leader = 2;        ///< a text on a leader to its dimension line
inline constexpr double cost_of_farther = 0.05;    ///< a millimetre of either

// Of notes, symbols and balloons.
inline constexpr double cost_of_way = 0.5;   ///< a millimetre of a leader
inline constexpr double cost_in_view = 30;   ///< inside the view
inline constexpr double cost_of_slant = 20;  ///< a leader of a symbol along the line at which it ends

// Of circles and angles.
inline constexpr double cost_of_length = 0.1;       ///< a millimetre of a leader, or of the radius of an arc
inline constexpr double cost_of_slope = 1;          ///< a leader that is not at 45 degrees
inline constexpr double cost_of_turn = 10;          ///< a shoulder on the other side
inline constexpr double cost_of_label_leader = 5;   ///< a leader to a name
inline constexpr double cost_of_inside = 1;         ///< a leader from inside
inline constexpr double cost_of_crossing_it = 0.5;  ///< a dimension line across the circle
inline constexpr double cost_outside = 3;           ///< a text outside its angle

}  // namespace epura::sheet
