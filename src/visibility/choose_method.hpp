// SPDX-License-Identifier: Apache-2.0
// The cheapest method that cannot be wrong by more than is allowed.
//
// Only bounds count that hold for every scene. Exact: 1e-6 of the drawing's size (docs/numerics.md). Sampled: a span
// that is shown wrongly holds no point that was looked at, so it is shorter than the distance of two points; half the
// allowed error is taken for that distance, so that a point on a border, which rounding may put on either side of it,
// does not matter. Item buffers and floats have no such bound: what they cannot see may have any length.
#pragma once

#include <optional>
#include <string>

#include "visibility/method.hpp"

namespace epura {

struct MethodChoice {
  Method method{};
  double bound = 0;      ///< mm: no misclassified span is longer
  std::string reason{};  ///< half a sentence
};

/// `mm` of paper are a view unit long; `allowed` is the length in mm that a misclassified span of an edge may have.
/// What a method costs is told from the number of points an edge (docs/accuracy.md). Throws Error{input} where not even
/// the exact method guarantees so little.
MethodChoice choose_method(const ProjectedScene& view, const FeatureEdges& drawn, double mm, double allowed);

}  // namespace epura
