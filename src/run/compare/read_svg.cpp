// SPDX-License-Identifier: Apache-2.0
// SVG -> picture.
#include <algorithm>
#include <cmath>
#include <optional>
#include <pugixml.hpp>
#include <set>
#include <string>
#include <string_view>

#include "base/error.hpp"
#include "base/text.hpp"
#include "compare/picture_maker.hpp"
#include "compare/read_pictures.hpp"
#include "scene/line_roles.hpp"
#include "sheet/lettering.hpp"
#include "svg/path.hpp"
#include "svg/style.hpp"

namespace epura::compare {

namespace {

constexpr int deepest = 100;                  // groups in groups
constexpr std::size_t longest_text = 10'000;  // bytes
constexpr std::size_t longest_model = 20;     // digits of its number

// The properties that a group passes on to its content.
struct Context {
  svg::Style style{};
  svg::AffineMap map{};
  std::string view{};   // label of the outermost layer
  std::string layer{};  // label or class of the innermost layer: the name of its lines
  bool visible = true;
  bool shows_dashes = true;  // whether some line of the layer is long enough for its dashes
  std::string model{};
  int depth = 0;
};

double millimetres(std::string_view length) {
  if (length.ends_with("mm")) length.remove_suffix(2);
  return parse_number(length).value_or(NAN);
}

double number_in(const pugi::xml_attribute& attribute) { return parse_number(attribute.value()).value_or(NAN); }

class SvgReader {
 public:
  SvgReader(std::string_view bytes, const std::string& where)
      : bytes_(bytes), where_(where), room_(bytes.size(), where), picture_(where) {}

  Picture read() {
    pugi::xml_document document;
    const pugi::xml_parse_result result =
        document.load_buffer(bytes_.data(), bytes_.size(), pugi::parse_default | pugi::parse_ws_pcdata_single);
    if (!result)
      throw Error(
          ErrorKind::input, where_,
          "is not valid XML: " + std::string(result.description()) + " (byte " + std::to_string(result.offset) + ")");
    const pugi::xml_node svg = document.child("svg");
    if (!svg) refuse("is not an SVG file");
    const Vec2 size(millimetres(svg.attribute("width").value()), millimetres(svg.attribute("height").value()));
    const std::vector<double> box = svg::numbers_in(svg.attribute("viewBox").value());
    if (!(size.x > 0 && size.y > 0) || box.size() != 4 || !(box[2] > 0 && box[3] > 0))
      refuse("has no size in millimetres");
    picture_.set_size(size);
    Context all;
    all.map = {{size.x / box[2], 0}, {0, size.y / box[3]}, {0, 0}};
    all.map.shift = -Vec2(box[0], box[1]) * Vec2(all.map.along.x, all.map.across.y);
    for (const pugi::xml_node style : svg.children("style")) rules_.merge(svg::read_rules(style.text().get()));
    all.style = style_of(svg, {}, rules_);
    for (const pugi::xml_node child : svg.children()) read_element(child, all);
    return picture_.finish();
  }

 private:
  [[noreturn]] void refuse(const std::string& what) const {
    throw Error(ErrorKind::input, where_, what, "epura compares only SVG files that it wrote itself");
  }

  void read_element(const pugi::xml_node& element, const Context& parent) {
    static const std::set<std::string_view> without_ink = {"title", "desc",  "metadata",          "style",
                                                           "defs",  "image", "sodipodi:namedview"};  // no pictures
    const std::string_view name = element.name();
    if (element.type() != pugi::node_element || without_ink.contains(name)) return;
    if (name != "g" && name != "path" && name != "text") refuse("has the element '" + std::string(name) + "'");
    const Context context = inside(element, parent);
    if (!context.style.is_shown()) return;
    if (name == "path") return read_path(element, context);
    if (name == "text") return read_text(element, context);
    // Views, features and dimensions have names, too, but roles of their own (svg_tree.hpp).
    const bool is_object = std::string_view(element.attribute("role").value()).starts_with("graphics-");
    if (const pugi::xml_attribute words = element.attribute("aria-label"); words && !is_object)
      return read_outlines(element, context, words.value());
    for (const pugi::xml_node child : element.children()) read_element(child, context);
  }

