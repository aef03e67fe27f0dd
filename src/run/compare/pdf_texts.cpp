// SPDX-License-Identifier: Apache-2.0
#include "compare/pdf_texts.hpp"

#include <cmath>
#include <string_view>

namespace epura::compare {

namespace {

constexpr double thousandth = 1e-3;  // of the font's size: unit of widths and displacements (ISO 32000-1, 9.2.4)

// Glyphs that are farther from each other, in sizes of the font, belong to two texts: well below a space, and above
// what shaping moves them by.
constexpr double max_gap = 0.15;

svg::AffineMap moved(const svg::AffineMap& map, const Vec2& by) { return map.after({{1, 0}, {0, 1}, by}); }

}  // namespace

void PdfTexts::take(const PdfOperation& operation, const svg::AffineMap& map) {
  const std::string_view name = operation.name;
  const std::vector<double>& n = operation.numbers;
  if (name == "BT") {
    line_ = glyph_ = {};
  } else if (name == "Tm" && n.size() == 6) {
    line_ = glyph_ = {{n[0], n[1]}, {n[2], n[3]}, {n[4], n[5]}};
  } else if (name == "Td" && n.size() == 2) {
    line_ = glyph_ = moved(line_, {n[0], n[1]});
  } else if (name == "Tf" && n.size() == 1 && operation.words.size() == 1) {
    const auto found = fonts_.find(operation.words[0]);
    font_ = found == fonts_.end() ? nullptr : &found->second;
    size_ = n[0];
  } else if ((name == "Tj" || name == "TJ") && font_ != nullptr) {
    show(operation, map);
  }
}

// Numbers between strings move the next glyph back.
void PdfTexts::show(const PdfOperation& operation, const svg::AffineMap& map) {
  std::size_t number = 0;
  for (const PdfString& string : operation.strings) {
    for (; number < string.numbers; ++number)
      glyph_ = moved(glyph_, {-operation.numbers[number] * thousandth * size_, 0});
    for (std::size_t i = 0; i + font_->bytes <= string.bytes.size(); i += font_->bytes) {
      const auto glyph = font_->glyphs.find(string.bytes.substr(i, font_->bytes));
      if (glyph != font_->glyphs.end()) add_glyph(glyph->second.words, glyph->second.width, map);
    }
  }
}

void PdfTexts::add_glyph(const std::string& words, double width, const svg::AffineMap& map) {
  room_.take(1);
  const svg::AffineMap page = map.after(glyph_);
  glyph_ = moved(glyph_, {width * thousandth * size_, 0});
  const Vec2 from = page.shift, to = map(glyph_.shift);
  const double em = page.scale() * size_;
  const bool continues = !lines_.empty() && std::abs(lines_.back().em - em) <= thousandth * em &&
                         glm::distance(lines_.back().to, from) <= max_gap * em &&
                         std::abs(cross(lines_.back().to - lines_.back().from, to - from)) <= thousandth * em * em;
  if (!continues) lines_.push_back({"", from, to, em});
  lines_.back().words += words;
  lines_.back().to = to;
}

std::vector<PictureText> PdfTexts::finish(int view) {
  std::vector<PictureText> texts;
  for (const Line& line : lines_) {
    const double length = glm::distance(line.from, line.to);
    if (line.words.find_first_not_of(' ') == std::string::npos || !(length > 0)) continue;
    if (!lettering_) lettering_.emplace();
    const Vec2 along = (line.to - line.from) / length, up = Vec2(-along.y, along.x) * (line.em / lettering_->em());
    PictureText& text = texts.emplace_back(PictureText{sheet::written(line.words), line.from, line.from, view});
    for (const Vec2& corner : {line.from + up, line.to, line.to + up}) {
      text.min = glm::min(text.min, corner);
      text.max = glm::max(text.max, corner);
    }
  }
  lines_.clear();
  return texts;
}

}  // namespace epura::compare
