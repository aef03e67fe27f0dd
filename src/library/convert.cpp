// SPDX-License-Identifier: Apache-2.0
#include "library/convert.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <type_traits>
#include <utility>

#include "base/error.hpp"
#include "base/largest_number.hpp"
#include "base/text.hpp"
#include "drawing/drawing.hpp"
#include "library/own_projections.hpp"
#include "scene/line_roles.hpp"

namespace epura {

namespace {

std::string item(const std::string& list, std::size_t number) { return list + "[" + std::to_string(number) + "]"; }

double checked(double number, const std::string& where, double min = -HUGE_VAL, double max = HUGE_VAL) {
  if (!std::isfinite(number)) throw Error(ErrorKind::input, where, "is not a finite number");
  min = std::max(min, -largest_number);
  max = std::min(max, largest_number);
  if (number < min || number > max)
    throw Error(ErrorKind::input, where,
                "is " + format_number(number) + ", allowed is " + format_number(min) + " to " + format_number(max));
  return number;
}

scene::Located<double> located(const std::optional<double>& number, const std::string& where) {
  if (!number) return {};
  return {checked(*number, where), where};
}

scene::LocatedText located(const std::string& text, const std::string& where) {
  if (text.empty()) return {};
  return {text, where};
}

// A program can give a number that is none of the enumerators, by a cast or without an initialisation.
template <class Enum>
scene::Located<Enum> chosen(Enum value, const std::string& where) {
  if (static_cast<std::size_t>(value) >= scene::Words<Enum>::list.size())
    throw Error(ErrorKind::input, where,
                "is " + std::to_string(static_cast<long long>(value)) + ", which none of its enumerators is");
  return {value, where};
}

template <class Value>
scene::Located<Value> located(const std::optional<Value>& value, const std::string& where) {
  if constexpr (std::is_enum_v<Value>)
    if (value) return chosen(*value, where);
  return {value, where};
}

template <std::size_t count>
glm::vec<count, double> vector_of(const std::array<double, count>& numbers, const std::string& where) {
  glm::vec<count, double> vector;
  for (std::size_t i = 0; i < count; ++i) vector[static_cast<int>(i)] = checked(numbers[i], where);
  return vector;
}

// Each of a list of numbers counts `count` things.
void expect_indices(const std::vector<int>& numbers, std::size_t count, const std::string& what,
                    const std::string& where) {
  for (const int number : numbers)
    if (number < 0 || number >= static_cast<int>(count))
      throw Error(ErrorKind::input, where, "there is no " + what + " " + std::to_string(number),
                  "they are numbered from 0 to " + std::to_string(static_cast<int>(count) - 1));
}

void take_bodies(const Polygons& polygons, const std::string& where, mesh::Soup& soup) {
  if (polygons.bodies.empty()) return;
  if (polygons.bodies.size() != polygons.faces.size())
    throw Error(ErrorKind::input, where + ".bodies", "has " + std::to_string(polygons.bodies.size()) + " numbers",
                "give one for each of the " + std::to_string(polygons.faces.size()) + " faces");
  expect_indices(polygons.bodies, polygons.body_names.size(), "body name", where + ".bodies");
  soup.face_body = polygons.bodies;
  soup.body_names = polygons.body_names;
}

std::shared_ptr<const mesh::Soup> soup_of(const Polygons& polygons, const std::string& where) {
  auto soup = std::make_shared<mesh::Soup>();
  soup->format = "memory";
  soup->points = polygons.points;
  soup->single_precision = polygons.single_precision;
  const std::size_t points = polygons.points.size();
  for (std::size_t face = 0; face < polygons.faces.size(); ++face) {
    expect_indices(polygons.faces[face], points, "point", item(where + ".faces", face));
    soup->corners.insert(soup->corners.end(), polygons.faces[face].begin(), polygons.faces[face].end());
    soup->end_face();
  }
  for (std::size_t line = 0; line < polygons.polylines.size(); ++line) {
    expect_indices(polygons.polylines[line], points, "point", item(where + ".polylines", line));
    soup->add_wire(polygons.polylines[line]);
  }
  take_bodies(polygons, where, *soup);
  return soup;
}

scene::ModelDescription describe(const Model& model, const std::string& where) {
  const bool in_memory = !model.polygons.faces.empty() || !model.polygons.points.empty();
  if (in_memory != model.file.empty())
    throw Error(ErrorKind::input, where, in_memory ? "has both a file and polygons" : "has neither a file nor polygons",
                "give exactly one of them");
  scene::ModelDescription description;
  if (in_memory)
    description.soup = soup_of(model.polygons, where + ".polygons");
  else
    description.file = {model.file == "-" ? "./-" : model.file, where + ".file"};
  if (!model.content.empty()) {
    if (in_memory) throw Error(ErrorKind::input, where, "has both content and polygons", "give exactly one of them");
    description.content = std::make_shared<const std::string>(model.content);
  }
  description.name = located(in_memory && model.name.empty() ? where : model.name, where + ".name");
  description.unit = located(model.unit, where + ".unit");
  description.up = located(model.up, where + ".up");
  const std::array<double, 12>& m = model.transform;
  for (const double number : m) checked(number, where + ".transform");
  description.transform = {
      rows({m[0], m[1], m[2], m[3]}, {m[4], m[5], m[6], m[7]}, {m[8], m[9], m[10], m[11]}, {0, 0, 0, 1}),
      where + ".transform"};
  description.line = chosen(model.line, where + ".line");
  description.surfaces = chosen(model.surfaces, where + ".surfaces");
  description.hidden = located(model.hidden, where + ".hidden");
  return description;
}

std::string text_of(const ParameterValue& value) {
  if (const auto* number = std::get_if<double>(&value)) return format_number(*number);
  if (const auto* word = std::get_if<std::string>(&value)) return *word;
  std::string text;
  for (const double number : std::get<std::vector<double>>(value))
    text += (text.empty() ? "" : ",") + format_number(number);
  return text;
}

scene::BreakChoice break_choice(const View& view, const std::string& where) {
  scene::BreakChoice choice;
  choice.automatic = view.automatic_breaks;
  for (const Break& one : view.breaks) {
    if (one.axis < 0 || one.axis > 2)
      throw Error(ErrorKind::input, where, "has axis " + std::to_string(one.axis), "0 is x, 1 is y, 2 is z");
    if (!(one.from < one.to)) throw Error(ErrorKind::input, where, "has a place 'from' that is not below 'to'");
    for (const double place : {one.from, one.to})
      if (!std::isinf(place)) checked(place, where);
    choice.parts.push_back({one.axis, one.from, one.to});
  }
  return choice;
}

scene::ViewDescription describe(const View& view, const std::string& where) {
  scene::ViewDescription description;
  scene::ProjectionRequest request{view.projection, {}};
  for (const auto& [name, value] : view.parameters) request.assignments.emplace_back(name, text_of(value));
  description.projection = {std::move(request), where + ".projection"};
  description.name = located(view.name, where + ".name");
  description.hidden = located(view.hidden, where + ".hidden");
  description.hatch = located(view.hatch, where + ".hatch");
  description.edges = {view.edges, where + ".edges"};
  if (view.crease_angle)
    description.crease_angle = {checked(*view.crease_angle, where + ".crease_angle", 0, 180), where + ".crease_angle"};
  if (view.weak_crease_angle)
    description.weak_crease_angle = {checked(*view.weak_crease_angle, where + ".weak_crease_angle", 0, 180),
                                     where + ".weak_crease_angle"};
  description.least_crease = {checked(view.least_crease, where + ".least_crease", 0, 100), where + ".least_crease"};
  description.join_within = {checked(view.join_within, where + ".join_within", 0, 1), where + ".join_within"};
  description.layers = chosen(view.layers, where + ".layers");
  description.near = located(view.near, where + ".near");
  description.far = located(view.far, where + ".far");
  if (!view.construction.empty()) {
    description.construction = {scene::ConstructionChoice(), where + ".construction"};
    for (const std::string& one : view.construction)
      description.construction.value->push_back(scene::parse_construction(one, where + ".construction"));
  }
  if (view.scale) {
    if (!(checked(*view.scale, where + ".scale") > 0))
      throw Error(ErrorKind::input, where + ".scale", "is not above 0");
    description.scale = {scene::ScaleChoice{view.scale, false}, where + ".scale"};
  }
  if (view.at) description.at = {vector_of(*view.at, where + ".at"), where + ".at"};
  description.sheet = {static_cast<int>(checked(view.sheet, where + ".sheet", 1)), where + ".sheet"};
  description.section = located(view.section, where + ".section");
  description.label = located(view.label, where + ".label");
  description.detail = located(view.detail, where + ".detail");
  if (view.automatic_breaks || !view.breaks.empty())
    description.breaks = {break_choice(view, where + ".breaks"), where + ".breaks"};
  if (view.break_line != BreakLine::zigzag) description.break_line = chosen(view.break_line, where + ".break_line");
  description.half = located(view.half, where + ".half");
  if (description.detail.given()) description.projection.value.reset();
  return description;
}

scene::StyleDescription describe(const Style& style, const std::string& where) {
  scene::StyleDescription description;
  description.match = {style.match, where + ".match"};
  description.line = located(style.line, where + ".line");
  description.hidden = located(style.hidden, where + ".hidden");
  if (style.colour) {
    const auto part = [&](std::size_t i) {
      return static_cast<int>(checked((*style.colour)[i], where + ".colour", 0, 255));
    };
    description.colour = {scene::ColourChoice{.colour = {part(0), part(1), part(2)}}, where + ".colour"};
  }
  if (style.file_colour) description.colour = {scene::ColourChoice{.of_file = true}, where + ".file_colour"};
  description.hatch = located(style.hatch, where + ".hatch");
  if (style.hatch_angle)
    description.hatch_angle = {checked(*style.hatch_angle, where + ".hatch_angle", 0, 180), where + ".hatch_angle"};
  if (style.hatch_pitch)
    description.hatch_pitch = {checked(*style.hatch_pitch, where + ".hatch_pitch", 0.5, 50), where + ".hatch_pitch"};
  if (!style.cut) description.cut = {false, where + ".cut"};
  if (!style.drawn) description.drawn = {false, where + ".drawn"};
  return description;
}

scene::SectionDescription describe(const Section& section, const std::string& where) {
  if (section.name.empty())
    throw Error(ErrorKind::input, where + ".name", "is empty", "views refer to sections by name");
  scene::SectionDescription description{
      {section.name, where}, vector_of(section.point, where + ".point"), vector_of(section.normal, where + ".normal")};
  if (!section.beyond) description.beyond = {false, where + ".beyond"};
  if (section.aligned) description.aligned = {true, where + ".aligned"};
  if (section.path.empty()) return description;
  std::vector<Vec3> path;
  for (const auto& corner : section.path) path.push_back(vector_of(corner, where + ".path"));
  description.path = {std::move(path), where + ".path"};
  return description;
}

scene::RevolvedDescription describe(const Revolved& revolved, const std::string& where) {
  return {located(revolved.view, where + ".view"),
          {vector_of(revolved.point, where + ".point"), where + ".point"},
          {vector_of(revolved.normal, where + ".normal"), where + ".normal"}};
}

scene::DetailDescription describe(const Detail& detail, const std::string& where) {
  if (detail.name.empty()) throw Error(ErrorKind::input, where + ".name", "is empty", "views refer to details by name");
  scene::DetailDescription description{{detail.name, where},
                                       located(detail.view, where + ".view"),
                                       {vector_of(detail.centre, where + ".centre"), where + ".centre"}};
  const auto above_0 = [&](double value, const std::string& member) {
    if (!(checked(value, where + member) > 0)) throw Error(ErrorKind::input, where + member, "is not above 0");
    return value;
  };
  if (detail.radius) description.radius = {above_0(*detail.radius, ".radius"), where + ".radius"};
  if (detail.size)
    description.size = {Vec2(above_0((*detail.size)[0], ".size"), above_0((*detail.size)[1], ".size")),
                        where + ".size"};
  return description;
}

scene::ExplodeDescription describe(const Explode& explode, const std::string& where) {
  scene::ExplodeDescription description{.where = where};
  description.match = located(explode.match, where + ".match");
  if (explode.move) description.move = {vector_of(*explode.move, where + ".move"), where + ".move"};
  if (explode.factor) description.factor = {checked(*explode.factor, where + ".factor", 0), where + ".factor"};
  description.view = located(explode.view, where + ".view");
  description.trace = located(explode.trace, where + ".trace");
  return description;
}

scene::Anchor anchor_of(const DimensionAnchor& anchor, const std::string& where) {
  if (const auto* vertex = std::get_if<std::array<int, 2>>(&anchor)) return *vertex;
  return vector_of(std::get<std::array<double, 3>>(anchor), where);
}

scene::DimensionDescription describe(const Dimension& dimension, const std::string& where) {
  scene::DimensionDescription description;
  description.where = where;
  description.view = located(dimension.view, where + ".view");
  description.type = chosen(dimension.type, where + ".type");
  description.direction = located(dimension.direction, where + ".direction");
  for (const DimensionAnchor& anchor : dimension.anchors)
    description.anchors.push_back(anchor_of(anchor, where + ".anchors"));
  if (dimension.offset)
    description.offset = {checked(*dimension.offset, where + ".offset", -scene::longest_side, scene::longest_side),
                          where + ".offset"};
  description.text = located(dimension.text, where + ".text");
  description.tolerance = located(dimension.tolerance, where + ".tolerance");
  if (dimension.holes != HoleDimensions::notes) description.holes = chosen(dimension.holes, where + ".holes");
  if (dimension.limits) description.limits = {true, where + ".limits"};
  description.arrangement = located(dimension.arrangement, where + ".arrangement");
  if (dimension.arrangement && dimension.type != DimensionType::linear && dimension.type != DimensionType::automatic)
    throw Error(ErrorKind::input, description.arrangement.where,
                "a dimension of type '" + std::string(scene::word_of(dimension.type)) + "' has no arrangement",
                "it belongs to the types 'linear' and 'auto'");
  return description;
}

scene::ThreadDescription describe(const Thread& thread, const std::string& where) {
  scene::ThreadDescription description;
  description.where = where;
  description.thread = {thread.thread, where + ".thread"};
  description.at = {anchor_of(thread.at, where + ".at"), where + ".at"};
  if (thread.depth) {
    if (!(checked(*thread.depth, where + ".depth") > 0))
      throw Error(ErrorKind::input, where + ".depth", "must be above 0");
    description.depth = located(thread.depth, where + ".depth");
  }
  description.equal = {thread.equal, where + ".equal"};
  description.callout = {thread.callout, where + ".callout"};
  description.view = located(thread.view, where + ".view");
  return description;
}

scene::PaperChoice paper_of(const PaperSize& size, const std::string& where) {
  if (const auto* name = std::get_if<std::string>(&size)) return scene::parse_paper_size(*name, where);
  if (const auto* automatic = std::get_if<AutomaticSize>(&size))
    return {*automatic == AutomaticSize::cut ? scene::PaperChoice::Kind::none : scene::PaperChoice::Kind::automatic,
            0,
            {0, 0}};
  const auto [width, height] = std::get<std::array<double, 2>>(size);
  return scene::parse_paper_size(format_number(width) + "x" + format_number(height), where);
}

scene::ScaleChoice scale_of(const Scale& scale, const std::string& where) {
  if (const auto* automatic = std::get_if<AutomaticScale>(&scale))
    return {std::nullopt, *automatic == AutomaticScale::standard};
  return scene::parse_scale(format_number(std::get<double>(scale)), where);
}

scene::SheetDescription describe(const SheetOptions& sheet, const std::string& where) {
  scene::SheetDescription description;
  description.where = where;
  if (sheet.size) description.size = {paper_of(*sheet.size, where + ".size"), where + ".size"};
  description.orientation = chosen(sheet.orientation, where + ".orientation");
  if (sheet.scale) description.scale = {scale_of(*sheet.scale, where + ".scale"), where + ".scale"};
  description.angle = chosen(sheet.angle, where + ".angle");
  description.layout = chosen(sheet.layout, where + ".layout");
  description.fit = chosen(sheet.fit, where + ".fit");
  description.frame = chosen(sheet.frame, where + ".frame");
  description.dimension_unit = chosen(sheet.dimension_unit, where + ".dimension_unit");
  description.decimal_sign = chosen(sheet.decimal_sign, where + ".decimal_sign");
  description.font = located(sheet.font, where + ".font");
  description.form = located(sheet.sheet_template, where + ".sheet_template");
  description.logo = located(sheet.logo, where + ".logo");
  description.style = located(sheet.style, where + ".style");
  for (const auto& [name, text] : sheet.title_block)
    description.title_block.emplace_back(name, scene::LocatedText{text, where + ".title_block"});
  return description;
}

template <class Description, class Part>
void describe_all(std::vector<Description>& descriptions, const std::vector<Part>& parts, const std::string& list) {
  for (std::size_t i = 0; i < parts.size(); ++i) descriptions.push_back(describe(parts[i], item(list, i)));
}

std::array<double, 2> pair_of(const Vec2& p) { return {p.x, p.y}; }

}  // namespace

scene::SceneDescription describe_scene(const Scene& scene) {
  if (scene.models.empty()) throw Error(ErrorKind::input, "models", "there is none", "give a file, or polygons");
  scene::SceneDescription description;
  describe_all(description.models, scene.models, "models");
  describe_all(description.views, scene.views, "views");
  describe_all(description.styles, scene.styles, "styles");
  describe_all(description.sections, scene.sections, "sections");
  describe_all(description.revolved, scene.revolved, "revolved");
  describe_all(description.details, scene.details, "details");
  describe_all(description.explosions, scene.explosions, "explosions");
  describe_all(description.dimensions, scene.dimensions, "dimensions");
  describe_all(description.threads, scene.threads, "threads");
  describe_all(description.sheets, scene.sheets, "sheets");
  return description;
}

pipeline::RunOptions run_options_of(const Settings& settings) {
  pipeline::RunOptions options;
  options.plugin_path = settings.plugin_path;
  options.projections = entries_of(settings.projections);
  options.allow_outside = settings.allow_outside;
  if (settings.wireframe) options.visibility = pipeline::Visibility::none;
  if (settings.contact) options.contact = checked(*settings.contact, "settings.contact", 0);
  if (settings.arcs) options.arcs = checked(*settings.arcs, "settings.arcs", 1e-6, 1);
  options.centre_lines = settings.centre_lines;
  if (settings.verify) {
    options.verify = true;
    options.verify_samples = static_cast<int>(checked(*settings.verify, "settings.verify", 1, 1e7));
  }
  if (settings.time_limit) options.time_limit = checked(*settings.time_limit, "settings.time_limit", 0);
  options.threads = static_cast<int>(checked(settings.threads, "settings.threads", 0, 1024));
  if (settings.max_error) options.max_error = checked(*settings.max_error, "settings.max_error", 1e-12, 1e6);
  options.error_note = settings.error_note;
  options.keeps_drawings = options.judges = true;
  return options;
}

DrawnView drawn_view(const drawing::ViewDrawing& drawing, int sheet) {
  DrawnView view{drawing.name, drawing.projection.name, sheet, drawing.scale, {}, {}, {}, {}};
  for (int row = 0; row < 4; ++row)
    for (int column = 0; column < 4; ++column)
      view.world_to_page[static_cast<std::size_t>(4 * row + column)] = drawing.world_to_page[column][row];
  view.lines.reserve(drawing.segments.size());
  for (const drawing::Segment& segment : drawing.segments)
    view.lines.push_back({pair_of(segment.from), pair_of(segment.to), segment.kind, segment.visible,
                          drawing.number_in_scene(segment.model), segment.body, segment.edge, segment.t});
  for (const drawing::Chain& chain : drawing.chains)
    for (const drawing::CurvePart& curve : chain.curves)
      view.arcs.push_back(
          {pair_of(curve.centre), pair_of(curve.u), pair_of(curve.v), curve.from, curve.to, chain.kind, chain.visible});
  return view;
}

ErrorBudget error_budget(const report::ViewError& error) {
  ErrorBudget budget;
  for (std::size_t i = 0; i < report::error_terms.size(); ++i) {
    const auto term = static_cast<report::ErrorTerm>(i);
    if (term == report::ErrorTerm::writing || error[term] == 0) continue;
    budget.total += error[term];
    budget.terms.push_back(
        {row_of(term).name, error[term], report::evidence_names[static_cast<std::size_t>(error.evidence(term))]});
  }
  std::stable_sort(budget.terms.begin(), budget.terms.end(),
                   [](const ErrorTerm& a, const ErrorTerm& b) { return a.mm > b.mm; });
  return budget;
}

std::vector<SheetLayer> layers_of(const sheet::Sheet& sheet) {
  std::vector<SheetLayer> layers;
  for (const sheet::Layer& layer : sheet.layers) {
    SheetLayer& made = layers.emplace_back(SheetLayer{layer.name, layer.style.width, {}});
    for (const sheet::Stroke& stroke : layer.strokes) {
      auto& points = made.strokes.emplace_back();
      for (const Vec2& p : stroke.points) points.push_back(pair_of(p));
      if (stroke.closed && !points.empty()) points.push_back(points.front());
    }
  }
  return layers;
}

}  // namespace epura
