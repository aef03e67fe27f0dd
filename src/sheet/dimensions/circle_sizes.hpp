// SPDX-License-Identifier: Apache-2.0
// Sizes of the models that circles have: holes, shafts, fillets.
#pragma once

#include <string>
#include <vector>

#include "sheet/dimensions/anchors.hpp"
#include "sheet/dimensions/automatic.hpp"
#include "sheet/notation.hpp"

namespace epura::sheet {

inline constexpr double size_agrees = 2e-4;  // relative

/// Whether two sizes are the same on a drawing.
bool agree(double a, double b);

/// A size of one feature, and how many dimensions give it.
struct CircleSize {
  std::string name;
  std::string kind;             ///< its name without lengths
  std::vector<double> lengths;  ///< in its name: equal ones may be rounded to different decimals
  int model;
  Vec3 centre, axis;
  double radius;
  bool anywhere = false;  ///< a dimension of any equal one counts: radii of fillets
  bool needs_depth = false;
  int equal = 0;  ///< number of its list of equal ones
  int dimensions = 0;

  /// Whether it is the radius of a fillet, which one note gives whatever the axes.
  [[nodiscard]] bool is_fillet() const { return kind == "radius"; }
  /// Whether a circle has this size and direction, or also this place.
  [[nodiscard]] bool is_equal(const WorldCircle& circle) const;
  [[nodiscard]] bool is_at(const WorldCircle& circle) const;
};

/// "bore ⌀12"
std::string name_of(const design::DesignCylinder& cylinder, const Notation& notation);

/// Of all features; first those of the holes, in their order.
std::vector<CircleSize> circle_sizes(const design::DesignFeatures& features, const Notation& notation);

}  // namespace epura::sheet
