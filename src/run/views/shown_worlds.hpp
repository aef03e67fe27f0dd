// SPDX-License-Identifier: Apache-2.0
// The models as views show them: assembled or exploded, whole or cut.
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "views/messages.hpp"
#include "views/sections.hpp"
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
  [[nodiscard]] const ShownWorld& of(const scene::ViewDescription& view) const {
    return worlds_[world_of_view_.at(*view.name)];
  }
  /// What the view shows, cut if it is a section.
  [[nodiscard]] const world::World& seen_in(const scene::ViewDescription& view) const {
    const CutSection* section = section_of(of(view).sections, view);
    return section == nullptr ? of(view).world : section->cut.world;
  }
  [[nodiscard]] bool is_main(const scene::ViewDescription& view) const { return world_of_view_.at(*view.name) == 0; }
  /// The surfaces of all sections that are shown, by name.
  [[nodiscard]] SectionSurfaces surfaces() const;

 private:
  std::vector<ShownWorld> worlds_;
  std::map<std::string, std::size_t> world_of_view_;
};

}  // namespace epura::pipeline
