// SPDX-License-Identifier: Apache-2.0
#include "sheet/partial_mark.hpp"

#include <algorithm>
#include <array>
#include <vector>

#include "base/error.hpp"
#include "base/text.hpp"
#include "sheet/line_styles.hpp"

namespace epura::sheet {

namespace {

using Letter = std::vector<std::vector<Vec2>>;

// On a grid 4 wide and 6 high, in the style of the vertical lettering of ISO 3098.
std::array<Letter, 26> alphabet() {
  const std::vector<Vec2> c{{4, 5}, {3, 6}, {1, 6}, {0, 5}, {0, 1}, {1, 0}, {3, 0}, {4, 1}};
  const std::vector<Vec2> p{{0, 0}, {0, 6}, {3, 6}, {4, 5}, {4, 4}, {3, 3}, {0, 3}};
  const std::vector<Vec2> o{{1, 0}, {0, 1}, {0, 5}, {1, 6}, {3, 6}, {4, 5}, {4, 1}, {3, 0}, {1, 0}};
  return {{{{{0, 0}, {2, 6}, {4, 0}}, {{0.6, 1.8}, {3.4, 1.8}}},
           {{{0, 3}, {3, 3}, {4, 4}, {4, 5}, {3, 6}, {0, 6}, {0, 0}, {3, 0}, {4, 1}, {4, 2}, {3, 3}}},
           {c},
           {{{0, 0}, {0, 6}, {2, 6}, {4, 4}, {4, 2}, {2, 0}, {0, 0}}},
           {{{4, 6}, {0, 6}, {0, 0}, {4, 0}}, {{0, 3}, {3, 3}}},
           {{{4, 6}, {0, 6}, {0, 0}}, {{0, 3}, {3, 3}}},
           {c, {{4, 1}, {4, 3}, {2, 3}}},
           {{{0, 0}, {0, 6}}, {{4, 0}, {4, 6}}, {{0, 3}, {4, 3}}},
           {{{2, 0}, {2, 6}}},
           {{{4, 6}, {4, 1}, {3, 0}, {1, 0}, {0, 1}}},
           {{{0, 0}, {0, 6}}, {{4, 6}, {0, 2}}, {{1.5, 3.5}, {4, 0}}},
           {{{0, 6}, {0, 0}, {4, 0}}},
           {{{0, 0}, {0, 6}, {2, 2}, {4, 6}, {4, 0}}},
           {{{0, 0}, {0, 6}, {4, 0}, {4, 6}}},
           {o},
           {p},
           {o, {{2, 2}, {4, 0}}},
           {p, {{2, 3}, {4, 0}}},
           {{{4, 5}, {3, 6}, {1, 6}, {0, 5}, {0, 4}, {1, 3}, {3, 3}, {4, 2}, {4, 1}, {3, 0}, {1, 0}, {0, 1}}},
           {{{2, 0}, {2, 6}}, {{0, 6}, {4, 6}}},
           {{{0, 6}, {0, 1}, {1, 0}, {3, 0}, {4, 1}, {4, 6}}},
           {{{0, 6}, {2, 0}, {4, 6}}},
           {{{0, 6}, {1, 0}, {2, 4}, {3, 0}, {4, 6}}},
           {{{0, 0}, {4, 6}}, {{0, 6}, {4, 0}}},
           {{{2, 0}, {2, 3}, {0, 6}}, {{2, 3}, {4, 6}}},
           {{{0, 6}, {4, 6}, {0, 0}, {4, 0}}}}};
}

// One letter for each character; empty for a blank.
std::vector<Letter> strokes_of_letters(const std::string& text) {
  const std::array<Letter, 26> all = alphabet();
  std::vector<Letter> letters;
  for (const char c : text) {
    check(c == ' ' || c == ':' || (c >= 'a' && c <= 'z'), "the mark of partial drawings has letters and blanks");
    if (c == ' ') letters.emplace_back();
    if (c == ':') letters.push_back({{{2, 1}, {2, 1.5}}, {{2, 4}, {2, 4.5}}});
    if (c >= 'a' && c <= 'z') letters.push_back(all[static_cast<std::size_t>(c - 'a')]);
  }
  return letters;
}

constexpr double partial_letter_height = 6, letter_step = 6;
constexpr double height_in_margin = 0.6;
constexpr double line_per_height = 0.1;

}  // namespace

Layer partial_mark(const Paper& paper, const std::string& stage) {
  const std::vector<Letter> letters = strokes_of_letters("partial: " + to_lower(stage));
  const double width = letter_step * static_cast<double>(letters.size());
  const double unit = std::min(height_in_margin * paper.above() / partial_letter_height, paper.width / width);
  const Vec2 start(std::min(paper.left, paper.width - unit * width),
                   paper.height - paper.above() / 2 - unit * partial_letter_height / 2);
  Layer layer = empty_layer("sheet", scene::SheetLine::partial, line_widths(paper));
  layer.style.width = line_per_height * partial_letter_height * unit;
  for (std::size_t i = 0; i < letters.size(); ++i)
    for (const std::vector<Vec2>& line : letters[i]) {
      Stroke stroke;
      for (const Vec2& p : line)
        stroke.points.push_back(start + unit * (p + Vec2(static_cast<double>(i) * letter_step, 0)));
      layer.strokes.push_back(stroke);
    }
  return layer;
}

}  // namespace epura::sheet
