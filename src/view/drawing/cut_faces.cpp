// SPDX-License-Identifier: Apache-2.0
#include "drawing/cut_faces.hpp"

#include <array>
#include <cstddef>
#include <utility>

#include "drawing/limits.hpp"

namespace epura::drawing {

namespace {

// The corners of what a triangle has in front of the plane.
std::vector<Vec3> in_front(const world::World& world, int triangle, const scene::CuttingPlane& plane) {
  const std::array<int, 3>& corners = world.triangles[triangle];
  const auto height = [&](const Vec3& p) { return glm::dot(plane.normal, p - plane.point); };
  std::vector<Vec3> ring;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3 &a = world.points[corners[i]], &b = world.points[corners[(i + 1) % 3]];
    const double at_a = height(a), at_b = height(b);
    if (at_a > 0) ring.push_back(a);
    if ((at_a > 0) != (at_b > 0)) ring.push_back(a + at_a / (at_a - at_b) * (b - a));
  }
  return ring;
}

}  // namespace

bool is_seen(const scene::CuttingPlane& plane, const projection::Projection& projection) {
  const Vec3 to_viewer = projection.central ? projection.projector - plane.point : projection.projector;
  // Planes along the direction to the viewer are lines on the page.
  return glm::dot(plane.normal, to_viewer) > rounding_part * glm::length(to_viewer);
}

std::vector<PaperTriangle> before_cuts_on_paper(const world::World& world, const std::vector<std::vector<int>>& uncut,
                                                const cut::CuttingSurface& surface, const Mat4& world_to_page) {
  const bool is_positive = (world_to_page * Vec4(surface.plane.point, 1)).w > 0;
  std::vector<PaperTriangle> triangles;
  const auto add = [&](int triangle, const scene::CuttingPlane& plane) {
    std::vector<Vec2> ring;
    for (const Vec3& corner : in_front(world, triangle, plane)) {
      const Vec4 p = world_to_page * Vec4(corner, 1);
      if ((p.w > 0) == is_positive && p.w != 0) ring.emplace_back(p.x / p.w, p.y / p.w);
    }
    for (std::size_t i = 2; i < ring.size(); ++i) triangles.push_back({ring[0], ring[i - 1], ring[i]});
  };
  for (std::size_t r = 0; r < uncut.size(); ++r)
    for (const int triangle : uncut[r])
      if (surface.regions[r].plane) add(triangle, turned_plane(surface.regions[r]));
  return triangles;
}

std::vector<CutFace> cut_faces_on_paper(const cut::CutWorld& cut, const scene::CuttingPlane& plane,
                                        const world::World& world, view::ProjectedScene& view,
                                        const view::PaperMap& paper) {
  std::vector<CutFace> seen;
  if (!is_seen(plane, view.projection)) return seen;
  for (const cut::WorldCutFace& face : cut.faces) {
    CutFace on_paper{face.model, face.body, {}};
    const int shift = world.first_vertex[face.model] - cut.world.first_vertex[face.model];
    for (std::vector<int> ring : face.rings) {
      for (int& v : ring) v += shift;
      std::vector<Vec2> places;
      for (const int v : view::clip_ring(view, ring)) places.push_back(paper(view.vertices[v]));
      if (!places.empty()) on_paper.rings.push_back(std::move(places));
    }
    if (!on_paper.rings.empty()) seen.push_back(std::move(on_paper));
  }
  return seen;
}

}  // namespace epura::drawing
