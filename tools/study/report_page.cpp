// SPDX-License-Identifier: Apache-2.0
#include "study/report_page.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

#include "output/format.hpp"

namespace epura::study {

namespace {

void lift(sheet::Layer& layer, double height) {
  for (sheet::Stroke& stroke : layer.strokes)
    for (Vec2& point : stroke.points) point.y += height;
  for (sheet::Fill& fill : layer.fills)
    for (auto& ring : fill.rings)
      for (Vec2& point : ring) point.y += height;
  for (sheet::Text& text : layer.texts) text.at.y += height;
}

}  // namespace

sheet::Sheet stacked(sheet::Sheet upper, sheet::Sheet lower) {
  for (sheet::Layer& layer : upper.layers) lift(layer, lower.height);
  std::move(lower.layers.begin(), lower.layers.end(), std::back_inserter(upper.layers));
  upper.width = std::max(upper.width, lower.width);
  upper.height += lower.height;
  return upper;
}

std::string report_page(const std::string& title, const std::vector<sheet::Sheet>& sheets, const std::string& notes) {
  const output::VectorOptions options{.decimals = 2, .text = SvgText::text};
  const report::Report report;
  output::FileContent content{{}, options, report, title, "Notes"};
  for (const sheet::Sheet& sheet : sheets) content.sheets.push_back({sheet});
  content.sheets.front().answers = notes;
  return output::to_html(content);
}

}  // namespace epura::study
