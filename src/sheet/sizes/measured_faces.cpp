// SPDX-License-Identifier: Apache-2.0
#include "sizes/measured_faces.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <set>
#include <tuple>
#include <utility>

#include "base/error.hpp"
#include "definition/limits.hpp"
#include "features/tolerances.hpp"
#include "sizes/equal_features.hpp"
#include "sizes/feature_table.hpp"
#include "surfaces/least_squares.hpp"

namespace epura::sheet {

namespace {

using definition::End;
using definition::Row;
using definition::UnknownKind;
using surfaces::PartSurface;
using surfaces::SurfaceKind;

// Within the reach of borders.
std::vector<Box> reaches_of(const definition::Part& part) {
  const Vec3 slack(definition::good_base * part.size);
  std::vector<Box> reaches;
  for (const definition::Contact& contact : part.contacts) {
    Box& box = reaches.emplace_back();
    for (const Vec3& one : contact.points) box.add(one);
    box.min -= slack;
    box.max += slack;
  }
  return reaches;
}

bool is_within(const Box& box, const Vec3& point) {
  return glm::all(glm::greaterThanEqual(point, box.min)) && glm::all(glm::lessThanEqual(point, box.max));
}

}  // namespace

MeasuredFaces::MeasuredFaces(const DrawnPart& drawn, const definition::Directions& directions,
                             const definition::Unknowns& unknowns, const Notation& notation)
    : part_(drawn.part),
      hexagons_(drawn.marks.hexagons),
      directions_(directions),
      unknowns_(unknowns),
      notation_(notation),
      reaches_(reaches_of(drawn.part)),
      slack_(slack_of(drawn.part)) {}

std::vector<Vec3> MeasuredFaces::rims_around(const WorldCircle& circle) const {
  std::vector<Vec3> rims;
  for (const definition::Contact& contact : part_.contacts)
    if (is_around(contact.faces[0], circle) || is_around(contact.faces[1], circle))
      rims.insert(rims.end(), contact.points.begin(), contact.points.end());
  return rims;
}

int MeasuredFaces::hexagon_of(int side, int other) const {
  for (const definition::Hexagon& one : hexagons_)
    if (std::ranges::count(one.sides, side) + std::ranges::count(one.sides, other) == 2) return one.face;
  return -1;
}

int MeasuredFaces::face_along(const Vec3& along) const {
  for (std::size_t i = 0; i < directions_.directions.size(); ++i)
    if (features::are_parallel(directions_.directions[i], along)) return directions_.first_face[i];
  return -1;
}

// A plane, an axis or a centre whose place along a direction this is. What is drawn in line is one place.
std::optional<End> MeasuredFaces::place_at(const Vec3& point, const Vec3& along) const {
  for (int face = 0; face < all_faces(); ++face) {
    const PartSurface& one = surface(face);
    Vec3 anchor = unknowns_.anchor(face);
    if (!definition::has_place_along(one, along) || std::abs(glm::dot(point - anchor, along)) > slack_) continue;
    if (one.kind == SurfaceKind::cylinder || one.kind == SurfaceKind::cone)
      anchor += glm::dot(point - anchor, one.axis) * one.axis;
    return End{anchor, {face}, one.kind != SurfaceKind::plane};
  }
  return std::nullopt;
}

// Where an axis that leans meets a plane.
std::optional<End> MeasuredFaces::crossing_at(const Vec3& point) const {
  for (int face = 0; face < all_faces(); ++face) {
    const PartSurface& one = surface(face);
    if (!surfaces::has_axis(one.kind) || features::distance_from_line(point, one.origin, one.axis) > slack_) continue;
    for (int other = 0; other < all_faces(); ++other)
      if (const PartSurface& plane = surface(other); plane.kind == SurfaceKind::plane &&
                                                     std::abs(surfaces::signed_distance(plane, point)) <= slack_ &&
                                                     std::abs(glm::dot(plane.axis, one.axis)) >= definition::good_base)
        return End{point, {face, other}, true};
  }
  return std::nullopt;
}

// Where a round face ends in a direction.
std::optional<End> MeasuredFaces::side_at(const Vec3& point, const Vec3& along) const {
  for (int face = 0; face < all_faces(); ++face) {
    const PartSurface& one = surface(face);
    const bool is_across = std::abs(glm::dot(one.axis, along)) <= features::parallel;
    double reach = 0;
    if (one.kind == SurfaceKind::sphere || (one.kind == SurfaceKind::cylinder && is_across)) reach = one.radius;
    if (one.kind == SurfaceKind::torus) reach = is_across ? one.radius + one.minor : one.minor;
    if (reach <= 0) continue;
    const Vec3& anchor = unknowns_.anchor(face);
    const double off = glm::dot(point - anchor, along);
    if (std::abs(std::abs(off) - reach) > slack_) continue;
    Vec3 at = anchor + (off < 0 ? -reach : reach) * along;
    if (one.kind == SurfaceKind::torus && !is_across) at += one.radius * surfaces::square_to(one.axis)[0];
    return End{at, {face}};
  }
  return std::nullopt;
}

// A corner, between faces that meet there.
std::optional<End> MeasuredFaces::corner_at(const Vec3& point) const {
  End end{point, {}};
  const auto add = [&end](int face) {
    if (std::find(end.faces.begin(), end.faces.end(), face) == end.faces.end()) end.faces.push_back(face);
  };
  for (std::size_t i = 0; i < part_.contacts.size(); ++i) {
    if (!is_within(reaches_[i], point)) continue;
    for (const int face : part_.contacts[i].faces)
      if (const PartSurface& one = surface(face);
          one.kind != SurfaceKind::free_form && std::abs(surfaces::signed_distance(one, point)) <= slack_)
        add(face);
  }
  if (end.faces.empty()) return std::nullopt;
  return end;
}

// Edges whose place along a direction this is, each corner once.
std::vector<End> MeasuredFaces::edges_at(const Vec3& point, const Vec3& along) const {
  std::vector<End> ends;
  const auto before = [](const Vec3& a, const Vec3& b) { return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z); };
  std::set<Vec3, decltype(before)> done(before);
  for (const definition::Contact& contact : part_.contacts)
    for (const Vec3& one : contact.points)
      if (std::abs(glm::dot(one - point, along)) <= slack_ && done.insert(one).second)
        if (std::optional<End> end = corner_at(one);
            end && !definition::end_motion(unknowns_, part_, *end, along).empty())
          ends.push_back(std::move(*end));
  return ends;
}

