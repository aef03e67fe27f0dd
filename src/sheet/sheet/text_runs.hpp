// SPDX-License-Identifier: Apache-2.0
// Splits a line of text into runs of one font, script and direction, in their order on paper. Unicode Annex 9.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "sheet/font_file.hpp"

namespace epura::sheet {

/// Whether the character belongs to the scripts of Chinese, Japanese or Korean.
bool is_ideographic(char32_t character);

struct TextRun {
  const FontFile* font;
  std::u32string characters;  ///< in the order of reading
  bool right_to_left;
};

/// Selects the font for characters that belong together: a letter and its marks.
using ChooseFont = std::function<const FontFile&(const std::u32string&)>;

/// The runs from left to right. The direction of the line is that of its first letter. Characters that only control
/// the direction take effect and are dropped.
std::vector<TextRun> text_runs(const std::u32string& line, const ChooseFont& choose_font);

}  // namespace epura::sheet
