// SPDX-License-Identifier: Apache-2.0
#include "views/mass.hpp"

#include <cstddef>
#include <vector>

#include "base/error.hpp"
#include "scene/body_styles.hpp"
#include "sheet/notation.hpp"

namespace epura::pipeline {

namespace {

std::string solid_name(const world::World& world, const scene::SceneDescription& scene, std::size_t model, int body) {
  const mesh::Mesh& mesh = *world.models[model].mesh;
  const std::string& name = scene::name_of_body(mesh, body);
  if (!name.empty()) return "body '" + name + "'";
  const std::string of_model = "model '" + scene::name_of(scene.models[model]) + "'";
  return mesh.report.bodies > 1 ? "body " + std::to_string(body) + " of " + of_model : of_model;
}

void tell_of_turned(const Messages& messages, const world::World& world, const scene::SceneDescription& scene) {
  for (std::size_t m = 0; m < world.models.size(); ++m)
    for (const world::Solid& solid : world::solids_of(world.models[m].mesh->whole(), world.models[m].to_world))
      if (solid.turned)
        messages.warn(solid_name(world, scene, m, solid.body) +
                      " is turned inside out in the file; its mass is that of the body turned back");
}

}  // namespace

world::MassProperties mass_of(const world::World& world, const scene::SceneDescription& scene, bool wants_mass,
                              const std::string& where) {
  std::vector<world::Solid> solids;
  std::vector<double> densities;
  for (std::size_t m = 0; m < world.models.size(); ++m) {
    const world::Placed& placed = world.models[m];
    for (world::Solid& solid : world::solids_of(placed.mesh->whole(), placed.to_world)) {
      const std::string name = solid_name(world, scene, m, solid.body);
      if (!solid.fault.empty())
        throw Error(ErrorKind::input, where, name + " has no volume: " + solid.fault,
                    "export it as a closed solid, or leave it out");
      densities.push_back(world::density_of(world, static_cast<int>(m), scene.models[m], solid.body));
      if (wants_mass && !(densities.back() > 0))
        throw Error(ErrorKind::input, where, name + " has no density, so its mass is unknown",
                    "give one in kg/m³: --density 7850, or 'density' in its [[model]] or [[style]]");
      solids.push_back(std::move(solid));
    }
  }
  if (solids.empty())
    throw Error(ErrorKind::input, where, "the models have no bodies, and no mass", "lines and points have no volume");
  return world::sum_of(solids, densities);
}

void complete_mass(scene::SceneDescription& scene, const world::World& world, const Messages& messages) {
  bool is_asked = false;
  for (scene::SheetDescription& sheet : scene.sheets) {
    const DecimalSign sign = sheet.decimal_sign.value_or(DecimalSign::point);
    for (auto& [name, text] : sheet.title_block)
      if (name == "mass" && *text == "auto") {
        is_asked = true;
        text.value = sheet::mass_text(mass_of(world, scene, true, text.where).mass.value_or(0), sign);
      }
  }
  if (is_asked) tell_of_turned(messages, world, scene);
}

}  // namespace epura::pipeline
