#include "sheet/partial_mark.hpp"

#include <algorithm>
#include <vector>

namespace epura {

namespace {

using Letter = std::vector<std::vector<Vec2>>;

// On a grid 4 wide and 6 high, after the vertical lettering of ISO 3098.
std::vector<Letter> letters_of_partial() {
  const Letter p{{{0, 0}, {0, 6}, {3, 6}, {4, 5}, {4, 4}, {3, 3}, {0, 3}}};
  const Letter a{{{0, 0}, {2, 6}, {4, 0}}, {{0.6, 1.8}, {3.4, 1.8}}};
  const Letter r{p[0], {{2, 3}, {4, 0}}};
  const Letter t{{{2, 0}, {2, 6}}, {{0, 6}, {4, 6}}};
  const Letter i{{{2, 0}, {2, 6}}};
  const Letter l{{{0, 6}, {0, 0}, {4, 0}}};
  return {p, a, r, t, i, a, l};
}

constexpr double letter_height = 6, letter_step = 6;
constexpr double height_in_margin = 0.6;
constexpr double line_per_height = 0.1;

}  // namespace

Layer partial_mark(const Paper& paper) {
  const std::vector<Letter> word = letters_of_partial();
  const double word_width = letter_step * static_cast<double>(word.size());
  const double unit = std::min(height_in_margin * paper.other / letter_height, paper.width / word_width);
  const Vec2 start(std::min(paper.left, paper.width - unit * word_width),
                   paper.height - paper.other / 2 - unit * letter_height / 2);
  Layer layer{"sheet/partial", {"partial", line_per_height * letter_height * unit}, {}};
  for (std::size_t i = 0; i < word.size(); ++i)
    for (const std::vector<Vec2>& line : word[i]) {
      Stroke stroke;
      for (const Vec2& p : line)
        stroke.points.push_back(start + unit * (p + Vec2(static_cast<double>(i) * letter_step, 0)));
      layer.strokes.push_back(stroke);
    }
  return layer;
}

}  // namespace epura
