// SPDX-License-Identifier: Apache-2.0
// The input of a verification: the drawn edges of a world and their drawing.
#pragma once

#include <array>

#include "drawing/drawing.hpp"
#include "edges/find_edges.hpp"
#include "verify/sight.hpp"
#include "view/projected_scene.hpp"
#include "visibility/visibility.hpp"
#include "world/world.hpp"

namespace epura::verify {

struct VerifyInput {
  const world::World& world;
  const projection::Projection& projection;
  const view::ViewLimits& limits;
  const edges::FeatureEdges& drawn;
  const visibility::HiddenSpans& hidden;
  const drawing::ViewDrawing& drawing;

  /// The ends of the whole edge in the world, even if it is cut; parameters t run from the first to the second.
  [[nodiscard]] std::array<Vec3, 2> ends_of(const edges::FeatureEdge& edge) const;
  /// The vertices of the world at an edge of a model's mesh.
  [[nodiscard]] std::array<int, 2> vertices_of(int model, int mesh_edge) const;
  /// Whether a triangle contains the edge: in the mesh, or as one of the two triangles that cross there.
  [[nodiscard]] bool contains(const edges::FeatureEdge& edge, int triangle) const;
  /// Whether a triangle has a corner in common with the edge.
  [[nodiscard]] bool joined(const edges::FeatureEdge& edge, int triangle) const;
};

/// Returns the parameters for looking at it: plane and projectors from the projection, units of the page from the
/// drawing's matrix.
Viewing viewing_of(const VerifyInput& input);

}  // namespace epura::verify
