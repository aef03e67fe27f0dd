// SPDX-License-Identifier: Apache-2.0
#include "sheet/text_runs.hpp"

#include <fribidi.h>
#include <hb.h>

#include <algorithm>
#include <cstdint>
#include <new>

#include "base/error.hpp"

namespace epura::sheet {

namespace {

using Level = FriBidiLevel;

struct Item {
  char32_t character;
  Level level;
  hb_script_t script;
  const FontFile* font;
};

// Joiners decide about the form of letters beside them.
bool is_joiner(char32_t c) { return c == 0x200C || c == 0x200D; }

bool is_mark(char32_t c) {
  switch (hb_unicode_general_category(hb_unicode_funcs_get_default(), c)) {
    case HB_UNICODE_GENERAL_CATEGORY_NON_SPACING_MARK:
    case HB_UNICODE_GENERAL_CATEGORY_SPACING_MARK:
    case HB_UNICODE_GENERAL_CATEGORY_ENCLOSING_MARK:
      return true;
    default:
      return is_joiner(c);
  }
}

bool is_direction_control(char32_t c) {
  return c == 0x200E || c == 0x200F || c == 0x61C || (c >= 0x202A && c <= 0x202E) || (c >= 0x2066 && c <= 0x2069);
}

std::vector<Level> levels_of(const std::u32string& line) {
  const std::vector<FriBidiChar> codes(line.begin(), line.end());
  const auto size = static_cast<FriBidiStrIndex>(codes.size());
  std::vector<FriBidiCharType> types(codes.size());
  std::vector<FriBidiBracketType> brackets(codes.size());
  std::vector<Level> levels(codes.size(), 0);
  fribidi_get_bidi_types(codes.data(), size, types.data());
  fribidi_get_bracket_types(codes.data(), size, types.data(), brackets.data());
  FriBidiParType direction = FRIBIDI_PAR_ON;  // that of the first letter
  const Level highest =
      fribidi_get_par_embedding_levels_ex(types.data(), brackets.data(), size, &direction, levels.data());
  if (highest == 0 && !line.empty()) throw std::bad_alloc();  // nothing else can fail
  return levels;
}

std::vector<hb_script_t> scripts_of(const std::u32string& line) {
  std::vector<hb_script_t> scripts;
  for (const char32_t c : line) scripts.push_back(hb_unicode_script(hb_unicode_funcs_get_default(), c));
  // Digits, spaces and marks belong to the letters before them; at the beginning, to those behind.
  const auto is_open = [](hb_script_t s) { return s == HB_SCRIPT_COMMON || s == HB_SCRIPT_INHERITED; };
  for (std::size_t i = 1; i < scripts.size(); ++i)
    if (is_open(scripts[i])) scripts[i] = scripts[i - 1];
  for (std::size_t i = scripts.size(); i-- > 1;)
    if (is_open(scripts[i - 1])) scripts[i - 1] = scripts[i];
  return scripts;
}

std::vector<Item> items_of(const std::u32string& line, const ChooseFont& choose_font) {
  const std::vector<Level> levels = levels_of(line);
  const std::vector<hb_script_t> scripts = scripts_of(line);
  check(levels.size() == line.size() && scripts.size() == line.size(), "each character has a level and a script");
  std::vector<Item> items;
  for (std::size_t begin = 0; begin < line.size();) {
    std::size_t end = begin + 1;
    while (end < line.size() && is_mark(line[end])) ++end;
    if (is_direction_control(line[begin])) {
      ++begin;
      continue;
    }
    std::u32string visible = line.substr(begin, end - begin);
    std::erase_if(visible, is_joiner);
    const FontFile& font = choose_font(visible.empty() ? line.substr(begin, end - begin) : visible);
    for (; begin < end; ++begin)
      if (!is_direction_control(line[begin])) items.push_back({line[begin], levels[begin], scripts[begin], &font});
  }
  return items;
}

// Rule L2: from the highest level down to the lowest odd one, reverses everything of that level or higher.
void sort_as_on_paper(std::vector<TextRun>& runs, std::vector<Level> levels) {
  const Level highest = levels.empty() ? Level{0} : *std::max_element(levels.begin(), levels.end());
  for (int level = highest; level > 0; --level)
    for (std::size_t begin = 0; begin < runs.size(); ++begin) {
      std::size_t end = begin;
      while (end < runs.size() && levels[end] >= level) ++end;
      const auto first = static_cast<std::ptrdiff_t>(begin), last = static_cast<std::ptrdiff_t>(end);
      std::reverse(runs.begin() + first, runs.begin() + last);
      std::reverse(levels.begin() + first, levels.begin() + last);
      begin = end;
    }
}

}  // namespace

bool is_ideographic(char32_t character) {
  switch (hb_unicode_script(hb_unicode_funcs_get_default(), character)) {
    case HB_SCRIPT_HAN:
    case HB_SCRIPT_HIRAGANA:
    case HB_SCRIPT_KATAKANA:
    case HB_SCRIPT_BOPOMOFO:
    case HB_SCRIPT_HANGUL:
      return true;
    default:
      return false;
  }
}

std::vector<TextRun> text_runs(const std::u32string& line, const ChooseFont& choose_font) {
  std::vector<TextRun> runs;
  std::vector<Level> levels;
  const Item* before = nullptr;
  const std::vector<Item> items = items_of(line, choose_font);
  for (const Item& item : items) {
    const bool continues =
        before != nullptr && before->level == item.level && before->script == item.script && before->font == item.font;
    if (!continues) {
      runs.push_back({item.font, {}, item.level % 2 != 0});
      levels.push_back(item.level);
    }
    runs.back().characters += item.character;
    before = &item;
  }
  check(runs.size() == levels.size(), "every run of letters has a direction");
  sort_as_on_paper(runs, levels);
  return runs;
}

}  // namespace epura::sheet
