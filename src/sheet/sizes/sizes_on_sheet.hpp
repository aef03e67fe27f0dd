// SPDX-License-Identifier: Apache-2.0
// Which sizes of the table of features the dimensions of a sheet give.
#pragma once

#include <span>
#include <vector>

#include "sizes/coverage.hpp"
#include "sizes/feature_table.hpp"

namespace epura::sheet {

struct SizesOnSheet {
  std::vector<int> dimensions;      ///< of each size in the table: how many give it
  std::vector<double> radii;        ///< that dimensions give
  std::vector<WorldCircle> labels;  ///< of holes in tables
  std::span<const char> held{};     ///< by face of the only model, if any: whether dimensions hold it
};

/// A dimension counts for the features on its circle, and for those equal to them if it is one of a fillet or has "4×".
SizesOnSheet sizes_on_sheet(std::span<const DimensionsInView> views, const DimensionSubject& subject,
                            const FeatureTable& table);

/// Whether a table labels the hole with this mouth.
bool is_labelled(const Vec3& mouth, const SizesOnSheet& on_sheet);

/// Of each size in the table, whether it is given: by dimensions, by the size of the models, in a table of holes.
std::vector<bool> given_sizes(const SizesOnSheet& on_sheet, const DimensionSubject& subject, const FeatureTable& table,
                              const Notation& notation);

/// How many dimensions may give a size and its equals: one for each different feature at their places, as a bolt fills
/// its hole.
int max_dimensions(const FeatureSize& size, const FeatureTable& table);

}  // namespace epura::sheet
