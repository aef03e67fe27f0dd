// SPDX-License-Identifier: Apache-2.0
// Diagrams with two logarithmic axes, as sheets for any writer.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "sheet/sheet.hpp"

namespace epura::study {

struct PlotPoint {
  Vec2 at;            ///< both positive
  std::string label;  ///< beside it; may be empty
  bool full = false;  ///< whether its mark is filled
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
  double least_y = 1e-10;  ///< lower values are drawn there
  std::string note{};      ///< below the diagram
};

/// 205 x 120 mm. Curves are distinguished by their marks and lines, which are explained in a key.
sheet::Sheet to_sheet(const LogPlot& plot);

}  // namespace epura::study
