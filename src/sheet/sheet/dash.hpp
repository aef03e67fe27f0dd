// SPDX-License-Identifier: Apache-2.0
// Fits dashes to lines so that ends, corners and crossings have ink. ISO 128-2.
#pragma once

#include <span>
#include <vector>

#include "base/vec.hpp"
#include "scene/line_roles.hpp"
#include "sheet/sheet.hpp"

namespace epura::sheet {

/// The shortest open line of type 02 that is dashed, in line widths: it has two dashes of half the usual length.
inline constexpr double shortest_dashed = 15;

/// n = round((L - dash) / period) periods, at least one, and one more dash fill the line exactly; the dashes are
/// adjusted to fit, with about the length of the line type, down to half of it in short lines of type 02. Continuous if
/// the line is too short.
Dashes fit_open(double length, double width, const scene::DashType& type = scene::dashed);

/// The same on a closed line: n = round(L / period) periods fill it exactly.
Dashes fit_closed(double length, double width, const scene::DashType& type = scene::dashed);

/// The same as fit_open with a dash in the middle, where a centre line crosses another.
Dashes fit_centred(double length, double width, const scene::DashType& type);

/// Dashed lines of type 02 that have ink at each of the `crossings`, ascending distances from the beginning of the
/// line: `dashes` with adjusted lengths if that suffices, otherwise a `pattern` for the whole line. If the pattern had
/// ink over nearly three dashes without a gap, crossings are ignored: a hidden line must look dashed.
struct FittedDashes {
  Dashes dashes{};
  std::vector<double> pattern{};
};
FittedDashes fit_crossings(double length, double width, bool closed, std::span<const double> crossings);

/// A part of a polyline: points first ... last; on a closed line, numbers continue past its end.
struct DashRun {
  int first, last;
  bool closed;  ///< the whole of a closed line without corners
};

/// Cuts a line at its corners (turns of more than 30 degrees that are not inside a curve), so that dashes end there. A
/// run has a length of at least `shortest` mm, so corners too close together stay inside one run. A closed line with
/// corners begins at one.
std::vector<DashRun> cut_at_corners(const std::vector<Vec2>& points, bool closed, double shortest,
                                    std::span<const drawing::CurvePart> curves = {});

/// Length along lines and curves.
double length_of(const std::vector<Vec2>& points, bool closed, std::span<const drawing::CurvePart> curves = {});

}  // namespace epura::sheet
