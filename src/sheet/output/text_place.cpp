// SPDX-License-Identifier: Apache-2.0
#include "output/text_place.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace epura::output {

std::optional<sheet::Lettering> lettering_of(const sheet::Sheet& sheet) {
  const bool written = std::any_of(sheet.layers.begin(), sheet.layers.end(),
                                   [](const sheet::Layer& layer) { return !layer.texts.empty(); });
  return written ? std::optional<sheet::Lettering>(std::in_place, sheet.font) : std::nullopt;
}

Vec2 start_of(const sheet::Text& text, const sheet::Lettering& lettering) {
  const double angle = text.angle * std::numbers::pi / 180;
  const Vec2 along(std::cos(angle), std::sin(angle));
  const double before = text.align == sheet::Align::left ? 0 : text.align == sheet::Align::middle ? 0.5 : 1;
  return text.at - along * (before * lettering.width(text.text, text.height));
}

}  // namespace epura::output
