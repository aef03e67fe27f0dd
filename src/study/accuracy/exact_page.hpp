// SPDX-License-Identifier: Apache-2.0
// The page in rational numbers: corners of triangles and edges mapped to it without rounding.
#pragma once

#include <optional>
#include <vector>

#include "verify/polygon.hpp"
#include "verify/verify_input.hpp"

namespace epura {

/// Depth grows towards the viewer. Origin and unit (about that of the view) are rounded, and the same for all points.
struct ExactPoint {
  Exact x, y, depth;
};

/// Twice the signed area of a, b, c.
Exact cross(const ExactPoint& a, const ExactPoint& b, const ExactPoint& c);

class ExactPage {
 public:
  ExactPage(const VerifyInput& claim, const ProjectedScene& view);

  /// A point before the viewer.
  [[nodiscard]] ExactPoint position(const Triple<Exact>& point) const;
  /// What of a triangle lies before the viewer and between the limits of depth: its corners in order, perhaps none.
  [[nodiscard]] std::vector<ExactPoint> position(const std::array<Vec3, 3>& corners) const;

 private:
  [[nodiscard]] Polygon<Exact> clipped(const std::array<Vec3, 3>& corners) const;

  Viewing viewing_;
  Triple<Exact> point_, n_, u_, v_;
  std::optional<Triple<Exact>> centre_;
  Exact page_, depth_, nearest_;
};

}  // namespace epura
