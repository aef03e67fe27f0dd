// SPDX-License-Identifier: Apache-2.0
// The features of the models that a drawing gives sizes for: holes, slots, shafts, hexagons, fillets, chamfers and
// steps, in world coordinates. Only what the recognised faces prove: a hole of another shape than those below is a list
// of its bores.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "base/progress.hpp"
#include "features/hexagons.hpp"
#include "world/world.hpp"

namespace epura::features {

/// A cylindrical or conical recess at the mouth of a hole.
struct Recess {
  double diameter;
  double size;  ///< depth of a counterbore; angle of a countersink, degrees
};

/// The thread of a hole or shaft.
struct ThreadFeature {
  std::string text;                ///< "M6"
  double diameter;                 ///< nominal
  int number;                      ///< of its description in the scene
  std::optional<double> length{};  ///< from the end of the hole or shaft, if it is shorter
  Vec3 end{0};                     ///< where it ends, on the axis
};

struct HoleFeature {
  int model;
  Vec3 mouth;       ///< on its axis, in the plane where it begins
  Vec3 axis;        ///< unit, out of the material at the mouth
  double diameter;  ///< of its narrowest bore
  bool through;
  std::optional<double>
      depth{};  ///< of the full diameter of a blind hole, from the mouth; nothing if it is not certain
  std::optional<Recess> counterbore{}, countersink{};
  int pitch_circle = -1;  ///< index in PartFeatures
  std::optional<ThreadFeature> thread{};
  double reach = 0;  ///< from the mouth to the end of its round faces, with the point of a drill

  /// Diameter by which it is called.
  [[nodiscard]] double called() const { return thread ? thread->diameter : diameter; }
  /// On its axis: where its narrowest bore begins, below a counterbore or countersink.
  [[nodiscard]] Vec3 begin_of_bore() const;
};

/// Whether a single note can describe both.
bool are_equal(const HoleFeature& a, const HoleFeature& b);

/// A cylinder all around: a shaft or boss, or a bore of a hole that is not a HoleFeature.
struct CylinderFeature {
  int model;
  Vec3 from, to;  ///< on its axis
  Vec3 axis;      ///< unit
  double radius;
  bool inwards;
  std::optional<ThreadFeature> thread{};
  bool whole = true;  ///< otherwise slots, flats or teeth interrupt it
  /// Its ends with those of other faces of the same cylinder that are no full turns.
  std::optional<std::array<Vec3, 2>> reach{};

  /// Radius by which it is called.
  [[nodiscard]] double called() const { return thread ? thread->diameter / 2 : radius; }
};

/// Two half cylinders and the planes between them, cut into the material.
struct SlotFeature {
  int model;
  std::array<Vec3, 2> centres;  ///< of its ends, where it begins
  Vec3 axis;                    ///< unit
  double radius;                ///< of its ends
  double reach = 0;             ///< of its ends along the axis, from where it begins
};

/// Plane sides on both sides of the line through two parallel axes, as of an arm from boss to boss.
struct ArmFeature {
  int model;
  std::array<Vec3, 2> centres;  ///< on these axes
  double width;                 ///< of parallel sides; 0 if they taper

  /// Whether its sides are at two places along an axis of the world.
  [[nodiscard]] bool has_sides(int axis, double a, double b) const;
};

/// Part of a cylinder of less than a turn: a fillet or a rounded corner.
struct ArcFeature {
  int model;
  Vec3 centre, axis;  ///< the axis is a unit vector
  double radius;
  std::vector<Vec3> points;  ///< in order along it
  bool inwards;
  Vec3 other_end{0};  ///< of its axis
};

/// A full cone, with the material inside.
struct ConeFeature {
  int model;
  std::array<Vec3, 2> ends;       ///< on its axis; the first one is that of the smaller circle
  std::array<double, 2> radii;    ///< at its ends; 0 at a tip
  Vec3 axis;                      ///< unit
  double angle;                   ///< between its side and the axis, degrees
  std::array<bool, 2> rounded{};  ///< whether a rounded edge continues it tangentially at its ends

  [[nodiscard]] Vec3 apex() const { return ends[0] + (ends[0] - ends[1]) * (radii[0] / (radii[1] - radii[0])); }
};

/// Part of a turn around an axis.
struct Sector {
  Vec3 middle;  ///< unit
  double half;  ///< degrees to either side
};

/// A torus: a fillet or rounded edge of a turned part.
struct RoundFeature {
  int model;
  Vec3 centre, axis;              ///< of the torus; the axis is a unit vector
  double ring;                    ///< radius of the circle on which the centres of its section lie
  double radius;                  ///< of its section
  std::array<double, 2> angles;   ///< ends of its section, degrees counterclockwise from outwards towards the axis
  std::vector<Sector> sectors{};  ///< what slots have left of it; empty for a full turn
  /// Whether an edge around the axis ends its section, so that its neighbours do not tell where it is: a groove, a
  /// bead.
  bool has_edge = false;

