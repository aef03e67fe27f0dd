// SPDX-License-Identifier: Apache-2.0
#include "laboratory/lab.hpp"

#include <array>
#include <memory>
#include <optional>
#include <utility>

#include "refine/refine_world.hpp"
#include "visibility/folds.hpp"

namespace epura::laboratory {

projection::Projection orthographic(const Vec3& towards_viewer, const Vec3& up) {
  projection::Projection p;
  p.name = "study";
  p.point = Vec3(0);
  p.n = glm::normalize(towards_viewer);
  p.u = glm::normalize(glm::cross(up, p.n));
  p.v = glm::cross(p.n, p.u);
  p.projector = p.n;
  return p;
}

projection::Projection from_above() { return orthographic({0, 0, 1}, {0, 1, 0}); }

projection::Projection perspective(const Vec3& eye, const Vec3& point, const Vec3& normal, const Vec3& up) {
  projection::Projection p = orthographic(normal, up);
  p.central = true;
  p.point = point;
  p.projector = eye;
  return p;
}

int Result::pieces(bool visible) const {
  int count = 0;
  for (const drawing::Segment& s : drawing.segments) count += s.visible == visible ? 1 : 0;
  return count;
}

double Result::length(bool visible) const {
  double sum = 0;
  for (const drawing::Segment& s : drawing.segments)
    if (s.visible == visible) sum += glm::length(s.to - s.from);
  return sum * unit;
}

double Result::merge_width() const { return drawing::coincidence_on_paper(view, {1, Vec2(0)}).tolerance * unit; }

world::World Lab::prepare(world::World world) const {
  return recognises ? recognised(std::move(world)) : std::move(world);
}

world::World Lab::world_of(const std::vector<Shape>& shapes) const { return prepare(laboratory::world_of(shapes)); }

Result Lab::draw(world::World world, const Camera& camera, const edges::EdgeOptions& options) const {
  std::optional<world::World> refined = refine::refine_world(world, camera.projection);
  Result r{refined ? std::move(*refined) : std::move(world), {}, {}, {}, {}, 1, {}};
  r.view = view_by(r.world, camera, arithmetic);
  r.unit = 1 / r.view.map.normalisation;
  r.condition = view::condition_of(camera.projection, r.world.box);
  r.drawn = edges::find_feature_edges(r.world, r.view, options);
  visibility::find_clear_contours(r.world, r.view, r.drawn);
  r.hidden = visibility::find_hidden(r.world, r.view, r.drawn);
  visibility::hide_folds(r.world, r.view, r.drawn, r.hidden);
  r.drawing = drawing::make_drawing({r.world, r.view, r.drawn, r.hidden}, {1, Vec2(0)}, {"study", true});
  return r;
}

HiddenLine Lab::hidden_of_line(const world::World& world, const projection::Projection& projection, const Vec3& from,
                               const Vec3& to) const {
  view::ProjectedScene view = view_by(world, {projection}, arithmetic);
  const UnsetVector<view::Mapped> ends = map_points(std::array{from, to}, {projection}, world.box, arithmetic);
  const int a = view::add_mapped_point(view, ends[0]);
  const int b = view::add_mapped_point(view, ends[1]);
  edges::FeatureEdges drawn;
  drawn.edges.push_back({{a, b}, {0, 1}, EdgeKind::intersection, 0, -1, 0});
  drawn.crossings.push_back({{from, to}, {-1, -1}, 90});
  const double unit = 1 / view.map.normalisation;
  return {visibility::find_hidden(world, view, drawn).spans, view.contact.touching / view.map.unit * unit,
          view.cell * unit, view.extent * unit};
}

}  // namespace epura::laboratory
