// SPDX-License-Identifier: Apache-2.0
#include "features/helical_threads.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <optional>
#include <utility>

#include "features/around_axis.hpp"
#include "features/helices.hpp"
#include "features/tolerances.hpp"

namespace epura::features {

namespace {

using surfaces::PartFace;
using surfaces::SurfaceKind;

/// The ends of a face, seen from an axis.
struct FaceReach {
  Range radius, height;
};

/// A ball around a free form.
struct FaceExtent {
  std::size_t face;
  Vec3 centre;
  double radius;
};

/// The part in which threads are looked for.
struct Threaded {
  const mesh::Mesh& mesh;
  const surfaces::PartFaces& part;
  double unit;                              ///< of the file, mm
  std::vector<std::vector<int>> triangles;  ///< by face
  std::vector<FaceExtent> free_forms;
  bool inside_out;  ///< the fronts of its triangles are inside
};

/// What has been found, and the triangles that belong to it.
struct Finds {
  HelicalForms forms;
  std::vector<char> taken;  ///< by triangle
};

std::vector<std::vector<int>> triangles_by_face(const surfaces::PartFaces& part) {
  std::vector<std::vector<int>> triangles(part.faces.size());
  for (std::size_t t = 0; t < part.face_of_triangle.size(); ++t)
    if (const int face = part.face_of_triangle[t]; face >= 0)
      triangles[static_cast<std::size_t>(face)].push_back(static_cast<int>(t));
  return triangles;
}

std::vector<FaceExtent> free_forms_of(const mesh::Mesh& mesh, const surfaces::PartFaces& part,
                                      const std::vector<std::vector<int>>& triangles) {
  std::vector<FaceExtent> forms;
  for (std::size_t face = 0; face < part.faces.size(); ++face) {
    if (part.faces[face].surface.kind != SurfaceKind::free_form) continue;
    Box box;
    for (const int t : triangles[face])
      for (const int v : mesh.triangle(t)) box.add(mesh.point(v));
    forms.push_back({face, box.centre(), glm::length(box.size()) / 2});
  }
  return forms;
}

bool is_inside_out(const mesh::Mesh& mesh) {
  double volume = 0;
  for (int t = 0; t < mesh.triangle_count(); ++t) {
    const auto [a, b, c] = mesh.triangle(t);
    volume += glm::dot(mesh.point(a), glm::cross(mesh.point(b), mesh.point(c)));
  }
  return volume < 0;
}

std::vector<int> vertices_of(const mesh::Mesh& mesh, const std::vector<int>& triangles) {
  std::vector<int> vertices;
  for (const int t : triangles)
    for (const int v : mesh.triangle(t)) vertices.push_back(v);
  std::sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  return vertices;
}

AroundAxis around_axis_of(const surfaces::PartSurface& surface) { return {surface.origin, surface.axis}; }

// The cylinder around vertices: those farthest from its axis are on a circle.
std::optional<surfaces::PartSurface> cylinder_along(const Vec3& direction, const mesh::Mesh& mesh,
                                                    const std::vector<int>& vertices) {
  if (vertices.size() < fewest_helix_points) return std::nullopt;
  surfaces::PartSurface cylinder{SurfaceKind::cylinder, Vec3(0), direction};
  for (const int v : vertices) cylinder.origin += mesh.point(v) / static_cast<double>(vertices.size());
  for (const double share : {0.3, 0.1, 0.03, 0.01, 0.01}) {
    const AroundAxis around = around_axis_of(cylinder);
    Range radius;
    for (const int v : vertices) radius.add(around.radius(mesh.point(v)));
    const double least = radius.to - share * (radius.to - radius.from);
    // Least squares of x² + y² = 2 a x + 2 b y + c.
    Mat3 sums(0);
    Vec3 right(0);
    for (const int v : vertices) {
      const Vec3 d = mesh.point(v) - around.origin;
      const Vec3 row(2 * glm::dot(d, around.u), 2 * glm::dot(d, around.v), 1);
      if (around.radius(mesh.point(v)) < least) continue;
      sums += glm::outerProduct(row, row);
      right += (row.x * row.x + row.y * row.y) / 4 * row;
    }
    const double size = radius.to * radius.to;
    if (!(glm::determinant(sums) > 1e-9 * size * size)) return std::nullopt;
    const Vec3 centre = glm::inverse(sums) * right;
    cylinder.origin += centre.x * around.u + centre.y * around.v;
    cylinder.radius = radius.to;
  }
  return cylinder;
}

FaceReach reach_of(const Threaded& in, const AroundAxis& around, int face) {
  FaceReach reach;
  for (const int t : in.triangles[static_cast<std::size_t>(face)])
    for (const int v : in.mesh.triangle(t)) {
      reach.radius.add(around.radius(in.mesh.point(v)));
      reach.height.add(around.height(in.mesh.point(v)));
    }
  return reach;
}

// Flanks and crests, and planes in which a thread ends.
bool lies_in_band(const Threaded& in, const AroundAxis& around, int face) {
  const surfaces::PartSurface& surface = in.part.faces[static_cast<std::size_t>(face)].surface;
  const bool across = are_parallel(surface.axis, around.axis);
  if (surface.kind != SurfaceKind::free_form && (surface.kind != SurfaceKind::plane || across)) return false;
  const Range radius = reach_of(in, around, face).radius;
  return radius.from >= flattest_thread * radius.to;
}

// Whether a few vertices of a face are where those of a thread around an axis may be.
bool may_be_around(const Threaded& in, const AroundAxis& around, std::size_t face) {
  constexpr std::size_t samples = 16;
  const std::vector<int>& triangles = in.triangles[face];
  Range radius;
  Vec3 directions(0);
  for (std::size_t i = 0; i < samples && !triangles.empty(); ++i) {
    const int triangle = triangles[scattered(i, triangles.size())];
    const Vec3 p = in.mesh.point(in.mesh.triangle(triangle)[0]) - around.origin;
    const Vec3 out = p - glm::dot(p, around.axis) * around.axis;
    radius.add(glm::length(out));
    if (glm::length(out) > 0) directions += glm::normalize(out) / static_cast<double>(samples);
  }
  const double diameter = 2 * radius.to * in.unit;
  return radius.from >= flattest_thread * radius.to && diameter >= smallest_thread && diameter <= largest_thread &&
         radius.to - radius.from >= min_thread_depth * radius.to && glm::length(directions) <= max_to_one_side;
}

template <class Visit>
void for_each_neighbour(const mesh::Mesh& mesh, int triangle, Visit&& visit) {
  const std::array<int, 3> corners = mesh.triangle(triangle);
  for (std::size_t i = 0; i < 3; ++i) {
    const auto [a, b] = std::minmax(corners[i], corners[(i + 1) % 3]);
    for (const int other : mesh.triangles_of(*mesh.edge_between({a, b}))) visit(other);
  }
}

// How much of the area of triangles faces away from the axis: negative in holes.
double facing_of(const Threaded& in, const AroundAxis& around, const std::vector<int>& triangles) {
  double outwards = 0, all = 0;
  for (const int t : triangles) {
    const auto [a, b, c] = in.mesh.triangle(t);
    const Vec3 area = glm::cross(in.mesh.point(b) - in.mesh.point(a), in.mesh.point(c) - in.mesh.point(a));
    const Vec3 middle = (in.mesh.point(a) + in.mesh.point(b) + in.mesh.point(c)) / 3.0 - around.origin;
    outwards += glm::dot(area, glm::normalize(middle - glm::dot(middle, around.axis) * around.axis));
    all += glm::length(area);
  }
  return outwards / all * (in.inside_out ? -1 : 1);
}

// The heights at which vertices are as far from the crests as most roots are: a chamfer may reach below these.
Range full_depth(const mesh::Mesh& mesh, const AroundAxis& around, const std::vector<int>& vertices, bool internal,
                 double near) {
  constexpr std::size_t share = 10;  // of the vertices, one of so many is beyond
  std::vector<double> radii;
  for (const int v : vertices) radii.push_back((internal ? -1 : 1) * around.radius(mesh.point(v)));
  std::vector<double> sorted = radii;
  const auto root = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / share);
  std::nth_element(sorted.begin(), root, sorted.end());
  Range heights;
  for (std::size_t i = 0; i < vertices.size(); ++i)
    if (std::abs(radii[i] - *root) <= near) heights.add(around.height(mesh.point(vertices[i])));
  return heights;
}

// One thread or other helix at most.
HelicalForms form_of(const Threaded& in, const AroundAxis& around, const std::vector<int>& triangles) {
  FaceReach reach;
  const std::vector<int> vertices = vertices_of(in.mesh, triangles);
  for (const int v : vertices) {
    reach.radius.add(around.radius(in.mesh.point(v)));
    reach.height.add(around.height(in.mesh.point(v)));
  }
  if (!(reach.radius.from >= flattest_thread * reach.radius.to)) return {};
  const double faces = facing_of(in, around, triangles);
  if (std::abs(faces) < min_thread_facing) return {};
  const bool internal = faces < 0;
  Crests crests{{}, internal ? reach.radius.from : reach.radius.to, internal, reach.height};
  const double near = crest_part * (reach.radius.to - reach.radius.from);
  for (const int v : vertices)
    if (const Vec3 p = in.mesh.point(v); std::abs(around.radius(p) - crests.radius) <= near)
      crests.points.emplace_back(around.turn(p), around.height(p));
  if (!goes_around(crests.points)) return {};
  const auto size = best_size(crests, in.unit);
  if (!size) {
    const auto pitch = pitch_of(crests);
    return pitch ? HelicalForms{{}, {{2 * crests.radius * in.unit, *pitch * in.unit}}} : HelicalForms{};
  }
  return {{{around.origin, around.axis, internal, crests.radius, reach.height.from, reach.height.to,
            full_depth(in.mesh, around, vertices, internal, near), *size, triangles}}};
}

// Whether a face is a cylinder around the axis.
bool is_around(const surfaces::PartSurface& surface, const AroundAxis& around) {
  return surface.kind == SurfaceKind::cylinder && are_parallel(surface.axis, around.axis) &&
         around.radius(surface.origin) <= on_axis * surface.radius;
}

// Whether a face is part of a ring between roots and crests, across the axis.
bool is_ring(const Threaded& in, const AroundAxis& around, int face, const Range& band) {
  const PartFace& plane = in.part.faces[static_cast<std::size_t>(face)];
  const double ring = std::numbers::pi * (band.to * band.to - band.from * band.from);
  if (plane.surface.kind != SurfaceKind::plane || plane.area > ring || !are_parallel(plane.surface.axis, around.axis))
    return false;
  const FaceReach reach = reach_of(in, around, face);
  return reach.radius.from >= band.from * (1 - on_axis) && reach.radius.to <= band.to * (1 + on_axis);
}

// Strips of cylinders between the flanks and rings at their ends belong to a thread, and what is left of them beyond
// its ends within a pitch.
HelicalThread with_strips(const Threaded& in, const AroundAxis& around, HelicalThread thread, std::vector<char> taken) {
  const double pitch = thread.thread.pitch / in.unit;
  Range band;
  for (const int v : vertices_of(in.mesh, thread.triangles)) band.add(around.radius(in.mesh.point(v)));
  const auto is_strip = [&](int triangle) {
    const int face = in.part.face_of_triangle[static_cast<std::size_t>(triangle)];
    if (face < 0 || taken[static_cast<std::size_t>(triangle)] != 0) return false;
    if (!is_around(in.part.faces[static_cast<std::size_t>(face)].surface, around) && !is_ring(in, around, face, band))
      return false;
    const std::array<int, 3> corners = in.mesh.triangle(triangle);
    return std::all_of(corners.begin(), corners.end(), [&](int v) {
      const double height = around.height(in.mesh.point(v));
      return height >= thread.low - pitch && height <= thread.high + pitch;
    });
  };
  for (std::size_t i = 0; i < thread.triangles.size(); ++i)
    for_each_neighbour(in.mesh, thread.triangles[i], [&](int other) {
      if (!is_strip(other)) return;
      taken[static_cast<std::size_t>(other)] = 1;
      thread.triangles.push_back(other);
    });
  for (const int v : vertices_of(in.mesh, thread.triangles)) {
    thread.low = std::min(thread.low, around.height(in.mesh.point(v)));
    thread.high = std::max(thread.high, around.height(in.mesh.point(v)));
  }
  std::sort(thread.triangles.begin(), thread.triangles.end());
  return thread;
}

// The groups of joined triangles around an axis that may be threads.
std::vector<std::vector<int>> groups_around(const Threaded& in, const AroundAxis& around,
                                            const std::vector<char>& taken) {
  std::vector<std::size_t> seeds;
  for (const FaceExtent& form : in.free_forms)
    if (around.radius(form.centre) <= form.radius && may_be_around(in, around, form.face)) seeds.push_back(form.face);
  if (seeds.empty()) return {};
  std::vector<char> known(in.part.faces.size(), 0);
  const auto may_belong = [&](int face) {
    char& answer = known[static_cast<std::size_t>(face)];
    if (answer == 0) answer = lies_in_band(in, around, face) ? 1 : -1;
    return answer > 0;
  };
  std::vector<char> visited = taken;
  std::vector<std::vector<int>> groups;
  for (const std::size_t seed : seeds) {
    const int first = in.triangles[seed].front();
    if (visited[static_cast<std::size_t>(first)] != 0 || !may_belong(static_cast<int>(seed))) continue;
    std::vector<int> group{first};
    visited[static_cast<std::size_t>(first)] = 1;
    for (std::size_t i = 0; i < group.size(); ++i)
      for_each_neighbour(in.mesh, group[i], [&](int other) {
        const int face = in.part.face_of_triangle[static_cast<std::size_t>(other)];
        if (visited[static_cast<std::size_t>(other)] != 0 || face < 0 || !may_belong(face)) return;
        visited[static_cast<std::size_t>(other)] = 1;
        group.push_back(other);
      });
    groups.push_back(std::move(group));
  }
  return groups;
}

Finds find_around(const Threaded& in, const surfaces::PartSurface& surface, Finds finds) {
  const AroundAxis around = around_axis_of(surface);
  const auto take = [&](const std::vector<int>& triangles) {
    for (const int triangle : triangles) finds.taken[static_cast<std::size_t>(triangle)] = 1;
  };
  for (const std::vector<int>& group : groups_around(in, around, finds.taken)) {
    HelicalForms form = form_of(in, around, group);
    if (form.threads.empty() && form.others.empty()) continue;
    take(group);
    finds.forms.others.insert(finds.forms.others.end(), form.others.begin(), form.others.end());
    for (HelicalThread& found : form.threads) {
      HelicalThread thread = with_strips(in, around, std::move(found), finds.taken);
      take(thread.triangles);
      finds.forms.threads.push_back(std::move(thread));
    }
  }
  return finds;
}

// Threads in plates have no round face beside them: their axis is perpendicular to a plane.
Finds find_in(const Threaded& in, std::size_t face, Finds finds) {
  if (finds.taken[static_cast<std::size_t>(in.triangles[face].front())] != 0) return finds;
  const std::vector<int> vertices = vertices_of(in.mesh, in.triangles[face]);
  std::vector<Vec3> directions;
  for (const PartFace& plane : in.part.faces) {
    const Vec3& axis = plane.surface.axis;
    if (plane.surface.kind != SurfaceKind::plane || directions.size() >= max_directions) continue;
    if (std::none_of(directions.begin(), directions.end(),
                     [&](const Vec3& known) { return are_parallel(known, axis); }))
      directions.push_back(axis);
  }
  for (const Vec3& direction : directions)
    if (const auto cylinder = cylinder_along(direction, in.mesh, vertices);
        cylinder && may_be_around(in, around_axis_of(*cylinder), face))
      finds = find_around(in, *cylinder, std::move(finds));
  return finds;
}

bool have_one_axis(const surfaces::PartSurface& surface, const surfaces::PartSurface& other) {
  return are_parallel(other.axis, surface.axis) &&
         distance_from_line(surface.origin, other.origin, other.axis) <= on_axis * surface.radius;
}

}  // namespace

HelicalForms find_helical_threads(const mesh::Mesh& mesh, const surfaces::PartFaces& part, double unit) {
  std::vector<std::vector<int>> triangles = triangles_by_face(part);
  std::vector<FaceExtent> free_forms = free_forms_of(mesh, part, triangles);
  if (free_forms.empty()) return {};
  const Threaded in{mesh, part, unit, std::move(triangles), std::move(free_forms), is_inside_out(mesh)};
  Finds finds{{}, std::vector<char>(part.face_of_triangle.size(), 0)};
  std::vector<surfaces::PartSurface> axes;  // around which has been looked
  for (const PartFace& face : part.faces) {
    const surfaces::PartSurface& surface = face.surface;
    if (!surfaces::has_axis(surface.kind) || face.sweep < half_turn ||
        std::any_of(axes.begin(), axes.end(), [&](const auto& known) { return have_one_axis(surface, known); }))
      continue;
    axes.push_back(surface);
    finds = find_around(in, surface, std::move(finds));
  }
  for (const FaceExtent& form : in.free_forms) finds = find_in(in, form.face, std::move(finds));
  return std::move(finds.forms);
}

}  // namespace epura::features
