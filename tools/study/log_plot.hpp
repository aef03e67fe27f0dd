// SPDX-License-Identifier: Apache-2.0
// Diagrams with two logarithmic axes, as sheets for any writer.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "sheet/sheet.hpp"

namespace epura::study {

struct PlotPoint {
  Vec2 at;                                   ///< both positive
  std::string label;                         ///< beside it; may be empty
  bool on_front = false;                     ///< no other point is lower and farther left: filled, and joined by steps
  std::array<double, 2> spread{at.x, at.x};  ///< of x: the bar through the mark
};

struct PlotCurve {
  std::string name;
  std::vector<PlotPoint> points;
};

/// A line across the diagram at one value.
struct PlotMark {
  std::string label;
  double at;
  bool vertical;  ///< at this x, otherwise at this y
};

struct LogPlot {
  std::string name;  ///< of its layers: unique in a document
  std::string title, x_axis, y_axis;
  std::vector<PlotCurve> curves;
  std::vector<PlotMark> marks{};
  double min_y = 1e-10;  ///< lower values are drawn there
  std::string note{};    ///< below the diagram
};

/// 205 x 120 mm. Curves are distinguished by their marks, lines and colours, which are explained in a key. No label
/// lies on a mark, a line or another label; one that has no room beside its mark stands farther away, with a line that
/// leads to it. Points of a curve whose marks overlap share a label.
sheet::Sheet to_sheet(const LogPlot& plot);

}  // namespace epura::study
