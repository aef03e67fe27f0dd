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

/// The axis of a feature, which has a place across it.
struct PlacedAxis {
  Vec3 centre, axis;
  std::string name;
};

/// Of all features but spheres, tori and a turned part itself, kind by kind; first of holes, in their order.
std::vector<PlacedAxis> placed_axes(const features::PartFeatures& features, const FeatureTable& table,
                                    const Notation& notation);

/// Of all features, feature by feature, apart from those whose places are along the own axes of a turned part.
std::vector<FeaturePlace> places_of_features(const DimensionSubject& subject, const FeatureTable& table,
                                             const Notation& notation);

}  // namespace epura::sheet
