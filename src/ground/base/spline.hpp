// SPDX-License-Identifier: Apache-2.0
// B-spline curves in homogeneous coordinates, in which projections move poles like points.
#pragma once

#include <functional>
#include <vector>

#include "base/vec.hpp"

namespace epura {

struct Spline {
  int degree;
  std::vector<Vec4> poles;    ///< (w x, w y, w z, w) with the weight w; more than the degree
  std::vector<double> knots;  ///< ascending, as many as poles and degree and 1 more
};

/// Returns the point at a parameter in homogeneous coordinates, by de Boor's algorithm.
Vec4 point_of(const Spline& spline, double parameter);

/// Returns the parameter between two, in any order, whose point has the least distance: of a piece that is short enough
/// that the distance has one minimum.
double nearest_parameter(const Spline& spline, double from, double to,
                         const std::function<double(const Vec4&)>& distance);

}  // namespace epura