Row MeasuredFaces::length(const Vec3& from, const Vec3& to, const Vec3& along) const {
  std::vector<Row> rows = lengths(from, to, along);
  return rows.empty() ? Row{} : std::move(rows.front());
}

std::vector<Row> MeasuredFaces::lengths(const Vec3& from, const Vec3& to, const Vec3& along) const {
  std::array<std::vector<End>, 2> ends;
  const int direction = face_along(along);
  for (const int side : {0, 1}) {
    const Vec3& point = side == 0 ? from : to;
    std::vector<End>& found = ends[static_cast<std::size_t>(side)];
    for (const auto& end : {corner_at(point), place_at(point, along), crossing_at(point), side_at(point, along)})
      if (found.empty() && end && !definition::end_motion(unknowns_, part_, *end, along).empty()) found.push_back(*end);
    if (found.empty()) found = edges_at(point, along);
  }
  std::vector<Row> rows;
  const auto is_line = [&](const End& end) {
    const SurfaceKind kind = surface(end.faces.front()).kind;
    return end.is_axis && end.faces.size() == 1 && (kind == SurfaceKind::cylinder || kind == SurfaceKind::cone);
  };
  for (std::size_t i = 0; i < ends[0].size(); ++i) {
    const End& first = ends[0][i];
    // Along a direction of faces, all others are sums of those of the first two ends.
    const std::size_t count = direction >= 0 && i > 0 ? 1 : ends[1].size();
    for (std::size_t j = 0; j < count; ++j) {
      End second = ends[1][j];
      Vec3 off = second.at - first.at;
      // From one axis to another, wherever along them.
      if (direction < 0 && is_line(first) && is_line(second)) {
        const Vec3& axis = surface(second.faces[0]).axis;
        second.at -= glm::dot(off, axis) * axis;
        off = second.at - first.at;
      }
      const Vec3 aside = off - glm::dot(off, along) * along;
      const bool is_aside = glm::length(aside) > slack_;
      // What no face has as its direction turns with one that is square to it.
      const int turning = direction < 0 && is_aside ? face_along(glm::normalize(aside)) : direction;
      if (turning < 0 && is_aside) continue;
      if (Row row = definition::length(unknowns_, part_, {first, second}, along, turning); !row.empty())
        rows.push_back(std::move(row));
    }
  }
  check(rows.size() <= ends[0].size() * ends[1].size(), "a length is between two ends");
  return rows;
}

bool MeasuredFaces::are_alike(double a, double b) const { return agree(a, b) || are_written_alike(a, b, notation_); }

