// SPDX-License-Identifier: Apache-2.0
// The models as views show them: assembled or exploded, whole or cut.
#pragma once

#include <cstddef>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "view/projected_scene.hpp"
#include "views/messages.hpp"
#include "views/sections.hpp"
#include "views/view_plan.hpp"
#include "world/exploded_world.hpp"

namespace epura::pipeline {

struct ShownWorld {
  world::World world;
  std::vector<world::Trace> traces{};  ///< of moved bodies
  CutSections sections{};              ///< those of its views
};

class ShownWorlds {
 public:
  /// Throws as explode_world and cut_sections do.
  ShownWorlds(world::World world, const scene::SceneDescription& scene, const Messages& messages,
              const Progress& progress);

  /// The models to which dimensions refer: assembled, unless all views are exploded alike.
  [[nodiscard]] const world::World& main() const { return worlds_.front().world; }
  [[nodiscard]] const ShownWorld& of(const scene::ViewDescription& view) const { return worlds_[number_of(view)]; }
  /// What the view shows, cut if it is a section.
  [[nodiscard]] const world::World& seen_in(const scene::ViewDescription& view) const {
    const CutSection* section = section_of(of(view).sections, view);
    return section == nullptr ? of(view).world : section->cut.world;
  }
  [[nodiscard]] bool is_main(const scene::ViewDescription& view) const { return number_of(view) == 0; }
  /// The surfaces of all sections that are shown, by name.
  [[nodiscard]] SectionSurfaces surfaces() const;

 private:
  // Views that the scene did not have show what dimensions refer to.
  [[nodiscard]] std::size_t number_of(const scene::ViewDescription& view) const {
    const auto known = world_of_view_.find(*view.name);
    return known == world_of_view_.end() ? 0 : known->second;
  }

  std::vector<ShownWorld> worlds_;
  std::map<std::string, std::size_t> world_of_view_;
};

/// Of each view, what depends on the models that it shows: steps of sections, revolved sections, styles. Throws
/// Error{input} for automatic dimensions of an assembly whose views are all exploded.
void choose_by_world(SheetOfViews& views, const scene::SceneDescription& scene, const ShownWorlds& worlds,
                     std::span<const view::ProjectedScene> seen);

}  // namespace epura::pipeline
