// SPDX-License-Identifier: Apache-2.0
// Fits lettering into a box. ISO 3098.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "sheet/lettering.hpp"

namespace epura::sheet {

/// Between the base lines of two lines, in text heights.
inline constexpr double line_spacing = 1.5;

/// Least height of capitals, mm. ISO 3098-1.
inline constexpr double min_text_height = 1.8;

struct FittedText {
  std::vector<std::string> lines;  ///< none for an empty text
  double height;                   ///< of capitals, mm
  bool cut;                        ///< the end is replaced by "..."
};

/// Sets the text in one line of height `height`, or of the next smaller heights of ISO 3098 down to 1.8 mm; if that is
/// still too wide, in two lines of 1.8 mm broken at a space; if that does not fit either, the text is cut. White space
/// and control characters count as spaces, and several of them as one.
FittedText fit_text(std::string_view text, double width, double height, const Lettering& lettering);

/// The same for text that must not be cut, in a room of this width and height: broken into as many lines of 1.8 mm as
/// fit, preferably after signs such as "-", otherwise in smaller letters.
FittedText fit_whole_text(std::string_view text, const Vec2& room, double height, const Lettering& lettering);

}  // namespace epura::sheet
