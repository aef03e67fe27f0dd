// SPDX-License-Identifier: Apache-2.0
// Which sizes of what is turned against the axes of the world have no dimension: angles of holes, positions along
// slopes.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "sizes/coverage.hpp"
#include "sizes/feature_table.hpp"
#include "sizes/sizes_on_sheet.hpp"

namespace epura::sheet {

struct TurnedCoverage {
  std::vector<bool> holes;  ///< in the order of the features: whether nothing of the kind is missing
  std::vector<std::string> missing;
};

/// Angles of holes about an axis that their note does not give, and positions along the slopes on which features begin.
TurnedCoverage cover_turned(std::span<const DimensionsInView> views, const DimensionSubject& subject,
                            const FeatureTable& table, const SizesOnSheet& on_sheet, const Notation& notation);

}  // namespace epura::sheet
