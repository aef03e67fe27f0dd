// SPDX-License-Identifier: Apache-2.0
#include "scene/scene_file.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <set>

#include "base/error.hpp"
#include "base/folder.hpp"
#include "base/text.hpp"
#include "importer/bounds.hpp"
#include "importer/read_model.hpp"
#include "scene/arrow_views.hpp"
#include "scene/body_styles.hpp"
#include "scene/details.hpp"
#include "scene/scene_keys.hpp"
#include "scene/toml_tree.hpp"
#include "scene/view_names.hpp"

namespace epura::scene {

namespace {

namespace fs = std::filesystem;

using Names = std::set<std::string>;

/// The numbers of the models with each name to which dimensions may refer.
using ModelNumbers = std::map<std::string, std::vector<int>>;

ModelNumbers numbers_of(const std::vector<ModelDescription>& models) {
  ModelNumbers numbers;
  for (int i = 0; i < static_cast<int>(models.size()); ++i) {
    const ModelDescription& model = models[std::size_t(i)];
    numbers[name_of(model)].push_back(i);
  }
  return numbers;
}

/// Returns the names of parts. Throws Error{input} for the second of two parts with one name.
template <class Part>
Names names_of(const std::vector<Part>& parts, const std::string& what) {
  Names names;
  for (const Part& part : parts)
    if (part.name.given() && !names.insert(*part.name).second)
      refuse_input(part.name.where, "'" + *part.name + "' is the name of an earlier " + what, "names must be unique");
  return names;
}

void refuse_unknown(const LocatedText& name, const Names& names, const std::string& what) {
  if (!name.given() || names.contains(*name)) return;
  const std::vector<std::string> known(names.begin(), names.end());
  refuse_input(name.where, "there is no " + what + " '" + *name + "'",
               known.empty() ? "there is no [[" + what + "]]" : did_you_mean(*name, known));
}

void check_views(const SceneDescription& scene, const Names& sections) {
  const std::size_t sheets = scene.sheets.size();
  for (const ViewDescription& view : scene.views) {
    refuse_unknown(view.section, sections, "section");
    if (const int sheet = view.sheet.value_or(1); std::size_t(sheet) > sheets)
      refuse_input(view.projection.where,
                   "the view is for sheet " + std::to_string(sheet) + " of " + std::to_string(sheets),
                   "add a [[sheet]]");
  }
}

/// Keys of the anchors of a dimension, in the order of DimensionDescription::anchors.
const std::vector<std::string>& anchor_keys(DimensionType type) {
  // In order of DimensionType.
  static const std::array<std::vector<std::string>, 8> keys = {
      {{"from", "to"}, {"from", "to"}, {"corner", "from", "to"}, {"at"}, {"at"}, {"at"}, {}, {"from"}}};
  return keys[static_cast<std::size_t>(type)];
}

// Returns the number of an anchor's model.
int model_of(const AnchorWords& anchor, const ModelNumbers& models, int count) {
  if (const int* number = std::get_if<int>(&anchor.model)) {
    if (*number < count) return *number;
    refuse_input(anchor.where, "there is no model " + std::to_string(*number),
                 "models are numbered from 0 to " + std::to_string(count - 1));
  }
  const auto& name = std::get<std::string>(anchor.model);
  const auto found = models.find(name);
  if (found == models.end()) {
    std::vector<std::string> known;
    for (const auto& [other, numbers] : models) known.push_back(other);
    refuse_input(anchor.where, "there is no model '" + name + "'", did_you_mean(name, known));
  }
  if (found->second.size() > 1)
    refuse_input(anchor.where, "several models are called '" + name + "'",
                 "give them different names, or use a number");
  return found->second.front();
}

/// The models and views to which dimensions refer.
struct Subjects {
  const std::vector<ModelDescription>& models;
  ModelNumbers numbers;
  Names views;
};

Anchor anchor_of(const AnchorWords& words, const Subjects& subjects) {
  if (words.point) return *words.point;
  if (!words.feature.text.empty()) return words.feature;
  const int model = model_of(words, subjects.numbers, static_cast<int>(subjects.models.size()));
  if (!subjects.models[std::size_t(model)].drawn.value_or(true))
    refuse_input(words.where, "the model is not drawn and has no vertices", "give the position as {point = [x, y, z]}");
  return std::array<int, 2>{model, words.vertex};
}

// Lengths between several places, in an arrangement.
void add_places(DimensionDescription& dimension, const DimensionWords& words, const Subjects& subjects) {
  for (const auto& [key, anchor] : words.anchors) {
    if (key != "points")
      refuse_input(anchor.where, "a dimension with an arrangement has no '" + key + "'", "its places are 'points'");
    dimension.anchors.push_back(anchor_of(anchor, subjects));
  }
  if (dimension.anchors.size() < 2)
    refuse_input(dimension.where, "a dimension with an arrangement needs two or more places",
                 "points = [{point = [x, y, z]}, ...]");
}

// Automatic sizes have their places, and get what can be said of them.
void expect_match(const DimensionWords& words) {
  const DimensionDescription& dimension = words.description;
  const std::string where = dimension.match.where;
  if (!words.anchors.empty() || dimension.holes.given() || dimension.arrangement.given())
    refuse_input(where, "a dimension with 'match' changes sizes that have their places",
                 "omit 'match', or the keys that say what is measured and how it is arranged");
  if (dimension.type.value == DimensionType::automatic)
    refuse_input(dimension.type.where, "no single size is of type 'auto'", "omit 'type', or name that of the size");
  if (!dimension.tolerance.given() && !dimension.text.given() && !dimension.offset.given() && !dimension.name.given())
    refuse_input(where, "nothing is said of the sizes that match",
                 "add a 'tolerance', a 'text', an 'offset', a 'name'");
  if (dimension.name.given() && !dimension.view.given())
    refuse_input(dimension.name.where, "a size with a name needs its view", "add 'view'");
}

// Throws Error{input} for keys that belong to other types.
void expect_keys_of_type(const DimensionDescription& dimension) {
  if (!dimension.type.given())
    refuse_input(dimension.where, "[[dimension]] lacks 'type'",
                 "type of the dimension; or 'match' for automatic sizes");
  const DimensionType type = *dimension.type;
  const std::string has_no = "a dimension of type '" + std::string(word_of(type)) + "' has no '";
  if (dimension.holes.given() && type != DimensionType::automatic)
    refuse_input(dimension.holes.where, has_no + "holes'", "it belongs to type 'auto'");
  if (dimension.arrangement.given() && type != DimensionType::automatic && type != DimensionType::linear)
    refuse_input(dimension.arrangement.where, has_no + "arrangement'", "it belongs to the types 'linear' and 'auto'");
}

DimensionDescription dimension_of(const DimensionWords& words, const Subjects& subjects) {
  DimensionDescription dimension = words.description;
  if (dimension.match.given())
    expect_match(words);
  else
    expect_keys_of_type(dimension);
  // Views of the command line are not known yet.
  if (!subjects.views.empty()) refuse_unknown(dimension.view, subjects.views, "view");
  if (dimension.match.given()) return dimension;
  if (dimension.arrangement.given() && *dimension.type == DimensionType::linear) {
    add_places(dimension, words, subjects);
    return dimension;
  }
  const std::string type(word_of(*dimension.type));
  const std::vector<std::string>& keys = anchor_keys(*dimension.type);
  for (const std::string& key : keys) {
    const auto found = std::find_if(words.anchors.begin(), words.anchors.end(),
                                    [&key](const auto& anchor) { return anchor.first == key; });
    if (found == words.anchors.end() && *dimension.type == DimensionType::automatic) continue;
    if (found == words.anchors.end())
      refuse_input(dimension.where, "a dimension of type '" + type + "' lacks '" + key + "'",
                   "[model, vertex], {point = [x, y, z]} or a feature, \"hole 3\"");
    dimension.anchors.push_back(anchor_of(found->second, subjects));
  }
  for (const auto& [key, anchor] : words.anchors)
    if (std::find(keys.begin(), keys.end(), key) == keys.end())
      refuse_input(anchor.where, "a dimension of type '" + type + "' has no '" + key + "'",
                   key == "points" ? "'points' need an arrangement, such as arrangement = \"chain\""
                   : keys.empty()  ? "it has no anchors"
                                   : did_you_mean(key, keys));
  return dimension;
}

ThreadDescription thread_of(const ThreadWords& words, const Subjects& subjects) {
  ThreadDescription thread = words.description;
  thread.at = {anchor_of(*words.at, subjects), words.at.where};
  if (!subjects.views.empty()) refuse_unknown(thread.view, subjects.views, "view");
  if (thread.view.given() && !thread.callout.value_or(true))
    refuse_input(thread.view.where, "a thread without a dimension has no view", "omit 'view', or 'callout'");
  return thread;
}

Located<FeatureName> feature_of(const Located<AnchorWords>& words, const std::string& what = "a requirement") {
  if (!words.given()) return {};
  if (words->feature.text.empty())
    refuse_input(words.where, what + " is about a feature, not a point",
                 "write \"hole 3\" or \"face 12\": epura info and epura new-scene number them");
  return {words->feature, words.where};
}

/// What a requirement of a type says, and must say.
struct RequirementRule {
  std::string_view key;
  bool is_given, may_be_given, is_needed;
};

RequirementDescription requirement_of(const RequirementWords& words) {
  RequirementDescription one = words.description;
  one.feature = feature_of(words.feature);
  one.to = feature_of(words.to);
  const std::string& type = *one.type;
  const bool is_datum = type == "datum", is_between = type == "linear distance" || type == "angle";
  const bool is_dimension = is_between || type == "diameter" || type == "radius";
  const auto row = std::find_if(characteristics.begin(), characteristics.end(),
                                [&type](const CharacteristicRow& known) { return known.name == type; });
  const bool is_tolerance = row != characteristics.end();
  if (!is_datum && !is_dimension && !is_tolerance) {
    std::vector<std::string> known{"diameter", "radius", "linear distance", "angle", "datum"};
    for (const CharacteristicRow& other : characteristics) known.emplace_back(other.name);
    refuse_input(one.type.where, "there is no type of requirement '" + type + "'", did_you_mean(type, known));
  }
  if (is_tolerance) one.frame.characteristic = row->characteristic;
  const bool has_datums = !one.frame.datums.empty();
  for (const auto& [key, is_given, may_be_given, is_needed] :
       {RequirementRule{"to", one.to.given(), is_between, is_between},
        {"value", one.value.given(), is_dimension, false},
        {"tolerance", one.tolerance.given(), is_dimension, false},
        {"zone", !one.frame.zone.empty(), is_tolerance, is_tolerance},
        {"datums", has_datums, is_tolerance && row->datums != DatumRule::none,
         is_tolerance && row->datums == DatumRule::required},
        {"letter", one.letter.given(), is_datum, is_datum}})
    if (is_given ? !may_be_given : is_needed)
      refuse_input(
          one.where,
          "a requirement of type '" + type + "' " + (is_given ? "has no '" : "lacks '") + std::string(key) + "'",
          is_given ? "omit it" : "docs/scenes.md says what it is");
  return one;
}

// ISO 1101, table 2.
void expect_datums(const CalloutDescription& callout, const ToleranceFrame* frame) {
  if (frame == nullptr) return;
  for (const ToleranceFrame& one : frame->also) expect_datums(callout, &one);
  const CharacteristicRow& row = row_of(frame->characteristic);
  if (row.datums == DatumRule::required && frame->datums.empty())
    refuse_input(callout.where, "a tolerance of " + std::string(row.name) + " needs a datum",
                 "write one: datums = [\"A\"]");
  if (row.datums == DatumRule::none && !frame->datums.empty())
    refuse_input(callout.where, "a tolerance of " + std::string(row.name) + " has no datums", "omit 'datums'");
  if (frame->datums.size() > 3)
    refuse_input(callout.where,
                 "a tolerance frame has " + std::to_string(frame->datums.size()) + " datums, at most 3 are allowed",
                 "several letters in one place are a common datum, such as \"A-B\"");
}

// Datums and tolerances belong to a feature: to a place, or to what a dimension measures.
void expect_attached(const CalloutDescription& callout, const Located<LeaderWords>& to) {
  const bool is_frame = std::holds_alternative<ToleranceFrame>(callout.content);
  if ((is_frame || std::holds_alternative<DatumFeature>(callout.content)) && !to.given() && !callout.dimension.given())
    refuse_input(callout.where, is_frame ? "[[tolerance_frame]] lacks 'to'" : "[[datum]] lacks 'to'",
                 "say where its leader ends, or the name of a 'dimension'");
  if (!callout.dimension.given()) return;
  if (to.given()) refuse_input(to.where, "it has a 'dimension' and needs no 'to'", "omit one of them");
  for (const auto& [key, where] :
       {std::pair("view", callout.view.where), {"at", callout.at.where}, {"end", callout.end.where}})
    if (!where.empty())
      refuse_input(where, "what stands in line with a dimension has no '" + std::string(key) + "'",
                   "omit it, or 'dimension'");
}

// Views and sheets are known once the command line is.
CalloutDescription callout_of(const CalloutWords& words, const Subjects& subjects) {
  CalloutDescription callout = words.description;
  expect_datums(callout, std::get_if<ToleranceFrame>(&callout.content));
  expect_attached(callout, words.to);
  if (callout.dimension.given()) return callout;
  if (!words.to.given()) {
    for (const auto& [key, where] : {std::pair("view", callout.view.where), {"end", callout.end.where}})
      if (!where.empty())
        refuse_input(where, "what has no leader has no '" + std::string(key) + "'",
                     "say where its leader ends, by 'to'");
    return callout;
  }
  if (callout.sheet.given())
    refuse_input(callout.sheet.where, "what has a leader is on the sheet of its view", "omit 'sheet', or 'to'");
  const auto* anchor = std::get_if<AnchorWords>(&*words.to);
  const Vec2* page = std::get_if<Vec2>(&*words.to);
  callout.to = {anchor != nullptr ? LeaderTarget(anchor_of(*anchor, subjects)) : LeaderTarget(*page), words.to.where};
  return callout;
}

void expect_cells(const TableDescription& table) {
  const std::size_t columns = table.header.empty() ? table.rows.front().size() : table.header.size();
  for (std::size_t i = 0; i < table.rows.size(); ++i)
    if (table.rows[i].size() != columns)
      refuse_input(table.where,
                   "row " + std::to_string(i + 1) + " of the table has " + std::to_string(table.rows[i].size()) +
                       (table.rows[i].size() == 1 ? " cell" : " cells") + " instead of " + std::to_string(columns),
                   "write \"\" for empty cells");
  if (table.at.given() && table.corner.given())
    refuse_input(table.corner.where, "the table has a position and a corner", "omit 'corner', or 'at'");
}

// Calls `visit` for the name of each file that the scene names.
template <class Scene, class Visit>
void visit_files(Scene& scene, const Visit& visit) {
  for (auto& model : scene.models) visit(model.file);
  for (auto& sheet : scene.sheets) {
    if (sheet.font.given() && names_font_file(*sheet.font)) visit(sheet.font);
    for (auto* file : {&sheet.form, &sheet.logo, &sheet.style})
      if (file->given()) visit(*file);
  }
}

// Whoever writes a file may not say how much memory and time reading another one takes.
void expect_usual_bounds(const LocatedText& model) {
  for (const auto& [key, value] : importer::parse_model_request(*model).parameters)
    if (importer::is_bound(key))
      refuse_input(model.where, "'" + key + "' changes what reading the file may take",
                   "--allow-outside allows it, if you trust the scene file");
}

// Resolves paths relative to the folder of the scene file.
void find_files(SceneDescription& scene, const fs::path& folder, FilesOutside outside) {
  visit_files(scene, [&](LocatedText& file) {
    const fs::path path = folder / *file;
    if (outside == FilesOutside::refused && !lies_below(path, folder))
      refuse_input(file.where, "'" + *file + "' lies outside the folder of the scene file",
                   "--allow-outside allows it, if you trust the scene file");
    file.value = path.string();
  });
  if (outside == FilesOutside::refused)
    for (const ModelDescription& model : scene.models) expect_usual_bounds(model.file);
}

}  // namespace

SceneDescription scene_of(const TomlValue& root) {
  SceneWords words = read_scene_words(root);
  SceneDescription& scene = words.description;
  if (scene.models.empty())
    refuse_input(root.where, "names no model", "a scene file needs at least:  [[model]]  file = \"part.obj\"");
  if (scene.sheets.empty()) scene.sheets.push_back(words.every_sheet);
  complete_directions(scene);
  expect_projections(scene);
  name_views(scene.views);
  expect_sound_names(scene);
  const Subjects subjects{scene.models, numbers_of(scene.models), names_of(scene.views, "view")};
  for (const DimensionWords& dimension : words.dimensions)
    scene.dimensions.push_back(dimension_of(dimension, subjects));
  for (const ThreadWords& thread : words.threads) scene.threads.push_back(thread_of(thread, subjects));
  for (const TableDescription& table : scene.tables) expect_cells(table);
  for (const CalloutWords& callout : words.callouts) scene.callouts.push_back(callout_of(callout, subjects));
  for (const RequirementWords& requirement : words.requirements)
    scene.requirements.push_back(requirement_of(requirement));
  for (const AcceptedWords& one : words.accepted)
    scene.accepted.push_back({feature_of(one.feature, "what is accepted"), one.description.reason});
  if (scene.parts_list && !subjects.views.empty()) refuse_unknown(scene.parts_list->view, subjects.views, "view");
  return scene;
}

SceneDescription read_scene_file(const fs::path& path, FilesOutside outside) {
  SceneDescription scene = scene_of(read_toml(path));
  find_files(scene, path.parent_path(), outside);
  return scene;
}

std::vector<fs::path> files_named_in(const SceneDescription& scene) {
  std::vector<fs::path> files;
  visit_files(scene, [&](const LocatedText& file) { files.emplace_back(*file); });
  return files;
}

void expect_sound_names(const SceneDescription& scene) {
  names_of(scene.models, "model");
  check_views(scene, names_of(scene.sections, "section"));
  names_of(scene.details, "detail");
  const Names dimensions = names_of(scene.dimensions, "dimension");
  for (const CalloutDescription& callout : scene.callouts) refuse_unknown(callout.dimension, dimensions, "dimension");
  names_of(scene.views, "view");
}

}  // namespace epura::scene
