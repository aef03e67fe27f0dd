// SPDX-License-Identifier: Apache-2.0
#include "views/coarse_meshes.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numbers>

#include "base/error.hpp"
#include "drawing/drawing.hpp"
#include "edges/dihedral.hpp"
#include "surfaces/recognise.hpp"

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
  constexpr double min_outline = 20;  // mm
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
  return length < min_outline ? 0 : sum / length;
}

bool is_rounded(const scene::ModelDescription& model) {
  return std::any_of(model.import.begin(), model.import.end(),
                     [](const auto& parameter) { return parameter.first == "subdivide"; });
}

// Whoever asks for all edges of the mesh beside its creases or its border wants to see them.
bool wants_mesh(const edges::EdgeOptions& edges) { return edges.smooth && (edges.crease || edges.boundary); }

}  // namespace

CoarseMeshes::CoarseMeshes(const scene::SceneDescription& scene, PartsByModel& parts) : scene_(scene), parts_(parts) {}

void CoarseMeshes::look(const ViewInput& input, const drawing::ViewDrawing& drawing, const Progress& progress) {
  constexpr double visible_rise = 0.1;  // mm
  constexpr int max_triangles = 50'000, max_bodies = 20;
  const edges::EdgeOptions& edges = input.options.edges;
  if (input.section != nullptr || input.options.wireframe || wants_mesh(edges)) return;
  for (int model = 0; model < static_cast<int>(input.world.models.size()); ++model) {
    const world::Placed& placed = input.world.models[model];
    const int number = input.world.number_in_scene(model);
    const scene::ModelDescription& description = scene_.models[static_cast<std::size_t>(number)];
    if (placed.part != nullptr || description.surfaces.value_or(Surfaces::automatic) == Surfaces::mesh ||
        placed.mesh->triangle_count() > max_triangles || placed.mesh->report.bodies > max_bodies)
      continue;
    const bool is_angular = !is_rounded(description) && mean_rise(input, drawing, model) >= visible_rise;
    if (!(is_angular || edges.smooth) || is_part(number, *placed.mesh, progress)) continue;
    Coarse& found = coarse_[number];
    found.name = std::filesystem::path(placed.mesh->report.name).filename().string();
    found.is_angular = found.is_angular || is_angular;
    found.has_smooth = found.has_smooth || edges.smooth;
    found.has_creases = found.has_creases || edges.crease;
  }
}

// Views of outlines alone do not need the faces of parts, so that they are not known yet.
bool CoarseMeshes::is_part(int model, const mesh::Mesh& mesh, const Progress& progress) {
  constexpr double min_recognised = 0.3;  // of the area
  constexpr double part_of_the_time = 0.1;
  const auto known = parts_.find(model);
  if (known != parts_.end()) return known->second;
  bool is_part = true;
  try {
    const Progress limited = progress.with_part_of_the_time(part_of_the_time);
    is_part = surfaces::recognise_faces(mesh, {}, limited).recognised >= min_recognised;
  } catch (const OutOfTime&) {
    // Nothing is said without knowing.
  }
  return parts_[model] = is_part;
}

std::vector<std::string> CoarseMeshes::warnings() const {
  std::vector<std::string> warnings;
  for (const auto& [model, mesh] : coarse_) {
    const std::string round = "round the mesh by " + mesh.name + ":subdivide=2";
    const std::string outlines = "--edges contour,boundary";
    if (mesh.is_angular)
      warnings.push_back("the outlines of '" + mesh.name + "' are angular: its mesh is coarse for this scale" +
                         (mesh.has_smooth ? ", and all edges of it are of the kind 'smooth'" : "") +
                         "\n  hint: " + round +
                         (mesh.has_smooth || mesh.has_creases ? ", and draw its outlines alone by " + outlines : ""));
    else
      warnings.push_back(
          "edges of the kind 'smooth' are all those of the mesh of '" + mesh.name + "'\n  hint: draw its outlines by " +
          outlines +
          (is_rounded(scene_.models[static_cast<std::size_t>(model)]) ? "" : "; if they are angular, " + round));
  }
  return warnings;
}

}  // namespace epura::pipeline
