// SPDX-License-Identifier: Apache-2.0
// Pictures of drawings and their differences as sheets, for any writer.
#pragma once

#include "compare/comparison.hpp"
#include "sheet/sheet.hpp"

namespace epura::compare {

/// Both drawings on one sheet: unchanged items grey, removed ones red, added ones green, changed ones amber; a line
/// that moved is red at its old and green at its new position. A strip of 8 mm below explains this.
sheet::Sheet overlay_of(const PageComparison& page);

/// The picture in black.
sheet::Sheet sheet_of(const Picture& picture);

}  // namespace epura::compare
