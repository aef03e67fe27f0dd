// SPDX-License-Identifier: Apache-2.0
#include "sheet/form.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/error.hpp"
#include "base/file.hpp"
#include "base/portable_math.hpp"
#include "base/text.hpp"
#include "scene/line_roles.hpp"
#include "scene/title_fields.hpp"
#include "sheet/fit_text.hpp"
#include "sheet/frame.hpp"
#include "sheet/projection_symbol.hpp"
#include "svg/artwork.hpp"

namespace epura::sheet {

namespace {

struct UsualNames {
  std::string_view field;
  std::string_view names;  ///< in small letters, without blanks, hyphens and underscores
};

// Of the templates of FreeCAD 0.20 to 1.0 (English, French, Italian, Spanish, Russian, Chinese).
constexpr std::array<UsualNames, 16> usual_names{{
    {"title", "title drawingtitle drawingtitle1 fctitle titleline1 partname titre titolo denominacion Название"},
    {"supplementary_title", "subtitle drawingtitle2 titleline2 soustitre sottotitolo"},
    {"owner", "owner ownername companyname company organization organisation societe ditta empresa Организация2"},
    {"creator", "author authorname drawnby designedbyname nomauteur nomeprogettista nombredibujo Разработал"},
    {"approver", "approvername supervisorname approved1 nomsuperviseur supervisore nombreaprobacion Утвердил"},
    {"number", "drawingnumber dn partcodename n°plano Номер"},
    {"date", "date date1 fcdate creationdate datedecreation datadicreazione fechadedibujo Датаразработки"},
    {"revision", "revision fcrev version numerodiversione"},
    {"scale", "scale fcscale fcsc echelle scala escala Масштаб"},
    {"size", "size fcsi a3"},
    {"sheet", "sheet sheetnumber fcsh feuille foglio"},
    {"page_number", "ofsheet Лист"},
    {"page_count", "totalsheets Листов"},
    {"mass", "weight poids peso Масса"},
    {"material", "materialmark Материал2"},
    {"general_tolerance", "tolerance tolerancia"},
}};

/// The named fields, and those that the sheet has by itself.
std::vector<std::string> known_fields() {
  std::vector<std::string> names = {"scale", "size", "sheet", "page_number", "page_count"};
  for (const scene::TitleField& field : scene::title_fields()) names.push_back(field.name);
  return names;
}

/// A field as forms name it: "Surface treatment" -> "surface_treatment".
std::string form_name(const std::string& field) {
  std::string name = to_lower(field);
  std::replace_if(
      name.begin(), name.end(), [](char c) { return c == ' ' || c == '-'; }, '_');
  return name;
}

/// The name of the field of a text. Names that are usual in FreeCAD's templates, in several languages, become those of
/// the known fields: "AUTHOR_NAME" -> "creator".
std::string field_of(const svg::Words& words) {
  if (!words.is_field) return words.name;
  std::string plain = words.name;
  std::erase(plain, '_');
  for (const UsualNames& usual : usual_names)
    for (const std::string_view name : split(usual.names, ' '))
      if (name == plain) return std::string(usual.field);
  return words.name;
}

constexpr std::array<std::string_view, 4> area_names = {"drawing_area", "title_block", "projection_symbol", "logo"};

bool is_field(const std::string& name, const std::vector<std::string>& names) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

std::optional<Rectangle> area_of(const svg::Artwork& art, std::string_view name) {
  for (const svg::Area& area : art.areas)
    if (area.name == name) return Rectangle{area.min, area.max};
  return std::nullopt;
}

/// Puts artwork into layers, which have one look each: consecutive shapes of one look share theirs.
class LayerMaker {
 public:
  LayerMaker(std::string name, scene::SheetLine line) : name_(std::move(name)), style_(scene::row_of(line).name) {}

