// SPDX-License-Identifier: Apache-2.0
// Replaces helical threads by the cylinders through their crests.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "base/angle.hpp"
#include "base/error.hpp"
#include "base/portable_math.hpp"
#include "features/around_axis.hpp"
#include "features/end_lines.hpp"
#include "features/helical_threads.hpp"
#include "features/tolerances.hpp"
#include "mesh/edge_table.hpp"

namespace epura::features {

namespace {

using surfaces::SurfaceKind;

/// A thread, and the part that has it.
struct ThreadOfPart {
  const mesh::Mesh& mesh;
  const surfaces::PartFaces& part;
  const HelicalThread& thread;
  AroundAxis around;

  [[nodiscard]] int face_of(int triangle) const { return part.face_of_triangle[static_cast<std::size_t>(triangle)]; }
  [[nodiscard]] const surfaces::PartSurface& surface_of(int face) const {
    return part.faces[static_cast<std::size_t>(face)].surface;
  }
  [[nodiscard]] bool is_across(const surfaces::PartSurface& surface) const {
    return surface.kind == SurfaceKind::plane && are_parallel(surface.axis, thread.axis);
  }
  [[nodiscard]] bool is_cone_around(const surfaces::PartSurface& surface) const {
    return surface.kind == SurfaceKind::cone && are_parallel(surface.axis, thread.axis);
  }
};

/// What is left of the mesh without the thread.
struct WithoutThread {
  mesh::Points points;
  std::vector<char> removed;                                ///< by triangle
  std::vector<std::pair<std::array<int, 3>, int>> added{};  ///< in the place of triangles that are cut

