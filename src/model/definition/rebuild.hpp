// SPDX-License-Identifier: Apache-2.0
// Finds the faces of a part again by what is said of them, beginning with faces that are off.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "definition/statements.hpp"

namespace epura::definition {

/// All that is said of a part, by rules and dimensions, as rows in terms of these unknowns.
using StateAll = std::function<std::vector<Statement>(const Unknowns&)>;

struct Rebuilt {
  std::vector<double> begun;   ///< of the unknowns: where they were at first
  std::vector<double> values;  ///< and in the end
  double left = 0;             ///< the largest difference to what is said that is left, as rows count it
  bool is_settled = false;     ///< the last step changed nothing any more
};

/// Changes each unknown by up to `off`, relative to the size of the part or in radians, as `seed` says; then looks for
/// faces by the method of Levenberg and Marquardt for which all holds that is certain. What is said is asked for where
/// the surfaces are then, by StateAll, so what is nearly so in linear terms does not count. What nothing holds stays
/// off. `base` holds the part as a whole (see base_rows).
Rebuilt rebuild(const Unknowns& unknowns, std::span<const Row> base, const StateAll& state_all, double off,
                unsigned seed);

}  // namespace epura::definition
