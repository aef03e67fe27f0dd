// SVG: pugixml makes the document, Cairo draws the paths of its layers.
#include <algorithm>
#include <cstddef>
#include <map>
#include <pugixml.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "base/error.hpp"
#include "output/canvas.hpp"
#include "output/glyphs.hpp"
#include "output/svg_lettering.hpp"
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

void add_layer(pugi::xml_node svg, const Layer& layer, const std::string& id) {
  pugi::xml_node g = svg.append_child("g");
  g.append_attribute("id") = id.c_str();
  g.append_attribute("inkscape:groupmode") = "layer";
  g.append_attribute("inkscape:label") = xml_text(layer.name).c_str();
  g.append_attribute("class") = identifier(layer.style.name).c_str();
  if (has_ink(layer)) g.append_child("path");
}

// One class a line style. It stands on the layers, so that a path's own dashes win over it.
std::string style_sheet(const Sheet& sheet) {
  std::map<std::string, std::string> rules;
  std::string common;
  for (const Layer& layer : sheet.layers) {
    const std::string name = "." + identifier(layer.style.name);
    std::string rule = "stroke-width:" + millimetres(layer.style.width);
    if (layer.style.dashes.dash > 0) rule += ";stroke-dasharray:" + dash_array(layer.style.dashes);
    const auto [place, added] = rules.emplace(name, rule);
    check(place->second == rule, "two line styles have one name");
    if (added) common += (common.empty() ? "" : ",") + name;
  }
  if (common.empty()) return {};
  std::string text = common + "{fill:none;stroke:#000;stroke-linecap:round;stroke-linejoin:round}";
  for (const auto& [name, rule] : rules) text += "\n" + name + "{" + rule + "}";
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
  svg.append_attribute("width") = (width + "mm").c_str();
  svg.append_attribute("height") = (height + "mm").c_str();
  svg.append_attribute("viewBox") = ("0 0 " + width + " " + height).c_str();
  svg.append_child("title").text() = xml_text(sheet.title).c_str();
  svg.append_child("style").text() = (style_sheet(sheet) + lettering_style(sheet)).c_str();
  return svg;
}

std::vector<std::string> layer_ids(const Sheet& sheet) {
  std::vector<std::string> ids;
  for (const Layer& layer : sheet.layers) {
    ids.push_back(identifier(layer.name));
    while (std::count(ids.begin(), ids.end(), ids.back()) > 1) ids.back() += '-';
  }
  return ids;
}

struct StringWriter : pugi::xml_writer {
  std::string bytes;
  void write(const void* data, std::size_t size) override { bytes.append(static_cast<const char*>(data), size); }
};

// The document without its paths.
std::string frame_of(const Sheet& sheet, const std::vector<std::string>& ids) {
  pugi::xml_document document;
  const pugi::xml_node svg = add_head(document, sheet);
  for (std::size_t i = 0; i < ids.size(); ++i) add_layer(svg, sheet.layers[i], ids[i]);
  StringWriter writer;
  document.save(writer, "", pugi::format_default, pugi::encoding_utf8);
  return writer.bytes;
}

}  // namespace

std::string to_svg(const Sheet& sheet, const VectorOptions& options) {
  const std::vector<std::string> ids = layer_ids(sheet);
  const std::string frame = frame_of(sheet, ids);
  const Canvas canvas = enlarged_canvas(sheet);
  const std::optional<Lettering> lettering = lettering_of(sheet);
  std::string svg;
  // Memory that is never touched costs nothing, moving a long text does.
  std::size_t most = frame.size();
  for (std::size_t i = 0; i < ids.size(); ++i) most += most_bytes(sheet.layers[i], ids[i]);
  svg.reserve(most);
  std::size_t copied = 0;
  for (std::size_t i = 0; i < ids.size(); ++i) {
    if (!has_ink(sheet.layers[i])) continue;
    const std::size_t here = frame.find(paths_here, copied);
    svg.append(frame, copied, here - copied);
    append_fills(svg, sheet.layers[i], sheet.height);
    append_paths(svg, sheet.layers[i], canvas, sheet.height, ids[i], options.plain);
    if (lettering) append_texts(svg, sheet.layers[i], sheet.height, *lettering, options.text);
    copied = here + paths_here.size();
  }
  svg.append(frame, copied);
  return svg;
}

}  // namespace epura
