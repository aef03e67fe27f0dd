// SPDX-License-Identifier: Apache-2.0
#include "library/describe_scene.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "base/error.hpp"
#include "base/text.hpp"
#include "scene/line_roles.hpp"
#include "scene/scene_file.hpp"
#include "scene/title_fields.hpp"
#include "scene/toml_tree.hpp"

namespace epura {

namespace {

using scene::TomlContent, scene::TomlList, scene::TomlTable, scene::TomlValue;

std::string item(const std::string& list, std::size_t number) { return list + "[" + std::to_string(number) + "]"; }

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

bool is_in_memory(const Model& model) { return !model.polygons.faces.empty() || !model.polygons.points.empty(); }

template <class Value>
bool is_given(const std::optional<Value>& value) {
  return value.has_value();
}
template <class List>
bool is_given(const List& list) {
  return !list.empty();
}

/// Says a value in the words of scene files. It has a key there, and a place in the scene.
struct InWords {
  std::string key, where;

  [[nodiscard]] TomlValue value(const auto& one) const { return {key, where, where, (*this)(one)}; }

  TomlContent operator()(const std::string& text) const { return text; }
  TomlContent operator()(double number) const { return number; }
  TomlContent operator()(int number) const { return static_cast<double>(number); }
  TomlContent operator()(bool truth) const { return truth; }
  template <class Value>
  TomlContent operator()(const std::optional<Value>& given) const {
    return (*this)(*given);
  }

  // A program can give a number that is none of the enumerators, by a cast or without an initialisation.
  template <class Enum>
  requires std::is_enum_v<Enum> TomlContent operator()(Enum choice) const {
    if (static_cast<std::size_t>(choice) >= scene::Words<Enum>::list.size())
      throw Error(ErrorKind::input, where,
                  "is " + std::to_string(static_cast<long long>(choice)) + ", which none of its enumerators is");
    return std::string(scene::word_of(choice));
  }

  // Numbers of one thing, whose place is that of the thing.
  template <class Number, std::size_t count>
  TomlContent operator()(const std::array<Number, count>& numbers) const {
    TomlList list;
    for (const Number number : numbers) list.values.push_back(value(number));
    return list;
  }
  template <class Element>
  TomlContent operator()(const std::vector<Element>& elements) const {
    TomlList list;
    for (std::size_t i = 0; i < elements.size(); ++i)
      list.values.push_back(InWords{key, item(where, i)}.value(elements[i]));
    return list;
  }

  TomlContent operator()(const EdgeKinds& kinds) const;
  TomlContent operator()(const Break& part) const;
  TomlContent operator()(const Transform& transform) const;
  TomlContent operator()(const ParameterValue& parameter) const;
  TomlContent operator()(const DimensionAnchor& anchor) const;
  TomlContent operator()(const LeaderTarget& target) const;
  TomlContent operator()(const Scale& scale) const;
  TomlContent operator()(const PaperSize& size) const;
  TomlContent operator()(const TitleBlock& fields) const;

  /// A part of a scene, or the scene.
  template <class Part>
  requires std::is_aggregate_v<Part> TomlContent operator()(const Part& part) const {
    TomlTable table;
    each_option(part, [&](const char* option, const char* member, const auto& given) {
      if (is_given(given)) table.values.push_back(InWords{option, of_member(member)}.value(given));
    });
    complete(table, part);
    return table;
  }

 private:
  [[nodiscard]] std::string of_member(const std::string& name) const {
    return where.empty() ? name : where + "." + name;
  }
  [[nodiscard]] TomlValue table_of(const std::string& name, const auto& one) const {
    return {key, where, where, TomlTable{{InWords{name, where}.value(one)}}};
  }

