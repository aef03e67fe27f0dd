// Dashes fitted to lines, so that ends and corners are drawn with ink. ISO 128-2, line type 02.
#pragma once

#include <vector>

#include "base/vec.hpp"
#include "sheet/sheet.hpp"

namespace epura {

/// Nominal lengths in line widths.
inline constexpr double dash_widths = 12, gap_widths = 3;

/// Dashes of about 12 widths and gaps of 3 widths on a line of this length: n = round((L - 12 d) / 15 d) gaps and
/// n + 1 dashes fill it exactly. Lines below 27 widths are continuous.
Dashes fit_open(double length, double width);

/// The same on a closed line: n = round(L / 15 d) dashes and as many gaps go round it exactly.
Dashes fit_closed(double length, double width);

/// A part of a polyline: points first ... last, counted on past its end when it is closed.
struct DashRun {
  int first, last;
  bool closed;  ///< the whole of a closed line, without a corner to begin at
};

/// Cuts a line at its corners, turns of more than 30 degrees, for dashes to end there. A run has at least 27 widths,
/// so that corners too close together stay inside one. A closed line begins at a corner when it has one.
std::vector<DashRun> cut_at_corners(const std::vector<Vec2>& points, bool closed, double width);

double length_of(const std::vector<Vec2>& points, bool closed);

}  // namespace epura
