// SPDX-License-Identifier: Apache-2.0
#include "design/design_features.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <optional>
#include <utility>

#include "base/angle.hpp"
#include "base/portable_math.hpp"
#include "base/range.hpp"
#include "design/bevels.hpp"
#include "design/cavities.hpp"
#include "design/centred_features.hpp"
#include "design/design_holes.hpp"
#include "design/engraving.hpp"
#include "design/face_borders.hpp"
#include "design/interrupted_faces.hpp"
#include "design/place_threads.hpp"
#include "design/plane_faces.hpp"
#include "design/round_faces.hpp"
#include "design/tolerances.hpp"
#include "design/true_extents.hpp"
#include "world/placed_part.hpp"

namespace epura::design {

namespace {

using features::SurfaceKind;

constexpr double shortest_arc = 20;      // degrees
constexpr double least_round = 180;      // degrees of a turn that slots may leave of a rounded edge
constexpr double longest_chamfer = 0.5;  // relative to the radius

bool are_same_recess(const std::optional<Recess>& a, const std::optional<Recess>& b) {
  if (!a || !b) return a.has_value() == b.has_value();
  return are_same(a->diameter, b->diameter) && are_same(a->size, b->size);
}

bool are_same_thread(const std::optional<DesignThread>& a, const std::optional<DesignThread>& b) {
  if (!a || !b) return a.has_value() == b.has_value();
  return a->text == b->text && a->number == b->number;
}

double distance_from_line(const Vec3& point, const Vec3& on_line, const Vec3& axis) {
  return glm::length(glm::cross(point - on_line, axis));
}

/// Finds the features of one model.
class PartReader {
 public:
  PartReader(const world::World& world, int model, world::PlacedPart part)
      : world_(world),
        model_(model),
        part_(without_letters(world.models[model], std::move(part))),
        round_(find_round_faces(world, model, part_)),
        interrupted_(find_interrupted(round_, SurfaceKind::cylinder)),
        planes_(find_plane_faces(world, model, part_)) {}

  void read(DesignFeatures& found) {
    DescribedHoles described = describe_holes(world_, model_, part_);
    for (DesignHole& hole : described.holes) found.holes.push_back(hole);
    found.cylinders.insert(found.cylinders.end(), described.bores.begin(), described.bores.end());
    add_shafts(found.cylinders);
    for (const scene::ThreadedFace& thread : world_.models[model_].threads) add_thread(thread, found);
    add_arcs(found);
    add_rounds(found);
    add_cones(found);
  }

  void add_levels(const DesignFeatures& found, std::vector<DesignLevel>& levels) const {
    const std::vector<Cavity> cavities = cavities_of(found, model_);
    for (std::size_t f = 0; f < part_.faces.size(); ++f) {
      const features::PartSurface& surface = part_.faces[f].surface;
      const std::vector<Vec3>& corners = planes_[f].corners;
      if (corners.empty()) continue;
      const int axis = axis_along(surface.axis);
      if (axis < 0 || cavity_around(cavities, surface.axis, corners)) continue;
      add_level(levels, {axis, surface.origin[axis], part_.faces[f].area, corners});
    }
  }

  void add_bevels(const DesignFeatures& found, std::vector<DesignBevel>& bevels) const {
    const std::vector<Cavity> cavities = cavities_of(found, model_);
    const auto is_other = [&](std::size_t face) {
      const PlaneFace& plane = planes_[face];
      return cavity_around(cavities, plane.normal, plane.corners).has_value() ||
             std::any_of(found.hexagons.begin(), found.hexagons.end(), [&](const DesignHexagon& hexagon) {
               return hexagon.model == model_ && hexagon.has_flat(plane.vertices);
             });
    };
    const std::vector<std::vector<FaceBorder>> borders = borders_of_faces(world_.models[model_]);
    const std::vector<DesignBevel> own = find_bevels({world_, model_, part_, planes_, borders}, is_other);
    bevels.insert(bevels.end(), own.begin(), own.end());
  }

  void add_inclined(std::vector<DesignPlane>& inclined) const {
    for (const PlaneFace& plane : planes_)
      if (!plane.corners.empty() && axis_along(plane.normal) < 0)
        inclined.push_back({model_, plane.normal, plane.corners});
  }