  void add(const svg::Shape& shape, double scale, const Vec2& shift) {
    std::vector<std::vector<Vec2>> rings;
    std::vector<Stroke> strokes;
    for (const svg::Line& line : shape.lines) {
      std::vector<Vec2> points = line.points;
      for (Vec2& p : points) p = p * scale + shift;
      if (points.size() > 2) rings.push_back(points);
      if (points.size() > 1) strokes.push_back({std::move(points), line.closed});
    }
    if (shape.fill && !rings.empty()) {
      // Lines and texts are painted over the areas of their layer.
      if (layers_.empty() || !(last().style.colour == *shape.fill) || !last().strokes.empty() || !last().texts.empty())
        begin(shape.width * scale, {}, *shape.fill);
      last().fills.push_back({std::move(rings)});
    }
    if (!shape.stroke) return;
    const Dashes dashes = dashes_of(shape.dashes, scale);
    const double width = shape.width * scale;
    const bool fits = !layers_.empty() && last().style.colour == *shape.stroke && last().texts.empty() &&
                      (last().strokes.empty() || (last().style.width == width && last().style.dashes == dashes));
    if (!fits) begin(width, dashes, *shape.stroke);
    last().style.width = width;
    last().style.dashes = dashes;
    for (Stroke& stroke : strokes) {
      stroke.dashes = dashes;
      last().strokes.push_back(std::move(stroke));
    }
  }

  void add(Text text, const Colour& colour) {
    if (layers_.empty() || !(last().style.colour == colour)) begin(0.25, {}, colour);
    last().texts.push_back(std::move(text));
  }

  std::vector<Layer> take() { return std::move(layers_); }

 private:
  Layer& last() { return layers_.back(); }

  void begin(double width, const Dashes& dashes, const Colour& colour) {
    const std::string number = layers_.empty() ? "" : " " + std::to_string(layers_.size() + 1);
    layers_.push_back({name_ + number, {style_, std::max(width, 0.01), dashes, colour}, {}});
  }

  // Ink and gap, and dots between the dashes.
  static Dashes dashes_of(const std::vector<double>& lengths, double scale) {
    if (lengths.size() < 2) return {};
    Dashes dashes{lengths[0] * scale, lengths[1] * scale};
    if (lengths.size() > 2) {
      dashes.dot = lengths[2] * scale;
      dashes.dots = static_cast<int>(lengths.size()) / 2 - 1;
    }
    return dashes;
  }

