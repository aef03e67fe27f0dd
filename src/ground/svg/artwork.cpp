// SPDX-License-Identifier: Apache-2.0
#include "svg/artwork.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <pugixml.hpp>
#include <utility>

#include "base/error.hpp"
#include "base/portable_math.hpp"
#include "base/text.hpp"
#include "svg/basic_shapes.hpp"
#include "svg/element.hpp"

namespace epura::svg {

namespace {

constexpr double longest_side = 20'000;  // mm
constexpr double min_text = 1e-6;        // mm
constexpr double farthest = 1e6;         // mm; what lies there is not meant for a sheet

// Elements that show nothing.
constexpr std::array<std::string_view, 7> silent = {
    "title", "desc", "metadata", "defs", "style", "sodipodi:namedview", "inkscape:path-effect"};

/// Elements with another hint than that they are not known.
constexpr std::array<std::pair<std::string_view, const char*>, 7> hints = {{
    {"use", "in Inkscape: Edit > Clone > Unlink Clone"},
    {"image", "pictures of pixels cannot be drawn here; trace it, or give a PNG as --logo"},
    {"script", "remove it"},
    {"flowRoot", "in Inkscape: Text > Unflow, or Text > Convert to Text"},
    {"foreignObject", "use a text"},
    {"textPath", "in Inkscape: Text > Remove from Path"},
    {"svg", "move what it has into the outer drawing"},
}};

// "Document type" and "document-type" are "document_type".
std::string normal_name(std::string_view name) {
  std::string normal = to_lower(name);
  for (char& c : normal)
    if (c == ' ' || c == '-') c = '_';
  return normal;
}

/// Elements that are drawn otherwise than they are meant.
struct Approximated {
  std::size_t count = 0;
  std::string first{};  ///< its place

  void note(std::string where) {
    if (count++ == 0) first = std::move(where);
  }
  [[nodiscard]] std::string sentence(const std::string& one, const std::string& many) const {
    return first + ": " + (count == 1 ? one : std::to_string(count) + " " + many);
  }
};

/// The size of the drawing in mm, and the map from user units, y down, to millimetres, y up.
struct Page {
  Vec2 size;
  AffineMap map;
};

Page page_of(const pugi::xml_node& svg, const Source& source) {
  constexpr double mm = 25.4 / 96;
  const std::vector<double> box = numbers_in(svg.attribute("viewBox").value());
  const bool has_box = box.size() == 4 && box[2] > 0 && box[3] > 0;
  Vec2 units(source.length_in(svg, "width"), source.length_in(svg, "height"));
  if (has_box && units == Vec2(0, 0)) units = {box[2], box[3]};
  // FreeCAD takes numbers without a unit as millimetres.
  const bool is_of_freecad = !svg.attribute("xmlns:freecad").empty();
  const bool has_unit = !parse_number(svg.attribute("width").value()).has_value();
  const Vec2 size = units * (is_of_freecad && !has_unit ? 1 : mm);
  if (!(size.x > 0 && size.y > 0 && std::max(size.x, size.y) <= longest_side))
    source.refuse(svg, "the drawing has no size", "give the <svg> a width and a height, such as 297mm and 210mm");
  const Vec2 scale = has_box ? size / Vec2(box[2], box[3]) : Vec2(mm);
  const Vec2 origin = has_box ? Vec2(box[0], box[1]) : Vec2(0);
  return {size, {{scale.x, 0}, {0, -scale.y}, {-origin.x * scale.x, size.y + origin.y * scale.y}}};
}

std::string_view field_of_freecad(const pugi::xml_node& text) {
  const pugi::xml_attribute filled = text.attribute("freecad:autofill");
  return (filled ? filled : text.attribute("freecad:editable")).value();
}

std::string name_of(const pugi::xml_node& element) {
  if (const std::string_view field = field_of_freecad(element); !field.empty()) return normal_name(field);
  const pugi::xml_attribute label = element.attribute("inkscape:label");
  return normal_name(label ? label.value() : element.attribute("id").value());
}

// Also false for NaN, as of an arc whose radius is beyond all numbers.
bool is_near(const Vec2& p) { return std::abs(p.x) <= farthest && std::abs(p.y) <= farthest; }

Vec2 near_sheet(const Source& source, const pugi::xml_node& element, const Vec2& p) {
  if (!is_near(p)) source.refuse(element, "reaches more than 1 km beyond the sheet", "remove what lies there");
  return p;
}

// A shape with the width and dashes of its stroke.
Shape with_stroke(Shape shape, const pugi::xml_node& element, const Context& context, const Source& source) {
  const std::string_view width = context.style.of("stroke-width"), dashes = context.style.of("stroke-dasharray");
  const auto units = width.empty() ? 1 : length_of(width);
  if (!units) source.refuse(element, "has the line width '" + std::string(width) + "'", "give a length, such as 0.7");
  shape.width = near_sheet(source, element, Vec2(*units * context.map.scale())).x;
  if (shape.width == 0) shape.stroke.reset();
  if (dashes.empty() || dashes == "none") return shape;
  for (const std::string_view word : split_lengths(dashes)) {
    const auto length = length_of(word);
    if (!length)
      source.refuse(element, "has the dashes '" + std::string(dashes) + "'", "give lengths, such as 3, 0.75");
    shape.dashes.push_back(near_sheet(source, element, Vec2(*length * context.map.scale())).x);
  }
  if (shape.dashes.size() % 2 == 1) shape.dashes.insert(shape.dashes.end(), shape.dashes.begin(), shape.dashes.end());
  return shape;
}

// The path data of an element. Throws Error{input} if it is none.
std::string path_data_of(const pugi::xml_node& element, const Source& source) {
  const auto data = path_of_shape(element, [&](const char* name) { return source.length_in(element, name); });
  if (data) return *data;
  const std::string name = element.name();
  const auto* const hint = std::find_if(hints.begin(), hints.end(), [&](const auto& one) { return one.first == name; });
  source.refuse(element, "has the element <" + name + ">, which is not drawn",
                hint != hints.end() ? hint->second : "use paths, rectangles, lines, circles, polygons and texts");
}

/// Reads elements one after the other.
class Reader {
 public:
  Reader(const Definitions& all, std::span<const std::string_view> areas, std::size_t bytes)
      : all_(all), wanted_(areas), room_(bytes, all.source.where) {}

