// SPDX-License-Identifier: Apache-2.0
#include "cut/revolved.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>

#include "base/error.hpp"
#include "scene/view_names.hpp"

namespace epura::cut {

namespace {

/// An outline in the cutting plane.
struct PlaneRing {
  std::vector<Vec3> corners;
  std::vector<Vec2> flat;  ///< the same, from the point of the section

  // By the even-odd rule.
  [[nodiscard]] bool encloses(const Vec2& p) const {
    bool inside = false;
    for (std::size_t i = 0; i < flat.size(); ++i) {
      const Vec2 &a = flat[i], &b = flat[(i + 1) % flat.size()];
      if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x)) inside = !inside;
    }
    return inside;
  }
};

std::vector<PlaneRing> rings_of(const CutWorld& cut, const WorldCutFace& face, const scene::CuttingPlane& plane) {
  std::vector<PlaneRing> rings;
  for (const std::vector<int>& ring : face.rings) {
    PlaneRing& flat = rings.emplace_back();
    for (const int v : ring) {
      const Vec3& p = cut.world.points[v];
      flat.corners.push_back(p);
      flat.flat.emplace_back(glm::dot(plane.right, p - plane.point), glm::dot(plane.up, p - plane.point));
    }
  }
  return rings;
}

// Tested in the middle of a side, since rings may touch in corners.
bool lies_in(const PlaneRing& ring, const PlaneRing& other) {
  return other.encloses((ring.flat[0] + ring.flat[1]) / 2.0);
}

// The outline around the point that encloses no other such one, and the outlines directly inside it; nothing if it
// bounds a hole, or none is around the point.
std::optional<std::vector<std::vector<Vec3>>> area_at_point(const std::vector<PlaneRing>& rings) {
  std::vector<std::size_t> around;
  for (std::size_t i = 0; i < rings.size(); ++i)
    if (rings[i].encloses(Vec2(0))) around.push_back(i);
  if (around.size() % 2 == 0) return std::nullopt;
  const auto innermost = std::find_if(around.begin(), around.end(), [&](std::size_t i) {
    return std::none_of(around.begin(), around.end(),
                        [&](std::size_t j) { return j != i && lies_in(rings[j], rings[i]); });
  });
  if (innermost == around.end()) return std::nullopt;
  const auto depth = [&](const PlaneRing& ring) {
    return std::count_if(rings.begin(), rings.end(),
                         [&](const PlaneRing& other) { return &other != &ring && lies_in(ring, other); });
  };
  const PlaneRing& outline = rings[*innermost];
  std::vector<std::vector<Vec3>> area{outline.corners};
  const auto hole_depth = depth(outline) + 1;
  for (const PlaneRing& ring : rings)
    if (&ring != &outline && lies_in(ring, outline) && depth(ring) == hole_depth) area.push_back(ring.corners);
  return area;
}

}  // namespace

void complete_revolved(scene::SceneDescription& scene) {
  for (scene::RevolvedDescription& one : scene.revolved)
    one.view = {*scene::whole_view(one.view, one.point.where, scene.views).name,
                one.view.given() ? one.view.where : one.point.where};
}

FaceAtPoint cut_face_at_point(const world::World& world, const scene::RevolvedDescription& section) {
  scene::SectionDescription description{{"revolved", section.point.where}, *section.point, *section.normal};
  description.beyond = {false, section.point.where};
  const CuttingSurface surface = make_cutting_surface(description);
  const CutWorld cut = cut_world(world, surface);
  for (const WorldCutFace& face : cut.faces)
    if (auto area = area_at_point(rings_of(cut, face, surface.plane))) return {face.model, face.body, std::move(*area)};
  refuse_input(section.point.where, "there is no material at the point of the revolved section",
               "move it into the part; the cutting plane goes through it");
}

}  // namespace epura::cut
