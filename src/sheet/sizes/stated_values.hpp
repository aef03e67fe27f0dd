// SPDX-License-Identifier: Apache-2.0
// What a text states instead of the measured value, or beside it.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "sheet/notation.hpp"
#include "sizes/dimensions_in_view.hpp"

namespace epura::sheet {

enum class NumberKind { any, diameter, depth, degrees };

struct NotedNumber {
  double value;  ///< millimetres or degrees
  NumberKind kind;
  double of = 0;  ///< the diameter before it, in mm, to which a depth or an angle belongs; 0: that of the note
};

/// All numbers of a note, as its elements say them (note_text.hpp), without the count and the names of threads.
std::vector<NotedNumber> noted_numbers(const std::string& text, const Notation& notation);

/// What a dimension measures, in mm or degrees; nothing for several lengths, and where an aligned section turns it.
std::optional<double> measured_size(const AnchoredDimension& dimension, const DimensionsInView& view);

/// Lengths, radii and diameters in mm, angles in degrees.
struct StatedSize {
  double stated, measured;
  double slack;  ///< half a unit of its last digit
  double unit;   ///< in which it is written
};

/// The size that a text states, whatever follows; between limits, that which is nearest to what the part has there.
/// Nothing for texts that stand for the measured value, and where it may be something else.
std::optional<StatedSize> stated_size(const AnchoredDimension& dimension, const DimensionsInView& view,
                                      const Notation& notation);

/// The core of a standard thread, in its diameters, at least.
inline constexpr double core_of_thread = 0.7;

/// Whether a text has a thread with the sizes of a standard.
bool gives_thread(const std::string& text, const Notation& notation);

/// Whether a dimension gives what it measures: by its value, or by a thread. "see note" does not.
bool gives_size(const AnchoredDimension& dimension, const DimensionsInView& view, const Notation& notation);

/// What it says on the sheet, or how many lengths it gives.
std::string text_of(const AnchoredDimension& dimension, const DimensionsInView& view, const Notation& notation);

}  // namespace epura::sheet
