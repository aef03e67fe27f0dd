// SPDX-License-Identifier: Apache-2.0
#include "pipeline/saved_views.hpp"

#include <algorithm>
#include <array>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "base/error.hpp"
#include "base/text.hpp"
#include "importer/read_model.hpp"
#include "pipeline/read_models.hpp"
#include "scene/arrow_views.hpp"
#include "scene/choices.hpp"

namespace epura::pipeline {

namespace {

/// In coordinates of the world.
struct StoredView {
  std::string name;
  bool is_central;
  Vec3 eye, towards, up;
  std::vector<std::array<Vec3, 2>> planes{};  ///< a point and a normal of each
};

Vec3 vector_of(const double* xyz) { return {xyz[0], xyz[1], xyz[2]}; }

StoredView placed(const importer::SavedView& view, const Mat4& place) {
  const auto at = [&](const Vec3& point) { return Vec3(place * Vec4(point, 1)); };
  const auto along = [&](const Vec3& direction) { return glm::normalize(Mat3(place) * direction); };
  StoredView stored{view.name, view.is_central != 0, at(vector_of(view.eye.data())),
                    along(vector_of(view.towards.data())), along(vector_of(view.up.data()))};
  for (const std::array<double, 6>& plane : view.planes)
    stored.planes.push_back({at(vector_of(plane.data())), along(vector_of(plane.data() + 3))});
  return stored;
}

// A coarse mesh does: only the views count.
std::vector<StoredView> stored_views(const scene::SceneDescription& scene, const RunOptions& options) {
  constexpr double coarse = 1e-2;
  std::vector<StoredView> stored;
  for (scene::ModelDescription model : scene.models) {
    if (!model.file.given() || model.soup != nullptr || model.content != nullptr || !model.drawn.value_or(true))
      continue;
    importer::ModelRequest request = importer::parse_model_request(*model.file);
    if (request.path == importer::standard_input) continue;
    const importer::ReadModel read = importer::read_model(request.path, request.parameters,
                                                          {.plugin_path = options.plugin_path,
                                                           .relative_tolerance = coarse,
                                                           .threads = options.threads,
                                                           .is_confined = options.sandbox != Sandbox::off,
                                                           .allow_outside = options.allow_outside});
    for (const importer::SavedView& view : read.saved_views) stored.push_back(placed(view, place_of(model, read)));
  }
  return stored;
}

std::string text_of(const Vec3& v) { return format_number(v.x) + "," + format_number(v.y) + "," + format_number(v.z); }

// One that a view names has its place; equal names of several models stay apart.
void take(scene::SceneDescription& scene, scene::ViewDescription view, const StoredView& stored,
          std::vector<scene::ViewDescription>& views) {
  const std::string where = view.projection.where;
  scene::ProjectionRequest& request = view.projection.value.value();
  std::erase_if(request.assignments, [](const auto& assignment) { return assignment.first == "view"; });
  request.name = stored.is_central ? "look-at" : "auxiliary";
  if (stored.is_central)
    request.assignments.insert(
        request.assignments.end(),
        {{"eye", text_of(stored.eye)}, {"ref", text_of(stored.eye - stored.towards)}, {"vup", text_of(stored.up)}});
  else
    request.assignments.insert(request.assignments.end(),
                               {{"direction", text_of(stored.towards)}, {"up", text_of(stored.up)}});
  const bool is_taken = std::any_of(views.begin(), views.end(), [&](const scene::ViewDescription& other) {
    return other.name.given() && *other.name == stored.name;
  });
  if (!view.name.given() && !is_taken) view.name = {stored.name, where};
  if (!view.label.given()) view.label = {stored.name, where};
  if (!stored.planes.empty() && !view.section.given()) {
    std::set<std::string> taken = scene::letters_of(scene);
    const auto& [point, normal] = stored.planes.front();
    scene.sections.push_back({.name = {scene::next_letter(taken), where},
                              .point = point,
                              .normal = glm::dot(normal, stored.towards) < 0 ? -normal : normal});
    view.section = scene.sections.back().name;
  }
  views.push_back(std::move(view));
}

std::string wanted_name(const scene::ViewDescription& view) {
  for (const auto& [key, value] : view.projection->assignments)
    if (key == "view") return value;
  return "";
}

bool is_saved(const scene::ViewDescription& view) {
  return view.projection.given() && view.projection->name == "saved";
}

}  // namespace

void expand_saved_views(scene::SceneDescription& scene, const RunOptions& options) {
  if (std::none_of(scene.views.begin(), scene.views.end(), is_saved)) return;
  const std::vector<StoredView> stored = stored_views(scene, options);
  std::vector<std::string> names;
  for (const StoredView& one : stored) names.push_back(one.name);
  std::vector<scene::ViewDescription> views;
  for (scene::ViewDescription& view : scene.views) {
    if (!is_saved(view)) {
      views.push_back(std::move(view));
      continue;
    }
    const std::string wanted = wanted_name(view);
    if (stored.empty())
      refuse_input(view.projection.where, "the models have stored no views", "name a projection, such as isometric");
    if (!wanted.empty() && std::find(names.begin(), names.end(), wanted) == names.end())
      refuse_input(view.projection.where, "the models have no saved view '" + wanted + "'",
                   did_you_mean(wanted, names));
    for (const StoredView& one : stored)
      if (wanted.empty() || one.name == wanted) take(scene, view, one, views);
  }
  scene.views = std::move(views);
}

}  // namespace epura::pipeline
