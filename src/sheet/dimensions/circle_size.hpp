// SPDX-License-Identifier: Apache-2.0
// Diameters and radii that a drawing has to give.
#pragma once

#include <string>
#include <vector>

#include "base/vec.hpp"

namespace epura::sheet {

/// A size of one feature, and how many dimensions give it.
struct CircleSize {
  std::string name;
  std::string kind;             ///< its name without lengths
  std::vector<double> lengths;  ///< in its name: equal ones may be rounded to different decimals
  int model;
  Vec3 centre, axis;
  double radius;
  bool anywhere;  ///< a dimension of any equal one counts: radii of fillets
  bool needs_depth;
  int equal = 0;  ///< number of its list of equal ones
  int dimensions = 0;
};

}  // namespace epura::sheet
