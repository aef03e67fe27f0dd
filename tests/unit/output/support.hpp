// SPDX-License-Identifier: Apache-2.0
// Sheets to write, and the ink that readers find in the files.
#pragma once

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <string_view>
#include <vector>

#include "base/text.hpp"
#include "sheet/sheet.hpp"

namespace epura {

/// Polylines with corners everywhere, at the corners of the sheet as well, open and closed, continuous and dashed.
inline sheet::Sheet random_sheet(double width, double height, int strokes = 50) {
  std::mt19937 random(7);
  const auto coordinate = [&random](double max) { return max * (static_cast<double>(random()) / 4294967295.0); };
  sheet::Sheet sheet{width,
                     height,
                     "random",
                     {{"a view/hidden", {"hidden", 0.25, {3, 0.75}}, {}}, {"a view/visible", {"visible", 0.5}, {}}}};
  for (sheet::Layer& layer : sheet.layers) {
    for (int i = 0; i < strokes; ++i) {
      sheet::Stroke stroke;
      for (int corner = 0; corner < 2 + i % 4; ++corner)
        stroke.points.emplace_back(coordinate(width), coordinate(height));
      stroke.closed = i % 4 == 3;
      if (layer.style.dashes.dash > 0) stroke.dashes.dash = 2.5 + i * 0.01, stroke.dashes.gap = 0.75;
      stroke.kind = EdgeKind::crease;
      stroke.edges = {{0, {i, i + 1}}};
      layer.strokes.push_back(stroke);
    }
  }
  sheet::Stroke frame;
  // All corners of the sheet, but no rectangle: that is another operator in PDF.
  frame.points = {{0, 0}, {width, 0}, {width, height}, {width / 2, height * 0.9}, {0, height}};
  frame.closed = true;
  sheet.layers.back().strokes.push_back(frame);
  return sheet;
}

/// A line as a reader sees it, on the sheet: mm, y up.
struct Ink {
  std::vector<Vec2> points;
  bool closed = false;
};

inline double number_in(std::string_view text) { return parse_number(text).value(); }

/// Largest distance between corners of what was drawn and what was read; infinite when the lines do not match.
inline double largest_error(const std::vector<sheet::Stroke>& drawn, const std::vector<Ink>& read) {
  if (drawn.size() != read.size()) return HUGE_VAL;
  double error = 0;
  for (std::size_t i = 0; i < drawn.size(); ++i) {
    if (drawn[i].closed != read[i].closed || drawn[i].points.size() != read[i].points.size()) return HUGE_VAL;
    for (std::size_t p = 0; p < drawn[i].points.size(); ++p)
      error = std::max(error, glm::distance(drawn[i].points[p], read[i].points[p]));
  }
  return error;
}

}  // namespace epura