  void add_hexagons(std::vector<DesignHexagon>& hexagons) const {
    const std::vector<DesignHexagon> own = find_hexagons(model_, planes_);
    hexagons.insert(hexagons.end(), own.begin(), own.end());
  }

 private:
  // A drawing gives the depth of letters at most, no sizes of their walls.
  static world::PlacedPart without_letters(const world::Placed& placed, world::PlacedPart part) {
    const std::vector<char> walls = walls_of_letters(placed, part);
    for (std::size_t f = 0; f < walls.size(); ++f)
      if (walls[f] != 0) part.faces[f].surface.kind = SurfaceKind::free_form;
    return part;
  }

  // Axes of short arcs are less accurate than the axis of the world to which they are parallel.
  static Vec3 snapped(const Vec3& direction) {
    const int axis = axis_along(direction);
    if (axis < 0) return direction;
    Vec3 exact(0);
    exact[axis] = direction[axis] < 0 ? -1 : 1;
    return exact;
  }

  void add_level(std::vector<DesignLevel>& levels, DesignLevel level) const {
    const double slack = 1e-5 * glm::length(world_.box.size());
    const bool is_end = level.at <= box_.min[level.axis] + slack || level.at >= box_.max[level.axis] - slack;
    if (is_end) return;
    for (DesignLevel& other : levels)
      if (other.axis == level.axis && std::abs(other.at - level.at) <= slack) {
        other.area += level.area;
        other.points.insert(other.points.end(), level.points.begin(), level.points.end());
        return;
      }
    levels.push_back(std::move(level));
  }

  // The ends of all faces of one cylinder.
  [[nodiscard]] std::array<Vec3, 2> reach_of(const RoundFace& whole) const {
    const Vec3 axis = whole.face.surface.axis;
    Range reach;
    for (const RoundFace& round : round_)
      if (&round == &whole || are_one_turn(round, whole))
        for (const double at : {round.from, round.to}) reach.add(glm::dot(round.at(at) - whole.at(0), axis));
    return {whole.at(0) + reach.from * axis, whole.at(0) + reach.to * axis};
  }

  void add_shafts(std::vector<DesignCylinder>& cylinders) const {
    for (const RoundFace& round : round_)
      if (round.face.surface.kind == SurfaceKind::cylinder && !round.face.inwards && round.is_whole()) {
        cylinders.push_back({model_, round.at(round.from), round.at(round.to), round.face.surface.axis,
                             round.face.surface.radius, false});
        cylinders.back().reach = reach_of(round);
      }
    for (const InterruptedFace& one : interrupted_) {
      const RoundFace& first = round_[static_cast<std::size_t>(one.parts.front())];
      const features::PartSurface& surface = first.face.surface;
      DesignCylinder cylinder{model_,       first.at(one.from), first.at(one.to),
                              surface.axis, surface.radius,     first.face.inwards};
      cylinder.whole = false;
      cylinders.push_back(cylinder);
    }
  }

  // To the hole or cylinder to which it belongs.
  void add_thread(const scene::ThreadedFace& threaded, DesignFeatures& found) const {
    const features::PartFace& face = part_.faces[threaded.face];
    const features::PartSurface& surface = face.surface;
    const double way = threaded.from_high ? -1 : 1;
    const double begin = threaded.from_high ? face.to : face.from;
    DesignThread thread{threaded.thread.text, threaded.thread.diameter, threaded.number};
    thread.end = surface.origin + (begin + way * threaded.length) * surface.axis;
    const auto chamfer = continuation_of(part_, threaded.face, threaded.from_high);
    if (threaded.is_partial) thread.length = threaded.length + (chamfer ? chamfer->height : 0);
    const auto is_here = [&](const Vec3& point, const Vec3& axis, double radius) {
      return are_same(radius, surface.radius) && are_parallel(axis, surface.axis) &&
             distance_from_line(point, surface.origin, surface.axis) <= same_size * 10 * radius;
    };
    for (DesignHole& hole : found.holes)
      if (threaded.internal && hole.model == model_ && is_here(hole.mouth, hole.axis, hole.diameter / 2))
        hole.thread = thread;
    const double middle = (face.from + face.to) / 2;
    for (DesignCylinder& cylinder : found.cylinders) {
      const double centre = glm::dot((cylinder.from + cylinder.to) / 2.0 - surface.origin, surface.axis);
      if (cylinder.inwards == threaded.internal && cylinder.model == model_ &&
          is_here(cylinder.from, cylinder.axis, cylinder.radius) &&
          std::abs(centre - middle) <= same_size * 10 * (face.to - face.from))
        cylinder.thread = thread;
    }
  }

