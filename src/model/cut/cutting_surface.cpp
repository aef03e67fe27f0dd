// SPDX-License-Identifier: Apache-2.0
#include "cut/cutting_surface.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>

#include "base/error.hpp"
#include "cut/limits.hpp"

namespace epura::cut {

namespace {

/// A path with its coordinates along the cutting planes and along the normal.
struct Trace {
  const std::string& where;
  std::vector<Vec3> corners;
  Vec3 normal, along;
  double least;  ///< shorter lengths are rounding errors

  [[nodiscard]] double s(std::size_t corner) const { return glm::dot(along, corners[corner] - corners.front()); }
  [[nodiscard]] double d(std::size_t corner) const { return glm::dot(normal, corners[corner] - corners.front()); }
  [[nodiscard]] bool is_step(std::size_t leg) const { return s(leg + 1) - s(leg) <= least; }
};

std::string corner_text(std::size_t corner) { return "point " + std::to_string(corner + 1) + " of the path"; }

double size_of(const std::vector<Vec3>& path) {
  double size = 0;
  for (const Vec3& p : path) size = std::max(size, glm::distance(p, path.front()));
  return size;
}

// Without the corners in which the path does not turn.
void join_legs(Trace& trace) {
  std::vector<Vec3> corners;
  for (std::size_t i = 0; i < trace.corners.size(); ++i) {
    const bool is_end = i == 0 || i + 1 == trace.corners.size();
    if (is_end || trace.is_step(i - 1) != trace.is_step(i)) corners.push_back(trace.corners[i]);
  }
  trace.corners = std::move(corners);
}

void expect_legs(const Trace& trace) {
  const auto refuse = [&](const std::string& what, const std::string& hint) {
    throw Error(ErrorKind::input, trace.where, what, hint);
  };
  double last_step = 0;
  for (std::size_t leg = 0; leg + 1 < trace.corners.size(); ++leg) {
    const double ds = trace.s(leg + 1) - trace.s(leg), dd = trace.d(leg + 1) - trace.d(leg);
    if (std::abs(ds) <= trace.least && std::abs(dd) <= trace.least)
      refuse(corner_text(leg + 1) + " is the same as the one before it", "remove it");
    if (ds < -trace.least || (std::abs(ds) <= trace.least && dd * last_step < 0))
      refuse("the path goes back on itself at " + corner_text(leg), "give its points in one direction");
    if (ds > trace.least && std::abs(dd) > trace.least)
      refuse("the path is inclined after " + corner_text(leg),
             "its legs run perpendicular to the normal, or are steps parallel to it; aligned = true turns inclined "
             "planes into one");
    last_step = std::abs(ds) <= trace.least ? dd : 0;
  }
}

Trace make_trace(const scene::SectionDescription& section, const Vec3& normal) {
  const std::string& where = section.path.where;
  const std::vector<Vec3>& path = *section.path;
  const auto refuse = [&](const std::string& what, const std::string& hint) {
    throw Error(ErrorKind::input, where, what, hint);
  };
  for (const Vec3& corner : path)
    if (!finite(corner)) refuse("has a number that is not finite", "");
  if (path.size() < 2) refuse("the path has fewer than two points", "give the corners of the cutting-plane line");
  if (path.size() > max_points_of_path)
    refuse("the path has " + std::to_string(path.size()) + " points, allowed are " + std::to_string(max_points_of_path),
           "draw one section for each part of the path");
  Trace trace{where, path, normal, Vec3(0), rounding_of_corners * size_of(path)};
  if (!(trace.least > 0)) refuse("all points of the path are the same", "give the corners of the cutting-plane line");
  Vec3 across(0);
  for (std::size_t i = 1; i < path.size() && !(glm::length(across) > trace.least); ++i) {
    across = path[i] - path[0];
    across -= glm::dot(across, normal) * normal;
  }
  if (!(glm::length(across) > trace.least))
    refuse("the path runs along the normal", "at least one of its legs is perpendicular to it");
  trace.along = glm::normalize(across);
  for (std::size_t i = 1; i < path.size(); ++i)
    if (glm::length(path[i] - path[0] - trace.s(i) * trace.along - trace.d(i) * normal) > trace.least)
      refuse(corner_text(i) + " is not in a plane with the normal and the points before it",
             "all points lie in one plane that is parallel to the normal");
  return trace;
}

// A region for each leg that is a cutting plane, and for what is beyond a step at an end.
void add_regions(CuttingSurface& surface, const Trace& trace) {
  const auto border = [&](const Vec3& point, double side) { return CutBorder{point, side * trace.along}; };
  const std::size_t legs = trace.corners.size() - 1;
  const auto add = [&](std::optional<scene::CuttingPlane> plane, std::size_t end) {
    CutRegion region{std::move(plane), {}};
    // At the end of the region before it, in spite of rounding.
    if (!surface.regions.empty()) region.borders.push_back(border(surface.regions.back().borders.back().point, -1));
    if (end < legs) region.borders.push_back(border(trace.corners[end], 1));
    surface.regions.push_back(std::move(region));
  };
  for (std::size_t leg = 0; leg < legs; ++leg) {
    const bool is_end = leg == 0 || leg + 1 == legs;
    if (!trace.is_step(leg)) {
      scene::CuttingPlane plane = surface.plane;
      plane.point = trace.corners[leg];
      add(plane, leg + 1);
    } else if (is_end) {
      const double towards_viewer = (leg == 0 ? -1 : 1) * (trace.d(leg + 1) - trace.d(leg));
      if (towards_viewer < 0)
        throw Error(ErrorKind::input, trace.where,
                    "the path " + std::string(leg == 0 ? "begins" : "ends") + " with a step against the normal",
                    "end it with a step along the normal, beside which everything is kept, or with a cutting plane");
      add(std::nullopt, leg == 0 ? 0 : legs);
      surface.divides.push_back(trace.corners[leg]);
    }
  }
}

/// A leg of an aligned section: its first corner and unit direction, along the planes and along the normal.
struct Leg {
  Vec2 at, along;
  double length;
  std::size_t corner;  ///< of the path
};

// Without the corners in which the path does not turn.
std::vector<Leg> straight_legs(const Trace& trace) {
  std::vector<Leg> legs;
  for (std::size_t i = 0; i + 1 < trace.corners.size(); ++i) {
    const Vec2 at(trace.s(i), trace.d(i)), to(trace.s(i + 1), trace.d(i + 1));
    if (!(glm::distance(at, to) > trace.least))
      throw Error(ErrorKind::input, trace.where, corner_text(i + 1) + " is the same as the one before it", "remove it");
    const Leg leg{at, glm::normalize(to - at), glm::distance(at, to), i};
    const bool goes_on = !legs.empty() && glm::distance(legs.back().along, leg.along) <= rounding_of_corners;
    if (goes_on)
      legs.back().length += leg.length;
    else
      legs.push_back(leg);
  }
  return legs;
}

// Legs perpendicular to those before and after them, which run in one direction, are steps: they cut nothing.
std::vector<Leg> without_steps(const std::vector<Leg>& legs) {
  std::vector<Leg> planes;
  for (std::size_t i = 0; i < legs.size(); ++i) {
    const bool is_step = i > 0 && i + 1 < legs.size() &&
                         glm::distance(legs[i - 1].along, legs[i + 1].along) <= rounding_of_corners &&
                         std::abs(glm::dot(legs[i].along, legs[i - 1].along)) <= rounding_of_corners;
    if (!is_step) planes.push_back(legs[i]);
  }
  return planes;
}

// Whether two legs meet; the first and the last one reach to infinity.
bool cross_each_other(const std::vector<Leg>& legs, std::size_t i, std::size_t j) {
  const Leg &a = legs[i], &b = legs[j];
  const double turn = cross(a.along, b.along);
  if (std::abs(turn) <= rounding_of_corners) return false;
  const double on_a = cross(b.at - a.at, b.along) / turn, on_b = cross(b.at - a.at, a.along) / turn;
  return (i == 0 || on_a >= 0) && on_a <= a.length && on_b >= 0 && (j + 1 == legs.size() || on_b <= b.length);
}

void expect_axes(const Trace& trace, const std::vector<Leg>& legs) {
  const auto refuse = [&](const std::string& what, const std::string& hint) {
    throw Error(ErrorKind::input, trace.where, what, hint);
  };
  if (legs.size() < 2)
    refuse("the path of the aligned section has no corner, so there is no axis to turn a plane about",
           "give a corner in which two planes meet, such as a point of the axis of a round part, or omit 'aligned'");
  for (std::size_t i = 0; i + 1 < legs.size(); ++i) {
    if (glm::distance(legs[i].along, -legs[i + 1].along) <= rounding_of_corners)
      refuse("the path goes back on itself at " + corner_text(legs[i + 1].corner), "give its points in one direction");
    for (std::size_t j = i + 2; j < legs.size(); ++j)
      if (cross_each_other(legs, i, j))
        refuse("the path crosses itself", "its first and last plane reach to infinity, and must not meet");
  }
}

/// Moves points of the plane of the trace, given along the planes and along the normal.
struct Turn {
  Vec2 cosine_sine{1, 0}, shift{0};