  std::string name_, style_;
  std::vector<Layer> layers_{};
};

struct Ray {
  Vec2 from, along;
};

using Shapes = std::vector<const svg::Shape*>;

// Those with lines. They are listed once: a form can have as many texts as it has bytes for.
Shapes stroked_shapes(const svg::Artwork& art) {
  Shapes shapes;
  for (const auto& item : art.items)
    if (const auto* shape = std::get_if<svg::Shape>(&item); shape != nullptr && shape->stroke) shapes.push_back(shape);
  return shapes;
}

// How far a ray runs before a line of the form crosses it.
double free_length(const Ray& ray, const Shapes& shapes) {
  double free = HUGE_VAL;
  const Vec2 across(-ray.along.y, ray.along.x);
  for (const svg::Shape* shape : shapes)
    for (const svg::Line& line : shape->lines)
      for (std::size_t i = 0; i + (line.closed ? 0 : 1) < line.points.size(); ++i) {
        const Vec2 a = line.points[i] - ray.from, b = line.points[(i + 1) % line.points.size()] - ray.from;
        const double before = glm::dot(a, across), behind = glm::dot(b, across);
        if ((before <= 0) == (behind <= 0)) continue;
        const double at = glm::dot(a + before / (before - behind) * (b - a), ray.along) - shape->width / 2;
        if (at > 0) free = std::min(free, at);
      }
  return free;
}

// The longest text that fits at the place of a field, with a little air at its end.
double room_of(const svg::Words& words, double height, const Shapes& shapes) {
  constexpr double air = 1;
  const double angle = words.angle * std::numbers::pi / 180;
  const Vec2 along(portable_cos(angle), portable_sin(angle)), up(-along.y, along.x);
  const Vec2 from = words.at + height / 2 * up;
  const double ahead = free_length({from, along}, shapes), behind = free_length({from, -along}, shapes);
  switch (words.anchor) {
    case svg::TextAnchor::start:
      return ahead - air;
    case svg::TextAnchor::middle:
      return 2 * (std::min(ahead, behind) - air);
    case svg::TextAnchor::end:
      break;
  }
  return behind - air;
}

Align align_of(svg::TextAnchor anchor) {
  return anchor == svg::TextAnchor::middle ? Align::middle
         : anchor == svg::TextAnchor::end  ? Align::right
                                           : Align::left;
}

// In as many lines as it needs, the first at the place of the field.
void add_field(LayerMaker& layers, DrawnForm& drawn, const svg::Words& words, const std::string& value,
               const std::pair<const Shapes&, const Lettering&>& on) {
  if (value.empty()) return;
  const std::string field = field_of(words);
  const auto& [shapes, lettering] = on;
  const double height = words.size / lettering.em(), room = room_of(words, height, shapes);
  FittedText fitted{{value}, height, false};
  const bool fits = lettering.width(value, height) <= room;
  if (!fits && field == "number")
    fitted = fit_whole_text(value, {room, 2.2 * height}, height, lettering);
  else if (!fits)
    fitted = fit_text(value, std::max(room, 1.0), height, lettering);
  check(fitted.height > 0, "a text has a height");
  if (fitted.cut) drawn.warnings.push_back("the title block has no room for all of the text of '" + field + "'");
  const double angle = words.angle * std::numbers::pi / 180;
  const Vec2 down(portable_sin(angle), -portable_cos(angle));
  for (std::size_t i = 0; i < fitted.lines.size(); ++i)
    layers.add({fitted.lines[i], words.at + static_cast<double>(i) * line_spacing * fitted.height * down, fitted.height,
                words.angle, align_of(words.anchor), field == "title" ? "title" : "field"},
               words.colour);
}

std::string value_in(const TitleBlock& block, const std::string& name) {
  for (const auto& [field, value] : block.fields)
    if (form_name(field) == name) return value;
  return value_of(block, name);
}

void draw_symbol(DrawnForm& drawn, const Form& form, const TitleBlock& block) {
  if (!form.symbol || !block.angle) return;
  const Vec2 room = form.symbol->size(), size = projection_symbol_size(1);
  const double height = 0.9 * std::min(room.x / size.x, room.y / size.y);
  Furniture symbol = projection_symbol(*block.angle, height, form.symbol->centre());
  const auto add = [&](scene::SheetLine line, double width, std::vector<Stroke> strokes) {
    const scene::SheetLineRow& row = scene::row_of(line);
    drawn.layers.push_back({std::string("sheet/") + row.layer, {row.name, width}, std::move(strokes)});
  };
  add(scene::SheetLine::title_block, medium_line, std::move(symbol.medium));
  add(scene::SheetLine::symbol_axes, narrow_line, std::move(symbol.narrow));
}

// Fields with values that the form does not show.
void warn_about_missing(DrawnForm& drawn, const Form& form, const TitleBlock& block) {
  for (const auto& [name, value] : block.fields) {
    const auto shows = [&field = name](const auto& item) {
      const auto* words = std::get_if<svg::Words>(&item);
      return words != nullptr && field_of(*words) == form_name(field);
    };
    const bool is_silent = value.empty() || name == "language";
    if (!is_silent && std::none_of(form.art.items.begin(), form.art.items.end(), shows))
      drawn.warnings.push_back("the template " + form.where + " has no field '" + name + "'");
  }
}

// Width and height of a PNG in pixels: bytes 16 to 23.
std::optional<Vec2> size_of_png(const std::string& bytes) {
  constexpr std::string_view signature("\x89PNG\r\n\x1a\n");
  if (!bytes.starts_with(signature) || bytes.size() < 24) return std::nullopt;
  const auto number = [&](std::size_t at) {
    double value = 0;
    for (std::size_t i = 0; i < 4; ++i) value = value * 256 + static_cast<unsigned char>(bytes[at + i]);
    return value;
  };
  const Vec2 size(number(16), number(20));
  return size.x > 0 && size.y > 0 ? std::optional(size) : std::nullopt;
}

}  // namespace

std::shared_ptr<const Form> read_form(const scene::LocatedText& file) {
  auto form = std::make_shared<Form>();
  form->where = *file;
  form->art = svg::read_artwork(read_file(*file), *file, area_names);
  const std::vector<std::string> known = known_fields();
  std::optional<Rectangle> fields;
  const svg::Words* named = nullptr;  // the first one that seems meant to be a field
  for (const auto& item : form->art.items) {
    const auto* words = std::get_if<svg::Words>(&item);
    if (words == nullptr) continue;
    if (!words->is_field && !is_field(words->name, known)) {
      if (named == nullptr && nearest_name(words->name, known)) named = words;
      continue;
    }
    const Rectangle place{words->at - Vec2(1), words->at + Vec2(1, words->size)};
    fields = fields ? united(*fields, place) : place;
  }
  if (!fields && named != nullptr)
    throw Error(ErrorKind::input, named->where, "the template has no field: '" + named->name + "' is none",
                did_you_mean(named->name, known));
  const Vec2 size = form->art.size;
  form->drawing_area =
      area_of(form->art, "drawing_area").value_or(Rectangle{{binding_margin, plain_margin}, size - Vec2(plain_margin)});
  form->title_block = area_of(form->art, "title_block");
  // A blank sheet has none: a point in the corner of the area.
  const Vec2 corner(form->drawing_area.max.x, form->drawing_area.min.y);
  if (!form->title_block) form->title_block = fields.value_or(Rectangle{corner, corner});
  form->symbol = area_of(form->art, "projection_symbol");
  form->logo = area_of(form->art, "logo");
  return form;
}

DrawnForm draw_form(const Form& form, const TitleBlock& block, const Lettering& lettering) {
  DrawnForm drawn{{}, form.art.warnings};
  LayerMaker layers("sheet/template", scene::SheetLine::form);
  std::vector<std::string> fields = known_fields();
  for (const auto& [name, value] : block.fields) fields.push_back(form_name(name));
  const Shapes shapes = stroked_shapes(form.art);
  for (const auto& item : form.art.items) {
    if (const auto* shape = std::get_if<svg::Shape>(&item)) {
      layers.add(*shape, 1, Vec2(0));
      continue;
    }
    const auto& words = std::get<svg::Words>(item);
    if (words.is_field || is_field(words.name, fields))
      add_field(layers, drawn, words, value_in(block, field_of(words)), {shapes, lettering});
    else
      layers.add({words.text, words.at, words.size / lettering.em(), words.angle, align_of(words.anchor), "caption"},
                 words.colour);
  }
  drawn.layers = layers.take();
  draw_symbol(drawn, form, block);
  warn_about_missing(drawn, form, block);
  return drawn;
}

std::shared_ptr<const Logo> read_logo(const scene::LocatedText& file) {
  auto logo = std::make_shared<Logo>();
  logo->name = *file;
  std::string bytes = read_file(*file);
  if (to_lower(*file).ends_with(".svg")) {
    logo->art = svg::read_artwork(bytes, *file);
    logo->size = logo->art.size;
    return logo;
  }
  const auto size = size_of_png(bytes);
  if (!size) throw Error(ErrorKind::input, *file, "is neither an SVG nor a PNG file", "a logo is one of them");
  logo->size = *size;
  logo->png = std::make_shared<const std::string>(std::move(bytes));
  return logo;
}

std::vector<Layer> draw_logo(const Logo& logo, const Rectangle& box) {
  const double scale = std::min(box.size().x / logo.size.x, box.size().y / logo.size.y);
  const Vec2 min = box.centre() - logo.size * (scale / 2);
  check(box.holds({min, min + logo.size * scale}, 1e-9 * (box.size().x + box.size().y)), "a logo is in its cell");
  const scene::SheetLineRow& row = scene::row_of(scene::SheetLine::logo);
  if (logo.png) {
    Layer layer{std::string("sheet/") + row.layer, {row.name, 0.25}, {}};
    layer.pictures.push_back({logo.png, logo.name, min, min + logo.size * scale});
    return {std::move(layer)};
  }
  LayerMaker layers(std::string("sheet/") + row.layer, scene::SheetLine::logo);
  const Lettering lettering;
  for (const auto& item : logo.art.items) {
    if (const auto* shape = std::get_if<svg::Shape>(&item)) {
      layers.add(*shape, scale, min);
      continue;
    }
    const auto& words = std::get<svg::Words>(item);
    layers.add({words.text, min + words.at * scale, words.size * scale / lettering.em(), words.angle,
                align_of(words.anchor), "logo"},
               words.colour);
  }
  return layers.take();
}

}  // namespace epura::sheet