bool MeasuredFaces::is_around(int face, const WorldCircle& circle) const {
  const PartSurface& one = surface(face);
  if (one.kind == SurfaceKind::sphere)
    return features::distance_from_line(one.origin, circle.centre, circle.axis) <= slack_;
  return surfaces::has_axis(one.kind) && features::are_parallel(one.axis, circle.axis) &&
         features::distance_from_line(circle.centre, one.origin, one.axis) <= slack_;
}

// The size of a round face that a radius may be.
Row MeasuredFaces::size(int face, double radius) const {
  const PartSurface& one = surface(face);
  if (one.kind == SurfaceKind::cone || one.kind == SurfaceKind::plane) return {};
  if (are_alike(one.radius, radius)) return unknowns_.growth(face, UnknownKind::radius);
  if (one.kind == SurfaceKind::torus && are_alike(one.minor, radius)) return unknowns_.growth(face, UnknownKind::minor);
  return {};
}

// The diameter of a circle that faces leave where they meet: the end of a cone, or a ring of a torus.
Row MeasuredFaces::rim(const WorldCircle& circle) const {
  const Vec3 out = surfaces::square_to(circle.axis)[0];
  std::array<End, 2> ends;
  for (const int side : {0, 1}) {
    const Vec3 at = circle.centre + (side == 0 ? -circle.radius : circle.radius) * out;
    End& end = ends[static_cast<std::size_t>(side)];
    end.at = at;
    for (int face = 0; face < all_faces(); ++face)
      if (const PartSurface& one = surface(face);
          (is_around(face, circle) ||
           (one.kind == SurfaceKind::plane && features::are_parallel(one.axis, circle.axis))) &&
          std::abs(surfaces::signed_distance(one, at)) <= slack_)
        end.faces.push_back(face);
    if (end.faces.empty()) return {};
  }
  return definition::diameter(unknowns_, part_, ends);
}

std::vector<WorldCircle> MeasuredFaces::rims_of_cones(double radius) const {
  std::vector<WorldCircle> rims;
  for (const definition::Contact& contact : part_.contacts)
    for (const int face : contact.faces) {
      const PartSurface& one = surface(face);
      if (one.kind != SurfaceKind::cone) continue;
      const Vec3& point = contact.points.front();
      const Vec3 foot = one.origin + glm::dot(point - one.origin, one.axis) * one.axis;
      if (are_alike(glm::distance(point, foot), radius) &&
          std::none_of(rims.begin(), rims.end(),
                       [&](const WorldCircle& rim) { return glm::distance(rim.centre, foot) <= slack_; }))
        rims.push_back({foot, one.axis, radius, {}, true});
    }
  return rims;
}

// A face of which a leg lies in its side, seen along a direction; its axis if the leg is a centre line; two axes if it
// goes from one to the other.
Row MeasuredFaces::turn_of_leg(const Vec3& corner, const Vec3& end, const Vec3& sight) const {
  const Vec3 leg = glm::normalize(end - corner), normal = glm::cross(sight, leg);
  for (int face = 0; face < all_faces(); ++face) {
    const PartSurface& one = surface(face);
    if (one.kind != SurfaceKind::plane && one.kind != SurfaceKind::cone) continue;
    const bool is_it = features::are_parallel(surfaces::normal_near(one, end), normal) &&
                       std::abs(surfaces::signed_distance(one, end)) <= slack_;
    if (is_it) return unknowns_.side_turn(face, end, sight);
  }
  for (const Vec3& wanted : {normal, leg})
    if (const int face = face_along(wanted); face >= 0) return unknowns_.turn(face, sight);
  const int from = axis_through(corner, sight), to = axis_through(end, sight);
  if (from < 0 || to < 0 || from == to) return {};
  check(from != to, "a leg has two ends");
  Row row = unknowns_.axis_motion(to, end, normal);
  definition::add(row, unknowns_.axis_motion(from, corner, normal), -1);
  Row turn;
  definition::add(turn, row, part_.size / glm::distance(corner, end));
  return definition::tidy(std::move(turn));
}

int MeasuredFaces::axis_through(const Vec3& point, const Vec3& along) const {
  for (int face = 0; face < all_faces(); ++face)
    if (const PartSurface& one = surface(face); surfaces::has_axis(one.kind) &&
                                                features::are_parallel(one.axis, along) &&
                                                features::distance_from_line(point, one.origin, one.axis) <= slack_)
      return face;
  return -1;
}

}  // namespace epura::sheet
