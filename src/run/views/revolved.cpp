// SPDX-License-Identifier: Apache-2.0
#include "views/revolved.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/error.hpp"
#include "drawing/drawing.hpp"

namespace epura::pipeline {

namespace {

constexpr double edge_on = 1e-6;  // radians

void expect_edge_on(const scene::RevolvedDescription& one, const projection::Projection& projection) {
  const auto refuse = [&](const std::string& what, const std::string& hint) {
    throw Error(ErrorKind::input, one.normal.where, "view '" + *one.view + "' " + what, hint);
  };
  if (projection.central) refuse("is a perspective, which has no revolved section", "choose a parallel view");
  const Vec3 towards = glm::normalize(projection.projector);
  if (glm::dot(towards, projection.n) < 1 - edge_on)
    refuse("is oblique, and a section turned into it would be distorted", "choose a view along its projectors");
  if (std::abs(glm::dot(glm::normalize(*one.normal), towards)) > edge_on)
    refuse("does not see the plane of the revolved section edge-on", "its normal is parallel to the picture");
}

}  // namespace

std::vector<RevolvedSection> cut_revolved(const world::World& world, const scene::SceneDescription& scene,
                                          const scene::ViewDescription& view,
                                          const projection::Projection& projection) {
  std::vector<RevolvedSection> sections;
  for (const scene::RevolvedDescription& one : scene.revolved) {
    if (*one.view != *view.name) continue;
    expect_edge_on(one, projection);
    sections.push_back({one, cut::cut_face_at_point(world, one)});
  }
  return sections;
}

drawing::RevolvedFace turned_face(const RevolvedSection& section, const projection::Projection& projection,
                                  const Mat4& map) {
  const Vec3 &point = *section.description.point, normal = glm::normalize(*section.description.normal);
  const Vec3 axis = glm::cross(normal, projection.n);
  const auto image = [&](const Vec3& v, double w) { return Vec2(map * Vec4(v, w)); };
  const Vec2 middle = image(point, 1), along = image(axis, 0), across = image(normal, 0);
  drawing::RevolvedFace face;
  double from = HUGE_VAL, to = -HUGE_VAL;
  for (const std::vector<Vec3>& ring : section.face.rings) {
    std::vector<Vec2>& turned = face.rings.emplace_back();
    for (const Vec3& p : ring) {
      const double on_axis = glm::dot(axis, p - point), towards = glm::dot(projection.n, p - point);
      turned.push_back(middle + on_axis * along - towards * across);
      from = std::min(from, on_axis);
      to = std::max(to, on_axis);
    }
  }
  face.axis = {middle + from * along, middle + to * along};
  return face;
}

void add_revolved(drawing::ViewDrawing& drawing, const std::vector<RevolvedSection>& sections) {
  for (const RevolvedSection& section : sections) {
    const Vec4 whole = drawing.world_to_page * Vec4(*section.description.point, 1);
    const Vec2 place = Vec2(whole) / whole.w, shift = drawing.shown.breaks.moved(place) - place;
    if (!drawing.shown.breaks.keeps(place))
      throw Error(ErrorKind::input, section.description.point.where,
                  "view '" + drawing.name + "' leaves the point of the revolved section out",
                  "choose a point that the view shows, or break the view elsewhere");
    drawing::RevolvedFace face = turned_face(section, drawing.projection, drawing.world_to_page);
    for (std::vector<Vec2>& ring : face.rings)
      for (Vec2& p : ring) p += shift;
    for (Vec2& p : face.axis) p += shift;
    for (const std::vector<Vec2>& ring : face.rings)
      for (const Vec2& p : ring) {
        drawing.box.min = glm::min(drawing.box.min, p);
        drawing.box.max = glm::max(drawing.box.max, p);
      }
    drawing.cuts.faces.push_back({section.face.model, section.face.body, face.rings});
    drawing.cuts.revolved.push_back(std::move(face));
  }
}

}  // namespace epura::pipeline
