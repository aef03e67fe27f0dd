// SPDX-License-Identifier: Apache-2.0
// In which order the parts of a sheet are read to people, and what is said of those that are not text.
#pragma once

#include <string>
#include <string_view>

#include "output/pdf/tags.hpp"
#include "sheet/sheet.hpp"

namespace epura::output {

/// The title block, then view by view: what it shows, its dimensions, notes, tolerances and tables. Frames and the
/// lines of title blocks are not read. PDF/UA-1 (ISO 14289-1).
PdfTags reading_order(const sheet::Sheet& sheet);

/// "View front, scale 1:2: 24 visible lines, 6 hidden lines.", in the language of the sheet if phrases have it.
std::string words_of_view(const sheet::Sheet& sheet, const std::string& view);

/// "diameter ⌀8 H7"
std::string words_of_dimension(const sheet::DimensionObject& dimension, std::string_view language);

}  // namespace epura::output
