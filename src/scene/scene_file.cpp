#include "scene/scene_file.hpp"

#include <algorithm>
#include <array>
#include <string_view>

#include "base/error.hpp"
#include "base/text.hpp"
#include "scene/scene_keys.hpp"
#include "scene/toml_tree.hpp"
#include "scene/view_names.hpp"

namespace epura {

namespace {

namespace fs = std::filesystem;

[[noreturn]] void refuse(const std::string& where, const std::string& reason, const std::string& hint) {
  throw Error(Trouble::input, where, reason, hint);
}

// By which dimensions may call a model.
std::string name_of(const ModelDescription& model) {
  return model.name.given() ? model.name.text : fs::path(model.file.text).stem().string();
}

template <class Part>
void refuse_namesakes(const std::vector<Part>& parts, const std::string& what) {
  for (auto part = parts.begin(); part != parts.end(); ++part) {
    const auto same = [&part](const Part& other) { return other.name.given() && other.name.text == part->name.text; };
    if (std::any_of(parts.begin(), part, same))
      refuse(part->name.where, "'" + part->name.text + "' is the name of an earlier " + what, "names are for one each");
  }
}

template <class Part>
std::vector<std::string> names_of(const std::vector<Part>& parts) {
  std::vector<std::string> names;
  for (const Part& part : parts) names.push_back(part.name.text);
  return names;
}

void refuse_unknown(const Given& name, const std::vector<std::string>& names, const std::string& what) {
  if (!name.given() || std::find(names.begin(), names.end(), name.text) != names.end()) return;
  refuse(name.where, "there is no " + what + " '" + name.text + "'",
         names.empty() ? "there is no [[" + what + "]] at all" : did_you_mean(name.text, names));
}

void check_views(const SceneDescription& scene) {
  const std::size_t sheets = scene.sheets.size();
  const std::vector<std::string> sections = names_of(scene.sections);
  for (const ViewDescription& view : scene.views) {
    refuse_unknown(view.section, sections, "section");
    if (std::size_t(view.sheet) > sheets)
      refuse(view.projection.where,
             "the view is for sheet " + std::to_string(view.sheet) + " of " + std::to_string(sheets),
             "add a [[sheet]]");
  }
}

struct DimensionType {
  std::string name;
  std::vector<std::string> anchors;  ///< keys, in the order of DimensionDescription::anchors
};

const DimensionType& type_of(const Given& type) {
  static const std::array<DimensionType, 6> types = {{{"linear", {"from", "to"}},
                                                      {"aligned", {"from", "to"}},
                                                      {"angular", {"corner", "from", "to"}},
                                                      {"radius", {"at"}},
                                                      {"diameter", {"at"}},
                                                      {"overall", {}}}};
  std::vector<std::string> names;
  for (const DimensionType& known : types) {
    if (known.name == type.text) return known;
    names.push_back(known.name);
  }
  refuse(type.where, "does not know '" + type.text + "'", did_you_mean(type.text, names));
}

// The number of the model that an anchor names.
int model_of(const AnchorWords& anchor, const std::vector<ModelDescription>& models) {
  const int count = static_cast<int>(models.size());
  if (const int* number = std::get_if<int>(&anchor.model)) {
    if (*number < count) return *number;
    refuse(anchor.where, "there is no model " + std::to_string(*number),
           "models are numbered from 0 to " + std::to_string(count - 1));
  }
  const auto& name = std::get<std::string>(anchor.model);
  std::vector<std::string> names;
  for (const ModelDescription& model : models) names.push_back(name_of(model));
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end()) refuse(anchor.where, "there is no model '" + name + "'", did_you_mean(name, names));
  if (std::count(names.begin(), names.end(), name) > 1)
    refuse(anchor.where, "several models are called '" + name + "'", "give them names of their own, or use a number");
  return static_cast<int>(found - names.begin());
}

Anchor anchor_of(const AnchorWords& words, const std::vector<ModelDescription>& models) {
  if (words.point) return *words.point;
  const int model = model_of(words, models);
  if (!models[std::size_t(model)].drawn)
    refuse(words.where, "model '" + name_of(models[std::size_t(model)]) + "' is not drawn and has no vertices",
           "give the place as {point = [x, y, z]}");
  return std::array<int, 2>{model, words.vertex};
}

DimensionDescription dimension_of(const DimensionWords& words, const SceneDescription& scene) {
  DimensionDescription dimension = words.description;
  const DimensionType& type = type_of(dimension.type);
  for (const std::string& key : type.anchors) {
    const auto found = std::find_if(words.anchors.begin(), words.anchors.end(),
                                    [&key](const auto& anchor) { return anchor.first == key; });
    if (found == words.anchors.end())
      refuse(dimension.where, "a dimension of type '" + type.name + "' lacks '" + key + "'",
             "[model, vertex] or {point = [x, y, z]}");
    dimension.anchors.push_back(anchor_of(found->second, scene.models));
  }
  for (const auto& [key, anchor] : words.anchors)
    if (std::find(type.anchors.begin(), type.anchors.end(), key) == type.anchors.end())
      refuse(anchor.where, "a dimension of type '" + type.name + "' has no '" + key + "'",
             type.anchors.empty() ? "it has no anchors" : did_you_mean(key, type.anchors));
  if (!scene.views.empty()) refuse_unknown(dimension.view, names_of(scene.views), "view");
  return dimension;
}

// A file's path, as seen from the folder of the scene file.
void find_files(std::vector<ModelDescription>& models, const fs::path& folder) {
  for (ModelDescription& model : models) model.file.text = (folder / model.file.text).string();
}

}  // namespace

SceneDescription read_scene_file(const fs::path& path) {
  SceneWords words = read_scene_words(read_toml(path));
  SceneDescription& scene = words.description;
  if (scene.models.empty())
    refuse(path.string(), "names no model", "a scene file has at least:  [[model]]  file = \"part.obj\"");
  if (scene.sheets.empty()) scene.sheets.push_back(words.every_sheet);
  refuse_namesakes(scene.models, "model");
  refuse_namesakes(scene.sections, "section");
  refuse_namesakes(scene.views, "view");
  name_views(scene.views);
  check_views(scene);
  for (const DimensionWords& dimension : words.dimensions) scene.dimensions.push_back(dimension_of(dimension, scene));
  find_files(scene.models, path.parent_path());
  return scene;
}

}  // namespace epura