  [[nodiscard]] Vec3 point(int vertex) const { return point_at(points, vertex); }
  int add(const Vec3& place) {
    points.push_back({place.x, place.y, place.z});
    return static_cast<int>(points.size()) - 1;
  }
};

/// The lines of the cylinder, from below, and the faces of the strips between them.
struct CylinderLines {
  WithoutThread remains;
  std::vector<EndLine> lines;
  std::vector<int> strips{};
};

/// What is done with the face beside an end of the thread.
enum class Ending {
  moved,    ///< its border is moved to the crests
  clipped,  ///< it surrounds the thread: what is within the thread is cut off
  remade    ///< a chamfer, cut by the thread: it is made anew between its other end and the crests
};
struct ThreadEnd {
  Ending ending = Ending::moved;
  int face = -1;
  double outermost = 0;  ///< radius of the line
};

// The face beside a line, if that is a single one; -1: otherwise.
int face_beside(const ThreadOfPart& of, const std::vector<char>& removed, const EndLine& line) {
  int found = -1;
  for (std::size_t i = 0; i < line.vertices.size(); ++i) {
    const auto [a, b] = std::minmax(line.vertices[i], line.vertices[(i + 1) % line.vertices.size()]);
    for (const int t : of.mesh.triangles_of(*of.mesh.edge_between({a, b}))) {
      if (removed[static_cast<std::size_t>(t)] != 0) continue;
      const int face = of.face_of(t);
      if (face < 0 || (found >= 0 && face != found)) return -1;
      found = face;
    }
  }
  return found;
}

ThreadEnd end_at(const ThreadOfPart& of, const std::vector<char>& removed, const EndLine& line) {
  ThreadEnd end{Ending::moved, face_beside(of, removed, line)};
  for (const int v : line.vertices) end.outermost = std::max(end.outermost, of.around.radius(of.mesh.point(v)));
  if (end.face < 0) return end;
  const surfaces::PartSurface& surface = of.surface_of(end.face);
  double farthest = 0;
  for (int t = 0; t < of.mesh.triangle_count(); ++t) {
    if (of.face_of(t) != end.face) continue;
    for (const int v : of.mesh.triangle(t)) farthest = std::max(farthest, of.around.radius(of.mesh.point(v)));
  }
  const bool surrounds = farthest > end.outermost * (1 + same_point);
  if (surrounds && (of.is_across(surface) || of.is_cone_around(surface))) end.ending = Ending::clipped;
  if (!surrounds && of.is_cone_around(surface)) end.ending = Ending::remade;
  return end;
}

// Height at which a plane or cone has a radius.
double height_at(const ThreadOfPart& of, int face, double radius) {
  const surfaces::PartSurface& surface = of.surface_of(face);
  if (!of.is_cone_around(surface)) return of.around.height(surface.origin);
  return of.around.height(surface.origin + (radius - surface.radius) / surface.slope * surface.axis);
}

// Distance between the thread and the circle at which faces around it are cut.
double clearance_of(const ThreadOfPart& of) {
  double least = HUGE_VAL, most = 0;
  for (const int t : of.thread.triangles)
    for (const int v : of.mesh.triangle(t)) {
      least = std::min(least, of.around.radius(of.mesh.point(v)));
      most = std::max(most, of.around.radius(of.mesh.point(v)));
    }
  return clear_of_crests * (most - least);
}

// The point of a segment at a distance from the axis, at a certain height.
Vec3 crossing_between(const AroundAxis& around, const std::array<Vec3, 2>& ends, double limit, double height) {
  const Vec3 from = around.outwards(ends[0]), to = around.outwards(ends[1]), step = to - from;
  const double square = glm::dot(step, step), half = glm::dot(from, step);
  const double rest = glm::dot(from, from) - limit * limit;
  const double root = std::sqrt(std::max(half * half - square * rest, 0.0));
  // The way out of the circle, in the direction in which the distance grows.
  const bool outwards = glm::length(to) > glm::length(from);
  const double t = std::clamp((-half + (outwards ? root : -root)) / square, 0.0, 1.0);
  return around.origin + height * around.axis + limit * glm::normalize(from + t * step);
}

// The closed line of links from a vertex to the next one; nothing if there are other links.
std::optional<EndLine> closed_line(const std::map<int, int>& next, double height) {
  EndLine line{{}, {}, height};
  if (next.empty()) return std::nullopt;
  for (int v = next.begin()->first; line.vertices.size() <= next.size();) {
    line.vertices.push_back(v);
    const auto following = next.find(v);
    if (following == next.end()) return std::nullopt;
    v = following->second;
    if (v == line.vertices.front()) break;
  }
  return line.vertices.size() == next.size() ? std::optional(std::move(line)) : std::nullopt;
}

/// What is left when an end of the thread is at its cylinder, and the line at that end.
struct Ended {
  WithoutThread remains;
  EndLine line;
};

// Cuts off what a face has within a circle around the thread, which the line becomes.
std::optional<Ended> clipped(const ThreadOfPart& of, const ThreadEnd& end, WithoutThread remains) {
  const double limit = std::max(end.outermost, of.thread.crest) + clearance_of(of);
  const double at = height_at(of, end.face, limit);
  std::map<std::array<int, 2>, int> crossings;  // of edges with the circle
  std::map<int, int> next;
  const auto is_out = [&](int v) { return of.around.radius(remains.point(v)) > limit * (1 + same_point); };
  const auto crossing = [&](int a, int b) {
    const auto [known, is_new] = crossings.try_emplace({std::min(a, b), std::max(a, b)}, -1);
    if (is_new)
      known->second = remains.add(crossing_between(of.around, {remains.point(a), remains.point(b)}, limit, at));
    return known->second;
  };
  for (int t = 0; t < of.mesh.triangle_count(); ++t) {
    if (of.face_of(t) != end.face) continue;
    std::array<int, 3> c = of.mesh.triangle(t);
    const auto out = std::count_if(c.begin(), c.end(), is_out);
    if (out == 3) continue;
    remains.removed[static_cast<std::size_t>(t)] = 1;
    if (out == 0) continue;
    // The corner that is alone on its side comes first.
    while (is_out(c[0]) != (out == 1) || is_out(c[1]) == is_out(c[0])) std::rotate(c.begin(), c.begin() + 1, c.end());
    const int p = crossing(c[0], c[1]), q = crossing(c[0], c[2]);
    if (out == 1) {
      remains.added.push_back({{c[0], p, q}, t});
      next[q] = p;
    } else {
      remains.added.push_back({{p, c[1], c[2]}, t});
      remains.added.push_back({{p, c[2], q}, t});
      next[p] = q;
    }
  }
  // Each crossing is in two triangles, unless another face is beside one.
  if (next.size() != crossings.size()) return std::nullopt;
  auto line = closed_line(next, at);
  return line ? std::optional(Ended{std::move(remains), std::move(*line)}) : std::nullopt;
}

// The points with those of a line moved to the cylinder; nothing if a face beside it is turned over.
std::optional<mesh::Points> moved_to_crests(const ThreadOfPart& of, const WithoutThread& remains, const EndLine& line) {
  std::vector<int> vertices = line.vertices;
  std::sort(vertices.begin(), vertices.end());
  mesh::Points moved = remains.points;
  for (const int v : line.vertices) {
    const Vec3 p = point_at(moved, v), flat = of.around.outwards(p);
    const Vec3 place = p - flat + of.thread.crest * glm::normalize(flat);
    moved[static_cast<std::size_t>(v)] = {place.x, place.y, place.z};
  }
  const auto area_of = [&of](const mesh::Points& points, int triangle) {
    const auto [a, b, c] = of.mesh.triangle(triangle);
    const Vec3 first = point_at(points, a);
    return glm::cross(point_at(points, b) - first, point_at(points, c) - first);
  };
  const double least = same_point * of.thread.crest * of.thread.crest;
  for (int t = 0; t < of.mesh.triangle_count(); ++t) {
    const std::array<int, 3> corners = of.mesh.triangle(t);
    if (remains.removed[static_cast<std::size_t>(t)] != 0 || std::none_of(corners.begin(), corners.end(), [&](int v) {
          return std::binary_search(vertices.begin(), vertices.end(), v);
        }))
      continue;
    const Vec3 now = area_of(moved, t), before = area_of(remains.points, t);
    if (!(glm::length(now) <= least || glm::length(before) <= least || glm::dot(now, before) > 0)) return std::nullopt;
  }
  return moved;
}

// The thread's end and its line, unrolled; nothing if the face beside it cannot be continued.
std::optional<Ended> ended_at(const ThreadOfPart& of, const ThreadEnd& end, Ended at) {
  if (end.ending == Ending::moved) {
    auto moved = moved_to_crests(of, at.remains, at.line);
    if (!moved) return std::nullopt;
    at.remains.points = std::move(*moved);
  }
  if (end.ending == Ending::clipped) {
    auto cut = clipped(of, end, std::move(at.remains));
    if (!cut) return std::nullopt;
    at = std::move(*cut);
  }
  auto line = unrolled(std::move(at.line), at.remains.points, of.around);
  return line ? std::optional(Ended{std::move(at.remains), std::move(*line)}) : std::nullopt;
}

// With a circle of the cylinder, which has at least as many points as a line.
Ended with_circle(const ThreadOfPart& of, WithoutThread remains, const EndLine& line, double at) {
  const std::size_t points = std::max(line.vertices.size(), fewest_helix_points);
  EndLine circle = circle_line(at, line.angles.front(), points, static_cast<int>(remains.points.size()));
  for (const double turn : circle.angles) {
    const double angle = turn * full_turn;
    const Vec3 out = portable_cos(angle) * of.around.u + portable_sin(angle) * of.around.v;
    remains.add(of.around.origin + at * of.around.axis + of.thread.crest * out);
  }
  return {std::move(remains), std::move(circle)};
}

// The two ends of the thread, the lower one first; nothing if there are not two.
std::optional<std::array<EndLine, 2>> two_lines(const ThreadOfPart& of, const std::vector<char>& removed) {
  std::vector<EndLine> lines = end_lines(of.mesh, removed, of.around);
  if (lines.size() != 2) return std::nullopt;
  if (lines[0].height > lines[1].height) std::swap(lines[0], lines[1]);
  return std::array{std::move(lines[0]), std::move(lines[1])};
}

// The closed lines around the axis, with those of the cylinder between the others; nothing if there are none.
std::optional<CylinderLines> lines_of_cylinder(const ThreadOfPart& of) {
  WithoutThread remains{of.mesh.points, std::vector<char>(of.mesh.polygon.size(), 0)};
  for (const int t : of.thread.triangles) remains.removed[static_cast<std::size_t>(t)] = 1;
  auto lines = two_lines(of, remains.removed);
  if (!lines) return std::nullopt;
  const std::array ends{end_at(of, remains.removed, (*lines)[0]), end_at(of, remains.removed, (*lines)[1])};
  for (const ThreadEnd& end : ends)
    for (int t = 0; end.ending == Ending::remade && t < of.mesh.triangle_count(); ++t)
      if (of.face_of(t) == end.face) remains.removed[static_cast<std::size_t>(t)] = 1;
  lines = two_lines(of, remains.removed);
  if (!lines) return std::nullopt;
  for (const std::size_t i : {0U, 1U}) {
    auto ended = ended_at(of, ends[i], {std::move(remains), std::move((*lines)[i])});
    if (!ended) return std::nullopt;
    remains = std::move(ended->remains);
    (*lines)[i] = std::move(ended->line);
  }
  CylinderLines all{std::move(remains), {(*lines)[0]}};
  const int cylinder = static_cast<int>(of.part.faces.size());
  for (const std::size_t i : {0U, 1U}) {
    const EndLine& line = (*lines)[i];
    const double radius = of.around.radius(all.remains.point(line.vertices.front()));
    const bool is_there =
        ends[i].ending == Ending::moved || std::abs(radius - of.thread.crest) <= same_point * of.thread.crest;
    if (!is_there) {
      const double at = height_at(of, ends[i].face, of.thread.crest);
      Ended circle = with_circle(of, std::move(all.remains), line, at);
      all.remains = std::move(circle.remains);
      all.lines.push_back(std::move(circle.line));
      all.strips.push_back(ends[i].face);
    }
    if (i == 0) all.strips.push_back(cylinder);
  }
  all.lines.push_back((*lines)[1]);
  check(all.strips.size() + 1 == all.lines.size(), "there is a strip between two lines");
  return all;
}

WithCylinder rebuilt(const ThreadOfPart& of, CylinderLines cylinder) {
  const WithoutThread& remains = cylinder.remains;
  // Vertices that have come to lie in one place are one.
  const std::map<int, int> same = coinciding(cylinder.lines, remains.points, same_point * of.thread.crest);
  const auto one = [&](int v) {
    const auto at = same.find(v);
    return at == same.end() ? v : at->second;
  };
  WithCylinder made;
  const auto add = [&](const std::array<int, 3>& corners, int polygon, int body, int face) {
    const std::array<int, 3> c{one(corners[0]), one(corners[1]), one(corners[2])};
    if (c[0] == c[1] || c[1] == c[2] || c[2] == c[0]) return;
    made.mesh.corners.insert(made.mesh.corners.end(), c.begin(), c.end());
    made.mesh.polygon.push_back(polygon);
    made.mesh.body.push_back(body);
    made.face_of_triangle.push_back(face);
  };
  const auto body_of = [&of](int t) { return of.mesh.body[static_cast<std::size_t>(t)]; };
  int next = 0;
  for (int t = 0; t < of.mesh.triangle_count(); ++t) {
    const int polygon = of.mesh.polygon[static_cast<std::size_t>(t)];
    next = std::max(next, polygon + 1);
    if (remains.removed[static_cast<std::size_t>(t)] == 0) add(of.mesh.triangle(t), polygon, body_of(t), of.face_of(t));
  }
  for (const auto& [corners, t] : remains.added) add(corners, next++, body_of(t), of.face_of(t));
  const int body = body_of(of.thread.triangles.front());
  for (std::size_t i = 1; i < cylinder.lines.size(); ++i)
    for (auto [a, b, c] : strip_between(cylinder.lines[i - 1], cylinder.lines[i])) {
      if (of.thread.internal) std::swap(b, c);
      add({a, b, c}, next++, body, cylinder.strips[i - 1]);
    }
  made.mesh.points = std::move(cylinder.remains.points);
  made.mesh.report = of.mesh.report;
  mesh::make_edges(made.mesh, mesh::wires_of(of.mesh));
  check(made.face_of_triangle.size() == made.mesh.polygon.size(), "every triangle has a face");
  return made;
}

}  // namespace

std::optional<WithCylinder> with_cylinder(const mesh::Mesh& mesh, const surfaces::PartFaces& part,
                                          const HelicalThread& thread) {
  const ThreadOfPart of{mesh, part, thread, {thread.origin, thread.axis}};
  auto lines = lines_of_cylinder(of);
  return lines ? std::optional(rebuilt(of, std::move(*lines))) : std::nullopt;
}

}  // namespace epura::features
