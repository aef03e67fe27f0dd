// SPDX-License-Identifier: Apache-2.0
// Chooses dimensions for the features of the models: each size once, in the view that shows it best. ISO 129-1, with
// depths, counterbores and countersinks by the signs of ISO 15786 and repeated features as "4× ⌀8".
#pragma once

#include <array>
#include <cstddef>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "features/part_features.hpp"
#include "features/true_extents.hpp"
#include "sheet/notation.hpp"
#include "sizes/dimensions_in_view.hpp"
#include "sizes/hole_table.hpp"
#include "sizes/overall.hpp"

namespace epura::sheet {

/// What is to be dimensioned.
struct DimensionSubject {
  const world::World& world;
  const features::PartFeatures& features;
  const std::array<features::Extent, 3>& extents;
};

/// How many steps a view dimensions along one axis, and how many radii; more would not be legible. The largest count,
/// but no step smaller than `min_level` of the area of the models' box, and no radii whose sum is less than
/// `min_radius` of its size: `epura lint` lists what is left.
inline constexpr std::size_t max_levels = 64, max_radii = 24;
inline constexpr double min_level = 5e-5, min_radius = 2e-3;

/// What has no dimension though a view shows it.
struct Omitted {
  std::map<std::string, std::size_t> too_many{};  ///< by view: sizes that are more than it can show
  std::map<std::string, std::size_t> askew{};     ///< by name: features at no angle that a view shows

  void append(Omitted other);
};

struct AutomaticPlan {
  std::vector<scene::DimensionDescription> dimensions;
  std::vector<HoleTable> tables;  ///< of views; their labels are dimensions
  Omitted omitted{};
};

/// Returns overall dimensions, as of overall_dimensions, and those of features:
/// - holes, pitch circles, slots, arcs in a view along their axes; shafts and chamfers in a view across them
/// - rounded edges of turned parts and ends of cones in a view across their axes; spheres where their outline is seen
/// - chamfers of 45 degrees, angles and ends of slopes in a view along them
/// - positions of holes, slots and bosses and heights of steps from one end of the models for all views, or from the
///   axis of a round end if both are round; along slopes from the end of their face; those of equally spaced ones as
///   "3× 20 (=60)"; holes on a pitch circle or about an axis have angles where they are uneven or askew
/// If an arrangement is wanted, positions along one axis are one row of dimensions. If a table of holes is wanted,
/// holes seen along their axes have labels instead of these, and pitch circles nothing. Sizes that no view shows in
/// true length are omitted. The first of the views that show a feature equally well counts. Last come dimensions of
/// faces that all these, and those that are `given`, leave free (free_face_dimensions.hpp); none if one view is wanted,
/// or if nothing is known of what else is given. Throws Error{input} if no view shows a size of the models.
AutomaticPlan automatic_dimensions(const scene::DimensionDescription& wanted, std::span<const NamedProjection> views,
                                   const DimensionSubject& subject, const Notation& notation,
                                   const std::optional<std::vector<DimensionsInView>>& given);

}  // namespace epura::sheet
