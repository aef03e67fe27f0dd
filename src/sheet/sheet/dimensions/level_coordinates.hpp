// SPDX-License-Identifier: Apache-2.0
// Where steps are dimensioned: each in the view in which it is nearest to the viewer.
#pragma once

#include <vector>

#include "sheet/dimensions/coordinates.hpp"
#include "sheet/dimensions/view_choice.hpp"

namespace epura::sheet {

/// The area below which a face is no step or slope to be dimensioned, for models in a box.
double min_area(const Box& box);

/// Places of the steps that are not known yet, at most `max_levels` along one axis in a view, the largest ones.
std::vector<Coordinate> level_coordinates(const DimensionSubject& subject, const ViewChoice& views,
                                          const Coordinates& known);

}  // namespace epura::sheet
