// SPDX-License-Identifier: Apache-2.0
#include "views/shown_worlds.hpp"

#include <algorithm>
#include <utility>

#include "base/error.hpp"
#include "features/assembly_features.hpp"
#include "scene/body_styles.hpp"
#include "scene/details.hpp"
#include "world/expect_usable.hpp"

namespace epura::pipeline {

namespace {

using Numbers = std::vector<std::size_t>;

// The moves in a view, by number. A detail shows what the view shows that it enlarges.
Numbers moves_in(const scene::ViewDescription& view, const scene::SceneDescription& scene) {
  std::string name = *view.name;
  if (view.detail.given()) name = *scene::find_detail(scene, *view.detail)->view;
  Numbers numbers;
  for (std::size_t i = 0; i < scene.explosions.size(); ++i)
    if (scene.explosions[i].view.value_or(name) == name) numbers.push_back(i);
  return numbers;
}

}  // namespace

ShownWorlds::ShownWorlds(world::World world, const scene::SceneDescription& scene, const Messages& messages,
                         const Progress& progress) {
  std::vector<std::string> names;
  for (const scene::ModelDescription& model : scene.models) names.push_back(scene::name_of(model));
  std::map<Numbers, std::vector<scene::ViewDescription>> views;  // without moves first
  for (const scene::ViewDescription& view : scene.views) views[moves_in(view, scene)].push_back(view);
  if (views.size() > 1) views.try_emplace(Numbers());
  for (const auto& [numbers, of_world] : views) {
    for (const scene::ViewDescription& view : of_world) world_of_view_[*view.name] = worlds_.size();
    std::vector<scene::ExplodeDescription> moves;
    for (const std::size_t i : numbers) moves.push_back(scene.explosions[i]);
    ShownWorld shown;
    if (!moves.empty()) {
      world::ExplodedWorld exploded = world::explode_world(world, moves, names);
      world::expect_usable(exploded.world);
      shown.world = std::move(exploded.world);
      shown.traces = std::move(exploded.traces);
    } else if (views.size() == 1) {
      shown.world = std::move(world);
    } else {
      shown.world = world;
    }
    scene::SceneDescription cut;
    cut.views = of_world;
    cut.sections = scene.sections;
    shown.sections = cut_sections(shown.world, cut, messages, progress);
    worlds_.push_back(std::move(shown));
  }
}

SectionSurfaces ShownWorlds::surfaces() const {
  SectionSurfaces surfaces;
  for (const ShownWorld& shown : worlds_) add_surfaces(surfaces, shown.sections);
  return surfaces;
}

namespace {

// Automatic dimensions give the places of parts, which are nowhere in views that are all exploded.
void expect_places_of_parts(const SheetOfViews& views, const scene::SceneDescription& scene) {
  for (const scene::DimensionDescription& one : scene.dimensions) {
    if (one.type.value != DimensionType::automatic) continue;
    const auto is_its = [&one](const scene::ViewDescription& view) {
      return one.view.value_or(*view.name) == *view.name;
    };
    const auto is_whole = [&](const scene::ViewDescription& view) {
      return is_its(view) && moves_in(view, scene).empty();
    };
    if (std::ranges::any_of(views.descriptions, is_its) && std::ranges::none_of(views.descriptions, is_whole))
      throw Error(ErrorKind::input, one.where,
                  "its views are exploded, where distances between parts are not those of the assembly",
                  "dimension a view of the whole assembly, or only overall sizes");
  }
}

}  // namespace

void choose_by_world(SheetOfViews& views, const scene::SceneDescription& scene, const ShownWorlds& worlds,
                     std::span<const view::ProjectedScene> seen) {
  const bool of_parts = features::is_assembly(worlds.main());
  if (of_parts) expect_places_of_parts(views, scene);
  for (std::size_t i = 0; i < seen.size(); ++i) {
    scene::ViewDescription& view = views.descriptions[i];
    // The hidden lines of parts behind parts make an assembly unreadable.
    if (of_parts && view.is_automatic && !view.hidden.given()) view.hidden = {HiddenLines::none, "--views auto"};
    const ShownWorld& shown = worlds.of(view);
    const CutSection* section = section_of(shown.sections, view);
    ViewOptions& chosen = views.plans[i].options;
    if (section != nullptr) expect_steps_edge_on(*section, seen[i], view);
    if (section != nullptr && section->surface.aligned) chosen.turned = section->surface;
    chosen.exploded = !worlds.is_main(view);
    chosen.revolved = cut_revolved(shown.world, scene, view, seen[i].projection);
    chosen.styles = styles_of(scene, view, section == nullptr ? shown.world : section->cut.world, seen[i].projection);
    const auto is_broken_out = [&view](const scene::BrokenOutDescription& one) { return *one.view == *view.name; };
    chosen.shows_inside = section != nullptr || chosen.wireframe || chosen.keep_hidden() ||
                          std::ranges::any_of(scene.broken_outs, is_broken_out);
  }
}

}  // namespace epura::pipeline
