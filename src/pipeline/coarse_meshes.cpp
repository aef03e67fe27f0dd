// SPDX-License-Identifier: Apache-2.0
#include "pipeline/coarse_meshes.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numbers>

#include "base/error.hpp"
#include "edges/dihedral.hpp"
#include "features/recognise.hpp"

namespace epura::pipeline {

namespace {

// In degrees; 180 where no surface continues.
double fold_at(const world::World& world, int model, const mesh::MeshEdge& edge) {
  if (edge.count != 2) return 180;
  const int first = world.first_vertex[model];
  const auto triangles = world.models[model].mesh->triangles_of(edge);
  return edges::fold_angle({world, model, 1}, {first + edge.vertex[0], first + edge.vertex[1]}, triangles[0],
                           triangles[1]);
}

// How far the smooth surface rises over its facets where the view shows them as an outline: the mean along it, mm. A
// chord of length l at whose ends the surface turns by an angle a is about l a / 8 below it.
double mean_rise(const ViewInput& input, const drawing::ViewDrawing& drawing, int model) {
  constexpr double least_outline = 20;  // mm
  double length = 0, sum = 0;
  for (const drawing::Segment& segment : drawing.segments) {
    if (segment.model != model || !segment.visible || is_link(segment) || segment.kind != EdgeKind::contour) continue;
    const mesh::MeshEdge* edge = input.world.models[model].mesh->edge_between(segment.edge);
    if (edge == nullptr) continue;
    const double fold = fold_at(input.world, model, *edge);
    if (fold >= input.options.edges.crease_angle) continue;
    const double chord = glm::distance(segment.from, segment.to);
    length += chord;
    sum += chord * chord * fold * std::numbers::pi / 180 / 8;
  }
  check(std::isfinite(sum), "lines on paper are finite");
  return length < least_outline ? 0 : sum / length;
}

// Views of outlines alone do not need the faces of parts, so that they are not known yet.
bool is_part(const world::Placed& placed, const Progress& progress) {
  constexpr double least_recognised = 0.3;  // of the area
  if (placed.part != nullptr) return true;
  try {
    return features::recognise_faces(*placed.mesh, {}, progress).recognised >= least_recognised;
  } catch (const OutOfTime&) {
    return true;
  }
}

bool is_rounded(const scene::ModelDescription& model) {
  return std::any_of(model.import.begin(), model.import.end(),
                     [](const auto& parameter) { return parameter.first == "subdivide"; });
}

// Whoever asks for all edges of the mesh beside its creases or its border wants to see them.
bool wants_mesh(const edges::EdgeOptions& edges) { return edges.smooth && (edges.crease || edges.boundary); }

std::string warning_of(const world::Placed& placed, const edges::EdgeOptions& edges, bool is_angular, bool is_round) {
  const std::string name = std::filesystem::path(placed.mesh->report.name).filename().string();
  const std::string round = "round the mesh by " + name + ":subdivide=2", outlines = "--edges contour,boundary";
  if (!is_angular)
    return "edges of the kind 'smooth' are all those of the mesh of '" + name + "'\n  hint: draw its outlines by " +
           outlines + (is_round ? "" : "; if they are angular, " + round);
  return "the outlines of '" + name + "' are angular: its mesh is coarse for this scale" +
         (edges.smooth ? ", and all edges of it are of the kind 'smooth'" : "") + "\n  hint: " + round +
         (edges.smooth || edges.crease ? ", and draw its outlines alone by " + outlines : "");
}

}  // namespace

std::vector<std::string> warnings_of_coarse_meshes(const ViewInput& input, const drawing::ViewDrawing& drawing,
                                                   const scene::SceneDescription& scene, const Progress& progress) {
  constexpr double visible_rise = 0.1;  // mm
  constexpr int most_triangles = 50'000, most_bodies = 20;
  std::vector<std::string> warnings;
  if (input.section != nullptr || input.options.wireframe || wants_mesh(input.options.edges)) return warnings;
  for (int model = 0; model < static_cast<int>(input.world.models.size()); ++model) {
    const world::Placed& placed = input.world.models[model];
    const scene::ModelDescription& description = scene.models[input.world.number_in_scene(model)];
    if (placed.part != nullptr || description.surfaces.value_or(Surfaces::automatic) == Surfaces::mesh ||
        placed.mesh->triangle_count() > most_triangles || placed.mesh->report.bodies > most_bodies)
      continue;
    const bool is_round = is_rounded(description);
    const bool is_angular = !is_round && mean_rise(input, drawing, model) >= visible_rise;
    if ((is_angular || input.options.edges.smooth) && !is_part(placed, progress))
      warnings.push_back(warning_of(placed, input.options.edges, is_angular, is_round));
  }
  return warnings;
}

}  // namespace epura::pipeline
