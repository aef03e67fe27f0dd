// SPDX-License-Identifier: Apache-2.0
#include "features/coaxial_faces.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <numbers>
#include <set>
#include <utility>

#include "base/angle.hpp"
#include "base/disjoint_sets.hpp"
#include "base/portable_math.hpp"
#include "features/tolerances.hpp"

namespace epura::features {

namespace {

using surfaces::SurfaceKind;

double aside(const RoundFace& from, const Vec3& point) {
  return distance_from_line(point, from.face.surface.origin, from.face.surface.axis);
}

bool are_coaxial(const RoundPart& of, const RoundFace& a, const RoundFace& b) {
  if (glm::length(glm::cross(a.face.surface.axis, b.face.surface.axis)) > told_apart_sine) return false;
  return std::min(aside(a, middle_of(b)), aside(b, middle_of(a))) <=
         slack_of(of.part.tolerance, std::max(a.reach, b.reach));
}

// Whether the axis of a face may be drawn.
bool may_be_grouped(const RoundFace& round) {
  const SurfaceKind kind = round.face.surface.kind;
  const bool is_ring = kind == SurfaceKind::torus && round.is_whole();
  return round.has_its_axis() && (kind == SurfaceKind::cylinder || kind == SurfaceKind::cone || is_ring);
}

// Whether two arcs, one within the other, are the sides of a groove, or of a stroke of a letter.
bool are_sides_of_groove(const RoundFace& outer, const RoundFace& inner) {
  const Vec3& axis = outer.face.surface.axis;
  if (!outer.face.inwards || inner.face.inwards ||
      glm::length(glm::cross(axis, inner.face.surface.axis)) > told_apart_sine)
    return false;
  const double depth = outer.to - outer.from, slack = groove_slack * depth;
  const Vec3 apart = middle_of(inner) - middle_of(outer);
  return std::abs(inner.to - inner.from - depth) <= slack && std::abs(glm::dot(apart, axis)) <= slack &&
         aside(outer, middle_of(inner)) < outer.reach - inner.reach;
}

bool is_side_of_groove(const RoundPart& of, const RoundFace& round) {
  const auto is_arc = [](const RoundFace& face) {
    return face.face.surface.kind == SurfaceKind::cylinder && face.face.sweep >= min_side && !face.is_whole();
  };
  return is_arc(round) && std::any_of(of.faces.begin(), of.faces.end(), [&](const RoundFace& other) {
           return is_arc(other) && (are_sides_of_groove(round, other) || are_sides_of_groove(other, round));
         });
}

// The total sweep in degrees of the arcs of one cylinder that is interrupted, for example by flats.
double sweep_with_others(const RoundPart& of, const RoundFace& round, const std::vector<int>& group) {
  if (round.face.surface.kind != SurfaceKind::cylinder || round.is_whole()) return round.face.sweep;
  std::vector<std::array<double, 2>> arcs;
  for (const int i : group) {
    const RoundFace& other = of.faces[static_cast<std::size_t>(i)];
    if (other.face.surface.kind != SurfaceKind::cylinder || other.face.inwards != round.face.inwards ||
        other.is_whole() ||
        std::abs(other.face.surface.radius - round.face.surface.radius) > same_size * round.face.surface.radius)
      continue;
    // Angles relative to the middle of this arc; full turns are added so that arcs across 180 degrees are included.
    const double sine = glm::dot(round.face.surface.axis, glm::cross(round.middle, other.middle));
    const double middle = portable_atan2(sine, glm::dot(round.middle, other.middle)) * 180 / std::numbers::pi;
    for (const double turn : {-360, 0, 360})
      arcs.push_back({middle + turn - other.face.sweep / 2, middle + turn + other.face.sweep / 2});
  }
  std::sort(arcs.begin(), arcs.end());
  double sweep = 0, end = -180;
  for (const auto& [from, to] : arcs) {
    const double begin = std::max(from, end), stop = std::min(to, 180.0);
    sweep += std::max(stop - begin, 0.0);
    end = std::max(end, to);
  }
  return sweep;
}

bool is_ball_on(const RoundPart& of, const RoundFace& ball, const RoundFace& shaft) {
  return ball.face.surface.kind == SurfaceKind::sphere &&
         aside(shaft, ball.face.surface.origin) <= slack_of(of.part.tolerance, shaft.reach);
}

// Whether there are equal ones about different axes, as holes from the middle of a ball outwards.
bool leads_to_equal_faces(const RoundPart& of, const std::vector<int>& faces) {
  return std::any_of(faces.begin(), faces.end(), [&](int one) {
    const surfaces::PartSurface& first = of.faces[static_cast<std::size_t>(one)].face.surface;
    return std::any_of(faces.begin(), faces.end(), [&](int other) {
      const surfaces::PartSurface& second = of.faces[static_cast<std::size_t>(other)].face.surface;
      return first.kind == second.kind && are_same(first.radius, second.radius) &&
             glm::length(glm::cross(first.axis, second.axis)) > told_apart_sine;
    });
  });
}

// Vertices of the uncut mesh: rims that a cut has shortened are still edges of the file.
std::vector<std::vector<int>> vertices_by_round_face(const world::Placed& placed, const std::vector<int>& place_of_face,
                                                     std::size_t count) {
  const mesh::Mesh& mesh = placed.mesh->whole();
  std::vector<std::vector<int>> vertices(count);
  for (int t = 0; t < mesh.triangle_count(); ++t) {
    const int face = placed.part->face_of_triangle[static_cast<std::size_t>(t)];
    const int place = face < 0 ? -1 : place_of_face[static_cast<std::size_t>(face)];
    if (place < 0) continue;
    const auto corners = mesh.triangle(t);
    std::vector<int>& of_face = vertices[static_cast<std::size_t>(place)];
    of_face.insert(of_face.end(), corners.begin(), corners.end());
  }
  return vertices;
}

}  // namespace

RoundPart make_round_part(const world::World& world, int model, world::PlacedPart part) {
  std::vector<RoundFace> faces = find_round_faces(world, model, part);
  std::vector<int> places(part.faces.size(), -1);
  for (std::size_t i = 0; i < faces.size(); ++i)
    places[static_cast<std::size_t>(faces[i].number)] = static_cast<int>(i);
  auto vertices = vertices_by_round_face(world.models[static_cast<std::size_t>(model)], places, faces.size());
  return {world, model, std::move(part), std::move(faces), std::move(places), std::move(vertices)};
}

// By a sweep along a direction in which holes of a pattern do not line up.
std::vector<std::vector<int>> coaxial_groups(const RoundPart& of, const std::vector<char>& used) {
  const Vec3 along = glm::normalize(Vec3(0.5377, 0.7236, 0.4326)), centre = of.world.box.centre();
  const double window = same_size * glm::length(of.world.box.size());
  std::vector<std::pair<double, int>> order;
  for (std::size_t i = 0; i < of.faces.size(); ++i) {
    const RoundFace& round = of.faces[i];
    if (used[i] != 0 || !may_be_grouped(round)) continue;
    const Vec3 d = round.face.surface.origin - centre;
    order.emplace_back(glm::dot(d - glm::dot(d, round.face.surface.axis) * round.face.surface.axis, along),
                       static_cast<int>(i));
  }
  std::sort(order.begin(), order.end());
  DisjointSets sets(of.faces.size());
  for (std::size_t i = 0; i < order.size(); ++i)
    for (std::size_t j = i + 1; j < order.size() && order[j].first - order[i].first <= window; ++j)
      if (are_coaxial(of, of.faces[static_cast<std::size_t>(order[i].second)],
                      of.faces[static_cast<std::size_t>(order[j].second)]))
        sets.join(order[i].second, order[j].second);
  std::map<int, std::vector<int>> by_root;
  for (const auto& [place, i] : order) by_root[sets.root(i)].push_back(i);
  std::vector<std::vector<int>> groups;
  for (auto& [root, group] : by_root) {
    std::sort(group.begin(), group.end());
    groups.push_back(std::move(group));
  }
  return groups;
}

std::vector<int> faces_with_axis(const RoundPart& of, const std::vector<int>& group) {
  std::vector<int> faces;
  for (const int i : group) {
    const RoundFace& round = of.faces[static_cast<std::size_t>(i)];
    if (sweep_with_others(of, round, group) >= half_turn && !is_side_of_groove(of, round)) faces.push_back(i);
  }
  if (faces.empty()) return {};
  std::map<int, std::vector<int>> at_balls;  // the faces about axes through them that they border
  for (const surfaces::PartBorder& border : of.borders())
    for (const int side : {0, 1}) {
      if (border.faces[0] < 0) continue;
      const int ball = of.place_of_face[static_cast<std::size_t>(border.faces[side])];
      const int next = of.place_of_face[static_cast<std::size_t>(border.faces[1 - side])];
      if (ball >= 0 && next >= 0 &&
          is_ball_on(of, of.faces[static_cast<std::size_t>(ball)], of.faces[static_cast<std::size_t>(next)]))
        at_balls[ball].push_back(next);
    }
  const std::set<int> of_group(faces.begin(), faces.end());
  for (const auto& [ball, nexts] : at_balls)
    if (std::any_of(nexts.begin(), nexts.end(), [&of_group](int next) { return of_group.count(next) > 0; }) &&
        !leads_to_equal_faces(of, nexts))
      faces.push_back(ball);
  std::sort(faces.begin(), faces.end());
  faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
  return faces;
}

}  // namespace epura::features
