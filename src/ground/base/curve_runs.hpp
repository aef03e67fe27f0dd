// SPDX-License-Identifier: Apache-2.0
// Finds runs of consecutive points of a polyline on one curve, greedily and independently of the kind of curve.
#pragma once

#include <algorithm>
#include <optional>
#include <vector>

namespace epura {

/// Points first ... last lie on the curve, which has members `deviation` (distance from them) and `tolerance`. In a
/// closed polyline, `last` may continue past its end.
template <class Curve>
struct CurveRun {
  int first, last;
  Curve curve;
};

/// Moves one end of a run towards `limit` as far as the curve allows, in steps that double and then halve. The
/// tolerance is for noise: points that lie much farther off than those of the run so far belong to something else.
template <class Curve, class Fit>
void grow(CurveRun<Curve>& run, int CurveRun<Curve>::*end, int limit, const Fit& fit) {
  constexpr double much_worse = 5, rounding = 0.02;
  const double max = std::max(much_worse * run.curve.deviation, rounding * run.curve.tolerance);
  const int sign = limit < run.*end ? -1 : 1;
  bool growing = true;
  for (int step = 1; step > 0; step = growing ? 2 * step : step / 2) {
    CurveRun<Curve> longer = run;
    longer.*end += sign * step;
    const bool inside = sign * (limit - longer.*end) >= 0;
    auto curve = inside ? fit(longer.first, longer.last) : std::nullopt;
    if (curve && curve->deviation > max) curve = std::nullopt;
    growing = growing && curve;
    if (!curve) continue;
    longer.curve = *curve;
    run = longer;
  }
}

/// Finds runs as long as possible, ascending; they share end points at most.
///   window(first, max) -> int                 last point of the shortest run from `first` worth fitting, or `max`
///   fit(first, last) -> std::optional<Curve>  the curve through all these points, if there is one
/// Both may be called with numbers of points that are negative or beyond the end of a closed polyline. After a failure,
/// the next attempt begins a sixteenth of the window later, so O(n log n) points are examined.
template <class Curve, class Window, class Fit>
std::vector<CurveRun<Curve>> find_curve_runs(int points, bool closed, const Window& window, const Fit& fit) {
  constexpr int tries_a_window = 16;
  std::vector<CurveRun<Curve>> runs;
  if (closed)
    if (const auto whole = fit(0, points)) return {{0, points, *whole}};

  // Around a closed polyline, up to the beginning of the first run.
  const auto max = [&](int at) { return !closed ? points - 1 : (runs.empty() ? at : runs.front().first) + points; };
  for (int at = 0; at < std::min(points, max(at));) {
    const int last = window(at, max(at));
    const auto curve = fit(at, last);
    if (!curve) {
      at += (last - at) / tries_a_window + 1;
      continue;
    }
    CurveRun<Curve> run{at, last, *curve};
    grow(run, &CurveRun<Curve>::last, max(at), fit);
    grow(run, &CurveRun<Curve>::first, !runs.empty() ? runs.back().last : closed ? run.last - points : 0, fit);
    at = run.last;
    runs.push_back(run);
  }
  for (CurveRun<Curve>& run : runs) {
    if (run.first >= 0) continue;
    run.first += points;
    run.last += points;
  }
  std::sort(runs.begin(), runs.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  return runs;
}

}  // namespace epura
