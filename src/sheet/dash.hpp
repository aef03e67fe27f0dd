// SPDX-License-Identifier: Apache-2.0
// Dashes fitted to lines so that ends, corners and crossings have ink. ISO 128-2.
#pragma once

#include <span>
#include <vector>

#include "base/vec.hpp"
#include "scene/line_roles.hpp"
#include "sheet/sheet.hpp"

namespace epura::sheet {

/// n = round((L - dash) / period) periods and one more dash fill the line exactly; the dashes are made to fit, about as
/// as long as in the line type. Continuous if the line is too short.
Dashes fit_open(double length, double width, const scene::DashType& type = scene::dashed);

/// The same on a closed line: n = round(L / period) periods go round it exactly.
Dashes fit_closed(double length, double width, const scene::DashType& type = scene::dashed);

/// The same as fit_open with a dash in the middle, where a centre line crosses another.
Dashes fit_centred(double length, double width, const scene::DashType& type);

/// Dashed lines of type 02 that have ink at each of the `crossings`, ascending distances from their beginning: `dashes`
/// with other lengths where these will do, otherwise a `pattern` for the whole line. Where that would have ink for
/// nearly three dashes without a gap, crossings are not heeded: a hidden line must look dashed.
struct FittedDashes {
  Dashes dashes{};
  std::vector<double> pattern{};
};
FittedDashes fit_crossings(double length, double width, bool closed, std::span<const double> crossings);

/// A part of a polyline: points first ... last, counted on past its end when it is closed.
struct DashRun {
  int first, last;
  bool closed;  ///< the whole of a closed line, without a corner to begin at
};

/// Cuts a line at its corners, turns of more than 30 degrees that are not inside a curve, for dashes to end there. A
/// run has at least `shortest` mm, so that corners too close together stay inside one. A closed line begins at a corner
/// when it has one.
std::vector<DashRun> cut_at_corners(const std::vector<Vec2>& points, bool closed, double shortest,
                                    std::span<const drawing::CurvePart> curves = {});

/// Along lines and curves.
double length_of(const std::vector<Vec2>& points, bool closed, std::span<const drawing::CurvePart> curves = {});

}  // namespace epura::sheet
