// SPDX-License-Identifier: Apache-2.0
#include "sizes/noted_faces.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <optional>
#include <utility>

#include "base/angle.hpp"
#include "base/error.hpp"
#include "definition/limits.hpp"
#include "features/tolerances.hpp"
#include "sizes/equal_features.hpp"
#include "world/placed_part.hpp"

namespace epura::sheet {

using definition::Row;
using definition::UnknownKind;
using surfaces::PartSurface;
using surfaces::SurfaceKind;

NotedFaces::NotedFaces(const DrawnPart& drawn, const definition::Unknowns& unknowns, const MeasuredFaces& measured)
    : part_(drawn.part),
      count_(drawn.faces),
      unknowns_(unknowns),
      measured_(measured),
      slack_(slack_of(drawn.part)),
      are_parts_(drawn.part.faces.size(), 0) {
  for (const definition::Contact& contact : part_.contacts) {
    const Vec3 along = contact.points.back() - contact.points.front();
    if (!contact.is_tangent || glm::length(along) <= slack_) continue;
    for (const int face : contact.faces)
      if (surface(face).kind == SurfaceKind::cylinder &&
          features::are_parallel(glm::normalize(along), surface(face).axis))
        are_parts_[static_cast<std::size_t>(face)] = 1;
  }
}

bool NotedFaces::is_of_part(const WorldCircle& circle) const {
  for (int face = 0; face < static_cast<int>(count_); ++face)
    if (is_part(face) && measured_.is_around(face, circle) && measured_.are_alike(surface(face).radius, circle.radius))
      return true;
  return false;
}

std::vector<WorldCircle> NotedFaces::with_all(std::vector<WorldCircle> circles,
                                              std::span<const NotedNumber> numbers) const {
  std::erase_if(circles, [&](const WorldCircle& circle) {
    return std::ranges::any_of(numbers, [&](const NotedNumber& number) {
      return number.kind != NumberKind::any && rows_of(number, circle).empty();
    });
  });
  return circles;
}

// Nothing else than its size tells which face a number means.
std::vector<Row> NotedFaces::rows_of(const NotedNumber& number, const WorldCircle& circle) const {
  std::vector<Row> rows;
  if (number.kind == NumberKind::any || number.kind == NumberKind::depth)
    for (Depth& one : along_walls(depths(circle, number.value), circle, number.of > 0 ? number.of / 2 : circle.radius))
      rows.push_back(std::move(one.row));
  if (number.kind == NumberKind::any || number.kind == NumberKind::diameter) add_diameters(rows, circle, number.value);
  if (number.kind == NumberKind::any || number.kind == NumberKind::degrees) add_angles(rows, circle, number);
  std::erase_if(rows, [](const Row& row) { return row.empty(); });
  return rows;
}

// The widest wall about the axis of a thread that its diameter does not exceed.
WorldCircle NotedFaces::bore_of(WorldCircle thread) const {
  std::optional<double> widest;
  for (int face = 0; face < static_cast<int>(count_); ++face)
    if (const PartSurface& one = surface(face);
        one.kind == SurfaceKind::cylinder && one.radius >= core_of_thread * thread.radius &&
        one.radius <= thread.radius + slack_ && measured_.is_around(face, thread))
      widest = std::max(widest.value_or(one.radius), one.radius);
  if (widest) thread.radius = *widest;
  return thread;
}

std::vector<WorldCircle> NotedFaces::equal_circles(const AnchoredDimension& dimension, bool is_thread) const {
  const WorldCircle circle = is_thread ? bore_of(dimension.circles.front()) : dimension.circles.front();
  if (dimension.is_label) return {circle};
  std::vector<WorldCircle> equal{circle}, any{circle};
  const bool with_parts = is_of_part(circle);
  for (int face = 0; face < static_cast<int>(count_) && repeats_of(dimension.text) > 1; ++face) {
    const PartSurface& one = surface(face);
    if (one.kind != SurfaceKind::cylinder || (is_part(face) && !with_parts)) continue;
    const auto is_new = [&](const std::vector<WorldCircle>& list) {
      return std::none_of(list.begin(), list.end(),
                          [&](const WorldCircle& known) { return measured_.is_around(face, known); });
    };
    const WorldCircle own{one.origin, one.axis, one.radius, {}, true};
    if (is_new(equal) && measured_.are_alike(one.radius, circle.radius) &&
        features::are_parallel(one.axis, circle.axis))
      equal.push_back(own);
    if (is_new(any)) any.push_back(own);
  }
  check(any.size() >= equal.size(), "those of the same size are some of all");
  return equal.size() > 1 ? equal : any;
}

std::vector<NotedFaces::Depth> NotedFaces::depths(const WorldCircle& circle, double depth) const {
  const std::vector<Vec3> rims = measured_.rims_around(circle);
  std::vector<Depth> found;
  for (std::size_t i = 0; i < rims.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      const auto [low, high] =
          std::minmax({glm::dot(rims[i] - circle.centre, circle.axis), glm::dot(rims[j] - circle.centre, circle.axis)});
      const bool is_done = std::any_of(found.begin(), found.end(), [&, at = low + high](const Depth& one) {
        return std::abs(one.low + one.high - at) <= slack_;
      });
      if (!measured_.are_alike(high - low, depth) || is_done) continue;
      found.push_back({measured_.length(rims[j], rims[i], circle.axis), low, high});
    }
  add_depths_below_round_faces(found, circle, depth);
  std::erase_if(found, [](const Depth& one) { return one.row.empty(); });
  std::stable_sort(found.begin(), found.end(), [](const Depth& a, const Depth& b) { return a.high > b.high; });
  for (const Depth& one : found) check(one.low <= one.high, "a depth goes up along the axis");
  return found;
}

// Of radial holes, below the place where their axis meets a round face.
void NotedFaces::add_depths_below_round_faces(std::vector<Depth>& found, const WorldCircle& circle,
                                              double depth) const {
  std::vector<double> done;
  for (const Vec3& rim : measured_.rims_around(circle)) {
    const double at = glm::dot(rim - circle.centre, circle.axis);
    if (std::any_of(done.begin(), done.end(), [&](double one) { return std::abs(one - at) <= slack_; })) continue;
    done.push_back(at);
    const Vec3 floor = circle.centre + at * circle.axis;
    for (const double up : {-1, 1}) {
      const Vec3 mouth = floor + up * depth * circle.axis;
      if (!is_on_round_face(mouth, circle.axis)) continue;
      Row row = measured_.length(floor, mouth, circle.axis);
      if (row.empty()) row = measured_.length(rim, mouth, circle.axis);
      found.push_back({std::move(row), std::min(at, at + up * depth), std::max(at, at + up * depth)});
    }
  }
}

// Those that go along all of a wall of this radius, as the depth behind a diameter does; all if none does.
std::vector<NotedFaces::Depth> NotedFaces::along_walls(std::vector<Depth> all, const WorldCircle& circle,
                                                       double radius) const {
  std::map<int, std::array<double, 2>> walls;  // where each begins and ends
  for (const definition::Contact& contact : part_.contacts)
    for (const int face : contact.faces)
      if (const PartSurface& one = surface(face); one.kind == SurfaceKind::cylinder &&
                                                  measured_.are_alike(one.radius, radius) &&
                                                  measured_.is_around(face, circle))
        for (const Vec3& point : contact.points) {
          const double at = glm::dot(point - circle.centre, circle.axis);
          auto& [low, high] = walls.try_emplace(face, std::array{at, at}).first->second;
          low = std::min(low, at);
          high = std::max(high, at);
        }
  std::vector<Depth> along;
  for (const Depth& one : all)
    if (std::any_of(walls.begin(), walls.end(), [&](const auto& wall) {
          return one.low <= wall.second[0] + slack_ && one.high >= wall.second[1] - slack_;
        }))
      along.push_back(one);
  check(along.size() <= all.size(), "those along walls are some of all");
  return along.empty() ? all : along;
}

// Within its borders; a surface goes on beyond them.
bool NotedFaces::reaches(int face, const Vec3& place) const {
  Box box;
  for (const definition::Contact& contact : part_.contacts)
    if (contact.faces[0] == face || contact.faces[1] == face)
      for (const Vec3& point : contact.points) box.add(point);
  const Vec3 slack(definition::good_base * part_.size);
  return glm::all(glm::greaterThanEqual(place, box.min - slack)) &&
         glm::all(glm::lessThanEqual(place, box.max + slack));
}

// Whether a round face is perpendicular to a direction at a place.
bool NotedFaces::is_on_round_face(const Vec3& place, const Vec3& along) const {
  for (int face = 0; face < static_cast<int>(count_); ++face) {
    if (!world::is_round(surface(face).kind)) continue;
    const surfaces::Nearness near = surfaces::nearness_of(surface(face), place);
    if (std::abs(near.distance) <= slack_ && near.normal != Vec3(0) && features::are_parallel(near.normal, along) &&
        reaches(face, place))
      return true;
  }
  return false;
}

// Of round faces, and of the ends of cones.
void NotedFaces::add_diameters(std::vector<Row>& rows, const WorldCircle& circle, double diameter) const {
  std::vector<double> done;  // places of ends along the axis
  for (int face = 0; face < static_cast<int>(count_); ++face)
    if (measured_.is_around(face, circle))
      if (Row row = measured_.size(face, diameter / 2); !row.empty()) rows.push_back(std::move(row));
  for (const definition::Contact& contact : part_.contacts) {
    if (std::none_of(contact.faces.begin(), contact.faces.end(), [&](int face) {
          return surface(face).kind == SurfaceKind::cone && measured_.is_around(face, circle);
        }))
      continue;
    const Vec3& rim = contact.points.front();
    const double at = glm::dot(rim - circle.centre, circle.axis);
    const bool is_done =
        std::any_of(done.begin(), done.end(), [&](double one) { return std::abs(one - at) <= slack_; });
    if (is_done || !measured_.are_alike(2 * features::distance_from_line(rim, circle.centre, circle.axis), diameter))
      continue;
    rows.push_back(measured_.rim({circle.centre + at * circle.axis, circle.axis, diameter / 2, {}, true}));
    done.push_back(at);
  }
  std::erase_if(rows, [](const Row& row) { return row.empty(); });
  check(done.size() <= part_.contacts.size(), "an end of a cone counts once");
}

// Whether a face ends in a circle of this radius.
bool NotedFaces::has_rim(int face, const WorldCircle& circle, double radius) const {
  return std::any_of(part_.contacts.begin(), part_.contacts.end(), [&](const definition::Contact& contact) {
    return (contact.faces[0] == face || contact.faces[1] == face) &&
           measured_.are_alike(features::distance_from_line(contact.points.front(), circle.centre, circle.axis),
                               radius);
  });
}

// Of cones, between opposite sides or between a side and the axis: of those that have the diameter before it, if any.
void NotedFaces::add_angles(std::vector<Row>& rows, const WorldCircle& circle, const NotedNumber& angle) const {
  std::vector<int> cones, with_diameter;
  for (int face = 0; face < static_cast<int>(count_); ++face) {
    if (surface(face).kind != SurfaceKind::cone || !measured_.is_around(face, circle)) continue;
    const double half = std::atan(std::abs(surface(face).slope)) * degrees;
    if (!measured_.are_alike(2 * half, angle.value) && !measured_.are_alike(half, angle.value)) continue;
    cones.push_back(face);
    if (angle.of > 0 && has_rim(face, circle, angle.of / 2)) with_diameter.push_back(face);
  }
  for (const int face : with_diameter.empty() ? cones : with_diameter)
    rows.push_back(unknowns_.growth(face, UnknownKind::angle));
}

std::vector<Row> NotedFaces::thread(const WorldCircle& bore) const {
  std::vector<Row> rows;
  for (int face = 0; face < static_cast<int>(count_); ++face)
    if (measured_.is_around(face, bore) && measured_.are_alike(surface(face).radius, bore.radius))
      rows.push_back(unknowns_.growth(face, UnknownKind::radius));
  return rows;
}

}  // namespace epura::sheet
