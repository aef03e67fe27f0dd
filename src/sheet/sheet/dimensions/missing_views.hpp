// SPDX-License-Identifier: Apache-2.0
// Which view to add for a size that no view shows.
#pragma once

#include <span>
#include <string>

#include "sheet/dimensions/coverage.hpp"

namespace epura::sheet {

struct Remedy {
  std::string sentence;  ///< goes on with ", "
  std::string view;      ///< as in --projection
};

/// What to say of a circle or arc around an axis along which no view looks; nothing if one does, or if its size can
/// also be given beside the axis and a view looks from there.
Remedy remedy_for(const Vec3& axis, bool only_along, std::span<const DimensionsInView> views);

/// The same for a rounded edge around an axis, whose section may be seen in a view that is not there.
Remedy remedy_beside(const Vec3& axis, std::span<const DimensionsInView> views);

}  // namespace epura::sheet