  [[nodiscard]] Vec2 turned(const Vec2& v) const {
    return {cosine_sine.x * v.x - cosine_sine.y * v.y, cosine_sine.y * v.x + cosine_sine.x * v.y};
  }
  [[nodiscard]] Vec2 operator()(const Vec2& p) const { return turned(p) + shift; }
};

// First about a corner, from one direction into another, then as `next`.
Turn turn_about(const Vec2& corner, const Vec2& from, const Vec2& to, const Turn& next) {
  Turn turn{{glm::dot(from, to), cross(from, to)}, Vec2(0)};
  turn.shift = next(corner - turn.turned(corner));
  turn.cosine_sine = next.turned(turn.cosine_sine);
  return turn;
}

// Turns each leg about the corner where it meets the next one towards the leg that stays, or about the first corner if
// all are inclined.
std::vector<Turn> turns_of(const std::vector<Leg>& legs, std::optional<std::size_t> stays) {
  std::vector<Turn> turns(legs.size());
  const Vec2 ahead(1, 0);
  const std::size_t first = stays.value_or(0);
  if (!stays) turns[0] = turn_about(legs[1].at, legs[0].along, ahead, {});
  for (std::size_t i = first + 1; i < legs.size(); ++i)
    turns[i] = turn_about(legs[i].at, legs[i].along, legs[i - 1].along, turns[i - 1]);
  for (std::size_t i = first; i-- > 0;)
    turns[i] = turn_about(legs[i + 1].at, legs[i].along, legs[i + 1].along, turns[i + 1]);
  return turns;
}

// A turn as a transform of the world.
Mat4 in_world(const Turn& turn, const Trace& trace) {
  const Vec3 &a = trace.along, &n = trace.normal, &start = trace.corners.front();
  const auto image = [&](const Vec3& v) {
    const Vec2 flat(glm::dot(a, v), glm::dot(n, v)), moved = turn.turned(flat) - flat;
    return v + moved.x * a + moved.y * n;
  };
  Mat4 transform(1.0);
  for (int axis = 0; axis < 3; ++axis) transform[axis] = Vec4(image(Mat3(1)[axis]), 0);
  transform[3] = Vec4(start + turn.shift.x * a + turn.shift.y * n - image(start), 1);
  return transform;
}

// Makes a region of each leg that is no step: what is perpendicular to it.
void align(CuttingSurface& surface, Trace& trace) {
  std::vector<Leg> legs = straight_legs(trace);
  const auto is_ahead = [&](const Leg& leg) { return std::abs(leg.along.y) <= rounding_of_corners; };
  const auto found = std::find_if(legs.begin(), legs.end(), is_ahead);
  if (found != legs.end() && found->along.x < 0) {
    trace.along = -trace.along;
    legs = straight_legs(trace);
  }
  expect_axes(trace, legs);
  const std::vector<Leg> all = std::exchange(legs, without_steps(legs));
  const auto in_space = [&](const Vec2& v) { return v.x * trace.along + v.y * trace.normal; };
  const auto point = [&](const Leg& leg) { return trace.corners.front() + in_space(leg.at); };
  const auto stays = std::find_if(legs.begin(), legs.end(), is_ahead);
  const std::vector<Turn> turns = turns_of(
      legs, stays == legs.end() ? std::nullopt : std::optional(static_cast<std::size_t>(stays - legs.begin())));
  surface.aligned = true;
  surface.along = trace.along;
  surface.plane.point = point(stays == legs.end() ? legs[1] : *stays);
  surface.regions.clear();
  for (std::size_t i = 0; i < legs.size(); ++i) {
    const Vec3 along = in_space(legs[i].along);
    scene::CuttingPlane plane = surface.plane;
    plane.point = point(legs[i]);
    if (!is_ahead(legs[i])) {
      plane.normal = in_space({-legs[i].along.y, legs[i].along.x});
      plane.right = along;
      plane.up = glm::cross(plane.normal, along);
    }
    CutRegion region{plane, {}, in_world(turns[i], trace)};
    if (i > 0) region.borders.push_back({point(legs[i]), -along});
    if (i + 1 < legs.size()) region.borders.push_back({point(legs[i + 1]), along});
    surface.regions.push_back(std::move(region));
  }
  for (const Leg& leg : all) surface.path.push_back(point(leg));
  surface.path.push_back(trace.corners.back());
}

}  // namespace

int side_of(const CutBorder& border, const Vec3& point, double slack) {
  const double distance = glm::dot(border.normal, point - border.point);
  return distance > slack ? 1 : distance < -slack ? -1 : 0;
}

scene::CuttingPlane turned_plane(const CutRegion& region) {
  scene::CuttingPlane plane = *region.plane;
  const auto turned = [&](const Vec3& v) { return Vec3(region.turn * Vec4(v, 0)); };
  plane.point = Vec3(region.turn * Vec4(plane.point, 1));
  plane.normal = turned(plane.normal);
  plane.right = turned(plane.right);
  plane.up = turned(plane.up);
  return plane;
}

std::optional<Mat4> turn_at(const CuttingSurface& surface, const Vec3& point, double slack) {
  std::optional<Mat4> turn;
  double least = HUGE_VAL;
  for (const CutRegion& region : surface.regions) {
    const double behind = -glm::dot(region.plane->normal, point - region.plane->point), apart = std::abs(behind);
    const bool is_inside = std::all_of(region.borders.begin(), region.borders.end(),
                                       [&](const CutBorder& border) { return side_of(border, point, slack) <= 0; });
    if (!is_inside || behind < -slack || apart >= least) continue;
    least = apart;
    turn = region.turn;
  }
  return turn;
}

bool keeps(const CuttingSurface& surface, const Vec3& point, double slack) {
  return std::any_of(surface.regions.begin(), surface.regions.end(), [&](const CutRegion& region) {
    const bool is_inside = std::all_of(region.borders.begin(), region.borders.end(),
                                       [&](const CutBorder& border) { return side_of(border, point, slack) <= 0; });
    return is_inside && (!region.plane || glm::dot(region.plane->normal, point - region.plane->point) <= slack);
  });
}

CuttingSurface plane_surface(const scene::CuttingPlane& plane) { return {plane, {{plane, {}}}}; }

CuttingSurface make_cutting_surface(const scene::SectionDescription& section) {
  const scene::CuttingPlane plane = scene::make_cutting_plane(section);
  CuttingSurface surface = plane_surface(plane);
  surface.beyond = section.beyond.value_or(true);
  if (section.aligned.value_or(false) && !section.path.given())
    throw Error(ErrorKind::input, section.aligned.where, "an aligned section has no path",
                "give the corners of the cutting-plane line: an end, a point of the axis, the other end");
  if (!section.path.given()) return surface;
  Trace trace = make_trace(section, plane.normal);
  if (section.aligned.value_or(false)) {
    align(surface, trace);
    return surface;
  }
  expect_legs(trace);
  join_legs(trace);
  const std::size_t first = trace.is_step(0) ? 1 : 0;
  surface.plane.point = trace.corners[first];
  surface.regions = {{surface.plane, {}}};
  if (trace.corners.size() == 2) return surface;
  surface.regions.clear();
  surface.along = trace.along;
  surface.path = trace.corners;
  add_regions(surface, trace);
  return surface;
}

}  // namespace epura::cut