  [[nodiscard]] Context inside(const pugi::xml_node& element, const Context& parent) const {
    Context context = parent;
    if (++context.depth > deepest) refuse("has too many nested groups");
    context.style = style_of(element, parent.style, rules_);
    if (const pugi::xml_attribute transform = element.attribute("transform")) {
      const auto map = svg::read_transform(transform.value());
      if (!map) refuse("has an unsupported transform: '" + std::string(transform.value()) + "'");
      context.map = parent.map.after(*map);
    }
    if (const std::string label = element.attribute("inkscape:label").value(); !label.empty()) {
      if (context.view.empty()) context.view = label;
      context.layer = label;
      const scene::SheetLineRow* row = scene::find_line(label);
      context.visible = row == nullptr || !row->is_hidden;
    }
    if (element.attribute("stroke-dasharray") && element.child("path")) context.shows_dashes = has_dashed_path(element);
    if (const pugi::xml_attribute visible = element.attribute("data-visible")) context.visible = visible.as_bool();
    if (const pugi::xml_attribute model = element.attribute("data-model")) context.model = model.value();
    return context;
  }

  static bool has_dashed_path(const pugi::xml_node& layer) {
    const auto is_dashed = [](const pugi::xml_node& path) {
      return std::string_view(path.attribute("stroke-dasharray").value()) != "none";
    };
    const auto paths = layer.children("path");
    return std::any_of(paths.begin(), paths.end(), is_dashed);
  }

  Vec2 on_page(const Context& context, const Vec2& p) const {
    const Vec2 at = context.map(p);
    return {at.x, picture_.size().y - at.y};
  }

  [[nodiscard]] svg::Path path_of(const pugi::xml_node& element, svg::PieceRoom& room) const {
    auto path = svg::read_path(element.attribute("d").value(), room);
    if (!path) refuse("has an unsupported path: id '" + std::string(element.attribute("id").value()) + "'");
    return std::move(*path);
  }

  void read_path(const pugi::xml_node& element, const Context& context) {
    const svg::Path path = path_of(element, room_);
    const std::string_view stroke = context.style.of("stroke"), fill = context.style.of("fill");
    const int view = picture_.view(context.view);
    if (fill != "none") add_lines(path, context, {.look = area_look(context), .view = view, .are_areas = true});
    if (stroke.empty() || stroke == "none") return;
    const int look = line_look(context);
    const std::vector<std::string> edges = edges_of(element, context);
    std::size_t pieces = 0;
    for (const svg::Line& line : path.lines) pieces += line.points.size() - (line.closed ? 0 : 1);
    // One edge for each piece of the path, or all edges for all pieces.
    const bool one_each = edges.size() == pieces;
    std::string all;
    if (!one_each)
      for (const std::string& edge : edges) all += (all.empty() ? "" : " ") + edge;
    const int first = edges.empty() ? -1 : picture_.add_origins(one_each ? edges : std::vector{all});
    add_lines(path, context, {.look = look, .view = view, .origin = first, .one_origin_each = one_each});
  }

  [[nodiscard]] std::vector<std::string> edges_of(const pugi::xml_node& element, const Context& context) const {
    std::vector<std::string> edges;
    const std::string_view list = element.attribute("data-edge").value();
    if (list.empty()) return edges;
    if (context.model.size() > longest_model) refuse("has a model whose number is too long");
    for (const std::string_view edge : split(list, ' '))
      edges.push_back(edge.find(':') != std::string_view::npos ? std::string(edge)
                                                               : context.model + ":" + std::string(edge));
    return edges;
  }

  struct LineMarks {
    int look = 0, view = 0, origin = -1;
    bool are_areas = false;        ///< closed, even if the path is not
    bool one_origin_each = false;  ///< the first piece has `origin`, the next one the next number
  };

