// SPDX-License-Identifier: Apache-2.0
// SVG: pugixml makes the document, Cairo draws the paths of its layers.
#include <algorithm>
#include <cstddef>
#include <map>
#include <pugixml.hpp>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "base/error.hpp"
#include "output/canvas.hpp"
#include "output/glyphs.hpp"
#include "output/svg_lettering.hpp"
#include "output/svg_metadata.hpp"
#include "output/svg_paths.hpp"
#include "output/write.hpp"

namespace epura {

namespace {

// Stands in the document where the paths of a layer go.
constexpr std::string_view paths_here = "<path />\n";

std::string millimetres(double value) {
  std::string text;
  append_millimetres(text, value);
  return text;
}

// A name that ids and style sheets take.
std::string identifier(std::string_view name) {
  constexpr std::string_view letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789_";
  std::string id(name);
  for (char& c : id)
    if (letters.find(c) == std::string_view::npos) c = '-';
  return id;
}

class Ids {
 public:
  /// An id like the name that nothing else in the document has, lines included.
  std::string unique(std::string_view name) {
    std::string id = identifier(name);
    if (id.empty() || id[0] < 'A') id.insert(0, "_");
    const bool like_a_line = id[0] == 'p' && id.find_first_not_of("0123456789", 1) == std::string::npos;
    if (like_a_line) id += '-';
    while (!used_.insert(id).second) id += '-';
    return id;
  }