  Artwork read(const pugi::xml_node& svg, const Page& page) {
    art_.size = page.size;
    Context context;
    context.map = page.map;
    context.style = style_of(svg, {}, all_.rules);
    for (const pugi::xml_node child : svg.children()) read_element(child, context);
    if (graded_.count > 0)
      art_.warnings.push_back(graded_.sentence("a gradient is drawn in its middle colour",
                                               "gradients are drawn in their middle colours, this is the first"));
    if (transparent_.count > 0)
      art_.warnings.push_back(
          transparent_.sentence("a transparent colour is drawn as it is on white paper",
                                "transparent colours are drawn as they are on white paper, this is the first"));
    if (stretched_.count > 0)
      art_.warnings.push_back(
          stretched_.sentence("a text that is wider or narrower than its font is drawn in its height",
                              "texts that are wider or narrower than their font are drawn in their "
                              "height, this is the first"));
    return std::move(art_);
  }

 private:
  // FreeCAD's templates state areas in comments: "Working space 10 10 410 287", two corners.
  void read_comment(const pugi::xml_node& comment, const Context& parent) {
    constexpr std::array<std::pair<std::string_view, std::string_view>, 2> spaces{
        {{"working space", "drawing_area"}, {"title block", "title_block"}}};
    const std::string text = to_lower(comment.value());
    for (const auto& [words, area] : spaces) {
      const std::size_t at = text.find(words);
      if (at == std::string::npos || std::find(wanted_.begin(), wanted_.end(), area) == wanted_.end()) continue;
      const std::vector<double> corners = numbers_in(std::string_view(text).substr(at + words.size()));
      if (corners.size() != 4) continue;
      const Vec2 one = parent.map({corners[0], corners[1]}), other = parent.map({corners[2], corners[3]});
      art_.areas.push_back({std::string(area), glm::min(one, other), glm::max(one, other)});
    }
  }

  void read_element(const pugi::xml_node& element, const Context& parent) {
    if (element.type() == pugi::node_comment) return read_comment(element, parent);
    if (element.type() != pugi::node_element) return;
    const std::string_view name = element.name();
    if (std::find(silent.begin(), silent.end(), name) != silent.end()) return;
    const Context context = inside(element, parent, all_);
    if (!context.style.is_shown()) return;
    const std::size_t first = art_.items.size();
    if (name == "g") {
      for (const pugi::xml_node child : element.children()) read_element(child, context);
    } else if (name == "text") {
      read_text(element, context);
    } else {
      read_shape(element, context);
    }
    note_area(element, first);
  }

  std::optional<Colour> paint(const pugi::xml_node& element, const Context& context, const std::string& property,
                              std::string_view usual) {
    const Painted painted = paint_of(element, context, all_, property, usual);
    if (painted.graded) graded_.note(all_.source.line_of(element));
    if (painted.transparent) transparent_.note(all_.source.line_of(element));
    return painted.colour;
  }

  void read_shape(const pugi::xml_node& element, const Context& context) {
    const std::string data = path_data_of(element, all_.source);
    auto path = read_path(data, room_);
    if (!path)
      all_.source.refuse(element, "has a path that cannot be read: '" + data.substr(0, 40) + "'",
                         "use the commands M L H V C Q A Z");
    Shape shape{std::move(path->lines)};
    for (Line& line : shape.lines)
      for (Vec2& p : line.points) p = near_sheet(all_.source, element, context.map(p));
    shape.fill = paint(element, context, "fill", "#000");
    shape.stroke = paint(element, context, "stroke", "none");
    shape = with_stroke(std::move(shape), element, context, all_.source);
    if (!shape.lines.empty()) art_.items.emplace_back(std::move(shape));
  }

