// SPDX-License-Identifier: Apache-2.0
// Points of a file that belong to no face or line, such as vertices of sketches and scans, are drawn as crosses.
#pragma once

#include <string>

#include "mesh/soup.hpp"

namespace epura::mesh {

/// The most points that are drawn.
inline constexpr std::size_t max_marks = 1'000'000;

struct PointMarks {
  int points = 0;  ///< that have a cross
  int arms = 0;    ///< wires added to the soup
};

/// Marks all points of a file that has nothing else.
void mark_lone_points(Soup& soup);

/// Adds a cross of three wires parallel to the axes for each marked point. The crosses do not extend beyond the box
/// around all points, so that they do not change the size of the model. Points that are not finite have none, nor has a
/// single point alone, whose cross would have no size. Throws Error{input} with `name` for more than `max_marks`
/// points.
PointMarks add_crosses(Soup& soup, const std::string& name);

}  // namespace epura::mesh
