// SPDX-License-Identifier: Apache-2.0
#include "features/part_features.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <numbers>
#include <optional>
#include <utility>

#include "base/angle.hpp"
#include "base/joined.hpp"
#include "base/portable_math.hpp"
#include "base/range.hpp"
#include "features/assembly_features.hpp"
#include "features/bevels.hpp"
#include "features/cavities.hpp"
#include "features/centred_features.hpp"
#include "features/engraving.hpp"
#include "features/hole_features.hpp"
#include "features/opposite_sides.hpp"
#include "features/place_threads.hpp"
#include "features/plane_faces.hpp"
#include "features/round_features.hpp"
#include "features/tolerances.hpp"
#include "features/true_extents.hpp"
#include "world/placed_part.hpp"

namespace epura::features {

namespace {

using surfaces::SurfaceKind;

bool are_same_recess(const std::optional<Recess>& a, const std::optional<Recess>& b) {
  if (!a || !b) return a.has_value() == b.has_value();
  return are_same(a->diameter, b->diameter) && are_same(a->size, b->size);
}

bool are_same_thread(const std::optional<ThreadFeature>& a, const std::optional<ThreadFeature>& b) {
  if (!a || !b) return a.has_value() == b.has_value();
  return a->text == b->text && a->number == b->number;
}

// A drawing gives the depth of letters at most, no sizes of their walls.
world::PlacedPart without_letters(const world::Placed& placed, world::PlacedPart part) {
  const std::vector<char> walls = walls_of_letters(placed, part);
  for (std::size_t f = 0; f < walls.size(); ++f)
    if (walls[f] != 0) part.faces[f].surface.kind = SurfaceKind::free_form;
  return part;
}

/// The faces of one model, without letters.
struct PartInWorld {
  const world::World& world;
  int model;
  world::PlacedPart part;
  std::vector<PlaneFace> planes;  ///< by face
};

/// What may have a thread.
struct Threadable {
  std::vector<HoleFeature> holes;
  std::vector<CylinderFeature> cylinders;
};

// With a thread at the hole or cylinder to which it belongs.
Threadable with_thread(const world::PlacedPart& part, const scene::ThreadedFace& threaded, Threadable found) {
  const surfaces::PartFace& face = part.faces[threaded.face];
  const surfaces::PartSurface& surface = face.surface;
  const double way = threaded.from_high ? -1 : 1;
  const double begin = threaded.from_high ? face.to : face.from;
  ThreadFeature thread{threaded.thread.text, threaded.thread.diameter, threaded.number};
  thread.end = surface.origin + (begin + way * threaded.length) * surface.axis;
  const auto chamfer = continuation_of(part, threaded.face, threaded.from_high);
  if (threaded.is_partial) thread.length = threaded.length + (chamfer ? chamfer->height : 0);
  const auto is_here = [&](const Vec3& point, const Vec3& axis, double radius) {
    return are_same(radius, surface.radius) && are_parallel(axis, surface.axis) &&
           distance_from_line(point, surface.origin, surface.axis) <= same_size * 10 * radius;
  };
  for (HoleFeature& hole : found.holes)
    if (threaded.internal && is_here(hole.mouth, hole.axis, hole.diameter / 2)) hole.thread = thread;
  const double middle = (face.from + face.to) / 2;
  for (CylinderFeature& cylinder : found.cylinders) {
    const double centre = glm::dot((cylinder.from + cylinder.to) / 2.0 - surface.origin, surface.axis);
    if (cylinder.inwards == threaded.internal && is_here(cylinder.from, cylinder.axis, cylinder.radius) &&
        std::abs(centre - middle) <= same_size * 10 * (face.to - face.from))
      cylinder.thread = thread;
  }
  return found;
}

// With what the round faces of a part and its holes are.
PartFeatures with_round(const PartInWorld& of, PartFeatures found) {
  const RoundFaces round{of.world, of.model, of.part, find_round_faces(of.world, of.model, of.part)};
  DescribedHoles described = describe_holes(of.world, of.model, of.part);
  Threadable own{std::move(described.holes), joined(std::move(described.bores), shafts_of(round))};
  for (const scene::ThreadedFace& thread : round.placed().threads) own = with_thread(of.part, thread, std::move(own));
  found.holes = joined(std::move(found.holes), std::move(own.holes));
  found.cylinders = joined(std::move(found.cylinders), std::move(own.cylinders));
  found.arcs = joined(std::move(found.arcs), arcs_of(round, found.slots));
  found.rounds = joined(std::move(found.rounds), rounds_of(round));
  found.balls = joined(std::move(found.balls), balls_of(round));
  Cones cones = cones_of(round);
  found.chamfers = joined(std::move(found.chamfers), std::move(cones.chamfers));
  found.cones = joined(std::move(found.cones), std::move(cones.others));
  return found;
}

// Plane faces perpendicular to a world axis, outside of holes and slots.
std::vector<LevelFeature> levels_of(const PartInWorld& of, const std::vector<Cavity>& cavities) {
  std::vector<LevelFeature> levels;
  for (std::size_t f = 0; f < of.part.faces.size(); ++f) {
    const surfaces::PartSurface& surface = of.part.faces[f].surface;
    const std::vector<Vec3>& corners = of.planes[f].corners;
    if (corners.empty()) continue;
    const int axis = axis_along(surface.axis);
    if (axis < 0 || cavity_around(cavities, surface.axis, corners)) continue;
    levels.push_back({axis, surface.origin[axis], of.part.faces[f].area, corners});
  }
  return levels;
}

// One for each place along an axis, without those at the ends of the models.
std::vector<LevelFeature> merged(std::vector<LevelFeature> levels, const world::World& world, double slack) {
  const Box box = box_of_faces(world);
  std::vector<LevelFeature> places;
  for (LevelFeature& level : levels) {
    const auto is_at_end = [&](const Vec3& p) {
      return p[level.axis] <= box.min[level.axis] + slack || p[level.axis] >= box.max[level.axis] - slack;
    };
    if (std::any_of(level.points.begin(), level.points.end(), is_at_end)) continue;
    const auto same = std::find_if(places.begin(), places.end(), [&](const LevelFeature& other) {
      return other.axis == level.axis && std::abs(other.at - level.at) <= slack;
    });
    if (same == places.end()) {
      places.push_back(std::move(level));
      continue;
    }
    same->area += level.area;
    same->points.insert(same->points.end(), level.points.begin(), level.points.end());
  }
  return places;
}

std::vector<BevelFeature> bevels_of(const PartInWorld& of, const std::vector<Cavity>& cavities,
                                    const std::vector<HexagonFeature>& hexagons) {
  const auto is_other = [&](std::size_t face) {
    const PlaneFace& plane = of.planes[face];
    return cavity_around(cavities, plane.normal, plane.corners).has_value() ||
           std::any_of(hexagons.begin(), hexagons.end(),
                       [&](const HexagonFeature& hexagon) { return hexagon.has_flat(plane.vertices); });
  };
  const std::vector<std::vector<FaceBorder>> borders =
      borders_of_faces(of.world.models[static_cast<std::size_t>(of.model)]);
  return find_bevels({of.world, of.model, of.part, of.planes, borders}, is_other);
}

// With what its plane faces are, given its holes and slots.
PartFeatures with_planes(const PartInWorld& of, PartFeatures found) {
  const std::vector<Cavity> cavities = cavities_of(found, of.model);
  const std::vector<HexagonFeature> hexagons = find_hexagons(of.model, of.planes);
  found.levels = joined(std::move(found.levels), levels_of(of, cavities));
  found.bevels = joined(std::move(found.bevels), bevels_of(of, cavities, hexagons));
  found.hexagons = joined(std::move(found.hexagons), hexagons);
  for (const PlaneFace& plane : of.planes)
    if (!plane.corners.empty() && axis_along(plane.normal) < 0)
      found.inclined.push_back({of.model, plane.normal, plane.corners});
  return found;
}

// A slot is cut into the material: a bar with round ends is none.
std::vector<SlotFeature> slots_of(const CentredFeatures& centred) {
  std::vector<SlotFeature> slots;
  for (const CentredSlot& slot : centred.slots) {
    const CentredRound &one = slot.ends[0], &other = slot.ends[1];
    if (one.enclosed && other.enclosed)
      slots.push_back({one.model,
                       {one.rings.back().centre, other.rings.back().centre},
                       one.axis,
                       one.rings.back().radius,
                       glm::dot(one.rings.back().centre - one.rings.front().centre, one.axis)});
  }
  for (SlotFeature& slot : slots) {
    Vec3 along = slot.centres[1] - slot.centres[0];
    along -= glm::dot(along, slot.axis) * slot.axis;
    slot.centres[1] = slot.centres[0] + along;
  }
  return slots;
}

std::vector<ArmFeature> arms_of(const CentredFeatures& centred) {
  std::vector<ArmFeature> arms;
  for (const CentredArm& arm : centred.arms) {
    const CentredRound &one = centred.round[arm.ends[0]], &other = centred.round[arm.ends[1]];
    arms.push_back({one.model, {one.rings.front().centre, other.rings.front().centre}, arm.width});
  }
  return arms;
}

bool are_one(const PitchCircleFeature& a, const PitchCircleFeature& b) {
  return a.model == b.model && are_same(a.radius, b.radius) && are_parallel(a.axis, b.axis) &&
         distance_from_line(b.centre, a.centre, a.axis) <= same_size * a.radius;
}

PartFeatures with_pitch_circles(const CentredFeatures& centred, PartFeatures found) {
  for (const PitchCircle& circle : centred.pitch_circles) {
    std::vector<HoleFeature*> on_it;
    for (const int number : circle.holes) {
      const CentredRound& round = centred.round[number];
      for (HoleFeature& hole : found.holes)
        if (hole.model == round.model && hole.pitch_circle < 0 && are_parallel(hole.axis, round.axis) &&
            distance_from_line(hole.mouth, round.rings.front().centre, round.axis) <= same_size * 10 * hole.diameter)
          on_it.push_back(&hole);
    }
    if (on_it.size() != circle.holes.size()) continue;
    // Holes of several kinds may be on one circle.
    const PitchCircleFeature own{on_it.front()->model, circle.centre, circle.axis, circle.radius};
    const auto same = std::find_if(found.pitch_circles.begin(), found.pitch_circles.end(),
                                   [&own](const PitchCircleFeature& other) { return are_one(own, other); });
    for (HoleFeature* hole : on_it) hole->pitch_circle = static_cast<int>(same - found.pitch_circles.begin());
    if (same == found.pitch_circles.end()) found.pitch_circles.push_back(own);
  }
  return found;
}

bool holds(const CylinderFeature& shaft, const Vec3& p) {
  const double slack = same_size * shaft.radius, along = glm::dot(p, shaft.axis);
  Range reach;
  for (const Vec3& end : shaft.reach.value_or(std::array{shaft.from, shaft.to})) reach.add(glm::dot(end, shaft.axis));
  return along >= reach.from - slack && along <= reach.to + slack &&
         distance_from_line(p, shaft.from, shaft.axis) <= shaft.radius + slack;
}

// Up to the circle at its larger end.
bool holds(const ConeFeature& cone, const Vec3& p) {
  const double slack = same_size * cone.radii[1], along = glm::dot(p - cone.ends[0], cone.axis);
  const auto [low, high] = std::minmax({0.0, glm::dot(cone.ends[1] - cone.ends[0], cone.axis)});
  return along >= low - slack && along <= high + slack &&
         distance_from_line(p, cone.ends[0], cone.axis) <= cone.radii[1] + slack;
}

// Whether a level is cut into a shaft, beside its axis, and reaches across it: no side of a keyway. Steps and grooves
// divide the shaft into several, and chamfers end them.
bool is_cut_into(const LevelFeature& level, const CylinderFeature& shaft, const PartFeatures& features) {
  const double slack = same_size * shaft.radius;
  if (shaft.inwards || std::abs(shaft.axis[level.axis]) > parallel) return false;
  if (std::abs(level.at - shaft.from[level.axis]) <= slack) return false;
  if (std::none_of(level.points.begin(), level.points.end(), [&](const Vec3& p) { return holds(shaft, p); }))
    return false;
  std::vector<const CylinderFeature*> line;
  for (const CylinderFeature& other : features.cylinders)
    if (are_on_one_axis(shaft, other)) line.push_back(&other);
  const auto is_inside = [&](const Vec3& p) {
    return std::any_of(line.begin(), line.end(), [&p](const CylinderFeature* one) { return holds(*one, p); }) ||
           std::any_of(features.chamfers.begin(), features.chamfers.end(), [&](const ConeFeature& chamfer) {
             return are_parallel(chamfer.axis, shaft.axis) && holds(chamfer, p);
           });
  };
  if (!std::all_of(level.points.begin(), level.points.end(), is_inside)) return false;
  const Vec3 across = glm::cross(shaft.axis, Mat3(1)[level.axis]);
  Range aside;
  for (const Vec3& p : level.points) aside.add(glm::dot(p - shaft.from, across));
  return aside.from < -slack && aside.to > slack;
}

// Whether a level is the floor of a keyway in a bore: its sides are steps, too, from the floor to the bore.
bool is_keyed_into(const LevelFeature& level, const CylinderFeature& bore, const std::vector<LevelFeature>& levels) {
  const double slack = same_size * bore.radius, depth = level.at - bore.from[level.axis];
  const int along = axis_along(bore.axis), across = 3 - along - level.axis;
  if (!bore.inwards || along < 0 || along == level.axis || std::abs(depth) <= bore.radius + slack) return false;
  Range aside;
  for (const Vec3& p : level.points)
    if (std::abs(p[across] - bore.from[across]) < bore.radius) aside.add(p[across]);
  const auto is_on_floor = [&](const Vec3& p) { return std::abs(p[level.axis] - level.at) <= slack; };
  const auto is_on_bore = [&](const Vec3& p) {
    return holds(bore, p) && distance_from_line(p, bore.from, bore.axis) >= bore.radius - slack &&
           (p[level.axis] - bore.from[level.axis]) * depth > 0;
  };
  const auto has_side = [&](double at) {
    return std::any_of(levels.begin(), levels.end(), [&](const LevelFeature& side) {
      return side.axis == across && std::abs(side.at - at) <= slack &&
             std::any_of(side.points.begin(), side.points.end(), is_on_floor) &&
             std::any_of(side.points.begin(), side.points.end(), is_on_bore);
    });
  };
  return aside.size() > slack && has_side(aside.from) && has_side(aside.to);
}

// Of several shafts around a level, or bores beside it, the thinnest counts.
std::vector<LevelFeature> with_other_sides(std::vector<LevelFeature> levels, const PartFeatures& features) {
  std::vector<CylinderFeature> round = features.cylinders;
  for (const HoleFeature& hole : features.holes)
    round.push_back({hole.model, hole.mouth, hole.mouth - hole.reach * hole.axis, hole.axis, hole.diameter / 2, true});
  for (LevelFeature& level : levels) {
    const CylinderFeature* thinnest = nullptr;
    for (const CylinderFeature& one : round)
      if ((thinnest == nullptr || one.radius < thinnest->radius) &&
          (is_cut_into(level, one, features) || is_keyed_into(level, one, levels)))
        thinnest = &one;
    if (thinnest == nullptr) continue;
    const double middle = thinnest->from[level.axis];
    level.other_side = level.at > middle ? middle - thinnest->called() : middle + thinnest->called();
  }
  return levels;
}

}  // namespace

bool ArmFeature::has_sides(int axis, double a, double b) const {
  const double line = centres[0][axis], slack = same_size * glm::distance(centres[0], centres[1]);
  return std::abs(centres[1][axis] - line) <= slack && std::abs(a + b - 2 * line) <= slack &&
         std::abs(std::abs(a - b) - width) <= slack;
}

Vec3 HoleFeature::begin_of_bore() const {
  double depth = counterbore ? counterbore->size : 0;
  if (countersink) {
    const double half = countersink->size / 2 * degree;
    depth = (countersink->diameter - diameter) / 2 * portable_cos(half) / portable_sin(half);
  }
  return mouth - depth * axis;
}

double RoundFeature::turn_from(const Vec3& out) const {
  double least = sectors.empty() ? 0 : 180;
  for (const Sector& sector : sectors) {
    const double apart = portable_atan2(glm::length(glm::cross(out, sector.middle)), glm::dot(out, sector.middle));
    least = std::min(least, apart / degree - sector.half);
  }
  return least;
}

std::vector<Vec3> RoundFeature::section(const Vec3& out) const {
  constexpr int steps = 8;
  std::vector<Vec3> points;
  for (int i = 0; i <= steps; ++i) {
    const double angle = (angles[0] + (angles[1] - angles[0]) * i / steps) * degree;
    points.push_back(centre + (ring + radius * portable_cos(angle)) * out + radius * portable_sin(angle) * axis);
  }
  return points;
}

// A larger sphere through the rim of a cap is off by as much less in its middle as the cap is high: of the radius, a
// part of 1 - cos(a), by area / (2 pi r^2). Facets along a quarter of a tube leave it uncertain by 1 / (1 - cos(45
// degrees)).
double radius_doubt(const surfaces::PartFace& face) {
  const double radius = face.surface.radius;
  const double height = face.surface.kind == surfaces::SurfaceKind::sphere && face.area > 0
                            ? face.area / (2 * std::numbers::pi * radius * radius)
                            : tube_height;
  return face.residual / std::min(height, 1.0);
}

bool are_equal(const HoleFeature& a, const HoleFeature& b) {
  return a.model == b.model && a.through == b.through && are_same(a.diameter, b.diameter) &&
         are_parallel(a.axis, b.axis) && (a.through || glm::dot(a.axis, b.axis) > 0) &&
         a.depth.has_value() == b.depth.has_value() && are_same(a.depth.value_or(0), b.depth.value_or(0)) &&
         are_same_recess(a.counterbore, b.counterbore) && are_same_recess(a.countersink, b.countersink) &&
         are_same_thread(a.thread, b.thread);
}

bool are_on_one_axis(const CylinderFeature& a, const CylinderFeature& b) {
  return a.model == b.model && a.inwards == b.inwards && are_parallel(a.axis, b.axis) &&
         distance_from_line(b.from, a.from, a.axis) <= same_size * std::max(a.radius, b.radius);
}

bool has_coaxial_outline(const PartFeatures& features, const CylinderFeature& circle) {
  const auto is_on_axis = [&circle](const Vec3& point, const Vec3& axis) {
    return are_parallel(axis, circle.axis) &&
           distance_from_line(point, circle.from, circle.axis) <= same_size * 10 * circle.radius;
  };
  return std::any_of(features.cylinders.begin(), features.cylinders.end(),
                     [&](const CylinderFeature& cylinder) {
                       return !cylinder.inwards && cylinder.model == circle.model &&
                              are_same(cylinder.radius, circle.radius) && is_on_axis(cylinder.from, cylinder.axis);
                     }) ||
         std::any_of(features.hexagons.begin(), features.hexagons.end(), [&](const HexagonFeature& hexagon) {
           return !hexagon.inwards && hexagon.model == circle.model &&
                  are_same(hexagon.across_flats / std::numbers::sqrt3, circle.radius) &&
                  is_on_axis(hexagon.centre, hexagon.axis);
         });
}

PartFeatures find_part_features(const world::World& world, const Progress& progress) {
  PartFeatures found;
  std::vector<AxialFace> axial;
  const CentredFeatures centred = find_centred_features(world, 30, progress);
  found.slots = slots_of(centred);
  found.arms = arms_of(centred);
  for (int model = 0; model < static_cast<int>(world.models.size()); ++model) {
    progress.expect_time();
    if (world.models[model].part == nullptr) continue;
    std::optional<world::PlacedPart> part = world::place_part(world.models[model]);
    if (!part) continue;
    world::PlacedPart unlettered = without_letters(world.models[model], std::move(*part));
    std::vector<PlaneFace> planes = find_plane_faces(world, model, unlettered);
    axial = joined(std::move(axial), find_axial_faces(model, planes));
    const PartInWorld of{world, model, std::move(unlettered), std::move(planes)};
    found = with_planes(of, with_round(of, std::move(found)));
  }
  const double slack = same_level * glm::length(world.box.size());
  found.levels = merged(std::move(found.levels), world, slack);
  found = with_pitch_circles(centred, std::move(found));
  std::stable_sort(found.levels.begin(), found.levels.end(), [](const LevelFeature& a, const LevelFeature& b) {
    return std::pair(a.axis, a.at) < std::pair(b.axis, b.at);
  });
  found.levels = with_other_sides(std::move(found.levels), found);
  found.of_assembly = is_assembly(world);
  // The levels of an assembly are the ends of its parts.
  if (!found.of_assembly) found.levels = with_opposite_sides(std::move(found.levels), axial, found.cylinders, slack);
  return found;
}

}  // namespace epura::features
