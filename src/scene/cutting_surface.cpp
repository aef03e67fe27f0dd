// SPDX-License-Identifier: Apache-2.0
#include "scene/cutting_surface.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "base/error.hpp"

namespace epura::scene {

namespace {

constexpr double straight = 1e-9;  // rounding of a path's corners, as a part of its size

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
             "its legs run perpendicular to the normal, or are steps parallel to it");
    last_step = std::abs(ds) <= trace.least ? dd : 0;
  }
}

Trace make_trace(const SectionDescription& section, const Vec3& normal) {
  const std::string& where = section.path.where;
  const std::vector<Vec3>& path = *section.path;
  const auto refuse = [&](const std::string& what, const std::string& hint) {
    throw Error(ErrorKind::input, where, what, hint);
  };
  for (const Vec3& corner : path)
    if (!finite(corner)) refuse("has a number that is not finite", "");
  if (path.size() < 2) refuse("the path has fewer than two points", "give the corners of the cutting-plane line");
  Trace trace{where, path, normal, Vec3(0), straight * size_of(path)};
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
  expect_legs(trace);
  join_legs(trace);
  return trace;
}

// A region for each leg that is a cutting plane, and for what is beyond a step at an end.
void add_regions(CuttingSurface& surface, const Trace& trace) {
  const auto border = [&](const Vec3& point, double side) { return CutBorder{point, side * trace.along}; };
  const std::size_t legs = trace.corners.size() - 1;
  const auto add = [&](std::optional<CuttingPlane> plane, std::size_t end) {
    CutRegion region{std::move(plane), {}};
    // At the end of the region before it, in spite of rounding.
    if (!surface.regions.empty()) region.borders.push_back(border(surface.regions.back().borders.back().point, -1));
    if (end < legs) region.borders.push_back(border(trace.corners[end], 1));
    surface.regions.push_back(std::move(region));
  };
  for (std::size_t leg = 0; leg < legs; ++leg) {
    const bool is_end = leg == 0 || leg + 1 == legs;
    if (!trace.is_step(leg)) {
      CuttingPlane plane = surface.plane;
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

}  // namespace

int side_of(const CutBorder& border, const Vec3& point, double slack) {
  const double distance = glm::dot(border.normal, point - border.point);
  return distance > slack ? 1 : distance < -slack ? -1 : 0;
}

CuttingSurface plane_surface(const CuttingPlane& plane) { return {plane, {{plane, {}}}}; }

CuttingSurface make_cutting_surface(const SectionDescription& section) {
  const CuttingPlane plane = make_cutting_plane(section);
  CuttingSurface surface = plane_surface(plane);
  surface.beyond = section.beyond.value_or(true);
  if (!section.path.given()) return surface;
  const Trace trace = make_trace(section, plane.normal);
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

}  // namespace epura::scene
