// SPDX-License-Identifier: Apache-2.0
#include "features/round_faces.hpp"

#include <algorithm>
#include <climits>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <numeric>
#include <optional>

#include "base/angle.hpp"
#include "base/portable_math.hpp"
#include "features/limits.hpp"

namespace epura::features {

namespace {

using surfaces::SurfaceKind;

/// Two directions perpendicular to an axis.
struct Around {
  Vec3 u, v;

  explicit Around(const Vec3& axis)
      : u(glm::normalize(glm::cross(axis, std::abs(axis.x) < 0.5 ? Vec3(1, 0, 0) : Vec3(0, 1, 0)))),
        v(glm::cross(axis, u)) {}
};

/// The angle that points around an axis span, and the direction of its middle.
struct Sweep {
  double degrees = 0;
  Vec3 middle{0};
};

Sweep sweep_of(const surfaces::PartSurface& surface, const std::vector<Vec3>& points) {
  const Around around(surface.axis);
  std::vector<double> angles;
  for (const Vec3& p : points) {
    const Vec3 d = p - surface.origin;
    const Vec2 spoke(glm::dot(d, around.u), glm::dot(d, around.v));
    if (spoke != Vec2(0)) angles.push_back(portable_atan2(spoke.y, spoke.x));
  }
  if (angles.empty()) return {};
  std::sort(angles.begin(), angles.end());
  double gap = angles.front() + 2 * std::numbers::pi - angles.back(), end = angles.front();
  for (std::size_t i = 1; i < angles.size(); ++i)
    if (angles[i] - angles[i - 1] > gap) {
      gap = angles[i] - angles[i - 1];
      end = angles[i];
    }
  const double middle = end - gap / 2 + std::numbers::pi;
  return {360 - gap / degree, portable_cos(middle) * around.u + portable_sin(middle) * around.v};
}

/// The remainder of a face in the world.
struct Remains {
  std::vector<int> vertices;
  int triangles = 0;
};

// The corners of triangles in the order of their vertices give each face its own once, ascending.
std::vector<Remains> remains_of_faces(const world::World& world, int model, const world::PlacedPart& part) {
  std::vector<Remains> remains(part.faces.size());
  const int first = world.first_triangle[model], before = world.first_vertex[model];
  std::vector<int> next(static_cast<std::size_t>(world.first_vertex[model + 1] - before) + 1, 0), round;
  for (int t = first; t < world.first_triangle[model + 1]; ++t) {
    const int face = part.face_of_triangle[t - first];
    if (face < 0 || !world::is_round(part.faces[face].surface.kind)) continue;
    round.push_back(t);
    ++remains[face].triangles;
    for (const int v : world.triangles[t]) ++next[v - before + 1];
  }
  std::partial_sum(next.begin(), next.end(), next.begin());
  std::vector<int> faces(3 * round.size());
  for (const int t : round)
    for (const int v : world.triangles[t]) faces[next[v - before]++] = part.face_of_triangle[t - first];
  int vertex = 0;
  for (int corner = 0; corner < static_cast<int>(faces.size()); ++corner) {
    while (next[vertex] <= corner) ++vertex;
    std::vector<int>& vertices = remains[faces[corner]].vertices;
    if (vertices.empty() || vertices.back() != before + vertex) vertices.push_back(before + vertex);
  }
  return remains;
}

// The rest of a face that the other planes of an aligned section show about the same axis, degrees.
double sweep_in_copies(const world::World& world, int model, const RoundFace& round) {
  double degrees = 0;
  for (int other = 0; other < static_cast<int>(world.models.size()); ++other) {
    if (other == model || world.number_in_scene(other) != world.number_in_scene(model)) continue;
    const std::optional<world::PlacedPart> part = world::place_part(world.models[other]);
    if (!part) continue;
    const surfaces::PartSurface &here = round.face.surface, &there = part->faces[round.number].surface;
    const Vec3 apart = glm::cross(there.origin - here.origin, here.axis);
    if (glm::length(apart) > same_point * round.reach || glm::length(glm::cross(here.axis, there.axis)) > same_point)
      continue;
    std::vector<Vec3> points;
    const std::vector<Remains> remains = remains_of_faces(world, other, *part);
    for (const int v : remains[round.number].vertices) points.push_back(world.points[v]);
    degrees += sweep_of(there, points).degrees;
  }
  return degrees;
}

}  // namespace

double RoundFace::radius_at(double height) const {
  if (face.surface.kind == SurfaceKind::cylinder) return face.surface.radius;
  if (face.surface.kind == SurfaceKind::cone) return std::max(face.surface.radius + face.surface.slope * height, 0.0);
  return reach;
}

std::vector<RoundFace> find_round_faces(const world::World& world, int model, const world::PlacedPart& part) {
  const std::vector<Remains> remains = remains_of_faces(world, model, part);
  const mesh::Mesh& mesh = *world.models[model].mesh;
  const int first_cut = mesh.uncut == nullptr ? INT_MAX : world.first_vertex[model] + mesh.first_cut_vertex;
  std::vector<RoundFace> round;
  for (int f = 0; f < static_cast<int>(remains.size()); ++f) {
    const std::vector<int>& vertices = remains[f].vertices;
    if (vertices.empty()) continue;
    const surfaces::PartFace& face = part.faces[f];
    const surfaces::PartSurface& surface = face.surface;
    RoundFace found{f, face, vertices, HUGE_VAL, -HUGE_VAL, 0, face.sweep};
    found.cut = vertices.back() >= first_cut || remains[f].triangles < face.triangles;
    std::vector<Vec3> points;
    for (const int v : vertices) {
      const Vec3 d = world.points[v] - surface.origin;
      const double height = glm::dot(d, surface.axis);
      found.from = std::min(found.from, height);
      found.to = std::max(found.to, height);
      found.reach = std::max(found.reach, glm::length(d - height * surface.axis));
      points.push_back(world.points[v]);
    }
    if (surface.kind != SurfaceKind::sphere && (found.cut || !found.is_whole())) {
      const Sweep sweep = sweep_of(surface, points);
      if (found.cut) found.sweep_left = std::min(sweep.degrees + sweep_in_copies(world, model, found), face.sweep);
      found.middle = sweep.middle;
    }
    round.push_back(found);
  }
  return round;
}

}  // namespace epura::features
