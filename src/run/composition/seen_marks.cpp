// SPDX-License-Identifier: Apache-2.0
#include "composition/seen_marks.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "search/halved_order.hpp"
#include "surfaces/limits.hpp"
#include "world/placed_part.hpp"

namespace epura::pipeline {

namespace {

// In sizes of the models: depths of facets that meet differ by less, and beside a line, its faces begin.
constexpr double depth_slack = 1e-3, beside_line = 2e-4;

// The edges of some triangles that belong to one of them only.
std::vector<std::array<int, 2>> borders_of(const world::World& world, const std::vector<std::size_t>& triangles) {
  std::map<std::array<int, 2>, int> uses;
  for (const std::size_t t : triangles)
    for (std::size_t k = 0; k < 3; ++k) {
      std::array<int, 2> edge{world.triangles[t][k], world.triangles[t][(k + 1) % 3]};
      std::sort(edge.begin(), edge.end());
      ++uses[edge];
    }
  std::vector<std::array<int, 2>> borders;
  for (const auto& [edge, count] : uses)
    if (count == 1) borders.push_back(edge);
  return borders;
}

bool is_seen_edge_on(const surfaces::PartFace& face, const Vec3& n) {
  using surfaces::SurfaceKind;
  const double along = std::abs(glm::dot(face.surface.axis, n));
  if (face.surface.kind == SurfaceKind::plane) return along <= max_tilt;
  return face.surface.kind == SurfaceKind::cylinder && along >= 1 - max_tilt * max_tilt;
}

}  // namespace

TrianglesByFace triangles_by_face(const world::World& world, std::size_t model) {
  const world::Placed& placed = world.models[model];
  if (placed.part == nullptr) return {};
  TrianglesByFace triangles(placed.part->faces.size());
  const std::vector<int> faces = world::faces_of_triangles(placed);
  const auto first = static_cast<std::size_t>(world.first_triangle[model]);
  for (std::size_t t = 0; t < faces.size(); ++t)
    if (faces[t] >= 0) triangles[static_cast<std::size_t>(faces[t])].push_back(first + t);
  return triangles;
}

FaceView::FaceView(std::string name, projection::Projection projection, const world::World& world)
    : name_(std::move(name)),
      projection_(std::move(projection)),
      world_(world),
      slack_(depth_slack * glm::length(world.box.size())) {
  std::vector<Vec2> places(world_.triangles.size());  // three times the centres
  for (std::size_t t = 0; t < places.size(); ++t) {
    const Corners page = corners_of(t);
    places[t] = Vec2(page[0] + page[1] + page[2]);
  }
  order_.resize(places.size());
  std::iota(order_.begin(), order_.end(), std::size_t{0});
  search::order_by_halving(order_.begin(), order_.end(), [&places](std::size_t t) { return places[t]; });
  tree_ = search::BoundsTree<3>(order_.size(), [this](std::size_t i) {
    const Corners page = corners_of(order_[i]);
    const auto [left, right] = std::minmax({page[0].x, page[1].x, page[2].x});
    const auto [low, high] = std::minmax({page[0].y, page[1].y, page[2].y});
    const auto [far, near] = std::minmax({page[0].z, page[1].z, page[2].z});
    return search::Bounds<3>{{{left, right}, {low, high}, {far, near}}};
  });
  for (std::size_t model = 0; model < world_.models.size(); ++model)
    triangles_.push_back(triangles_by_face(world_, model));
}

FaceView::Corners FaceView::corners_of(std::size_t triangle) const {
  Corners page;
  for (std::size_t k = 0; k < 3; ++k)
    page[k] = on_page(world_.points[static_cast<std::size_t>(world_.triangles[triangle][k])]);
  return page;
}

// Whether the line of sight through a place meets a face between two depths: the first one answers, of however many.
bool FaceView::has_face_between(const Vec2& place, double from, double to) const {
  bool is_met = false;
  tree_.visit({{{place.x, place.x}, {place.y, place.y}, {from, to}}}, [&](std::size_t i) {
    const PageTriangle seen(corners_of(order_[i]));
    const auto depth = seen.is_edge_on() ? std::nullopt : seen.depth_at(place);
    is_met = depth && from < *depth && *depth <= to;
    return !is_met;
  });
  return is_met;
}

bool FaceView::is_nearest(const Vec3& page) const { return !has_face_between(Vec2(page), page.z + slack_, HUGE_VAL); }

// A line is seen if nothing is nearer on either side: where there is nothing at all, it is clear what a mark on it
// means; less so where something is farther, least where another face begins. 0: it is not seen.
double FaceView::clarity_of_edge(const Vec3& page, const Vec2& across) const {
  constexpr double before_others = 0.3, at_another = 0.1;
  const Vec2 aside = beside_line * glm::length(world_.box.size()) * across;
  double clarity = at_another;
  for (const double side : {1.0, -1.0}) {
    const Vec2 place = Vec2(page) + side * aside;
    if (has_face_between(place, page.z + slack_, HUGE_VAL)) return 0;
    if (has_face_between(place, page.z - slack_, page.z + slack_)) continue;
    clarity = std::max(clarity, has_face_between(place, -HUGE_VAL, page.z - slack_) ? before_others : 1.0);
  }
  return clarity;
}

void FaceView::add_line(std::vector<SeenMark>& marks, const Vec3& from, const Vec3& to) const {
  const Vec3 a = on_page(from), b = on_page(to);
  const Vec2 along = Vec2(b) - Vec2(a);
  const double length = glm::length(along);
  if (!(length > 1e-6 * glm::length(world_.box.size()))) return;
  for (const double t : {0.5, 0.25, 0.75}) {
    const Vec3 page = a + t * (b - a);
    const double worth = length * (t == 0.5 ? 1 : 0.5) * clarity_of_edge(page, left_of(along / length));
    if (worth > 0) marks.push_back({in_world(page), true, worth});
  }
}

// The outlines of a full cylinder that is seen from the side.
void FaceView::add_outlines(std::vector<SeenMark>& marks, const surfaces::PartFace& face) const {
  const surfaces::PartSurface& surface = face.surface;
  if (surface.kind != surfaces::SurfaceKind::cylinder || face.inwards || face.sweep < surfaces::whole_turn) return;
  if (std::abs(glm::dot(surface.axis, projection_.n)) > max_tilt) return;
  const Vec3 out = surface.radius * glm::normalize(glm::cross(surface.axis, projection_.n));
  for (const Vec3& side : {out, -out})
    add_line(marks, surface.origin + face.from * surface.axis + side, surface.origin + face.to * surface.axis + side);
}

void FaceView::add_areas(std::vector<SeenMark>& marks, const std::vector<std::size_t>& triangles) const {
  for (const std::size_t t : triangles) {
    const Corners page = corners_of(t);
    const double area = std::abs(cross(Vec2(page[1] - page[0]), Vec2(page[2] - page[0]))) / 2;
    const Vec3 middle = (page[0] + page[1] + page[2]) / 3.0;
    if (area > 0 && is_nearest(middle)) marks.push_back({in_world(middle), false, std::sqrt(area)});
  }
}

std::vector<SeenMark> FaceView::marks_on(const FaceName& name, const surfaces::PartFace& face) const {
  std::vector<SeenMark> marks;
  const auto model = static_cast<std::size_t>(name.model), number = static_cast<std::size_t>(name.face);
  if (model >= triangles_.size() || number >= triangles_[model].size()) return marks;
  const std::vector<std::size_t>& triangles = triangles_[model][number];
  if (triangles.empty()) return marks;
  if (is_seen_edge_on(face, projection_.n)) {
    for (const auto& [from, to] : borders_of(world_, triangles))
      add_line(marks, world_.points[static_cast<std::size_t>(from)], world_.points[static_cast<std::size_t>(to)]);
  } else {
    add_outlines(marks, face);
    add_areas(marks, triangles);
  }
  std::stable_sort(marks.begin(), marks.end(), [](const SeenMark& a, const SeenMark& b) {
    return a.on_line != b.on_line ? a.on_line : a.worth > b.worth;
  });
  return marks;
}

}  // namespace epura::pipeline
