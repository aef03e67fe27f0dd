// SPDX-License-Identifier: Apache-2.0
// The places along the axes of the world that features have, each with its name.
#pragma once

#include <string>
#include <vector>

#include "sizes/feature_table.hpp"

namespace epura::sheet {

struct FeaturePlace {
  int axis;
  double at;
  std::string name;  ///< empty if it needs no dimension
};

/// Of all features, feature by feature.
std::vector<FeaturePlace> places_of_features(const DimensionSubject& subject, const FeatureTable& table,
                                             const Notation& notation);

}  // namespace epura::sheet
