// SPDX-License-Identifier: Apache-2.0
// Surfaces from planar faces and strips of quadrilaterals, joined where they have equal corners.
//
// Loops run counter-clockwise seen from outside. Coordinates are rounded to a millionth of a millimetre, so that the
// files do not depend on the last digit of a library's sine.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "geometry.hpp"

namespace samples {

class Solid {
 public:
  explicit Solid(std::string name) : name_(std::move(name)) {}

  /// A planar face; holes may run either way round. A face that is not convex is cut into triangles.
  void face(const Loop& outer, const std::vector<Loop>& holes = {});
  /// Quadrilaterals between loops of as many points: `to` lies above `from`, which runs to the right. Twisted ones are
  /// cut into triangles.
  void strip(const Loop& from, const Loop& to);
  /// Strips from ring to ring; `closed` joins the last to the first, otherwise the ends are capped.
  void rings(const std::vector<Loop>& loops, bool closed);
  /// A prism on `base`, which runs counter-clockwise seen from where `step` leads, as its holes do.
  void prism(const Loop& base, const Point& step, const std::vector<Loop>& holes = {});
  /// The wall of a hole: `rim` runs counter-clockwise seen from outside, `step` leads into the material.
  void bore(const Loop& rim, const Point& step) { strip(rim, shifted(rim, step)); }

  [[nodiscard]] const std::string& name() const { return name_; }
  [[nodiscard]] const std::vector<Point>& points() const { return points_; }
  [[nodiscard]] const std::vector<std::vector<int>>& faces() const { return faces_; }
  [[nodiscard]] Loop corners(const std::vector<int>& face) const;

 private:
  std::vector<int> indices(const Loop& loop);

  std::string name_;
  std::vector<Point> points_;
  std::vector<std::vector<int>> faces_;
  std::map<Point, int> number_of_;
};

/// The solids of one file.
using Model = std::vector<Solid>;

}  // namespace samples
