// SPDX-License-Identifier: Apache-2.0
#include "pipeline/item_names.hpp"

#include <fnmatch.h>

#include <algorithm>
#include <cstddef>
#include <memory>
#include <optional>
#include <string>

#include "base/text.hpp"
#include "scene/body_styles.hpp"
#include "world/items.hpp"

namespace epura::pipeline {

namespace {

// A pattern that a name alone matches.
std::string literal(const std::string& name) {
  std::string pattern;
  for (const char letter : name) {
    if (std::string("*?[\\").find(letter) != std::string::npos) pattern += '\\';
    pattern += letter;
  }
  return pattern;
}

/// The models of a scene, and the items of their parts list once a pattern asks for them.
class Names {
 public:
  Names(const scene::SceneDescription& scene, std::vector<KeptModel>& models, std::span<const Mat4> places)
      : scene_(scene), models_(models), places_(places) {}

  [[nodiscard]] bool has_body(const std::string& pattern) const {
    scene::StyleDescription style;
    style.match.value = pattern;
    for (std::size_t m = 0; m < models_.size(); ++m)
      for (int body = 0; body < models_[m].mesh->report.bodies; ++body)
        if (scene::matches(style, *models_[m].mesh, body, scene::name_of(scene_.models[m]))) return true;
    return false;
  }

  /// The names of the bodies of the items that a pattern matches, each once.
  std::vector<std::string> bodies_of_items(const std::string& pattern) {
    std::vector<std::string> names;
    for (const world::Item& item : items()) {
      if (::fnmatch(pattern.c_str(), item.name.c_str(), 0) != 0) continue;
      for (const auto& [model, body] : item.bodies) {
        const std::string name = name_body(static_cast<std::size_t>(model), body, item.name);
        if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
      }
    }
    return names;
  }

  /// All that patterns may be written with.
  std::vector<std::string> known() {
    std::vector<std::string> names;
    const auto add = [&names](const std::string& name) {
      if (!name.empty() && std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
    };
    for (const world::Item& item : items()) add(item.name);
    for (std::size_t m = 0; m < models_.size(); ++m) {
      add(scene::name_of(scene_.models[m]));
      for (int body = 0; body < models_[m].mesh->report.bodies; ++body)
        add(scene::name_of_body(*models_[m].mesh, body));
    }
    return names;
  }

 private:
  const std::vector<world::Item>& items() {
    if (items_) return *items_;
    std::vector<world::Placed> placed;
    std::vector<std::vector<importer::BodyPart>> parts;
    for (std::size_t m = 0; m < models_.size(); ++m) {
      placed.push_back({models_[m].mesh, places_[m]});
      parts.push_back(models_[m].rest.body_parts);
    }
    return items_.emplace(world::find_items(world::make_world(std::move(placed)), scene_.models, parts).items);
  }

  // The name of a body, which is that of its item if it has none.
  std::string name_body(std::size_t model, int body, const std::string& item) {
    const mesh::Mesh& mesh = *models_[model].mesh;
    if (const std::string& own = scene::name_of_body(mesh, body); !own.empty()) return own;
    auto named = std::make_shared<mesh::Mesh>(mesh);
    mesh::MeshReport& report = named->report;
    const auto bodies = static_cast<std::size_t>(report.bodies);
    if (report.body_names.empty() && !report.body_colours.empty())
      report.body_colours.resize(bodies, report.body_colours.front());
    report.body_names.resize(bodies);
    report.body_names[static_cast<std::size_t>(body)] = item;
    models_[model].mesh = std::move(named);
    return item;
  }

  const scene::SceneDescription& scene_;
  std::vector<KeptModel>& models_;
  std::span<const Mat4> places_;
  std::optional<std::vector<world::Item>> items_{};
};

// One description, or one for each name of the bodies that it means.
template <class Description>
void add_each(std::vector<Description>& all, const Description& one, Names& names, const std::string& pattern) {
  const std::vector<std::string> bodies =
      names.has_body(pattern) ? std::vector<std::string>() : names.bodies_of_items(pattern);
  if (bodies.empty()) all.push_back(one);
  for (const std::string& body : bodies) {
    all.push_back(one);
    all.back().match.value = literal(body);
  }
}

}  // namespace

BodyPatterns with_item_names(const scene::SceneDescription& scene, std::vector<KeptModel>& models,
                             std::span<const Mat4> places, const Messages& messages) {
  Names names(scene, models, places);
  BodyPatterns patterns;
  for (const scene::StyleDescription& style : scene.styles) {
    const std::size_t before = patterns.styles.size();
    add_each(patterns.styles, style, names, *style.match);
    const bool is_one = patterns.styles.size() == before + 1 && patterns.styles.back().match.value == style.match.value;
    // A misspelt pattern must not pass for a drawing without such bodies.
    if (is_one && !names.has_body(*style.match))
      messages.warn(style.match.where + ": no body or model is called '" + *style.match +
                    "'\n  hint: " + did_you_mean(*style.match, names.known()));
  }
  for (const scene::ExplodeDescription& move : scene.explosions)
    if (move.match.given())
      add_each(patterns.explosions, move, names, *move.match);
    else
      patterns.explosions.push_back(move);
  return patterns;
}

}  // namespace epura::pipeline
