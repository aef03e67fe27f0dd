// SPDX-License-Identifier: Apache-2.0
// Parses a dimension and finds its anchors in the world.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/progress.hpp"
#include "base/vec.hpp"
#include "scene/description.hpp"
#include "scene/scene.hpp"
#include "scene/true_extents.hpp"

namespace epura::sheet {

/// A circle or an arc in the world.
struct WorldCircle {
  Vec3 centre, axis;  ///< the axis has length 1
  double radius;
  std::vector<Vec3> rim;  ///< its vertices, in order round it
  bool whole;
};

/// The axis of the world that an overall dimension lies along.
constexpr int axis_of(DimensionDirection direction) {
  return direction == DimensionDirection::width ? 0 : direction == DimensionDirection::height ? 2 : 1;
}

struct AnchoredDimension {
  std::string where;  ///< for errors
  DimensionType type;
  std::optional<DimensionDirection> direction;  ///< of linear and overall ones
  std::vector<Vec3> points;                     ///< two ends; angular: the corner, then the ends of its legs
  std::vector<WorldCircle> circles;             ///< radius, diameter: all that pass through the anchor, at least one
  std::optional<double> offset;
  std::string text;                                    ///< "<>" stands for the measured value
  scene::ExtentForm form = scene::ExtentForm::length;  ///< of overall ones
  double beyond_vertices = 0;                          ///< by so much more they measure than the mesh, which is drawn
};

/// In their order; those that there is no time for are left out. Throws Error{input} that names where the dimension was
/// asked for: for a direction that its type lacks or wants, vertices that are not there, anchors that coincide, and
/// anchors on no circle where one is requested.
std::vector<AnchoredDimension> find_anchors(const scene::World& world,
                                            std::span<const scene::DimensionDescription> dimensions,
                                            const Progress& progress = {});

}  // namespace epura::sheet
