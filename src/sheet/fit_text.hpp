// SPDX-License-Identifier: Apache-2.0
// Fits lettering into a box. ISO 3098.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "sheet/lettering.hpp"

namespace epura::sheet {

struct FittedText {
  std::vector<std::string> lines;  ///< none for an empty text
  double height;                   ///< of capitals, mm
  bool cut;                        ///< the end is replaced by "..."
};

/// Sets the text in one line of height `height`, or of the next smaller heights of ISO 3098 down to 1.8 mm; if that is
/// still too wide, in two lines of 1.8 mm broken at a space; if that does not fit either, the text is cut. White space
/// and control characters count as spaces, and several of them as one.
FittedText fit_text(std::string_view text, double width, double height, const Lettering& lettering);

}  // namespace epura::sheet
