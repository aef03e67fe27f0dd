// SPDX-License-Identifier: Apache-2.0
// What the drawing of an assembly gives sizes for: where its parts are, and where others may be fastened to it.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "features/part_features.hpp"
#include "world/world.hpp"

namespace epura::features {

/// Whether there are several models, or a file with several bodies that are closed or have names.
bool is_assembly(const world::World& world);

/// Of the features of an assembly, holes in which no other part is; and as levels where its parts begin (on the left,
/// in front, below) or, of round parts and those with a bore in the middle, where their axes are, without parts smaller
/// than a hundredth of its size, unless they are too many (PartFeatures::unplaced). The features of its parts are for
/// their own drawings.
PartFeatures assembly_features(const world::World& world, const PartFeatures& all);

/// "43 places of parts along x", by axis with any: of PartFeatures::unplaced.
std::vector<std::string> unplaced_parts(const std::array<std::size_t, 3>& unplaced);

/// Whether the parts of an assembly are too many for places along each axis: holes are then without sizes, too.
bool has_too_many_parts(const PartFeatures& features);

/// How many parts are too small for a place, as above.
std::size_t parts_without_place(const world::World& world);

/// The features that a drawing of the world gives sizes for. Throws OutOfTime.
PartFeatures features_to_dimension(const world::World& world, const Progress& progress = {});

}  // namespace epura::features
