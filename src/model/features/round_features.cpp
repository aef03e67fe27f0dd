// SPDX-License-Identifier: Apache-2.0
#include "features/round_features.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "base/angle.hpp"
#include "base/portable_math.hpp"
#include "base/range.hpp"
#include "features/interrupted_faces.hpp"
#include "features/tolerances.hpp"

namespace epura::features {

namespace {

using surfaces::SurfaceKind;

// Axes of short arcs are less accurate than the axis of the world to which they are parallel.
Vec3 snapped(const Vec3& direction) {
  const int axis = axis_along(direction);
  if (axis < 0) return direction;
  Vec3 exact(0);
  exact[axis] = direction[axis] < 0 ? -1 : 1;
  return exact;
}

// The ends of all faces of one cylinder.
std::array<Vec3, 2> cylinder_reach(const RoundFaces& of, const RoundFace& whole) {
  const Vec3 axis = whole.face.surface.axis;
  Range reach;
  for (const RoundFace& round : of.faces)
    if (&round == &whole || are_one_turn(round, whole))
      for (const double at : {round.from, round.to}) reach.add(glm::dot(round.at(at) - whole.at(0), axis));
  return {whole.at(0) + reach.from * axis, whole.at(0) + reach.to * axis};
}

bool is_end_of_slot(const std::vector<SlotFeature>& slots, const ArcFeature& arc) {
  return std::any_of(slots.begin(), slots.end(), [&](const SlotFeature& slot) {
    return slot.model == arc.model && are_same(slot.radius, arc.radius) && are_parallel(slot.axis, arc.axis) &&
           std::any_of(slot.centres.begin(), slot.centres.end(), [&](const Vec3& centre) {
             return distance_from_line(centre, arc.centre, arc.axis) <= same_size * 10 * arc.radius;
           });
  });
}

Sector sector_of(const RoundFace& round) { return {round.middle, round.face.sweep / 2}; }

bool is_rest_of(const RoundFace& round, const RoundFace& first) {
  return surfaces::are_one(round.face.surface, first.face.surface) && round.face.inwards == first.face.inwards;
}

// Whether a border runs around the axis of a torus, as the ends of slots do not.
bool is_around(const surfaces::PartBorder& border, const surfaces::PartSurface& torus, const RoundFaces& of) {
  const mesh::Mesh& mesh = of.placed().mesh->whole();
  const auto height = [&](int vertex) {
    return glm::dot(of.world.points[of.world.first_vertex[of.model] + vertex] - torus.origin, torus.axis);
  };
  const double slack = slack_of(of.part.tolerance, torus.minor);
  return border.closed && std::all_of(border.edges.begin(), border.edges.end(), [&](int edge) {
           const auto& [a, b] = mesh.edges[static_cast<std::size_t>(edge)].vertex;
           return std::abs(height(a) - height(b)) <= slack;
         });
}

// By face of the part: whether it is a torus, and a border that is no tangent one runs around its axis.
std::vector<char> tori_with_edges(const RoundFaces& of) {
  std::vector<char> have(of.part.faces.size(), 0);
  for (const surfaces::PartBorder& border : of.placed().part->borders) {
    if (border.kind == surfaces::BorderKind::tangent) continue;
    for (const int number : border.faces) {
      if (number < 0 || have[static_cast<std::size_t>(number)] != 0) continue;
      const surfaces::PartSurface& surface = of.part.faces[static_cast<std::size_t>(number)].surface;
      if (surface.kind == SurfaceKind::torus && is_around(border, surface, of))
        have[static_cast<std::size_t>(number)] = 1;
    }
  }
  return have;
}

RoundFeature round_of(const RoundFaces& of, const RoundFace& round) {
  const surfaces::PartSurface& surface = round.face.surface;
  std::vector<double> angles;
  for (const int v : round.vertices) {
    const Vec3 d = of.world.points[v] - surface.origin;
    const double height = glm::dot(d, surface.axis), out = glm::length(d - height * surface.axis) - surface.radius;
    angles.push_back(portable_atan2(height, out) / degree);
  }
  std::sort(angles.begin(), angles.end());
  // The section leaves out the largest gap.
  double from = angles.front(), largest = angles.front() + 360 - angles.back();
  for (std::size_t i = 1; i < angles.size(); ++i)
    if (const double gap = angles[i] - angles[i - 1]; gap > largest) {
      largest = gap;
      from = angles[i];
    }
  RoundFeature made{of.model,       surface.origin, surface.axis,
                    surface.radius, surface.minor,  {from, from + 360 - largest}};
  if (!round.is_whole()) made.sectors.push_back(sector_of(round));
  return made;
}

// At which ends of a cone a torus continues it.
std::array<bool, 2> rounded_ends(const RoundFaces& of, const RoundFace& round, const ConeFeature& cone) {
  const mesh::Mesh& mesh = of.placed().mesh->whole();
  const Vec3 middle = (cone.ends[0] + cone.ends[1]) / 2.0, upwards = cone.ends[1] - cone.ends[0];
  std::array<bool, 2> rounded{};
  for (const surfaces::PartBorder& border : of.placed().part->borders)
    for (const int side : {0, 1}) {
      if (border.faces[side] != round.number || border.faces[1 - side] < 0) continue;
      const surfaces::PartSurface& other = of.part.faces[border.faces[1 - side]].surface;
      if (border.kind != surfaces::BorderKind::tangent || other.kind != SurfaceKind::torus) continue;
      const int vertex = mesh.edges[static_cast<std::size_t>(border.edges.front())].vertex[0];
      const Vec3& point = of.world.points[of.world.first_vertex[of.model] + vertex];
      rounded[glm::dot(point - middle, upwards) > 0 ? 1 : 0] = true;
    }
  return rounded;
}

// Whether a cone lies between a plane at its smaller end and a cylinder at its larger one.
bool is_chamfer(const RoundFaces& of, const RoundFace& round, const ConeFeature& cone) {
  if (glm::distance(cone.ends[0], cone.ends[1]) > longest_chamfer * cone.radii[1] || !(cone.radii[0] > 0)) return false;
  bool plane = false, cylinder = false;
  const double slack = slack_of(of.part.tolerance, cone.radii[1]);
  for (const surfaces::PartBorder& border : of.placed().part->borders)
    for (const int side : {0, 1}) {
      if (border.faces[side] != round.number || border.faces[1 - side] < 0) continue;
      const surfaces::PartSurface& other = of.part.faces[border.faces[1 - side]].surface;
      plane = plane || (other.kind == SurfaceKind::plane && are_parallel(other.axis, cone.axis) &&
                        std::abs(glm::dot(other.origin - cone.ends[0], cone.axis)) <= slack);
      cylinder = cylinder || (other.kind == SurfaceKind::cylinder && are_parallel(other.axis, cone.axis) &&
                              std::abs(other.radius - cone.radii[1]) <= slack);
    }
  return plane && cylinder;
}

// Whether two parts of one cylinder are beside each other around its axis, not along it.
bool are_side_by_side(const RoundFace& a, const RoundFace& b) {
  const double turn = portable_atan2(glm::length(glm::cross(a.middle, b.middle)), glm::dot(a.middle, b.middle));
  return turn / degree > std::max(a.face.sweep, b.face.sweep) / 2;
}

// Whether what parts two faces of one cylinder along its axis is a groove: it is not longer than the shorter one.
bool are_parted_by_groove(const RoundFace& a, const RoundFace& b) {
  const auto reach_of = [&a](const RoundFace& one) {
    const auto along = [&](double height) { return glm::dot(one.at(height) - a.at(0), a.face.surface.axis); };
    return std::minmax({along(one.from), along(one.to)});
  };
  const auto [low, high] = reach_of(a);
  const auto [other_low, other_high] = reach_of(b);
  const double apart = std::max(low, other_low) - std::min(high, other_high);
  return apart <= (1 + same_size) * std::min(high - low, other_high - other_low);
}

// The faces of one cylinder that are one arc with a face.
std::vector<std::size_t> parts_of_arc(const RoundFaces& of, std::size_t first, const std::vector<char>& done) {
  std::vector<std::size_t> parts{first};
  for (std::size_t known = 0; known < parts.size(); ++known)
    for (std::size_t j = first + 1; j < of.faces.size(); ++j)
      if (done[j] == 0 && std::find(parts.begin(), parts.end(), j) == parts.end() &&
          are_one_turn(of.faces[first], of.faces[j]) && are_parted_by_groove(of.faces[parts[known]], of.faces[j]))
        parts.push_back(j);
  std::sort(parts.begin(), parts.end());
  return parts;
}

// Of cylinders that are no shafts or bores, the faces that stand for all of one arc: a groove may part it.
std::vector<std::size_t> firsts_of_arcs(const RoundFaces& of) {
  std::vector<char> done(of.faces.size(), 0);
  for (const InterruptedFace& one : find_interrupted(of.faces, SurfaceKind::cylinder))
    for (const int part : one.parts) done[static_cast<std::size_t>(part)] = 1;
  std::vector<std::size_t> firsts;
  for (std::size_t i = 0; i < of.faces.size(); ++i) {
    if (of.faces[i].face.surface.kind != SurfaceKind::cylinder || done[i] != 0) continue;
    std::vector<std::size_t> parts = parts_of_arc(of, i, done);
    std::stable_sort(parts.begin(), parts.end(),
                     [&](std::size_t a, std::size_t b) { return of.faces[a].face.sweep > of.faces[b].face.sweep; });
    double sweep = 0;
    for (std::size_t j = 0; j < parts.size(); ++j) {
      const RoundFace& part = of.faces[parts[j]];
      done[parts[j]] = 1;
      if (std::all_of(parts.begin(), parts.begin() + static_cast<std::ptrdiff_t>(j),
                      [&](std::size_t other) { return are_side_by_side(of.faces[other], part); }))
        sweep += part.face.sweep;
    }
    if (sweep >= shortest_arc && of.faces[parts.front()].face.sweep <= longest_arc) firsts.push_back(parts.front());
  }
  return firsts;
}

}  // namespace

std::vector<CylinderFeature> shafts_of(const RoundFaces& of) {
  std::vector<CylinderFeature> cylinders;
  for (const RoundFace& round : of.faces)
    if (round.face.surface.kind == SurfaceKind::cylinder && !round.face.inwards && round.is_whole()) {
      cylinders.push_back({of.model, round.at(round.from), round.at(round.to), round.face.surface.axis,
                           round.face.surface.radius, false});
      cylinders.back().reach = cylinder_reach(of, round);
    }
  for (const InterruptedFace& one : find_interrupted(of.faces, SurfaceKind::cylinder)) {
    const RoundFace& first = of.faces[static_cast<std::size_t>(one.parts.front())];
    const surfaces::PartSurface& surface = first.face.surface;
    CylinderFeature cylinder{of.model,     first.at(one.from), first.at(one.to),
                             surface.axis, surface.radius,     first.face.inwards};
    cylinder.whole = false;
    cylinders.push_back(cylinder);
  }
  return cylinders;
}

std::vector<ArcFeature> arcs_of(const RoundFaces& of, const std::vector<SlotFeature>& slots) {
  std::vector<ArcFeature> arcs;
  for (const std::size_t number : firsts_of_arcs(of)) {
    const RoundFace& round = of.faces[number];
    const surfaces::PartSurface& surface = round.face.surface;
    ArcFeature arc{of.model, round.at(round.to), snapped(surface.axis), surface.radius,
                   {},       round.face.inwards, round.at(round.from)};
    if (is_end_of_slot(slots, arc)) continue;
    constexpr int steps = 8;
    const Vec3 across = glm::cross(surface.axis, round.middle);
    for (int i = 0; i <= steps; ++i) {
      const double angle = round.face.sweep * degree * (static_cast<double>(i) / steps - 0.5);
      arc.points.push_back(arc.centre +
                           surface.radius * (portable_cos(angle) * round.middle + portable_sin(angle) * across));
    }
    arcs.push_back(std::move(arc));
  }
  return arcs;
}

std::vector<RoundFeature> rounds_of(const RoundFaces& of) {
  std::vector<RoundFeature> rounds;
  const std::vector<char> have_edges = tori_with_edges(of);
  std::vector<char> done(of.faces.size(), 0);
  for (std::size_t i = 0; i < of.faces.size(); ++i) {
    if (of.faces[i].face.surface.kind != SurfaceKind::torus || done[i] != 0) continue;
    RoundFeature round = round_of(of, of.faces[i]);
    round.has_edge = of.faces[i].is_whole() && have_edges[static_cast<std::size_t>(of.faces[i].number)] != 0;
    double sum = of.faces[i].face.sweep;
    for (std::size_t j = i + 1; j < of.faces.size(); ++j) {
      if (done[j] != 0 || of.faces[i].is_whole() || !is_rest_of(of.faces[j], of.faces[i])) continue;
      done[j] = 1;
      sum += of.faces[j].face.sweep;
      round.sectors.push_back(sector_of(of.faces[j]));
    }
    if (sum >= half_turn) rounds.push_back(std::move(round));
  }
  return rounds;
}

std::vector<BallFeature> balls_of(const RoundFaces& of) {
  std::vector<BallFeature> balls;
  for (const RoundFace& round : of.faces) {
    const surfaces::PartSurface& sphere = round.face.surface;
    if (sphere.kind != SurfaceKind::sphere) continue;
    Vec3 middle(0);
    for (const int v : round.vertices) middle += glm::normalize(of.world.points[v] - sphere.origin);
    middle /= static_cast<double>(std::max<std::size_t>(round.vertices.size(), 1));
    const bool is_known = std::any_of(balls.begin(), balls.end(), [&](const BallFeature& ball) {
      return are_same(ball.radius, sphere.radius) &&
             glm::distance(ball.centre, sphere.origin) <= same_size * sphere.radius;
    });
    if (!is_known) balls.push_back({of.model, sphere.origin, sphere.radius, middle, radius_doubt(round.face)});
  }
  return balls;
}

Cones cones_of(const RoundFaces& of) {
  Cones found;
  const auto add = [&](const RoundFace& round, double begin, double end) {
    if (round.face.inwards) return;
    const surfaces::PartSurface& surface = round.face.surface;
    const double low = round.radius_at(begin), high = round.radius_at(end);
    const bool rises = low < high;
    const double from = rises ? begin : end, to = rises ? end : begin;
    ConeFeature cone{of.model,
                     {round.at(from), round.at(to)},
                     {std::min(low, high), std::max(low, high)},
                     surface.axis,
                     portable_atan2(std::abs(high - low), std::abs(to - from)) / degree};
    if (cone.radii[0] <= same_size * cone.radii[1]) cone.radii[0] = 0;
    cone.rounded = rounded_ends(of, round, cone);
    (is_chamfer(of, round, cone) ? found.chamfers : found.others).push_back(cone);
  };
  for (const RoundFace& round : of.faces)
    if (round.face.surface.kind == SurfaceKind::cone && round.is_whole()) add(round, round.from, round.to);
  for (const InterruptedFace& one : find_interrupted(of.faces, SurfaceKind::cone))
    add(of.faces[static_cast<std::size_t>(one.parts.front())], one.from, one.to);
  return found;
}

}  // namespace epura::features
