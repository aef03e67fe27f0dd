// SPDX-License-Identifier: Apache-2.0
#include "output/of_sheet.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "base/text.hpp"

namespace epura::output {

std::string fact_of(const sheet::Sheet& sheet, std::string_view name) {
  for (const auto& [fact, value] : sheet.facts)
    if (fact == name) return value;
  return {};
}

std::string description_of(const sheet::Sheet& sheet) {
  std::string text;
  for (const sheet::ViewFrame& view : sheet.views) {
    append_to_list(text, view.name);
    if (!view.projection.empty() && view.projection != view.name) text += " (" + view.projection + ")";
    if (!view.scale.empty()) text += " " + view.scale;
  }
  return text;
}

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
