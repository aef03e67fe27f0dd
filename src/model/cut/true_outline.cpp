// SPDX-License-Identifier: Apache-2.0
#include "cut/true_outline.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

#include "cut/limits.hpp"
#include "surfaces/limits.hpp"

namespace epura::cut {

namespace {

using surfaces::PartFace;
using surfaces::SurfaceKind;

/// The two triangles that meet at a vertex of the cut.
struct Meeting {
  std::array<int, 2> triangles{-1, -1};
  int count = 0;
};

class OutlineMover {
 public:
  OutlineMover(const world::World& world, int model, const PlaneFrame& frame, const world::PlacedPart& part)
      : world_(world),
        first_triangle_(world.first_triangle[model]),
        plane_(frame.plane),
        part_(part),
        precise_(rounding_part / frame.normalisation) {}

  [[nodiscard]] std::optional<Vec3> place_for(const Vec3& start, const Meeting& meeting) const {
    if (meeting.count != 2) return std::nullopt;
    const std::array<int, 2> faces{face_of(meeting.triangles[0]), face_of(meeting.triangles[1])};
    std::vector<const PartFace*> surfaces;
    for (const int f : faces)
      if (f >= 0 && part_.faces[f].surface.kind != SurfaceKind::free_form &&
          (surfaces.empty() || surfaces.front() != &part_.faces[f]))
        surfaces.push_back(&part_.faces[f]);
    const auto round = [](const PartFace* face) { return world::is_round(face->surface.kind); };
    if (std::none_of(surfaces.begin(), surfaces.end(), round)) return std::nullopt;
    for (const PartFace* face : surfaces)
      if (!(std::abs(surfaces::signed_distance(face->surface, start)) <= reach_of(*face))) return std::nullopt;
    const std::optional<Vec3> place =
        surfaces.size() == 1 ? onto(*surfaces[0], start) : between(*surfaces[0], *surfaces[1], start);
    const double most = std::max(size_of(meeting.triangles[0]), size_of(meeting.triangles[1]));
    return place && glm::distance(*place, start) <= most ? place : std::nullopt;
  }

 private:
  /// The distance of a point from a surface, and how it changes within the plane.
  struct Slope {
    double distance;
    Vec2 gradient;
  };

  [[nodiscard]] int face_of(int triangle) const { return part_.face_of_triangle[triangle]; }

  [[nodiscard]] double reach_of(const PartFace& face) const {
    return surfaces::max_sagittas * face.sagitta + face.residual + part_.tolerance;
  }

  // The length of the longest side: no point of a surface is farther from where its facets meet the plane.
  [[nodiscard]] double size_of(int triangle) const {
    const auto& [a, b, c] = world_.triangles[first_triangle_ + triangle];
    const auto& p = world_.points;
    return std::max({glm::distance(p[a], p[b]), glm::distance(p[b], p[c]), glm::distance(p[c], p[a])});
  }

  [[nodiscard]] Slope slope_at(const PartFace& face, const Vec3& point) const {
    const Vec3 normal = surfaces::normal_near(face.surface, point);
    return {surfaces::signed_distance(face.surface, point),
            {glm::dot(normal, plane_.right), glm::dot(normal, plane_.up)}};
  }

  [[nodiscard]] Vec3 moved(const Vec3& point, const Vec2& by) const {
    return point + by.x * plane_.right + by.y * plane_.up;
  }

  // Newton's method, straight towards the outline.
  [[nodiscard]] std::optional<Vec3> onto(const PartFace& face, Vec3 point) const {
    for (int step = 0; step < newton_steps; ++step) {
      const Slope slope = slope_at(face, point);
      if (std::abs(slope.distance) <= precise_) return point;
      const double steepness = glm::dot(slope.gradient, slope.gradient);
      if (!(steepness > 0)) return std::nullopt;
      point = moved(point, -slope.distance / steepness * slope.gradient);
    }
    return std::nullopt;
  }

  // Where two surfaces touch, they need not meet to the last digit.
  [[nodiscard]] std::optional<Vec3> between(const PartFace& one, const PartFace& other, Vec3 point) const {
    for (int step = 0; step < newton_steps; ++step) {
      const Slope a = slope_at(one, point), b = slope_at(other, point);
      const double apart = std::max(std::abs(a.distance), std::abs(b.distance));
      if (apart <= precise_) return point;
      const double turn = cross(a.gradient, b.gradient);
      const bool touch = std::abs(turn) <= told_apart_sine * glm::length(a.gradient) * glm::length(b.gradient);
      if (touch && apart <= part_.tolerance) return point;
      if (turn == 0) return std::nullopt;
      const Vec2 by = Vec2(b.distance * a.gradient.y - a.distance * b.gradient.y,
                           a.distance * b.gradient.x - b.distance * a.gradient.x) /
                      turn;
      point = moved(point, by);
    }
    return std::nullopt;
  }

  const world::World& world_;
  int first_triangle_;
  const scene::CuttingPlane& plane_;
  const world::PlacedPart& part_;
  double precise_;
};

// Of each new vertex.
std::vector<Meeting> meetings_of(const CutMesh& cut, int file_vertices) {
  std::vector<Meeting> meetings(cut.points.size());
  for (const CutSegment& segment : cut.segments)
    for (const int vertex : segment.vertex) {
      if (vertex < file_vertices) continue;
      Meeting& meeting = meetings[vertex - file_vertices];
      if (meeting.count < 2) meeting.triangles[meeting.count] = segment.triangle;
      ++meeting.count;
    }
  return meetings;
}

}  // namespace

double move_to_surfaces(CutMesh& cut, const world::World& world, int model, const PlaneFrame& frame) {
  if (cut.points.empty()) return 0;
  const std::optional<world::PlacedPart> part = world::place_part(world.models[model]);
  if (!part) return 0;
  const OutlineMover mover(world, model, frame, *part);
  const std::vector<Meeting> meetings = meetings_of(cut, world.first_vertex[model + 1] - world.first_vertex[model]);
  double most = 0;
  for (std::size_t v = 0; v < cut.points.size(); ++v) {
    const std::optional<Vec3> place = mover.place_for(cut.points[v], meetings[v]);
    if (!place) continue;
    most = std::max(most, glm::distance(cut.points[v], *place));
    cut.points[v] = *place;
  }
  return most;
}

}  // namespace epura::cut
