// SVG: Cairo draws each layer, pugixml joins the layers into one document in millimetres.
#include <cairo-svg.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <pugixml.hpp>
#include <set>
#include <utility>

#include "base/error.hpp"
#include "base/text.hpp"
#include "output/canvas.hpp"
#include "output/utf8.hpp"
#include "output/write.hpp"

namespace epura {

namespace {

constexpr int decimals = 5;  // of a millimetre

using Group = std::vector<const Stroke*>;  // what becomes one <path>

std::string millimetres(double value) { return format_fixed(value, decimals); }

std::string dash_array(double dash, double gap) {
  return dash > 0 ? millimetres(dash) + " " + millimetres(gap) : "none";
}

// Text that XML can hold: it has no way to write control characters.
std::string xml_text(std::string_view text) {
  std::string valid = valid_utf8(text);
  for (char& c : valid)
    if (static_cast<unsigned char>(c) < ' ' && c != '\n' && c != '\t') c = ' ';
  return valid;
}

// A name that ids and style sheets take.
std::string identifier(std::string_view name) {
  constexpr std::string_view letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789_";
  std::string id(name);
  for (char& c : id)
    if (letters.find(c) == std::string_view::npos) c = '-';
  return id;
}

std::vector<Group> groups_of(const Layer& layer, bool plain) {
  std::vector<Group> groups;
  std::map<std::string, std::size_t> group_of_dashes;
  for (const Stroke& stroke : layer.strokes) {
    if (stroke.points.empty()) continue;
    std::size_t group = groups.size();
    if (plain) group = group_of_dashes.emplace(dash_array(stroke.dash, stroke.gap), group).first->second;
    if (group == groups.size()) groups.emplace_back();
    groups[group].push_back(&stroke);
  }
  return groups;
}

std::string cairo_svg(const Canvas& canvas, const Layer& layer, const std::vector<Group>& groups) {
  std::string bytes;
  const CairoSurface surface(cairo_svg_surface_create_for_stream(append_bytes, &bytes, canvas.size.x, canvas.size.y));
  {
    const Pen pen = make_pen(surface);
    begin_vector_file(pen, canvas);
    for (const Group& group : groups) draw(pen, canvas, layer.style, group);
  }
  finish(surface, "SVG");
  return bytes;
}

// Cairo writes "M x y L x y ... Z M x y " in its units.
std::string path_in_millimetres(std::string_view path, const Canvas& canvas, double height) {
  std::string result, start;
  const auto next_token = [&path] {
    const std::size_t end = std::min(path.find(' '), path.size());
    const std::string_view token = path.substr(0, end);
    path.remove_prefix(std::min(end + 1, path.size()));
    return token;
  };
  while (!path.empty()) {
    const std::string_view command = next_token();
    if (command == "Z") {
      result += 'Z';
      continue;
    }
    const auto x = parse_number(next_token()), y = parse_number(next_token());
    check((command == "M" || command == "L") && x && y, "Cairo wrote an SVG path in another form");
    const Vec2 p = canvas.to_sheet({*x, *y});
    const std::string point = millimetres(p.x) + " " + millimetres(height - p.y);
    if (command == "M") {
      start = "M" + point;  // only wanted when a line follows
    } else {
      result += std::exchange(start, {}) + "L" + point;
    }
  }
  return result;
}

void add_origin(pugi::xml_node path, const Stroke& stroke) {
  if (!stroke.kind.empty()) path.append_attribute("data-kind") = xml_text(stroke.kind).c_str();
  if (!stroke.edges.empty()) path.append_attribute("data-edges") = xml_text(stroke.edges).c_str();
}

void add_layer(pugi::xml_node svg, const Sheet& sheet, const Layer& layer, const Canvas& canvas, bool plain,
               const std::string& id) {
  pugi::xml_node g = svg.append_child("g");
  g.append_attribute("id") = id.c_str();
  g.append_attribute("inkscape:groupmode") = "layer";
  g.append_attribute("inkscape:label") = xml_text(layer.name).c_str();
  g.append_attribute("class") = identifier(layer.style.name).c_str();

  const std::vector<Group> groups = groups_of(layer, plain);
  std::string bytes = cairo_svg(canvas, layer, groups);
  pugi::xml_document drawn;
  check(bool(drawn.load_buffer_inplace(bytes.data(), bytes.size())), "Cairo wrote no XML");
  const std::string usual_dashes = dash_array(layer.style.dash, layer.style.gap);
  pugi::xml_node line = drawn.child("svg").child("g").child("path");
  for (std::size_t i = 0; i < groups.size(); ++i) {
    line = line.next_sibling("path");  // the first one has no ink
    check(bool(line), "Cairo left a stroke out");
    const Stroke& stroke = *groups[i].front();
    pugi::xml_node path = g.append_child("path");
    if (!plain) path.append_attribute("id") = (id + "-" + std::to_string(i)).c_str();
    if (!plain) add_origin(path, stroke);
    const std::string dashes = dash_array(stroke.dash, stroke.gap);
    if (dashes != usual_dashes) path.append_attribute("stroke-dasharray") = dashes.c_str();
    path.append_attribute("d") = path_in_millimetres(line.attribute("d").value(), canvas, sheet.height).c_str();
  }
}

// One class a line style. It stands on the layers, so that a path's own dashes win over it.
std::string style_sheet(const Sheet& sheet) {
  std::map<std::string, std::string> rules;
  std::string common;
  for (const Layer& layer : sheet.layers) {
    const std::string name = "." + identifier(layer.style.name);
    std::string rule = "stroke-width:" + millimetres(layer.style.width);
    if (layer.style.dash > 0) rule += ";stroke-dasharray:" + dash_array(layer.style.dash, layer.style.gap);
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
  svg.append_child("style").text() = style_sheet(sheet).c_str();
  return svg;
}

struct StringWriter : pugi::xml_writer {
  std::string bytes;
  void write(const void* data, std::size_t size) override { bytes.append(static_cast<const char*>(data), size); }
};

}  // namespace

std::string to_svg(const Sheet& sheet, const VectorOptions& options) {
  pugi::xml_document document;
  const pugi::xml_node svg = add_head(document, sheet);
  const Canvas canvas = enlarged_canvas(sheet);
  std::set<std::string> ids;
  for (const Layer& layer : sheet.layers) {
    std::string id = identifier(layer.name);
    while (!ids.insert(id).second) id += '-';
    add_layer(svg, sheet, layer, canvas, options.plain, id);
  }
  StringWriter writer;
  document.save(writer, "", pugi::format_default, pugi::encoding_utf8);
  return writer.bytes;
}

}  // namespace epura
