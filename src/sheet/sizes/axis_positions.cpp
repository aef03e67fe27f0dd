// SPDX-License-Identifier: Apache-2.0
#include "sizes/axis_positions.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/error.hpp"
#include "features/tolerances.hpp"
#include "sizes/hole_directions.hpp"

namespace epura::sheet {

namespace {

using features::are_parallel;
using features::parallel;

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
  for (const NamedProjection* view : plan.views.all()) {
    if (along == nullptr && are_parallel(view->projection.n, axis)) continue;  // a section has removed it there
    if (shows_length_along(*view, direction) && (best == nullptr || facing(view) > facing(best) + parallel))
      best = view;
  }
  return best;
}

// Whether a section has removed all of what has an axis beside its plane.
bool is_removed(const NamedProjection& view, const Vec3& centre, const Vec3& axis) {
  return !view.aligned() && std::abs(glm::dot(view.projection.n, axis)) <= parallel && !keeps(view, centre);
}

/// Where the axis of a feature meets a plane face that is square to it.
struct Foot {
  const features::PlaneFeature* face;
  Vec3 at;
};

// Among the corners of a face.
bool is_within(const Vec3& p, const features::PlaneFeature& face, double slack) {
  Box box;
  for (const Vec3& corner : face.corners) box.add(corner);
  return glm::all(glm::lessThanEqual(box.min, p + slack)) && glm::all(glm::greaterThanEqual(box.max, p - slack));
}

// The nearest one: features may be cut off before it, as a bore is by another face.
std::optional<Foot> foot_of(const Planning& plan, const Vec3& centre, const Vec3& axis) {
  const double slack = features::same_size * glm::length(plan.box.size());
  std::optional<Foot> nearest;
  for (const features::PlaneFeature& plane : plan.subject.features.inclined) {
    if (!are_parallel(plane.normal, axis)) continue;
    const Vec3 foot = centre + glm::dot(plane.corners.front() - centre, axis) * axis;
    if (is_within(foot, plane, slack) &&
        (!nearest || glm::distance(foot, centre) < glm::distance(nearest->at, centre) - slack))
      nearest = {&plane, foot};
  }
  return nearest;
}

/// A place of a row along a slope.
struct RowPlace {
  double at;
  Vec3 centre;
};

// Of one group on one face, without those at `known` places.
std::vector<RowPlace> row_of(const SlantedPlace& first, std::span<const SlantedPlace> places,
                             std::span<const double> known, double slack) {
  std::vector<RowPlace> row;
  for (const SlantedPlace& place : places) {
    if (place.face != first.face || place.group != first.group || place.view != first.view) continue;
    const double at = glm::dot(place.centre, place.along);
    check(std::isfinite(at), "features are at places");
    const auto is_there = [&](double other) { return std::abs(other - at) <= slack; };
    if (std::none_of(known.begin(), known.end(), is_there) &&
        std::none_of(row.begin(), row.end(), [&](const RowPlace& other) { return is_there(other.at); }))
      row.push_back({at, place.centre});
  }
  return row;
}

// From the end of the face that is on the left or below in the view.
double base_of_slope(const SlantedPlace& place) {
  const projection::Projection& projection = place.view->projection;
  const double way = glm::dot(place.along, projection.u + 1e-3 * projection.v) < 0 ? -1 : 1;
  double base = HUGE_VAL;
  for (const Vec3& corner : place.face->corners) base = std::min(base, way * glm::dot(corner, place.along));
  return way * base;
}

std::vector<scene::DimensionDescription> row_dimensions(const Planning& plan, const SlantedPlace& of,
                                                        std::vector<RowPlace> places, double slack) {
  const double base = base_of_slope(of);
  std::stable_sort(places.begin(), places.end(),
                   [&](const RowPlace& a, const RowPlace& b) { return std::abs(a.at - base) < std::abs(b.at - base); });
  std::vector<scene::DimensionDescription> dimensions;
  const auto measure = [&](double from, const RowPlace& to, const std::string& text) {
    if (std::abs(to.at - from) <= slack) return;
    dimensions.push_back(plan.dimension(DimensionType::aligned, *of.view, text));
    dimensions.back().anchors = {to.centre + (from - to.at) * of.along, to.centre};
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
    return dimensions;
  }
  for (std::size_t i = 1; i < places.size(); ++i) measure(base, places[i], "<>");
  return dimensions;
}

// Along the own axes of a turned part, from the faces that are rather on the left and below.
Planned own_positions_of(const features::TurnedPart& part, std::span<const Vec3> centres, const NamedProjection& view,
                         int group) {
  Planned planned;
  for (const std::size_t side : {0U, 1U}) {
    const Vec3& along = part.directions[side];
    const double right = glm::dot(along, view.projection.u), up = glm::dot(along, view.projection.v);
    const features::PlaneFeature* base = part.ends[side][(std::abs(right) > std::abs(up) ? right : up) < 0 ? 1 : 0];
    for (const Vec3& centre : centres) planned.places.emplace_back(SlantedPlace{&view, base, along, centre, group});
  }
  return planned;
}

}  // namespace

Planned positions_of(const Planning& plan, std::span<const Vec3> centres, const Vec3& axis,
                     const NamedProjection* along, int group) {
  check(!centres.empty(), "a group of features has one");
  if (along != nullptr && plan.table.is_turned(axis))
    return own_positions_of(*plan.table.turned, centres, *along, group);
  Planned planned;
  for (int world = 0; world < 3; ++world)
    if (std::abs(axis[world]) <= parallel)
      if (const NamedProjection* view = view_along(plan, world, axis, along))
        for (const Vec3& centre : centres)
          if (!is_removed(*view, centre, axis))
            planned.places.emplace_back(Coordinate{view, world, centre[world], centre, group, centre});
  if (features::axis_along(axis) >= 0) return planned;
  const std::optional<Vec3> slanted = slanted_across(axis);
  const NamedProjection* view = plan.views.along(axis);
  if (view == nullptr && slanted) view = plan.views.beside(*slanted, centres.front());
  for (const Vec3& centre : centres) {
    const std::optional<Foot> foot = slanted && view != nullptr ? foot_of(plan, centre, axis) : std::nullopt;
    if (!foot) {
      if (group >= 0 && std::cmp_less(group, plan.table.sizes.size()))
        ++planned.omitted.askew[plan.table.sizes[static_cast<std::size_t>(group)].name];
      continue;
    }
    // One direction for all that begins on a face.
    const Vec3 direction = glm::dot(foot->face->normal, axis) < 0 ? -*slanted : *slanted;
    planned.places.emplace_back(SlantedPlace{view, foot->face, direction, foot->at, group});
  }
  return planned;
}

std::vector<scene::DimensionDescription> slanted_dimensions(const Planning& plan,
                                                            std::span<const SlantedPlace> places) {
  const double slack = features::same_size * glm::length(plan.box.size());
  std::map<const features::PlaneFeature*, std::vector<double>> known;
  std::vector<scene::DimensionDescription> dimensions;
  for (const SlantedPlace& place : places) {
    std::vector<double>& of_face = known[place.face];
    std::vector<RowPlace> row = row_of(place, places, of_face, slack);
    if (row.empty()) continue;
    for (const RowPlace& one : row) of_face.push_back(one.at);
    for (scene::DimensionDescription& dimension : row_dimensions(plan, place, std::move(row), slack))
      dimensions.push_back(std::move(dimension));
  }
  return dimensions;
}

}  // namespace epura::sheet
