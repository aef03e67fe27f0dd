// SPDX-License-Identifier: Apache-2.0
// Lettering fitted into a box. ISO 3098.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "sheet/lettering.hpp"

namespace epura::sheet {

struct FittedText {
  std::vector<std::string> lines;  ///< none for an empty text
  double height;                   ///< of capitals, mm
  bool cut;                        ///< the end is missing, replaced by "..."
};

/// The text in one line as high as `height`, or the next smaller heights of ISO 3098 down to 1.8 mm; if that is too
/// wide still, in two lines of 1.8 mm broken at a space; if that does not do, cut. White space and control characters
/// are spaces, several of them one.
FittedText fit_text(std::string_view text, double width, double height, const Lettering& lettering);

}  // namespace epura::sheet
