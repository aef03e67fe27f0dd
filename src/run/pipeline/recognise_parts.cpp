// SPDX-License-Identifier: Apache-2.0
#include "pipeline/recognise_parts.hpp"

#include <algorithm>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/parallel.hpp"
#include "composition/annotations.hpp"
#include "edges/find_edges.hpp"
#include "pipeline/read_models.hpp"
#include "sizes/own_frame.hpp"
#include "surfaces/recognise.hpp"
#include "views/time_for_lines.hpp"
#include "views/view_plan.hpp"
#include "world/facet_heights.hpp"

namespace epura::pipeline {

namespace {

// Degrees.
constexpr double flat = 0.005;

// If no lines inside surfaces are drawn, there is nothing to distinguish.
bool is_asked(const scene::ViewDescription& view) {
  const EdgeKinds kinds = view.edges.value_or({});
  return kinds.crease || kinds.tangent || kinds.smooth || kinds.intersection;
}

// Round faces of bodies that fit into each other cross wherever their facets differ.
bool may_fit(const world::World& world) {
  int bodies = 0;
  for (const world::Placed& placed : world.models) bodies += placed.mesh->report.bodies;
  return bodies > 1;
}

// Degrees: edges with a smaller fold angle are not distinguished from those inside faces. If only creases are
// requested, fine tessellations have none.
double min_fold(const world::World& world, const scene::SceneDescription& scene, const RunOptions& options) {
  double least = edges::EdgeOptions().part_angle;
  const bool fit = may_fit(world);
  for (const scene::ViewDescription& view : scene.views) {
    const EdgeKinds kinds = view.edges.value_or({});
    if (kinds.tangent || (kinds.intersection && fit)) return flat;
    least = std::min(least, view.crease_angle.value_or(least));
  }
  // Outlines of cut faces are those of surfaces, and so are arcs.
  const bool cut = !scene.sections.empty() || !scene.broken_outs.empty() || !scene.revolved.empty();
  return cut || has_centre_lines(scene, options) || options.arcs || !scene.dimensions.empty() ? flat
                                                                                              : std::max(least, flat);
}

// Whether sizes along axes are given of a part of which nobody has chosen how it lies.
bool may_be_turned(const scene::SceneDescription& scene) {
  const auto is_measured = [](const scene::DimensionDescription& one) {
    return one.type.value == DimensionType::automatic || one.type.value == DimensionType::overall;
  };
  const auto is_anchored = [](const scene::DimensionDescription& one) {
    return !one.anchors.empty() && one.type.value != DimensionType::automatic;
  };
  const bool has_places = std::ranges::any_of(scene.dimensions, is_anchored) || !scene.sections.empty() ||
                          !scene.details.empty() || !scene.broken_outs.empty() || !scene.revolved.empty() ||
                          !scene.explosions.empty() || !scene.threads.empty() || !scene.callouts.empty() ||
                          !scene.requirements.empty();
  return std::ranges::all_of(scene.views, &scene::ViewDescription::is_automatic) && !has_places &&
         std::ranges::any_of(scene.dimensions, is_measured) && scene.models.size() == 1 &&
         !scene.models.front().transform.given();
}

/// How much time there is; none if there is so little that nothing would end.
struct TimeForFaces {
  Progress until;
  bool any;
};

std::shared_ptr<const surfaces::PartFaces> part_of(const mesh::Mesh& mesh, std::optional<double> least,
                                                   const TimeForFaces& time) {
  // Contours of coarse facets are moved to the surface; those of very fine ones are on it.
  constexpr int fine = 50000;
  if (least && !surfaces::has_shallow_folds(mesh, mesh.triangle_count() < fine ? flat : *least)) return nullptr;
  if (!time.any) throw OutOfTime{recognising_faces};
  auto part = std::make_shared<surfaces::PartFaces>(surfaces::recognise_faces(mesh, {}, time.until));
  return part->faces.empty() ? nullptr : part;
}

}  // namespace

void recognise_parts(world::World& world, const scene::SceneDescription& scene, const RunOptions& options,
                     report::Report& report, Progress progress) {
  // Dimensions of features need faces even where folds alone identify all edges.
  std::optional<double> least;
  const bool names_faces = dimensions_features(scene) || !scene.requirements.empty() || may_be_turned(scene);
  if (!names_faces && !options.lint && !options.describes && scene.threads.empty())
    least = min_fold(world, scene, options);
  std::vector<std::vector<int>> wanted;  // models of one mesh
  std::map<const mesh::Mesh*, std::size_t> number;
  const bool asked = names_faces || std::any_of(scene.views.begin(), scene.views.end(), is_asked);
  for (int model = 0; model < static_cast<int>(world.models.size()); ++model) {
    const world::Placed& placed = world.models[model];
    if (!asked || scene.models[model].surfaces.value_or(Surfaces::automatic) != Surfaces::automatic ||
        placed.part != nullptr || placed.mesh->triangle_count() == 0)
      continue;
    const auto [known, is_new] = number.emplace(placed.mesh.get(), wanted.size());
    if (is_new) wanted.emplace_back();
    wanted[known->second].push_back(model);
  }
  progress.begin(recognising_faces, wanted.size());
  const double read = seconds_now(progress);
  const TimeForFaces time{progress, !progress.is_limited() || *progress.time_limit() - read >= read};
  try {
    parallel_for(wanted.size(), 1, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) {
        const auto part = part_of(*world.models[wanted[i].front()].mesh, least, time);
        for (const int model : wanted[i]) world.models[model].part = part;
        progress.advance(1);
      }
    });
    if (const double error = world::tessellation_error(world, progress); error > 0) report.tessellation = {error, 0};
  } catch (const OutOfTime& cut) {
    report.partial.add_stage(cut.stage);
  }
  const bool any = std::any_of(world.models.begin(), world.models.end(),
                               [](const world::Placed& placed) { return placed.part != nullptr; });
  if (wanted.empty() && !any) return;
  long long triangles = 0, faces = 0, models = 0;
  for (const world::Placed& placed : world.models) {
    triangles += placed.mesh->triangle_count();
    if (placed.part == nullptr) continue;
    faces += static_cast<long long>(placed.part->faces.size());
    ++models;
  }
  report.plan.push_back({"features", models > 0,
                         models == 0 ? "no model has faces of a part that its folds do not tell"
                                     : "edges are those of faces in " + std::to_string(models) + " of " +
                                           std::to_string(world.models.size()) + " models",
                         triangles, faces});
}

void turn_to_own_axes(world::World& world, scene::SceneDescription& scene, const Messages& messages) {
  if (!may_be_turned(scene)) return;
  const auto turn = sheet::turn_to_own_frame(world);
  if (!turn) return;
  scene.models.front().transform = {*turn, "--views auto"};
  world::Placed& placed = world.models.front();
  placed.to_world = *turn * placed.to_world;
  auto styles = std::move(world.styles);
  world = world::make_world(std::move(world.models), wants_wires(scene));
  world.styles = std::move(styles);
  for (scene::DimensionDescription& dimension : scene.dimensions)
    for (scene::Anchor& datum : dimension.anchors)
      if (auto* point = std::get_if<Vec3>(&datum)) *point = Vec3(*turn * Vec4(*point, 1));
  messages.print(world.models.front().mesh->report.name + " lies askew and is drawn along its own axes: --transform '" +
                 sheet::words_of_turn(*turn) + "'; --transform rotate:z,0 leaves it as it lies\n");
}

}  // namespace epura::pipeline
