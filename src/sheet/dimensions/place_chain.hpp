// SPDX-License-Identifier: Apache-2.0
// Which places along one axis of the world dimensions join.
#pragma once

#include <array>
#include <string>
#include <utility>
#include <vector>

#include "base/disjoint_sets.hpp"
#include "design/true_extents.hpp"
#include "sheet/notation.hpp"

namespace epura::sheet {

inline constexpr std::array axis_names{"x", "y", "z"};

/// Places along one axis, from one end of the models to the other.
class PlaceChain {
 public:
  /// Places that are closer to one another than `slack` are one.
  PlaceChain(const design::Extent& extent, double slack);

  /// `name` is empty for places that need no dimension.
  void add(double at, const std::string& name);
  /// After all places, before what joins them.
  void begin();

  /// What is no place is ignored.
  void join(double a, double b);
  /// The same by a length; returns false if other lengths join both already.
  bool join_by_length(double a, double b);
  /// Joins the places that divide a length equally.
  void join_row(double from, double to, int parts);

  /// Whether dimensions join a place to both ends of the models.
  [[nodiscard]] bool is_joined(double at);

  /// Adds the places that nothing joins to the ends of the models.
  void list_open(int axis, const Notation& notation, std::vector<std::string>& open);

 private:
  [[nodiscard]] int index_of(double at) const;

  double slack_;
  design::Extent extent_;
  std::vector<std::pair<double, std::string>> places_;
  DisjointSets sets_{0}, lengths_{0};
};

}  // namespace epura::sheet