  void add_arcs(DesignFeatures& found) const {
    for (const RoundFace& round : round_) {
      const features::PartSurface& surface = round.face.surface;
      if (surface.kind != SurfaceKind::cylinder || round.face.sweep < shortest_arc || round.face.sweep > longest_arc)
        continue;
      const auto shares = [&](const RoundFace& other) { return &other != &round && are_one_turn(round, other); };
      if (std::any_of(round_.begin(), round_.end(), shares)) continue;
      DesignArc arc{model_, round.at(round.to), snapped(surface.axis), surface.radius, {}, round.face.inwards};
      if (is_end_of_slot(found.slots, arc)) continue;
      constexpr int steps = 8;
      const Vec3 across = glm::cross(surface.axis, round.middle);
      for (int i = 0; i <= steps; ++i) {
        const double angle = round.face.sweep * degree * (static_cast<double>(i) / steps - 0.5);
        arc.points.push_back(arc.centre +
                             surface.radius * (portable_cos(angle) * round.middle + portable_sin(angle) * across));
      }
      found.arcs.push_back(std::move(arc));
    }
  }

  [[nodiscard]] bool is_end_of_slot(const std::vector<DesignSlot>& slots, const DesignArc& arc) const {
    return std::any_of(slots.begin(), slots.end(), [&](const DesignSlot& slot) {
      return slot.model == model_ && are_same(slot.radius, arc.radius) && are_parallel(slot.axis, arc.axis) &&
             std::any_of(slot.centres.begin(), slot.centres.end(), [&](const Vec3& centre) {
               return distance_from_line(centre, arc.centre, arc.axis) <= same_size * 10 * arc.radius;
             });
    });
  }

  void add_rounds(DesignFeatures& found) const {
    std::vector<char> done(round_.size(), 0);
    for (std::size_t i = 0; i < round_.size(); ++i) {
      if (round_[i].face.surface.kind == SurfaceKind::sphere) add_ball(round_[i], found);
      if (round_[i].face.surface.kind != SurfaceKind::torus || done[i] != 0) continue;
      DesignRound round = round_of(round_[i]);
      double sum = round_[i].face.sweep;
      for (std::size_t j = i + 1; j < round_.size(); ++j) {
        if (done[j] != 0 || round_[i].is_whole() || !is_rest_of(round_[j], round_[i])) continue;
        done[j] = 1;
        sum += round_[j].face.sweep;
        round.sectors.push_back(sector_of(round_[j]));
      }
      if (sum >= least_round) found.rounds.push_back(std::move(round));
    }
  }

  static Sector sector_of(const RoundFace& round) { return {round.middle, round.face.sweep / 2}; }

  static bool is_rest_of(const RoundFace& round, const RoundFace& first) {
    return features::are_one(round.face.surface, first.face.surface) && round.face.inwards == first.face.inwards;
  }

  void add_ball(const RoundFace& round, DesignFeatures& found) const {
    const features::PartSurface& sphere = round.face.surface;
    Vec3 middle(0);
    for (const int v : round.vertices) middle += glm::normalize(world_.points[v] - sphere.origin);
    middle /= static_cast<double>(std::max<std::size_t>(round.vertices.size(), 1));
    const bool is_known = std::any_of(found.balls.begin(), found.balls.end(), [&](const DesignBall& ball) {
      return ball.model == model_ && are_same(ball.radius, sphere.radius) &&
             glm::distance(ball.centre, sphere.origin) <= same_size * sphere.radius;
    });
    if (!is_known) found.balls.push_back({model_, sphere.origin, sphere.radius, middle, radius_doubt(round.face)});
  }

