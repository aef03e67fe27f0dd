// SPDX-License-Identifier: Apache-2.0
// Parses a dimension and finds its anchors in the world.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/progress.hpp"
#include "base/vec.hpp"
#include "features/true_extents.hpp"
#include "scene/description.hpp"
#include "sizes/tolerance.hpp"
#include "world/world.hpp"

namespace epura::sheet {

/// A circle or an arc in the world.
struct WorldCircle {
  Vec3 centre, axis;  ///< the axis has length 1
  double radius;
  std::vector<Vec3> rim;  ///< its vertices, in order around it
  bool whole;
};

/// The world axis of an overall dimension.
constexpr int axis_of(DimensionDirection direction) {
  return direction == DimensionDirection::width ? 0 : direction == DimensionDirection::height ? 2 : 1;
}

struct AnchoredDimension {
  std::string where;  ///< for error messages
  DimensionType type;
  std::optional<DimensionDirection> direction;  ///< of linear and overall dimensions
  std::vector<Vec3> points;          ///< two ends, or the places of an arrangement, its origin first; angular:
                                     ///< the corner, then the ends of its legs
  std::vector<Vec3> opposite{};      ///< linear: the ends for a dimension line above or on the left, if any
  std::vector<WorldCircle> circles;  ///< radius, diameter, arc: all circles through the anchor, at least one
  std::optional<double> offset;
  std::string text;  ///< "<>" stands for the measured value
  std::optional<Tolerance> tolerance{};
  features::ExtentForm form = features::ExtentForm::length;  ///< of overall dimensions
  bool is_label = false;                                     ///< diameter: of a hole whose position is in a table
  double beyond_vertices = 0;  ///< how much more they measure than the mesh, which is drawn
  double unevenness = 0;       ///< how much less ink may show of them, as faces are not quite plane
  std::optional<DimensionArrangement> arrangement{};  ///< of a linear dimension between several places
  std::string name{};                                 ///< by which datums and frames refer to it; may be empty
  std::optional<scene::StatedValue> stated{};         ///< instead of the measured value
  bool is_exact = false;                              ///< theoretically
};

/// The position of an anchor. Throws Error{input} with `where` as the location for vertices that do not exist or that
/// belong to nothing, and for coordinates that are not finite.
Vec3 position_of(const world::World& world, const scene::Anchor& anchor, const std::string& where);

/// In the order given; without those for which there is no time. Throws Error{input} that locates the dimension: for a
/// direction that its type does not allow or that is missing, vertices that do not exist, anchors that coincide, and
/// anchors that are not on a circle where one is required.
std::vector<AnchoredDimension> find_anchors(const world::World& world,
                                            std::span<const scene::DimensionDescription> dimensions,
                                            const Progress& progress = {});

}  // namespace epura::sheet
