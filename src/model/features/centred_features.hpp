// SPDX-License-Identifier: Apache-2.0
// Finds features with centre lines: shafts and bores over their whole length, slots, holes on a pitch circle. ISO
// 128-2, type 04.1.
#pragma once

#include <array>
#include <vector>

#include "base/progress.hpp"
#include "world/world.hpp"

namespace epura::features {

/// A circle about the axis of a feature.
struct Ring {
  Vec3 centre;
  double radius;
};

/// Round faces of a model about one axis, together at least half a turn, and hexagons about it, of which the circles
/// are those through their corners; or a rim if no faces are recognised.
struct CentredRound {
  int model;
  Vec3 axis;                    ///< unit
  std::vector<Ring> rings{};    ///< circles at the ends of its faces; at least one
  std::vector<int> vertices{};  ///< vertices of its faces or its rim, in the model's file; ascending
  bool enclosed = false;        ///< a whole bore or slot, not opened by a cut: visible only through its ends
  bool cut = false;             ///< a plane cuts one of its faces
  Vec3 beside{0};               ///< an own axis of a turned part across it, instead of those of the world; unit, or 0
};

/// Two half cylinders and the planes between them, tangent to both: a slot, or a bar with round ends.
struct CentredSlot {
  std::array<CentredRound, 2> ends;
};

/// Plane sides from one round feature to another one with a parallel axis, mirror images in the plane through both
/// axes: an arm from boss to boss, or what is cut between two bores.
struct CentredArm {
  std::array<int, 2> ends;  ///< indices of round features
  double width;             ///< of parallel sides; 0 if they taper
};

/// Equal holes around a shaft or bore.
struct PitchCircle {
  Vec3 centre, axis;
  double radius;
  std::vector<int> holes;  ///< indices of round features
};

struct CentredFeatures {
  std::vector<CentredRound> round;
  std::vector<CentredSlot> slots;
  std::vector<CentredArm> arms;
  std::vector<PitchCircle> pitch_circles;
};

/// Returns the features of all models, in their order. Arcs of less than half a turn have no axis, nor have the sides
/// of grooves and engraved letters that run along an arc. If no faces are recognised, whole circles and arcs of half a
/// turn or more count, among boundaries and creases of `crease_angle` degrees or more. Throws OutOfTime.
CentredFeatures find_centred_features(const world::World& world, double crease_angle = 30,
                                      const Progress& progress = {});

}  // namespace epura::features