  void note_area(const pugi::xml_node& element, std::size_t first) {
    const std::string name = name_of(element);
    if (std::find(wanted_.begin(), wanted_.end(), name) == wanted_.end()) return;
    Area area{name, Vec2(HUGE_VAL), Vec2(-HUGE_VAL)};
    for (std::size_t i = first; i < art_.items.size(); ++i)
      if (const auto* shape = std::get_if<Shape>(&art_.items[i]))
        for (const Line& line : shape->lines)
          for (const Vec2& p : line.points) {
            area.min = glm::min(area.min, p);
            area.max = glm::max(area.max, p);
          }
    if (area.min.x < area.max.x && area.min.y < area.max.y) art_.areas.push_back(std::move(area));
  }

  // A text may have a <tspan> for each of its lines, each with a place of its own.
  void read_text(const pugi::xml_node& element, const Context& context) {
    read_words(element, context, element, name_of(element));
  }

  void read_words(const pugi::xml_node& node, const Context& context, const pugi::xml_node& text,
                  const std::string& name) {
    Words words;
    for (const pugi::xml_node child : node.children()) {
      if (child.type() == pugi::node_pcdata || child.type() == pugi::node_cdata) {
        words.text += child.value();
      } else if (std::string_view(child.name()) == "tspan") {
        if (!child.attribute("x") && !child.attribute("y") && !child.first_element_by_path("tspan"))
          words.text += child.text().get();
        else
          read_words(child, inside(child, context, all_), text, name);
      } else if (child.type() == pugi::node_element && std::string_view(child.name()) != "title") {
        all_.source.refuse(child, "a text has the element <" + std::string(child.name()) + ">", "use plain texts");
      }
    }
    const bool is_blank = words.text.find_first_not_of(" \t\r\n") == std::string::npos;
    const bool is_empty_field = is_blank && node == text && !node.child("tspan") && !name.empty();
    if (!is_blank || is_empty_field) add_words(std::move(words), node, context, text, name);
  }

  void add_words(Words words, const pugi::xml_node& node, const Context& context, const pugi::xml_node& text,
                 const std::string& name) {
    const auto place = [&](const char* axis) {
      return all_.source.length_in(node.attribute(axis) ? node : text, axis);
    };
    const AffineMap& map = context.map;
    const auto size = length_of(context.style.of("font-size"));
    if (!size) all_.source.refuse(node, "a text has no size in units", "give it a font-size, such as 3.5px");
    const double along = glm::length(map.along), across = glm::length(map.across);
    const double turned = map.along.x * map.across.y - map.along.y * map.across.x;
    if (std::abs(turned + along * across) > 1e-6 * along * across)
      all_.source.refuse(node, "a text is mirrored or slanted", "only scale and turn it");
    if (std::abs(along - across) > 0.01 * along) stretched_.note(all_.source.line_of(node));
    words.size = *size * across;
    if (!(words.size > min_text && words.size <= farthest))
      all_.source.refuse(node, "a text has no height", "give it a font-size and a transform that leave it one");
    words.at = near_sheet(all_.source, node, map({place("x"), place("y")}));
    words.angle = portable_atan2(map.along.y, map.along.x) * 180 / std::numbers::pi;
    const std::string_view anchor = context.style.of("text-anchor");
    words.anchor = anchor == "middle" ? TextAnchor::middle : anchor == "end" ? TextAnchor::end : TextAnchor::start;
    words.colour = paint(node, context, "fill", "#000").value_or(Colour());
    words.is_field = !field_of_freecad(text).empty();
    words.name = name;
    words.where = all_.source.line_of(text);
    art_.items.emplace_back(std::move(words));
  }

  const Definitions& all_;
  std::span<const std::string_view> wanted_;
  PieceRoom room_;
  Approximated graded_{}, transparent_{}, stretched_{};
  Artwork art_{};
};

}  // namespace

Artwork read_artwork(std::string_view bytes, const std::string& where, std::span<const std::string_view> areas) {
  Definitions all{Source(bytes, where)};
  pugi::xml_document document;
  const pugi::xml_parse_result result = document.load_buffer(
      bytes.data(), bytes.size(), pugi::parse_default | pugi::parse_ws_pcdata_single | pugi::parse_comments);
  if (!result)
    throw Error(ErrorKind::input, all.source.line_at(result.offset),
                "is not valid XML: " + std::string(result.description()));
  const pugi::xml_node svg = document.child("svg");
  if (!svg) throw Error(ErrorKind::input, where, "is not an SVG file");
  const Page page = page_of(svg, all.source);
  all.rules = style_sheets_in(svg, all.source);
  all.gradients = gradients_of(svg);
  return Reader(all, areas, bytes.size()).read(svg, page);
}

}  // namespace epura::svg
