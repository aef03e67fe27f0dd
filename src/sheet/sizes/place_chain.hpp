// SPDX-License-Identifier: Apache-2.0
// Which places along one axis of the world dimensions join.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "base/disjoint_sets.hpp"
#include "features/true_extents.hpp"
#include "sizes/feature_places.hpp"
#include "sizes/place_joins.hpp"

namespace epura::sheet {

inline constexpr std::array axis_names{"x", "y", "z"};

/// Places along one axis, from one end of the models to the other.
class PlaceChain {
 public:
  /// Those of the features along this axis; places that are closer to one another than `slack` are one.
  PlaceChain(int axis, const features::Extent& extent, std::span<const FeaturePlace> places, double slack);

  /// What is no place is ignored. Returns false if other lengths join both ends of a length already.
  bool join(const PlaceJoin& join);

  /// The places that dimensions join to both ends of the models.
  [[nodiscard]] std::vector<double> joined();

  /// The places that nothing joins to the ends of the models.
  [[nodiscard]] std::vector<std::string> open(const Notation& notation);

 private:
  void add(double at, const std::string& name);
  [[nodiscard]] int index_of(double at) const;
  bool join_by_length(double a, double b);

  int axis_;
  double slack_;
  features::Extent extent_;
  std::vector<std::pair<double, std::string>> places_;
  DisjointSets sets_{0}, lengths_{0};
};

}  // namespace epura::sheet
