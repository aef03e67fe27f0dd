// SPDX-License-Identifier: Apache-2.0
#include "world/facet_heights.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <span>

#include "base/parallel.hpp"
#include "world/placed_part.hpp"

namespace epura::world {

namespace {

using surfaces::SurfaceKind;
using Triangle = std::array<Vec3, 3>;

constexpr std::size_t triangles_a_piece = 4096;
// Twice the sine of half of 30 degrees, the least angle of a crease.
constexpr double sharp = 0.5176;

Triangle corners_of(const World& world, int triangle) {
  const auto& [a, b, c] = world.triangles[triangle];
  return {world.points[a], world.points[b], world.points[c]};
}

// The height of the surface above a facet, sampled where facets are farthest from the surface through their corners.
double height_over(const surfaces::PartSurface& surface, const Triangle& p) {
  double height = 0;
  for (const Vec3& place : {0.5 * (p[0] + p[1]), 0.5 * (p[1] + p[2]), 0.5 * (p[2] + p[0]), (p[0] + p[1] + p[2]) / 3.0})
    height = std::max(height, std::abs(surfaces::signed_distance(surface, place)));
  return height;
}

/// A model of the world and its faces.
struct FacetsOfModel {
  const World& world;
  int model;
  std::optional<PlacedPart> part;

  FacetsOfModel(const World& all, int number)
      : world(all), model(number), part(place_part(all.models[static_cast<std::size_t>(number)])) {}

  [[nodiscard]] int first() const { return world.first_triangle[model]; }
  [[nodiscard]] int count() const { return world.first_triangle[model + 1] - first(); }
  [[nodiscard]] const mesh::Mesh& mesh() const { return *world.models[static_cast<std::size_t>(model)].mesh; }
  // The face of a triangle of the model, if its surface is known.
  [[nodiscard]] const surfaces::PartFace* known(int triangle) const {
    const int face = part ? part->face_of_triangle[triangle] : -1;
    if (face < 0) return nullptr;
    const surfaces::PartFace& found = part->faces[static_cast<std::size_t>(face)];
    return found.surface.kind == SurfaceKind::free_form ? nullptr : &found;
  }
};

// From a side of a facet to its third corner, perpendicular to the side.
Vec3 across(const FacetsOfModel& facets, const mesh::MeshEdge& edge, int triangle) {
  const mesh::Mesh& mesh = facets.mesh();
  int opposite = -1;
  for (const int corner : mesh.triangle(triangle))
    if (corner != edge.vertex[0] && corner != edge.vertex[1]) opposite = corner;
  if (opposite < 0) return Vec3(0);
  const int before = facets.world.first_vertex[facets.model];
  const auto at = [&](int vertex) { return facets.world.points[before + vertex]; };
  const Vec3 from = at(edge.vertex[0]), along = at(edge.vertex[1]) - from, to = at(opposite) - from;
  const double square = glm::dot(along, along);
  return square > 0 ? to - (glm::dot(to, along) / square) * along : Vec3(0);
}

// Of known surfaces; `residuals` times the distance of vertices from them is added.
void add_known(const FacetsOfModel& facets, double residuals, std::span<double> heights, const Progress& progress) {
  if (!facets.part) return;
  parallel_for(heights.size(), triangles_a_piece, progress, [&](std::size_t begin, std::size_t end) {
    for (std::size_t t = begin; t < end; ++t) {
      const auto triangle = static_cast<int>(t);
      const surfaces::PartFace* face = facets.known(triangle);
      if (face == nullptr) continue;
      if (is_round(face->surface.kind))
        heights[t] = height_over(face->surface, corners_of(facets.world, facets.first() + triangle));
      heights[t] += residuals * face->residual;
    }
  });
}

// By edges in their order, so that the sums are the same in every run.
void add_estimates(const FacetsOfModel& facets, std::span<double> heights, std::span<char> estimated) {
  const Placed& placed = facets.world.models[static_cast<std::size_t>(facets.model)];
  const mesh::Mesh& mesh = facets.mesh();
  for (std::size_t e = 0; e < mesh.edges.size(); ++e) {
    const mesh::MeshEdge& edge = mesh.edges[e];
    if (edge.count != 2 || edge.cut != mesh::CutEdge::none) continue;
    const std::span<const int> both = mesh.triangles_of(edge);
    const std::array unknown{facets.known(both[0]) == nullptr, facets.known(both[1]) == nullptr};
    if (!unknown[0] && !unknown[1]) continue;
    const surfaces::PartBorder* border =
        placed.part == nullptr ? nullptr : placed.part->border_at(static_cast<std::ptrdiff_t>(e));
    if (border != nullptr && border->kind == surfaces::BorderKind::sharp) continue;
    const std::array sides{across(facets, edge, both[0]), across(facets, edge, both[1])};
    const std::array lengths{glm::length(sides[0]), glm::length(sides[1])};
    if (!(lengths[0] > 0 && lengths[1] > 0)) continue;
    const double fold = glm::length(sides[0] / lengths[0] + sides[1] / lengths[1]);
    if (!(fold < sharp)) continue;
    for (std::size_t side = 0; side < 2; ++side) {
      if (!unknown[side]) continue;
      // Of a circle with this chord, whose tangents turn by the fold.
      heights[static_cast<std::size_t>(both[side])] += lengths[side] * fold / 4 / (1 + std::sqrt(1 - fold * fold / 4));
      estimated[static_cast<std::size_t>(both[side])] = 1;
    }
  }
}

}  // namespace

FacetHeights facet_heights(const World& world, const Progress& progress) {
  FacetHeights heights{
      std::vector<double>(world.triangles.size(), 0), {}, std::vector<char>(world.triangles.size(), 0), {}};
  for (int model = 0; model < static_cast<int>(world.models.size()); ++model) {
    progress.expect_time();
    const FacetsOfModel facets(world, model);
    const auto first = static_cast<std::size_t>(facets.first()), count = static_cast<std::size_t>(facets.count());
    const std::span of_model = std::span(heights.of_triangle).subspan(first, count);
    const std::span estimated = std::span(heights.is_estimated).subspan(first, count);
    add_known(facets, 1, of_model, progress);
    add_estimates(facets, of_model, estimated);
    const auto largest = std::max_element(of_model.begin(), of_model.end());
    heights.of_model.push_back(count == 0 ? 0 : *largest);
    heights.model_is_estimated.push_back(count == 0 ? 0
                                                    : estimated[static_cast<std::size_t>(largest - of_model.begin())]);
  }
  return heights;
}

double tessellation_error(const World& world, const Progress& progress) {
  double largest = 0;
  for (int model = 0; model < static_cast<int>(world.models.size()); ++model) {
    progress.expect_time();
    const FacetsOfModel facets(world, model);
    std::vector<double> heights(static_cast<std::size_t>(facets.count()), 0);
    add_known(facets, 0, heights, progress);
    for (const double height : heights) largest = std::max(largest, height);
  }
  return largest;
}

}  // namespace epura::world