  /// Whether it is there in a direction from the axis.
  [[nodiscard]] bool reaches(const Vec3& out) const { return turn_from(out) <= 0; }
  /// Degrees from a direction to the nearest one in which it is there; not positive if it is there.
  [[nodiscard]] double turn_from(const Vec3& out) const;
  /// The points of its section in one direction from the axis, in order.
  [[nodiscard]] std::vector<Vec3> section(const Vec3& out) const;
};

/// A sphere, or a part of one.
struct BallFeature {
  int model;
  Vec3 centre;
  double radius;
  Vec3 middle;       ///< mean direction of its points from the centre; shorter than 1 if it has much of a sphere
  double doubt = 0;  ///< as of radius_doubt
};

/// By how much the radius of a sphere or of the tube of a torus may differ from that of the surface to which it was
/// fitted: the smaller the face, the less its vertices tell.
double radius_doubt(const surfaces::PartFace& face);

/// Plane faces perpendicular to a world axis, at the same place along it; without those at the ends of the models and
/// those inside holes and slots.
struct LevelFeature {
  int axis;  ///< 0, 1, 2 for x, y, z
  double at;
  double area;
  std::vector<Vec3> points;  ///< corners of the faces
  /// Of a flat or the floor of a keyway: the place of the other side of its shaft or bore, from which it is measured.
  std::optional<double> other_side{};
  /// Of one side of a groove, rib, pocket or boss: the place of the side opposite.
  std::optional<double> partner{};
};

/// A plane face that is parallel to one axis of the world only: a chamfered corner, or a slope.
struct BevelFeature {
  int model;
  int along;                  ///< the axis of the world
  std::array<Vec3, 2> ends;   ///< where it meets its neighbours, or would without the rounding between them
  std::array<int, 2> across;  ///< the axes of the world to which these are perpendicular; -1 for a slope, one at most
  double area;
  bool is_chamfer = false;        ///< of 45 degrees, at a corner of the material
  std::array<bool, 2> rounded{};  ///< an arc, tangent to both, lies between it and its neighbour
  Vec3 normal{0};                 ///< unit, out of the material
  int face = -1;                  ///< its number in the part

  /// The size of a chamfer along both axes.
  [[nodiscard]] double leg() const;
};

/// A plane face that is parallel to one axis of the world only, on which features may begin.
struct PlaneFeature {
  int model;
  Vec3 normal;                ///< unit, out of the material
  std::vector<Vec3> corners;  ///< three or more
};

struct PitchCircleFeature {
  int model;
  Vec3 centre, axis;
  double radius;
};

struct PartFeatures {
  std::vector<HoleFeature> holes;
  std::vector<CylinderFeature> cylinders;
  std::vector<SlotFeature> slots;
  std::vector<ArmFeature> arms;
  std::vector<ArcFeature> arcs;
  std::vector<RoundFeature> rounds;
  std::vector<BallFeature> balls;
  std::vector<ConeFeature> chamfers;  ///< between the end of a shaft and its cylinder
  std::vector<ConeFeature> cones;     ///< all others
  std::vector<LevelFeature> levels;   ///< by axis and place
  std::vector<PitchCircleFeature> pitch_circles;
  std::vector<BevelFeature> bevels{};
  std::vector<HexagonFeature> hexagons{};
  std::vector<PlaneFeature> inclined{};
  bool of_assembly = false;  ///< as is_assembly of the world
  /// Along each axis: places of parts of an assembly that are too many for a row, and that are not among the levels.
  std::array<std::size_t, 3> unplaced{};
};

/// Whether two cylinders of one model, both outwards or both inwards, have one axis.
bool are_on_one_axis(const CylinderFeature& a, const CylinderFeature& b);

/// Whether a shaft or boss of the same model, or the corners of a hexagon, have this axis and radius.
bool has_coaxial_outline(const PartFeatures& features, const CylinderFeature& circle);

/// Features of all models without regard to cuts, in the order of the models and their faces. Throws OutOfTime.
PartFeatures find_part_features(const world::World& world, const Progress& progress = {});

}  // namespace epura::features
