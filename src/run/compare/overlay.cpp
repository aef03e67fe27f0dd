// SPDX-License-Identifier: Apache-2.0
#include "compare/overlay.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <optional>
#include <string>

#include "sheet/lettering.hpp"

namespace epura::compare {

namespace {

constexpr double strip = 8;            // of the legend, mm
constexpr double letters = 3.5;        // height of its capitals
constexpr double column = 30;          // from word to word
constexpr double seen_width = 0.7;     // minimum width of differing lines
constexpr double border_width = 0.13;  // of areas, whose inside is not filled

struct MarkStyle {
  const char* name;
  Colour colour;
};

// In the order of painting, which is also that of `Mark`.
constexpr std::array<MarkStyle, 4> marks = {
    {{"same", {160, 160, 160}}, {"changed", {225, 145, 0}}, {"removed", {205, 0, 0}}, {"added", {0, 140, 60}}}};

sheet::Dashes dashes_of(const std::vector<double>& lengths) {
  if (lengths.size() < 2) return {};
  const double dot = lengths.size() > 3 ? lengths[2] : 0;
  return {lengths[0], lengths[1], dot, static_cast<int>(lengths.size()) / 2 - 1};
}

// Lines of one colour and look, in one layer.
class LookLayers {
 public:
  LookLayers(const MarkStyle& mark, Vec2 shift, double min_width) : mark_(mark), shift_(shift), min_width_(min_width) {}

  void add_line(const Vec2& from, const Vec2& to, const PictureLook& look) {
    const double width = std::max(look.filled ? border_width : look.width, min_width_);
    const sheet::Dashes dashes = dashes_of(look.dashes);
    const bool is_short = glm::distance(from, to) < 2 * (dashes.dash + dashes.gap);
    sheet::Stroke stroke{{from + shift_, to + shift_}};
    if (!is_short) stroke.dashes = dashes;
    layer({width, look.dashes}).strokes.push_back(std::move(stroke));
  }

  // Scaled so that the letters fill their box; of the directions along and up the page, the one that fits its
  // proportions.
  void add_text(const PictureText& text) {
    if (!lettering_) lettering_.emplace();
    Vec2 min(HUGE_VAL), max(-HUGE_VAL);
    for (const sheet::GlyphOutline& glyph : lettering_->outlines(text.words, 1))
      for (const sheet::GlyphOutline::Curve& curve : glyph.curves)
        for (const Vec2& p : {curve.control, curve.end}) {
          min = glm::min(min, p);
          max = glm::max(max, p);
        }
    const Vec2 size = text.max - text.min, letters_size = max - min;
    if (!(letters_size.x > 0 && letters_size.y > 0)) return;
    const bool upright =
        std::abs(size.x * letters_size.x - size.y * letters_size.y) < std::abs(cross(size, letters_size));
    const double height = (upright ? size.y : size.x) / letters_size.x;
    const Vec2 corner = upright ? Vec2(-max.y, min.x) : min;
    layer({border_width, {}})
        .texts.push_back({text.words, text.min + shift_ - height * corner, height, upright ? 90.0 : 0.0});
  }

  void add_legend(double x) {
    sheet::Text word{mark_.name, {x, (strip - letters) / 2}, letters};
    word.role = "legend";
    layer({border_width, {}}).texts.push_back(std::move(word));
  }

  void append_to(std::vector<sheet::Layer>& layers) {
    for (auto& [look, layer] : layers_) layers.push_back(std::move(layer));
  }

 private:
  using LookKey = std::pair<double, std::vector<double>>;

  sheet::Layer& layer(const LookKey& look) {
    const auto [place, added] = layers_.try_emplace(look);
    if (added) {
      const std::string name = mark_.name + ("-" + std::to_string(layers_.size()));
      place->second = {"comparison/" + name, {name, look.first, dashes_of(look.second), mark_.colour}, {}};
    }
    return place->second;
  }

  MarkStyle mark_;
  Vec2 shift_;
  double min_width_;
  std::optional<sheet::Lettering> lettering_{};
  std::map<LookKey, sheet::Layer> layers_{};
};

}  // namespace

sheet::Sheet overlay_of(const PageComparison& page) {
  sheet::Sheet sheet{std::max(page.size.x, column * double(marks.size())), page.size.y + strip, "comparison", {}};
  for (std::size_t i = 0; i < marks.size(); ++i) {
    LookLayers layers(marks[i], {0, strip}, i == 0 ? 0 : seen_width);
    for (const MarkedPiece& piece : page.pieces)
      if (static_cast<std::size_t>(piece.mark) == i) layers.add_line(piece.from, piece.to, piece.look);
    for (const MarkedText& text : page.texts)
      if (static_cast<std::size_t>(text.mark) == i) layers.add_text(text.text);
    layers.add_legend(5 + column * double(i));
    layers.append_to(sheet.layers);
  }
  return sheet;
}

sheet::Sheet sheet_of(const Picture& picture) {
  sheet::Sheet sheet{picture.size.x, picture.size.y, "drawing", {}};
  LookLayers layers({"drawing", {}}, {0, 0}, 0);
  for (const PicturePiece& piece : picture.pieces)
    layers.add_line(piece.from, piece.to, picture.looks[static_cast<std::size_t>(piece.look)]);
  for (const PictureText& text : picture.texts) layers.add_text(text);
  layers.append_to(sheet.layers);
  return sheet;
}

}  // namespace epura::compare