  [[nodiscard]] DesignRound round_of(const RoundFace& round) const {
    const features::PartSurface& surface = round.face.surface;
    std::vector<double> angles;
    for (const int v : round.vertices) {
      const Vec3 d = world_.points[v] - surface.origin;
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
    DesignRound made{model_, surface.origin, surface.axis, surface.radius, surface.minor, {from, from + 360 - largest}};
    if (!round.is_whole()) made.sectors.push_back(sector_of(round));
    return made;
  }

  void add_cones(DesignFeatures& found) const {
    for (const RoundFace& round : round_) {
      const features::PartSurface& surface = round.face.surface;
      if (surface.kind != SurfaceKind::cone || round.face.inwards || !round.is_whole()) continue;
      const double low = round.radius_at(round.from), high = round.radius_at(round.to);
      const bool rises = low < high;
      const double from = rises ? round.from : round.to, to = rises ? round.to : round.from;
      DesignCone cone{model_,
                      {round.at(from), round.at(to)},
                      {std::min(low, high), std::max(low, high)},
                      surface.axis,
                      portable_atan2(std::abs(high - low), std::abs(to - from)) / degree};
      cone.rounded = rounded_ends(round, cone);
      (is_chamfer(round, cone) ? found.chamfers : found.cones).push_back(cone);
    }
  }

  // At which ends of a cone a torus continues it.
  [[nodiscard]] std::array<bool, 2> rounded_ends(const RoundFace& round, const DesignCone& cone) const {
    const mesh::Mesh& mesh = world_.models[model_].mesh->whole();
    const Vec3 middle = (cone.ends[0] + cone.ends[1]) / 2.0, upwards = cone.ends[1] - cone.ends[0];
    std::array<bool, 2> rounded{};
    for (const features::PartBorder& border : world_.models[model_].part->borders)
      for (const int side : {0, 1}) {
        if (border.faces[side] != round.number || border.faces[1 - side] < 0) continue;
        const features::PartSurface& other = part_.faces[border.faces[1 - side]].surface;
        if (border.kind != features::BorderKind::tangent || other.kind != SurfaceKind::torus) continue;
        const int vertex = mesh.edges[static_cast<std::size_t>(border.edges.front())].vertex[0];
        const Vec3& point = world_.points[world_.first_vertex[model_] + vertex];
        rounded[glm::dot(point - middle, upwards) > 0 ? 1 : 0] = true;
      }
    return rounded;
  }

  // Whether a cone lies between a plane at its smaller end and a cylinder at its larger one.
  [[nodiscard]] bool is_chamfer(const RoundFace& round, const DesignCone& cone) const {
    if (glm::distance(cone.ends[0], cone.ends[1]) > longest_chamfer * cone.radii[1] || !(cone.radii[0] > 0))
      return false;
    bool plane = false, cylinder = false;
    const double slack = std::max(32 * part_.tolerance, same_size * cone.radii[1]);
    for (const features::PartBorder& border : world_.models[model_].part->borders)
      for (const int side : {0, 1}) {
        if (border.faces[side] != round.number || border.faces[1 - side] < 0) continue;
        const features::PartSurface& other = part_.faces[border.faces[1 - side]].surface;
        plane = plane || (other.kind == SurfaceKind::plane && are_parallel(other.axis, cone.axis) &&
                          std::abs(glm::dot(other.origin - cone.ends[0], cone.axis)) <= slack);
        cylinder = cylinder || (other.kind == SurfaceKind::cylinder && are_parallel(other.axis, cone.axis) &&
                                std::abs(other.radius - cone.radii[1]) <= slack);
      }
    return plane && cylinder;
  }

  const world::World& world_;
  int model_;
  world::PlacedPart part_;
  std::vector<RoundFace> round_;
  std::vector<InterruptedFace> interrupted_;
  std::vector<PlaneFace> planes_;  ///< by face
  Box box_ = box_of_faces(world_);
};

// A slot is cut into the material: a bar with round ends is none.
void add_slots(const CentredFeatures& centred, std::vector<DesignSlot>& slots) {
  for (const SlotFeature& slot : centred.slots) {
    const RoundFeature &one = slot.ends[0], &other = slot.ends[1];
    if (one.enclosed && other.enclosed)
      slots.push_back(
          {one.model, {one.rings.back().centre, other.rings.back().centre}, one.axis, one.rings.back().radius});
  }
  for (DesignSlot& slot : slots) {
    Vec3 along = slot.centres[1] - slot.centres[0];
    along -= glm::dot(along, slot.axis) * slot.axis;
    slot.centres[1] = slot.centres[0] + along;
  }
}

bool are_one(const DesignPitchCircle& a, const DesignPitchCircle& b) {
  return a.model == b.model && are_same(a.radius, b.radius) && are_parallel(a.axis, b.axis) &&
         distance_from_line(b.centre, a.centre, a.axis) <= same_size * a.radius;
}

void add_pitch_circles(const CentredFeatures& centred, DesignFeatures& found) {
  for (const PitchCircle& circle : centred.pitch_circles) {
    std::vector<DesignHole*> on_it;
    for (const int number : circle.holes) {
      const RoundFeature& round = centred.round[number];
      for (DesignHole& hole : found.holes)
        if (hole.model == round.model && hole.pitch_circle < 0 && are_parallel(hole.axis, round.axis) &&
            distance_from_line(hole.mouth, round.rings.front().centre, round.axis) <= same_size * 10 * hole.diameter)
          on_it.push_back(&hole);
    }
    if (on_it.size() != circle.holes.size()) continue;
    // Holes of several kinds may be on one circle.
    const DesignPitchCircle own{on_it.front()->model, circle.centre, circle.axis, circle.radius};
    const auto same = std::find_if(found.pitch_circles.begin(), found.pitch_circles.end(),
                                   [&own](const DesignPitchCircle& other) { return are_one(own, other); });
    for (DesignHole* hole : on_it) hole->pitch_circle = static_cast<int>(same - found.pitch_circles.begin());
    if (same == found.pitch_circles.end()) found.pitch_circles.push_back(own);
  }
}

bool holds(const DesignCylinder& shaft, const Vec3& p) {
  const double slack = same_size * shaft.radius, along = glm::dot(p, shaft.axis);
  Range reach;
  for (const Vec3& end : shaft.reach.value_or(std::array{shaft.from, shaft.to})) reach.add(glm::dot(end, shaft.axis));
  return along >= reach.from - slack && along <= reach.to + slack &&
         distance_from_line(p, shaft.from, shaft.axis) <= shaft.radius + slack;
}

bool are_coaxial(const DesignCylinder& a, const DesignCylinder& b) {
  return !a.inwards && !b.inwards && are_parallel(a.axis, b.axis) &&
         distance_from_line(b.from, a.from, a.axis) <= same_size * std::max(a.radius, b.radius);
}

// Whether a level is cut into a shaft, beside its axis, and reaches across it: no side of a keyway. Steps and grooves
// divide the shaft into several.
bool is_cut_into(const DesignLevel& level, const DesignCylinder& shaft, const std::vector<DesignCylinder>& cylinders) {
  const double slack = same_size * shaft.radius;
  if (shaft.inwards || std::abs(shaft.axis[level.axis]) > parallel) return false;
  if (std::abs(level.at - shaft.from[level.axis]) <= slack) return false;
  if (std::none_of(level.points.begin(), level.points.end(), [&](const Vec3& p) { return holds(shaft, p); }))
    return false;
  std::vector<const DesignCylinder*> line;
  for (const DesignCylinder& other : cylinders)
    if (are_coaxial(shaft, other)) line.push_back(&other);
  const auto is_inside = [&line](const Vec3& p) {
    return std::any_of(line.begin(), line.end(), [&p](const DesignCylinder* one) { return holds(*one, p); });
  };
  if (!std::all_of(level.points.begin(), level.points.end(), is_inside)) return false;
  const Vec3 across = glm::cross(shaft.axis, Mat3(1)[level.axis]);
  Range aside;
  for (const Vec3& p : level.points) aside.add(glm::dot(p - shaft.from, across));
  return aside.from < -slack && aside.to > slack;
}

// Of several shafts around a level, the thinnest counts.
void find_other_sides(DesignFeatures& found) {
  for (DesignLevel& level : found.levels) {
    const DesignCylinder* thinnest = nullptr;
    for (const DesignCylinder& shaft : found.cylinders)
      if ((thinnest == nullptr || shaft.radius < thinnest->radius) && is_cut_into(level, shaft, found.cylinders))
        thinnest = &shaft;
    if (thinnest == nullptr) continue;
    const double middle = thinnest->from[level.axis];
    level.other_side = level.at > middle ? middle - thinnest->called() : middle + thinnest->called();
  }
}

}  // namespace

double DesignRound::turn_from(const Vec3& out) const {
  double least = sectors.empty() ? 0 : 180;
  for (const Sector& sector : sectors) {
    const double apart = portable_atan2(glm::length(glm::cross(out, sector.middle)), glm::dot(out, sector.middle));
    least = std::min(least, apart / degree - sector.half);
  }
  return least;
}

std::vector<Vec3> DesignRound::section(const Vec3& out) const {
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
double radius_doubt(const features::PartFace& face) {
  constexpr double of_tubes = 3;
  const double radius = face.surface.radius;
  const double height = face.surface.kind == features::SurfaceKind::sphere && face.area > 0
                            ? face.area / (2 * std::numbers::pi * radius * radius)
                            : 1 / of_tubes;
  return face.residual / std::min(height, 1.0);
}

bool are_equal(const DesignHole& a, const DesignHole& b) {
  return a.model == b.model && a.through == b.through && are_same(a.diameter, b.diameter) &&
         are_parallel(a.axis, b.axis) && (a.through || glm::dot(a.axis, b.axis) > 0) &&
         a.depth.has_value() == b.depth.has_value() && are_same(a.depth.value_or(0), b.depth.value_or(0)) &&
         are_same_recess(a.counterbore, b.counterbore) && are_same_recess(a.countersink, b.countersink) &&
         are_same_thread(a.thread, b.thread);
}

bool has_coaxial_outline(const DesignFeatures& features, const DesignCylinder& circle) {
  const auto is_on_axis = [&circle](const Vec3& point, const Vec3& axis) {
    return are_parallel(axis, circle.axis) &&
           distance_from_line(point, circle.from, circle.axis) <= same_size * 10 * circle.radius;
  };
  return std::any_of(features.cylinders.begin(), features.cylinders.end(),
                     [&](const DesignCylinder& cylinder) {
                       return !cylinder.inwards && cylinder.model == circle.model &&
                              are_same(cylinder.radius, circle.radius) && is_on_axis(cylinder.from, cylinder.axis);
                     }) ||
         std::any_of(features.hexagons.begin(), features.hexagons.end(), [&](const DesignHexagon& hexagon) {
           return !hexagon.inwards && hexagon.model == circle.model &&
                  are_same(hexagon.across_flats / std::numbers::sqrt3, circle.radius) &&
                  is_on_axis(hexagon.centre, hexagon.axis);
         });
}

DesignFeatures find_design_features(const world::World& world, const Progress& progress) {
  DesignFeatures found;
  const CentredFeatures centred = find_centred_features(world, 30, progress);
  add_slots(centred, found.slots);
  for (int model = 0; model < static_cast<int>(world.models.size()); ++model) {
    progress.expect_time();
    if (world.models[model].part == nullptr) continue;
    std::optional<world::PlacedPart> part = world::place_part(world.models[model]);
    if (!part) continue;
    PartReader reader(world, model, std::move(*part));
    reader.read(found);
    reader.add_levels(found, found.levels);
    reader.add_hexagons(found.hexagons);
    reader.add_bevels(found, found.bevels);
    reader.add_inclined(found.inclined);
  }
  add_pitch_circles(centred, found);
  std::stable_sort(found.levels.begin(), found.levels.end(), [](const DesignLevel& a, const DesignLevel& b) {
    return std::pair(a.axis, a.at) < std::pair(b.axis, b.at);
  });
  find_other_sides(found);
  return found;
}

}  // namespace epura::design
