// SPDX-License-Identifier: Apache-2.0
#include "output/svg_tree.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <string_view>

#include "base/error.hpp"
#include "base/text.hpp"
#include "output/of_sheet.hpp"
#include "output/reading_order.hpp"
#include "output/xml_text.hpp"
#include "scene/line_roles.hpp"
#include "sheet/phrases.hpp"

namespace epura::output {

namespace {

// What has a name and owns others.
void append_object(std::string& svg, const std::string& id, std::string_view name, const std::string& owned) {
  svg += "<g";
  if (!id.empty()) append_attribute(svg, "id", id);
  svg += " role=\"graphics-object group\"";
  append_attribute(svg, "aria-label", name);
  append_attribute(svg, "aria-owns", owned);
  svg += "/>\n";
}

void add(std::string& ids, const std::string& id) { ids.append(ids.empty() ? "" : " ").append(id); }

}  // namespace

std::string language_of_names(const sheet::Sheet& sheet) {
  return std::string(sheet::language_of_phrases(fact_of(sheet, "language")));
}

std::string name_of(const sheet::Stroke& stroke, const sheet::Layer& layer, const sheet::Sheet& sheet) {
  const scene::SheetLineRow* row = scene::find_line(layer.style.name);
  std::string length;
  if (stroke.facts >= 0)
    length = " " + format_rounded(sheet.line_facts[static_cast<std::size_t>(stroke.facts)].length, 6);
  return sheet::phrase(row != nullptr && row->is_hidden ? "one hidden" : "one visible", language_of_names(sheet),
                       std::array{length});
}

void append_name(std::string& svg, const std::string& name) {
  svg += " role=\"graphics-symbol img\"";
  append_attribute(svg, "aria-label", name);
}

std::string text_id(const std::string& prefix, std::size_t number) { return prefix + "t" + std::to_string(number); }

void append_view_name(std::string& svg, const sheet::Sheet& sheet, const std::string& view) {
  const bool is_view =
      std::ranges::any_of(sheet.views, [&view](const sheet::ViewFrame& one) { return one.name == view; });
  svg += " role=\"graphics-object group\"";
  append_attribute(svg, "aria-label",
                   is_view ? words_of_view(sheet, view) : sheet::phrase("frame", language_of_names(sheet)));
}

void append_tree(std::string& svg, const sheet::Sheet& sheet, std::span<const sheet::Layer* const> layers,
                 const std::string& prefix, FirstIds first) {
  const std::string language = language_of_names(sheet);
  std::map<int, std::string> owned;  // of features
  std::string dimensions;
  for (const sheet::Layer* layer : layers) {
    std::size_t line = first.line;
    for (const sheet::Stroke& stroke : layer->strokes) {
      if (stroke.points.size() < 2) continue;  // no ink, and no number
      if (stroke.feature >= 0) add(owned[stroke.feature], prefix + std::to_string(line));
      ++line;
    }
    for (const sheet::DimensionObject& dimension : layer->dimensions) {
      check(dimension.texts.end <= layer->texts.size(), "a dimension has texts of its layer");
      std::string texts;
      for (std::size_t i = dimension.texts.begin; i < dimension.texts.end; ++i)
        add(texts, text_id(prefix, first.text + i));
      if (texts.empty()) continue;
      const std::string id = "d" + texts.substr(0, texts.find(' '));
      append_object(dimensions, id, words_of_dimension(dimension, language), texts);
      if (dimension.feature >= 0) add(owned[dimension.feature], id);
    }
    first.line += layer->strokes.size();
    first.text += layer->texts.size();
  }
  for (const auto& [feature, ids] : owned)
    append_object(svg, "", sheet.features[static_cast<std::size_t>(feature)].words, ids);
  svg += dimensions;
}

}  // namespace epura::output