  void add_lines(const svg::Path& path, const Context& context, LineMarks marks) {
    for (const svg::Line& line : path.lines) {
      const std::size_t count = line.points.size();
      for (std::size_t i = 0; i + (line.closed || marks.are_areas ? 0 : 1) < count; ++i) {
        const Vec2 from = on_page(context, line.points[i]), to = on_page(context, line.points[(i + 1) % count]);
        picture_.add({from, to, marks.look, marks.view, marks.origin});
        if (marks.one_origin_each) ++marks.origin;
      }
    }
  }

  int line_look(const Context& context) {
    PictureLook look{context.layer, context.visible};
    const double scale = context.map.scale();
    const std::string_view width = context.style.of("stroke-width");
    const auto units = width.empty() ? 1 : parse_number(width);
    if (!units) refuse("has an unsupported line width: '" + std::string(width) + "'");
    look.width = scale * *units;
    for (const double length : svg::numbers_in(context.style.of("stroke-dasharray")))
      look.dashes.push_back(scale * length);
    // The first dash is the adjusted one.
    if (context.style.has_fitted_dashes && look.dashes.size() > 1)
      look.dashes[0] = scene::type_with_dots(static_cast<int>(look.dashes.size()) / 2 - 1).dash * look.width;
    look.colour = svg::colour_of(context.style.of("stroke"));
    look.is_short = !context.shows_dashes;
    room_.take(look.dashes.size());
    return picture_.look(look);
  }

  int area_look(const Context& context) {
    PictureLook look{context.layer + " area", true, true};
    look.colour = svg::colour_of(context.style.of("fill"));
    return picture_.look(look);
  }

  void add_text(const std::string& words, const Context& context, const std::vector<Vec2>& outline) {
    PictureText text{sheet::written(words), Vec2(HUGE_VAL), Vec2(-HUGE_VAL), picture_.view(context.view)};
    for (const Vec2& p : outline) {
      text.min = glm::min(text.min, on_page(context, p));
      text.max = glm::max(text.max, on_page(context, p));
    }
    if (!outline.empty()) picture_.add(text);  // blanks are not visible
  }

  void read_outlines(const pugi::xml_node& group, const Context& context, const std::string& words) {
    std::vector<Vec2> outline;
    svg::PieceRoom room = room_;  // a copy, because only their box is kept
    for (const pugi::xml_node path : group.children("path")) {
      const svg::Path read = path_of(path, room);
      for (const svg::Line& line : read.lines) outline.insert(outline.end(), line.points.begin(), line.points.end());
      outline.insert(outline.end(), read.controls.begin(), read.controls.end());
    }
    add_text(words, context, outline);
  }

  // Set in the font of the project.
  void read_text(const pugi::xml_node& element, const Context& context) {
    const std::string words = element.text().get();
    if (words.size() > longest_text) refuse("has a text of more than " + std::to_string(longest_text) + " bytes");
    if (!lettering_) lettering_.emplace();
    const double height = parse_number(context.style.of("font-size")).value_or(NAN) / lettering_->em();
    const Vec2 at(number_in(element.attribute("x")), number_in(element.attribute("y")));
    if (!std::isfinite(height + at.x + at.y)) refuse("has a text without place or size: '" + words + "'");
    const std::string_view anchor = context.style.of("text-anchor");
    const double before = anchor == "middle" ? 0.5 : anchor == "end" ? 1 : 0;
    const Vec2 start = at - Vec2(before * lettering_->width(words, height), 0);
    std::vector<Vec2> outline;
    const auto add = [&](const Vec2& p) { outline.push_back(start + Vec2(p.x, -p.y)); };
    for (const sheet::GlyphOutline& glyph : lettering_->outlines(words, height))
      for (const sheet::GlyphOutline::Curve& curve : glyph.curves) {
        add(curve.control);
        add(curve.end);
      }
    add_text(words, context, outline);
  }

  std::string_view bytes_;
  const std::string& where_;
  svg::Rules rules_{};
  std::optional<sheet::Lettering> lettering_{};
  svg::PieceRoom room_;
  PictureMaker picture_;
};

}  // namespace

Picture picture_of_svg(std::string_view bytes, const std::string& where) { return SvgReader(bytes, where).read(); }

}  // namespace epura::compare