 private:
  std::set<std::string> used_;
};

pugi::xml_node add_group(pugi::xml_node parent, const std::string& id, std::string_view label) {
  pugi::xml_node g = parent.append_child("g");
  g.append_attribute("id") = id.c_str();
  g.append_attribute("inkscape:groupmode") = "layer";
  g.append_attribute("inkscape:label") = xml_text(label).c_str();
  return g;
}

// What all lines of the layer share is said once. Layers of lines that are no edges have none of it.
void add_origin(pugi::xml_node g, const Layer& layer) {
  const auto is_edge = [](const Stroke& stroke) { return stroke.kind.has_value(); };
  if (std::none_of(layer.strokes.begin(), layer.strokes.end(), is_edge)) return;
  g.append_attribute("data-visible") = layer.style.name.starts_with("hidden") ? "0" : "1";
  if (const auto model = common_model(layer)) g.append_attribute("data-model") = *model;
}

// Of VIEW/ROLE the view; empty where there is none.
std::string_view view_of(const Layer& layer) {
  const std::size_t slash = layer.name.rfind('/');
  return std::string_view(layer.name).substr(0, slash == std::string::npos ? 0 : slash);
}

// The layers of a view side by side: all ink is black, so that any order does.
std::vector<const Layer*> by_view(const Sheet& sheet) {
  std::map<std::string_view, std::size_t> places;
  std::vector<const Layer*> layers;
  for (const Layer& layer : sheet.layers) {
    places.emplace(view_of(layer), places.size());
    layers.push_back(&layer);
  }
  const auto place = [&](const Layer* layer) { return places.at(view_of(*layer)); };
  std::stable_sort(layers.begin(), layers.end(), [&](const Layer* a, const Layer* b) { return place(a) < place(b); });
  return layers;
}

// VIEW/ROLE is a layer ROLE in a layer VIEW.
void add_layers(pugi::xml_node svg, const std::vector<const Layer*>& layers, bool plain) {
  Ids ids;
  pugi::xml_node view;
  const Layer* previous = nullptr;
  for (const Layer* layer : layers) {
    const std::string_view name = view_of(*layer), whole = layer->name;
    const bool has_view = !name.empty();
    if (has_view && (previous == nullptr || view_of(*previous) != name)) view = add_group(svg, ids.unique(name), name);
    pugi::xml_node g = has_view ? add_group(view, ids.unique(whole), whole.substr(name.size() + 1))
                                : add_group(svg, ids.unique(whole), whole);
    g.append_attribute("class") = identifier(layer->style.name).c_str();
    if (!plain) add_origin(g, *layer);
    if (has_ink(*layer)) g.append_child("path");
    previous = layer;
  }
}

// "#1f7a3d"
std::string hexadecimal(const Colour& colour) {
  constexpr std::string_view digits = "0123456789abcdef";
  std::string text = "#";
  for (const int part : {colour.red, colour.green, colour.blue})
    for (const int digit : {part / 16, part % 16}) text += digits[static_cast<std::size_t>(digit)];
  return text;
}

// One class a line style. It stands on the layers, so that a path's own dashes win over it.
std::string style_sheet(const Sheet& sheet) {
  std::map<std::string, std::string> rules;
  std::string common;
  for (const Layer& layer : sheet.layers) {
    const std::string name = "." + identifier(layer.style.name);
    std::string rule = "stroke-width:" + millimetres(layer.style.width);
    if (layer.style.dashes.dash > 0) rule += ";stroke-dasharray:" + dash_array(layer.style.dashes);
    if (layer.style.colour != Colour{}) rule += ";stroke:" + hexadecimal(layer.style.colour);
    const auto [place, added] = rules.emplace(name, rule);
    check(place->second == rule, "two line styles have one name");
    if (added) common += (common.empty() ? "" : ",") + name;
  }
  if (common.empty()) return {};
  std::string text = common + "{fill:none;stroke:#000;stroke-linecap:round;stroke-linejoin:round}";
  for (const auto& [name, rule] : rules) text += "\n" + name + "{" + rule + "}";
  return text;
}

// Fills and letters of layers that are not black.
std::string colours_of_areas(const Sheet& sheet) {
  std::set<std::string> rules;
  for (const Layer& layer : sheet.layers) {
    if (layer.style.colour == Colour{} || (layer.fills.empty() && layer.texts.empty())) continue;
    const std::string name = "." + identifier(layer.style.name);
    rules.insert("\n" + name + " .filled," + name + " .lettering{fill:" + hexadecimal(layer.style.colour) + "}");
  }
  std::string text;
  for (const std::string& rule : rules) text += rule;
  return text;
}

pugi::xml_node add_head(pugi::xml_document& document, const Sheet& sheet) {
  pugi::xml_node declaration = document.append_child(pugi::node_declaration);
  declaration.append_attribute("version") = "1.0";
  declaration.append_attribute("encoding") = "UTF-8";
  const std::string width = millimetres(sheet.width), height = millimetres(sheet.height);
  pugi::xml_node svg = document.append_child("svg");
  svg.append_attribute("xmlns") = "http://www.w3.org/2000/svg";
  svg.append_attribute("xmlns:inkscape") = "http://www.inkscape.org/namespaces/inkscape";
  svg.append_attribute("xmlns:sodipodi") = "http://sodipodi.sourceforge.net/DTD/sodipodi-0.dtd";
  svg.append_attribute("width") = (width + "mm").c_str();
  svg.append_attribute("height") = (height + "mm").c_str();
  svg.append_attribute("viewBox") = ("0 0 " + width + " " + height).c_str();
  pugi::xml_node view = svg.append_child("sodipodi:namedview");
  view.append_attribute("inkscape:document-units") = "mm";
  add_svg_metadata(svg, sheet);
  svg.append_child("style").text() = (style_sheet(sheet) + lettering_style(sheet) + colours_of_areas(sheet)).c_str();
  return svg;
}

struct StringWriter : pugi::xml_writer {
  std::string bytes;
  void write(const void* data, std::size_t size) override { bytes.append(static_cast<const char*>(data), size); }
};

// The document without its paths.
std::string frame_of(const Sheet& sheet, const std::vector<const Layer*>& layers, bool plain) {
  pugi::xml_document document;
  add_layers(add_head(document, sheet), layers, plain);
  StringWriter writer;
  document.save(writer, "", pugi::format_default, pugi::encoding_utf8);
  return writer.bytes;
}

}  // namespace

std::string to_svg(const Sheet& sheet, const VectorOptions& options, const Progress& progress) {
  const std::vector<const Layer*> layers = by_view(sheet);
  const std::string frame = frame_of(sheet, layers, options.plain);
  const Canvas canvas = enlarged_canvas(sheet);
  const std::optional<Lettering> lettering = lettering_of(sheet);
  std::string svg;
  // Memory that is never touched costs nothing, moving a long text does.
  std::size_t max = frame.size();
  for (const Layer* layer : layers) max += most_bytes(*layer);
  svg.reserve(max);
  std::size_t copied = 0, lines = 0;
  for (const Layer* layer : layers) {
    if (!has_ink(*layer)) continue;
    const std::size_t here = frame.find(paths_here, copied);
    svg.append(frame, copied, here - copied);
    append_fills(svg, *layer, sheet.height);
    append_paths(svg, *layer, canvas, {sheet.height, options.decimals, options.plain, lines}, progress);
    if (lettering) append_texts(svg, *layer, sheet.height, *lettering, options.text);
    copied = here + paths_here.size();
    lines += layer->strokes.size();
  }
  svg.append(frame, copied);
  return svg;
}

}  // namespace epura