  // Adds what is no option of its own.
  void complete(TomlTable&, const auto&) const {}
  void complete(TomlTable& table, const Model& model) const;
  void complete(TomlTable& table, const View& view) const;
};

TomlContent InWords::operator()(const EdgeKinds& kinds) const {
  TomlList list;
  for (const auto& [kind, member] : scene::chosen_edge_kinds)
    if (kinds.*member) list.values.push_back(value(std::string(scene::word_of(kind))));
  return list;
}

TomlContent InWords::operator()(const Break& part) const {
  constexpr std::array axes{"x:", "y:", "z:"};
  if (part.axis < 0 || part.axis >= static_cast<int>(axes.size()))
    throw Error(ErrorKind::input, where, "has axis " + std::to_string(part.axis), "0 is x, 1 is y, 2 is z");
  const auto word = [](double place) { return std::isinf(place) ? std::string() : format_number(place); };
  if (part.from == HUGE_VAL || part.to == -HUGE_VAL)
    throw Error(ErrorKind::input, where, "leaves nothing out: it begins or ends at the wrong infinity");
  return axes[static_cast<std::size_t>(part.axis)] + word(part.from) + ":" + word(part.to);
}

TomlContent InWords::operator()(const Transform& transform) const {
  const auto* matrix = std::get_if<std::array<double, 12>>(&transform);
  if (matrix == nullptr) return std::get<std::string>(transform);
  TomlList rows;
  for (std::size_t i = 0; i < matrix->size(); i += 4)
    rows.values.push_back(value(std::array{(*matrix)[i], (*matrix)[i + 1], (*matrix)[i + 2], (*matrix)[i + 3]}));
  return rows;
}

TomlContent InWords::operator()(const ParameterValue& parameter) const {
  return std::visit([this](const auto& one) { return (*this)(one); }, parameter);
}

TomlContent InWords::operator()(const DimensionAnchor& anchor) const {
  if (const auto* vertex = std::get_if<std::array<int, 2>>(&anchor)) return (*this)(*vertex);
  if (const auto* feature = std::get_if<std::string>(&anchor)) return *feature;
  return table_of("point", std::get<std::array<double, 3>>(anchor)).content;
}

TomlContent InWords::operator()(const LeaderTarget& target) const {
  if (const auto* page = std::get_if<std::array<double, 2>>(&target)) return table_of("page", *page).content;
  if (const auto* vertex = std::get_if<std::array<int, 2>>(&target)) return (*this)(*vertex);
  if (const auto* feature = std::get_if<std::string>(&target)) return *feature;
  return table_of("point", std::get<std::array<double, 3>>(target)).content;
}

TomlContent InWords::operator()(const Scale& scale) const {
  if (const auto* number = std::get_if<double>(&scale)) return *number;
  return std::string(std::get<AutomaticScale>(scale) == AutomaticScale::standard ? "auto" : "fit");
}

TomlContent InWords::operator()(const PaperSize& size) const {
  if (const auto* name = std::get_if<std::string>(&size)) return *name;
  if (const auto* automatic = std::get_if<AutomaticSize>(&size))
    return std::string(*automatic == AutomaticSize::cut ? "none" : "auto");
  const auto [width, height] = std::get<std::array<double, 2>>(size);
  return format_number(width) + "x" + format_number(height);
}

TomlContent InWords::operator()(const TitleBlock& fields) const {
  TomlTable table, free;
  for (const auto& [name, text] : fields) {
    const auto has_name = [&name = name](const scene::TitleField& field) { return field.name == name; };
    const bool is_known = std::any_of(scene::title_fields().begin(), scene::title_fields().end(), has_name);
    (is_known ? table : free).values.push_back(InWords{name, where}.value(text));
  }
  if (!free.values.empty()) table.values.push_back({"free", where, where, std::move(free)});
  return table;
}

void InWords::complete(TomlTable& table, const Model& model) const {
  const bool in_memory = is_in_memory(model);
  if (in_memory != model.file.empty())
    throw Error(ErrorKind::input, where, in_memory ? "has both a file and polygons" : "has neither a file nor polygons",
                "give exactly one of them");
  if (in_memory && !model.content.empty())
    throw Error(ErrorKind::input, where, "has both content and polygons", "give exactly one of them");
  if (in_memory) table.values.push_back({"file", where, where, where});
  for (TomlValue& option : table.values)
    if (option.key == "file" && model.file == "-") option.content = "./-";
}

void InWords::complete(TomlTable& table, const View& view) const {
  for (TomlValue& option : table.values) {
    if (option.key != "projection" || view.parameters.empty()) continue;
    TomlTable request{{InWords{"name", option.where}.value(view.projection)}};
    for (const auto& [name, parameter] : view.parameters)
      request.values.push_back(InWords{name, of_member("parameters")}.value(parameter));
    option.content = std::move(request);
  }
  if (!view.automatic_breaks) return;
  const std::string member = of_member("automatic_breaks");
  if (!view.breaks.empty()) throw Error(ErrorKind::input, member, "stands beside other breaks", "give one of them");
  table.values.push_back(InWords{"break", member}.value(std::string("auto")));
}

// Models in memory have no file.
void take_content(const Model& model, const std::string& where, scene::ModelDescription& description) {
  if (is_in_memory(model)) {
    if (!description.name.given()) description.name = {where, where};
    description.file = {};
    description.soup = soup_of(model.polygons, where + ".polygons");
  } else if (!model.content.empty()) {
    description.content = std::make_shared<const std::string>(model.content);
  }
}

}  // namespace

scene::SceneDescription describe_scene(const Scene& scene) {
  if (scene.models.empty()) throw Error(ErrorKind::input, "models", "there is none", "give a file, or polygons");
  scene::SceneDescription description = scene::scene_of({"", "scene", "scene", InWords{}(scene)});
  for (std::size_t i = 0; i < scene.models.size(); ++i)
    take_content(scene.models[i], item("models", i), description.models[i]);
  return description;
}

}  // namespace epura
