// SPDX-License-Identifier: Apache-2.0
#include "sheet/dimensions/axis_positions.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "base/error.hpp"
#include "design/tolerances.hpp"
#include "sheet/dimensions/equal_features.hpp"

namespace epura::sheet {

namespace {

using design::are_parallel;
using design::parallel;

bool shows_length_along(const NamedProjection& view, const Vec3& direction) {
  return are_parallel(view.projection.u, direction) || are_parallel(view.projection.v, direction);
}

// The view that shows lengths along an axis of the world as such, horizontally or vertically, and sees the mouth of
// what has another axis best.
const NamedProjection* view_along(const Planning& plan, int world, const Vec3& axis, const NamedProjection* along) {
  const Vec3 direction = Mat3(1)[world];
  if (along != nullptr && shows_length_along(*along, direction)) return along;
  const NamedProjection* best = nullptr;
  const auto facing = [&](const NamedProjection* view) { return std::abs(glm::dot(view->projection.n, axis)); };
  for (const NamedProjection* view : plan.views.all())
    if (shows_length_along(*view, direction) && (best == nullptr || facing(view) > facing(best) + parallel))
      best = view;
  return best;
}

// The plane face on which a feature begins.
const design::DesignPlane* face_around(const Planning& plan, const Vec3& centre, const Vec3& axis) {
  const double slack = design::same_size * glm::length(plan.box.size());
  for (const design::DesignPlane& plane : plan.subject.features.inclined)
    if (are_parallel(plane.normal, axis) && std::abs(glm::dot(plane.corners.front() - centre, axis)) <= slack)
      return &plane;
  return nullptr;
}

/// A place along a slope.
struct SlantedPlace {
  double at;
  Vec3 centre;
};

void add_slanted_row(Planning& plan, const NamedProjection& view, const Vec3& along, std::vector<SlantedPlace> places,
                     double base) {
  std::sort(places.begin(), places.end(), [&](const SlantedPlace& a, const SlantedPlace& b) {
    return std::abs(a.at - base) < std::abs(b.at - base);
  });
  const double slack = design::same_size * glm::length(plan.box.size());
  const auto is_same = [&](const SlantedPlace& a, const SlantedPlace& b) { return std::abs(a.at - b.at) <= slack; };
  places.erase(std::unique(places.begin(), places.end(), is_same), places.end());
  const auto measure = [&](double from, const SlantedPlace& to, const std::string& text) {
    if (std::abs(to.at - from) <= slack) return;
    plan.add(DimensionType::aligned, view, text).anchors = {to.centre + (from - to.at) * along, to.centre};
  };
  check(!places.empty(), "a row has a place");
  const double pitch = places.size() < 2 ? 0 : places[1].at - places[0].at;
  bool is_row = places.size() > 2;
  for (std::size_t i = 1; i < places.size(); ++i)
    is_row = is_row && std::abs(places[i].at - places[i - 1].at - pitch) <= slack;
  measure(base, places.front(), "<>");
  if (is_row) {
    const std::string steps = std::to_string(places.size() - 1) + "× " + plan.length(std::abs(pitch)) + " (=<>)";
    measure(places.front().at, places.back(), steps);
    return;
  }
  for (std::size_t i = 1; i < places.size(); ++i) measure(base, places[i], "<>");
}

// From the end of the face that is on the left or below in the view.
void add_slanted(Planning& plan, std::span<const Vec3> centres, const Vec3& axis, const Vec3& along) {
  const NamedProjection* view = plan.views.along(axis);
  if (view == nullptr) view = plan.views.beside(along, centres.front());
  std::vector<std::pair<const design::DesignPlane*, std::vector<SlantedPlace>>> rows;
  for (const Vec3& centre : centres) {
    const design::DesignPlane* face = face_around(plan, centre, axis);
    if (face == nullptr || view == nullptr) continue;
    const auto row = std::find_if(rows.begin(), rows.end(), [&](const auto& one) { return one.first == face; });
    const SlantedPlace place{glm::dot(centre, along), centre};
    check(std::isfinite(place.at), "holes are at places");
    if (row == rows.end())
      rows.push_back({face, {place}});
    else
      row->second.push_back(place);
  }
  for (auto& [face, places] : rows) {
    const double way = glm::dot(along, view->projection.u + 1e-3 * view->projection.v) < 0 ? -1 : 1;
    double base = HUGE_VAL;
    for (const Vec3& corner : face->corners) base = std::min(base, way * glm::dot(corner, along));
    add_slanted_row(plan, *view, along, std::move(places), way * base);
  }
}

}  // namespace

std::optional<Vec3> slanted_across(const Vec3& axis) {
  if (design::axis_along(axis) >= 0) return std::nullopt;
  for (int world = 0; world < 3; ++world)
    if (std::abs(axis[world]) <= parallel) return glm::normalize(glm::cross(Mat3(1)[world], axis));
  return std::nullopt;
}

void add_positions(Planning& plan, std::span<const Vec3> centres, const Vec3& axis, const NamedProjection* along) {
  check(!centres.empty(), "a group of features has one");
  for (int world = 0; world < 3; ++world)
    if (std::abs(axis[world]) <= parallel)
      if (const NamedProjection* view = view_along(plan, world, axis, along))
        for (const Vec3& centre : centres) plan.stations.add({view, world, centre[world], centre, plan.groups, centre});
  if (const auto slanted = slanted_across(axis)) add_slanted(plan, centres, axis, *slanted);
}

}  // namespace epura::sheet
