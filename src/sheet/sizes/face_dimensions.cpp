// SPDX-License-Identifier: Apache-2.0
#include "sizes/face_dimensions.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

#include "base/angle.hpp"
#include "base/error.hpp"
#include "base/portable_math.hpp"
#include "definition/limits.hpp"
#include "features/tolerances.hpp"
#include "sizes/axis_positions.hpp"
#include "sizes/prism_dimensions.hpp"
#include "sizes/slope_dimensions.hpp"
#include "surfaces/least_squares.hpp"

namespace epura::sheet {

namespace {

using features::are_parallel;
using scene::DimensionDescription;
using surfaces::PartSurface;
using surfaces::SurfaceKind;

// A short arc in the middle of what a view shows of a circle.
scene::FeatureCircle arc_towards(const Vec3& centre, const Vec3& normal, double radius, const Vec3& towards) {
  constexpr double half = 0.1;  // radians
  const Vec3 out = glm::normalize(towards), aside = glm::cross(normal, out);
  std::vector<Vec3> arc;
  for (const double turn : {-half, 0.0, half}) arc.push_back(centre + radius * glm::normalize(out + turn * aside));
  return {centre, normal, radius, std::move(arc)};
}

// The part of a circle about an axis where points are: beside the largest gap between them.
std::vector<Vec3> arc_through(const std::vector<Vec3>& points, const Vec3& centre, const Vec3& axis, double radius) {
  constexpr int parts = 8;
  const auto [u, v] = surfaces::square_to(axis);
  std::vector<double> angles;
  for (const Vec3& point : points)
    angles.push_back(portable_atan2(glm::dot(point - centre, v), glm::dot(point - centre, u)));
  std::sort(angles.begin(), angles.end());
  double from = 0, sweep = 0;
  for (std::size_t i = 0; i < angles.size(); ++i) {
    const bool is_last = i + 1 == angles.size();
    const double next = is_last ? angles[0] + full_turn : angles[i + 1], rest = full_turn - (next - angles[i]);
    if (i == 0 || rest < sweep) {
      from = next;
      sweep = rest;
    }
  }
  std::vector<Vec3> arc;
  for (int i = 0; i <= parts; ++i) {
    const double angle = from + sweep * i / parts;
    arc.push_back(centre + radius * (portable_cos(angle) * u + portable_sin(angle) * v));
  }
  check(arc.size() > 1, "an arc has two ends");
  return arc;
}

// The direction of an edge, if it is straight.
std::optional<Vec3> direction_of(const std::vector<Vec3>& points, double slack) {
  Vec3 longest(0);
  for (const Vec3& point : points)
    if (glm::length(point - points.front()) > glm::length(longest)) longest = point - points.front();
  if (!(glm::length(longest) > slack)) return std::nullopt;
  const Vec3 direction = glm::normalize(longest);
  for (const Vec3& point : points)
    if (features::distance_from_line(point, points.front(), direction) > slack) return std::nullopt;
  return direction;
}

// Whether a section has removed what a dimension in its view would lead to.
bool leads_to_nothing(const FaceDimension& one, const ViewChoice& views) {
  for (const auto& place : one.planned.places)
    if (const auto* coordinate = std::get_if<Coordinate>(&place))
      return !keeps(*coordinate->view, coordinate->point) && !keeps(*coordinate->view, coordinate->opposite);
  return std::ranges::any_of(one.planned.dimensions, [&](const DimensionDescription& dimension) {
    const auto view = std::ranges::find(views.all(), *dimension.view, [](const NamedProjection* v) { return v->name; });
    const auto is_removed = [&](const Vec3& point) { return view != views.all().end() && !keeps(**view, point); };
    return (dimension.circle && is_removed(dimension.circle->centre)) ||
           std::ranges::any_of(dimension.anchors, [&](const auto& anchor) {
             const auto* point = std::get_if<Vec3>(&anchor);
             return point != nullptr && is_removed(*point);
           });
  });
}

}  // namespace

FaceDimensions::FaceDimensions(const Planning& plan, const SheetReading& reading)
    : plan_(plan),
      reading_(reading),
      part_(world::place_part(plan.subject.world.models.front())),
      all_points_(features::points_of_faces(plan.subject.world)),
      contacts_(reading.drawn.faces),
      slack_(slack_of(reading.drawn.part)) {
  const std::vector<definition::Contact>& contacts = reading.drawn.part.contacts;
  for (std::size_t i = 0; i < contacts.size(); ++i)
    for (const int face : contacts[i].faces)
      if (static_cast<std::size_t>(face) < contacts_.size())
        contacts_[static_cast<std::size_t>(face)].push_back(static_cast<int>(i));
  check(part_ && part_->faces.size() == reading.drawn.faces, "the faces of the part are those of the model");
}

std::vector<FaceDimension> FaceDimensions::of(int face) const {
  std::vector<FaceDimension> found;
  switch (face_of(face).surface.kind) {
    case SurfaceKind::plane:
      add_places(found, face);
      add_places_on_slope(found, face);
      add_angles(found, face);
      add_edges(found, face);
      add_widths(found, face);
      add_widths_of_arm(found, face);
      add_corners(found, face);
      break;
    case SurfaceKind::cylinder:
      add_size(found, face);
      add_places(found, face);
      add_slant(found, face);
      break;
    case SurfaceKind::cone:
      add_rims(found, face);
      add_places(found, face);
      add_cone_angle(found, face);
      break;
    case SurfaceKind::sphere:
      add_ball(found, face);
      add_places(found, face);
      break;
    case SurfaceKind::torus:
      add_tube(found, face);
      add_places(found, face);
      break;
    case SurfaceKind::free_form:
      break;
  }
  check(std::ranges::all_of(
            found, [](const auto& one) { return one.planned.dimensions.size() + one.planned.places.size() == 1; }),
        "each is one dimension or place");
  std::erase_if(found, [&](const FaceDimension& one) { return leads_to_nothing(one, plan_.views); });
  return found;
}

std::vector<int> FaceDimensions::beside(int face) const {
  std::vector<int> faces;
  for (const int contact : contacts_[static_cast<std::size_t>(face)])
    for (const int other : reading_.drawn.part.contacts[static_cast<std::size_t>(contact)].faces)
      if (other != face && static_cast<std::size_t>(other) < contacts_.size()) faces.push_back(other);
  return faces;
}

void FaceDimensions::add(std::vector<FaceDimension>& found, Measure measure, DimensionDescription dimension) const {
  check(dimension.view.given(), "a dimension stands in a view");
  found.push_back({measure, {{std::move(dimension)}}});
}

// Each along a slope, or along an own axis of a turned part.
void FaceDimensions::add_slanted(std::vector<FaceDimension>& found, Measure measure, const Planned& places) const {
  for (const auto& place : places.places)
    if (const auto* slanted = std::get_if<SlantedPlace>(&place))
      for (DimensionDescription& dimension : slanted_dimensions(plan_, {slanted, 1}))
        add(found, measure, std::move(dimension));
}

// At its borders.
std::vector<Vec3> FaceDimensions::points_of(int face) const {
  std::vector<Vec3> points;
  for (const int contact : contacts_[static_cast<std::size_t>(face)]) {
    const std::vector<Vec3>& own = reading_.drawn.part.contacts[static_cast<std::size_t>(contact)].points;
    points.insert(points.end(), own.begin(), own.end());
  }
  return points;
}

// A whole cylinder has a diameter, seen across it, or along it where it is a bore; part of one has a radius.
void FaceDimensions::add_size(std::vector<FaceDimension>& found, int face) const {
  const PartSurface& surface = face_of(face).surface;
  const surfaces::PartFace& own = part_->faces[static_cast<std::size_t>(face)];
  const bool is_whole = own.sweep >= 360;
  const Vec3 from = own.surface.origin + own.from * own.surface.axis,
             to = from + (own.to - own.from) * own.surface.axis;
  // Extension lines to the outside are short there.
  const auto off = [&](const Vec3& p) { return std::abs(glm::dot(p - plan_.box.centre(), surface.axis)); };
  const Vec3 end = off(from) > off(to) ? from : to;
  const NamedProjection* along = plan_.views.along(surface.axis);
  const NamedProjection* across = is_whole ? plan_.views.across(surface.axis, end) : nullptr;
  const NamedProjection* view = along != nullptr && (own.inwards || across == nullptr) ? along : across;
  if (view == nullptr) return;
  check(surface.radius > 0, "a cylinder has a radius");
  scene::FeatureCircle circle{end, surface.axis, surface.radius, {}};
  if (!is_whole) circle.arc = arc_through(points_of(face), end, surface.axis, surface.radius);
  add(found, Measure::size,
      plan_.dimension(is_whole ? DimensionType::diameter : DimensionType::radius, *view, "<>", std::move(circle)));
}

// The radius of the section of a torus, on the side where it is, and the diameter of its ring, or the radius of the
// inner side of a bend.
void FaceDimensions::add_tube(std::vector<FaceDimension>& found, int face) const {
  const PartSurface& surface = face_of(face).surface;
  const bool is_whole = part_->faces[static_cast<std::size_t>(face)].sweep >= 360;
  const double inside = surface.radius - surface.minor;
  if (const NamedProjection* along = plan_.views.along(surface.axis); along != nullptr && !is_whole && inside > slack_)
    add(found, Measure::width,
        plan_.dimension(DimensionType::radius, *along, "<>",
                        {surface.origin, surface.axis, inside,
                         arc_through(points_of(face), surface.origin, surface.axis, inside)}));
  const NamedProjection* view = plan_.views.across(surface.axis, surface.origin);
  if (view == nullptr) return;
  const projection::Projection& projection = view->projection;
  Vec3 aside = are_parallel(projection.u, surface.axis) ? projection.v : projection.u;
  if (glm::dot(face_of(face).at - surface.origin, aside) < 0) aside = -aside;
  const Vec3 centre = surface.origin + surface.radius * aside;
  check(surface.minor > 0, "a torus has a section");
  Vec3 towards(0);
  for (const Vec3& point : points_of(face)) {
    const Vec2 profile = surfaces::profile_of(surface, point);
    towards += (profile.x - surface.radius) * aside + profile.y * surface.axis;
  }
  if (!(glm::length(towards) > slack_)) towards = aside;
  add(found, Measure::size,
      plan_.dimension(DimensionType::radius, *view, "<>", arc_towards(centre, projection.n, surface.minor, towards)));
  if (is_whole)
    add(found, Measure::width,
        plan_.dimension(DimensionType::diameter, *view, "<>", {surface.origin, surface.axis, surface.radius, {}}));
}

// Where a view shows its outline.
void FaceDimensions::add_ball(std::vector<FaceDimension>& found, int face) const {
  constexpr double steep = 0.5;  // cosine
  const PartSurface& surface = face_of(face).surface;
  const Vec3 off = (face_of(face).at - surface.origin) / surface.radius;
  for (const NamedProjection* view : plan_.views.all()) {
    const projection::Projection& projection = view->projection;
    if (std::abs(glm::dot(off, projection.n)) > steep) continue;
    const Vec3 flat = off - glm::dot(off, projection.n) * projection.n;
    add(found, Measure::size,
        plan_.dimension(DimensionType::radius, *view, "S<>",
                        arc_towards(surface.origin, projection.n, surface.radius,
                                    glm::length(flat) > slack_ ? flat : projection.u + projection.v)));
    return;
  }
}

bool FaceDimensions::is_fillet(int face) const {
  return face_of(face).surface.kind == SurfaceKind::cylinder &&
         std::ranges::count_if(contacts_[static_cast<std::size_t>(face)], [&](int number) {
           return reading_.drawn.part.contacts[static_cast<std::size_t>(number)].is_tangent;
         }) > 1;
}

// Along the axes of the world: of a plane across one, of axes and centres; of slopes along them.
void FaceDimensions::add_places(std::vector<FaceDimension>& found, int face) const {
  const definition::Face& one = face_of(face);
  const PartSurface& surface = one.surface;
  // Where a fillet is follows from what it rounds.
  const Measure measure = is_fillet(face) ? Measure::edge : Measure::place;
  const auto add_place = [&](const Coordinate& place) { found.push_back({measure, {{}, {place}}}); };
  if (surface.kind == SurfaceKind::plane) {
    const int axis = world_axis(surface.axis);
    const features::LevelFeature level{axis, axis < 0 ? 0 : one.at[axis], one.area, points_of(face)};
    if (axis < 0 || level.points.empty()) return;
    if (const auto place = coordinate_of(level, plan_.views, all_points_, slack_)) add_place(*place);
    return;
  }
  const int group = static_cast<int>(plan_.table.sizes.size() + plan_.subject.features.balls.size() +
                                     plan_.subject.features.cones.size()) +
                    face;
  const bool is_ball = surface.kind == SurfaceKind::sphere;
  const Vec3 centre = reading_.unknowns.anchor(face);
  for (int sight = 0; sight < (is_ball ? 3 : 1); ++sight) {
    const Vec3 axis = is_ball ? Mat3(1)[sight] : surface.axis;
    const Planned places = positions_of(plan_, std::array{centre}, axis, plan_.views.along(axis), group);
    add_slanted(found, measure, places);
    for (const auto& place : places.places)
      if (const auto* coordinate = std::get_if<Coordinate>(&place)) add_place(*coordinate);
  }
  check(surface.kind != SurfaceKind::free_form, "a free form has no place of its own");
  const int axis = world_axis(surface.axis);
  const NamedProjection* across = plan_.views.across(surface.axis, centre);
  if (surface.kind != SurfaceKind::torus || axis < 0 || across == nullptr) return;
  const bool horizontal = std::abs(across->projection.u[axis]) > 0.5;
  const Vec3 out = surface.radius * (horizontal ? -across->projection.v : across->projection.u);
  add_place({across, axis, centre[axis], centre + out, -1, centre - out});
}

// Of an axis that leans: where it meets a plane in which the face ends, and at which angle.
void FaceDimensions::add_slant(std::vector<FaceDimension>& found, int face) const {
  const PartSurface& surface = face_of(face).surface;
  if (world_axis(surface.axis) >= 0) return;
  const surfaces::PartFace& own = part_->faces[static_cast<std::size_t>(face)];
  for (const int other : beside(face)) {
    const PartSurface& plane = face_of(other).surface;
    const double cosine = glm::dot(surface.axis, plane.axis);
    if (plane.kind != SurfaceKind::plane || world_axis(plane.axis) < 0 || std::abs(cosine) < definition::good_base ||
        are_parallel(surface.axis, plane.axis))
      continue;
    const double along = glm::dot(plane.origin - surface.origin, plane.axis) / cosine;
    const Vec3 at = surface.origin + along * surface.axis, sight = glm::normalize(glm::cross(plane.axis, surface.axis));
    const NamedProjection *aside = plan_.views.along(sight), *onto = plan_.views.along(plane.axis);
    for (int axis = 0; axis < 3; ++axis) {
      if (axis == world_axis(plane.axis)) continue;
      const NamedProjection* view = aside != nullptr && std::abs(sight[axis]) <= features::parallel ? aside : onto;
      if (view != nullptr) found.push_back({Measure::place, {{}, {Coordinate{view, axis, at[axis], at, -1, at}}}});
    }
    if (aside == nullptr) continue;
    const Vec3 leg =
        (std::abs(own.from - along) > std::abs(own.to - along) ? own.from - along : own.to - along) * surface.axis;
    Vec3 trace = glm::cross(sight, plane.axis);
    if (glm::dot(trace, leg) < 0) trace = -trace;
    DimensionDescription dimension = plan_.dimension(DimensionType::angular, *aside, "<>");
    dimension.anchors = {at, at + glm::length(leg) * trace, at + leg};
    check(glm::length(leg) > 0, "a face goes on from the plane in which it ends");
    add(found, Measure::angle, std::move(dimension));
  }
}

// Of a wall of a pocket or boss that stands on a slope, along this: from the wall that looks at it, or away from it,
// and of the nearer one of both from the end of the slope.
void FaceDimensions::add_places_on_slope(std::vector<FaceDimension>& found, int face) const {
  const Vec3& normal = face_of(face).surface.axis;
  const auto is_wall_on = [&](int wall, const Vec3& slope) {
    const PartSurface& one = face_of(wall).surface;
    return one.kind == SurfaceKind::plane && std::abs(glm::dot(one.axis, slope)) <= features::parallel;
  };
  int slope = -1;
  for (const int other : beside(face))
    if (const definition::Face& one = face_of(other);
        one.surface.kind == SurfaceKind::plane && world_axis(one.surface.axis) < 0 &&
        is_wall_on(face, one.surface.axis) && (slope < 0 || one.area > face_of(slope).area))
      slope = other;
  const NamedProjection* view = plan_.views.beside(normal, face_of(face).at);
  if (world_axis(normal) >= 0 || slope < 0 || view == nullptr) return;
  const PartSurface& plane = face_of(slope).surface;
  check(!are_parallel(plane.axis, normal), "a wall stands on its slope");
  std::vector<int> walls{face};
  for (const int other : beside(slope))
    if (is_wall_on(other, plane.axis) && glm::dot(face_of(other).surface.axis, normal) < -1 + features::parallel) {
      add_width(found, Measure::place, face, face_of(other).at);
      walls.push_back(other);
    }
  for (const features::PlaneFeature& one : plan_.subject.features.inclined)
    if (are_parallel(one.normal, plane.axis) &&
        std::abs(glm::dot(one.corners.front() - plane.origin, plane.axis)) <= slack_) {
      std::vector<DimensionDescription> places;
      for (const int wall : walls) {
        const SlantedPlace place{view, &one, normal, face_of(wall).at, -1};
        for (DimensionDescription& dimension : slanted_dimensions(plan_, {&place, 1}))
          places.push_back(std::move(dimension));
      }
      const auto length = [](const DimensionDescription& dimension) {
        return glm::distance(std::get<Vec3>(dimension.anchors[0]), std::get<Vec3>(dimension.anchors[1]));
      };
      std::stable_sort(places.begin(), places.end(), [&](const DimensionDescription& a, const DimensionDescription& b) {
        return length(a) < length(b);
      });
      for (DimensionDescription& dimension : places) add(found, Measure::place, std::move(dimension));
      return;
    }
}

// With neighbours that are plane, too; first with those across an axis of the world.
void FaceDimensions::add_angles(std::vector<FaceDimension>& found, int face) const {
  const PartSurface& surface = face_of(face).surface;
  for (const bool is_straight : {true, false})
    for (const int number : contacts_[static_cast<std::size_t>(face)]) {
      const definition::Contact& contact = reading_.drawn.part.contacts[static_cast<std::size_t>(number)];
      const int other = contact.faces[contact.faces[0] == face ? 1 : 0];
      const PartSurface& beside = face_of(other).surface;
      if (beside.kind != SurfaceKind::plane || (world_axis(beside.axis) >= 0) != is_straight ||
          are_parallel(beside.axis, surface.axis))
        continue;
      const Vec3 edge = glm::normalize(glm::cross(surface.axis, beside.axis)), corner = contact.points.front();
      const NamedProjection* view = plan_.views.along(edge);
      if (view == nullptr) continue;
      DimensionDescription dimension = plan_.dimension(DimensionType::angular, *view, "<>");
      dimension.anchors = {corner};
      for (const int side : {other, face}) {
        const Vec3 leg = glm::normalize(glm::cross(edge, face_of(side).surface.axis));
        double longest = 0;
        for (const Vec3& point : points_of(side))
          if (const double length = glm::dot(point - corner, leg); std::abs(length) > std::abs(longest))
            longest = length;
        dimension.anchors.emplace_back(corner + longest * leg);
        if (std::abs(longest) <= slack_) dimension.anchors.clear();
      }
      check(dimension.anchors.size() <= 3, "an angle has a corner and two legs");
      if (dimension.anchors.size() == 3) add(found, Measure::angle, std::move(dimension));
    }
}

// Between opposite sides, with the corner at the apex.
void FaceDimensions::add_cone_angle(std::vector<FaceDimension>& found, int face) const {
  const PartSurface& surface = face_of(face).surface;
  const NamedProjection* view = plan_.views.across(surface.axis, surface.origin);
  if (view == nullptr || part_->faces[static_cast<std::size_t>(face)].sweep < 360) return;
  const projection::Projection& projection = view->projection;
  const Vec3 out = are_parallel(projection.u, surface.axis) ? -projection.v : projection.u;
  const Vec3 apex = surface.origin - surface.radius / surface.slope * surface.axis;
  Vec2 end(0);
  for (const Vec3& point : points_of(face))
    if (const Vec2 profile = surfaces::profile_of(surface, point); profile.x > end.x) end = profile;
  const Vec3 middle = surface.origin + end.y * surface.axis;
  if (end.x <= slack_ || glm::distance(apex, middle) > glm::length(plan_.box.size())) return;
  DimensionDescription dimension = plan_.dimension(DimensionType::angular, *view, "<>");
  dimension.anchors = {apex, middle + end.x * out, middle - end.x * out};
  add(found, Measure::angle, std::move(dimension));
}

// Diameters where a cone ends, and their places along its axis.
void FaceDimensions::add_rims(std::vector<FaceDimension>& found, int face) const {
  const PartSurface& surface = face_of(face).surface;
  const NamedProjection* view = plan_.views.across(surface.axis, surface.origin);
  if (view == nullptr || part_->faces[static_cast<std::size_t>(face)].sweep < 360) return;
  const projection::Projection& projection = view->projection;
  const Vec3 out = are_parallel(projection.u, surface.axis) ? -projection.v : projection.u;
  check(surface.slope != 0, "a cone grows along its axis");
  for (const int number : contacts_[static_cast<std::size_t>(face)]) {
    const std::vector<Vec3>& points = reading_.drawn.part.contacts[static_cast<std::size_t>(number)].points;
    const Vec2 rim = surfaces::profile_of(surface, points.front());
    const bool is_circle = std::all_of(points.begin(), points.end(), [&](const Vec3& point) {
      return glm::distance(surfaces::profile_of(surface, point), rim) <= slack_;
    });
    if (!is_circle || rim.x <= slack_) continue;
    const Vec3 centre = surface.origin + rim.y * surface.axis;
    add(found, Measure::size, plan_.dimension(DimensionType::diameter, *view, "<>", {centre, surface.axis, rim.x, {}}));
    if (const int axis = world_axis(surface.axis); axis >= 0)
      found.push_back({Measure::edge,
                       {{}, {Coordinate{view, axis, centre[axis], centre + rim.x * out, -1, centre - rim.x * out}}}});
  }
}

// Places of straight edges along the axes of the world across them, or those of a turned part.
void FaceDimensions::add_edges(std::vector<FaceDimension>& found, int face) const {
  for (const int number : contacts_[static_cast<std::size_t>(face)]) {
    const std::vector<Vec3>& points = reading_.drawn.part.contacts[static_cast<std::size_t>(number)].points;
    const std::optional<Vec3> edge = direction_of(points, slack_);
    const NamedProjection* view = edge ? plan_.views.along(*edge) : nullptr;
    if (view == nullptr) continue;
    if (plan_.table.is_turned(*edge)) {
      add_slanted(found, Measure::edge, positions_of(plan_, std::array{points[0]}, *edge, view, -1));
      continue;
    }
    for (int axis = 0; axis < 3; ++axis)
      if (std::abs((*edge)[axis]) <= features::parallel)
        found.push_back({Measure::edge, {{}, {Coordinate{view, axis, points[0][axis], points[0], -1, points[0]}}}});
  }
}

// Places along the axes of the world, or those of a turned part, at which a plane that leans against all of them cuts
// edges that run along them.
void FaceDimensions::add_corners(std::vector<FaceDimension>& found, int face) const {
  const Vec3& normal = face_of(face).surface.axis;
  for (int axis = 0; axis < 3; ++axis)
    if (std::abs(normal[axis]) <= features::parallel) return;
  std::vector<Vec3> known;
  for (const Vec3& corner : points_of(face)) {
    const auto ends_there = [&](int number) {
      const std::vector<Vec3>& points = reading_.drawn.part.contacts[static_cast<std::size_t>(number)].points;
      return std::ranges::any_of(points, [&](const Vec3& p) { return glm::distance(p, corner) <= slack_; });
    };
    const bool is_new =
        std::ranges::none_of(known, [&](const Vec3& one) { return glm::distance(one, corner) <= slack_; });
    if (!is_new || std::ranges::count_if(contacts_[static_cast<std::size_t>(face)], ends_there) < 2) continue;
    known.push_back(corner);
    if (const auto& turned = plan_.table.turned; turned && plan_.views.along(turned->axis) != nullptr)
      add_slanted(found, Measure::edge,
                  positions_of(plan_, std::array{corner}, turned->axis, plan_.views.along(turned->axis), -1));
    for (int axis = 0; axis < 3; ++axis)
      if (const NamedProjection* view = plan_.views.beside(Mat3(1)[axis], corner);
          view != nullptr && !is_over_turned_part(plan_, axis))
        found.push_back({Measure::edge, {{}, {Coordinate{view, axis, corner[axis], corner, -1, corner}}}});
  }
  check(known.size() <= all_points_.size(), "corners are points of faces");
}

// Distances from planes that are parallel to one that leans against the axes of the world, the nearest ones first; of
// those that look the same way, from the largest one if it is outside, as depths of several floors from one slope, and
// from the others last.
void FaceDimensions::add_widths(std::vector<FaceDimension>& found, int face) const {
  constexpr std::size_t most = 4;
  const Vec3& normal = face_of(face).surface.axis;
  if (world_axis(normal) >= 0) return;
  const Vec3 from = face_of(face).at;
  struct Place {
    double off;  // out of the material
    int face;
    bool is_alike;  // looks the same way
  };
  std::vector<Place> places;
  int largest = face;
  for (int other = 0; other < static_cast<int>(reading_.drawn.faces); ++other) {
    const PartSurface& one = face_of(other).surface;
    const double off = glm::dot(one.origin - from, normal);
    if (one.kind != SurfaceKind::plane || !are_parallel(one.axis, normal) || std::abs(off) <= slack_) continue;
    const bool is_alike = glm::dot(one.axis, normal) > 0;
    places.push_back({off, other, is_alike});
    if (is_alike && face_of(other).area > face_of(largest).area * (1 + features::same_size)) largest = other;
  }
  const auto key = [&](const Place& one) {
    return std::pair(one.is_alike && !(one.face == largest && one.off > 0), std::abs(one.off));
  };
  std::stable_sort(places.begin(), places.end(), [&](const Place& a, const Place& b) { return key(a) < key(b); });
  check(places.size() < reading_.drawn.faces, "a face is no width from itself");
  for (std::size_t i = 0; i < std::min(places.size(), most); ++i)
    add_width(found, Measure::width, face, face_of(places[i].face).surface.origin);
}

// The cylinder about an axis that a plane along it meets in a corner, perhaps behind a fillet; -1 if there is none.
int FaceDimensions::boss_beside(int face, const PartSurface& axis) const {
  const auto is_boss = [&](int other) {
    const PartSurface& one = face_of(other).surface;
    return one.kind == SurfaceKind::cylinder && are_parallel(one.axis, axis.axis) &&
           features::distance_from_line(one.origin, axis.origin, axis.axis) <= slack_;
  };
  const std::vector<int> near = beside(face);
  if (const auto boss = std::ranges::find_if(near, is_boss); boss != near.end()) return *boss;
  for (const int fillet : near) {
    if (face_of(fillet).surface.kind != SurfaceKind::cylinder) continue;
    const std::vector<int> behind = beside(fillet);
    if (const auto boss = std::ranges::find_if(behind, is_boss); boss != behind.end()) return *boss;
  }
  return -1;
}

// Widths of an arm that tapers, between the corners in which its sides meet its bosses, or would without a fillet.
void FaceDimensions::add_widths_of_arm(std::vector<FaceDimension>& found, int face) const {
  const PartSurface& side = face_of(face).surface;
  for (const definition::SymmetryLine& line : reading_.drawn.marks.symmetries) {
    const Vec3& across = face_of(line.face).surface.axis;
    const bool is_side = line.pairs.front()[0] == face || line.pairs.front()[1] == face;
    if (!is_side || line.axes.size() != 2 || are_parallel(side.axis, across)) continue;
    for (const int end : {0, 1}) {
      const PartSurface &axis = face_of(line.axes[end]).surface, &other = face_of(line.axes[1 - end]).surface;
      const NamedProjection* view = plan_.views.along(axis.axis);
      const int boss = boss_beside(face, axis);
      if (view == nullptr || boss < 0) continue;
      const double radius = face_of(boss).surface.radius, off = glm::dot(side.origin - axis.origin, side.axis);
      if (std::abs(off) >= radius) continue;
      check(radius > 0, "a boss has a radius");
      Vec3 along = glm::cross(axis.axis, side.axis);
      if (glm::dot(along, other.origin - axis.origin) < 0) along = -along;
      Vec3 corner = axis.origin + off * side.axis + std::sqrt(radius * radius - off * off) * along;
      corner += glm::dot(face_of(face).at - corner, axis.axis) * axis.axis;
      DimensionDescription dimension = plan_.dimension(DimensionType::aligned, *view, "<>");
      dimension.anchors = {corner, axis.origin + glm::reflect(corner - axis.origin, across)};
      add(found, Measure::width, std::move(dimension));
    }
  }
}

// Along its normal, to the plane through a point.
void FaceDimensions::add_width(std::vector<FaceDimension>& found, Measure measure, int face, const Vec3& to) const {
  const Vec3 &from = face_of(face).at, &normal = face_of(face).surface.axis;
  const NamedProjection* view = plan_.views.beside(normal, from);
  if (view == nullptr) return;
  DimensionDescription dimension = plan_.dimension(DimensionType::aligned, *view, "<>");
  dimension.anchors = {from, from + glm::dot(to - from, normal) * normal};
  add(found, measure, std::move(dimension));
}

}  // namespace epura::sheet
