// SPDX-License-Identifier: Apache-2.0
#include "drawing/cut_faces.hpp"

#include <utility>

namespace epura::drawing {

namespace {

// Planes at a smaller angle (radians) to the viewer's direction are lines on the page.
constexpr double edge_on = 1e-9;

bool is_seen(const scene::CuttingPlane& plane, const projection::Projection& projection) {
  const Vec3 to_viewer = projection.central ? projection.projector - plane.point : projection.projector;
  return glm::dot(plane.normal, to_viewer) > edge_on * glm::length(to_viewer);
}

}  // namespace

std::vector<CutFace> cut_faces_on_paper(const std::vector<scene::WorldCutFace>& faces, const scene::CuttingPlane& plane,
                                        view::ProjectedScene& view, const view::PaperMap& paper) {
  std::vector<CutFace> seen;
  if (!is_seen(plane, view.projection)) return seen;
  for (const scene::WorldCutFace& face : faces) {
    CutFace on_paper{face.model, face.body, {}};
    for (const std::vector<int>& ring : face.rings) {
      std::vector<Vec2> places;
      for (const int v : view::clip_ring(view, ring)) places.push_back(paper(view.vertices[v]));
      if (!places.empty()) on_paper.rings.push_back(std::move(places));
    }
    if (!on_paper.rings.empty()) seen.push_back(std::move(on_paper));
  }
  return seen;
}

}  // namespace epura::drawing
