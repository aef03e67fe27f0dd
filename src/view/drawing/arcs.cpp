// SPDX-License-Identifier: Apache-2.0
#include "drawing/arcs.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <span>
#include <utility>

#include "base/angle.hpp"
#include "base/circle_fit.hpp"
#include "base/curve_runs.hpp"
#include "base/error.hpp"
#include "base/parallel.hpp"
#include "base/portable_math.hpp"
#include "drawing/conic_fit.hpp"
#include "drawing/limits.hpp"

namespace epura::drawing {

namespace {

struct Fit {
  Ellipse ellipse;
  bool circle;
  double from, sweep;  ///< angles; a negative sweep is clockwise
  double longest_step;
  double rise;  ///< of the curve over its chords, at most
  double deviation, tolerance;
};

// Height of the curve over the chord of a step: the chord is parallel to the tangent in its middle.
double rise_over(const Ellipse& e, double from, double step) {
  const double middle = from + step / 2;
  const Vec2 tangent = portable_cos(middle) * e.v - portable_sin(middle) * e.u;
  return std::abs(cross(e.u, e.v)) / glm::length(tangent) * (1 - portable_cos(step / 2));
}

// Whether the largest value is not much more than the usual one.
bool is_even(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *std::max_element(middle, values.end()) <= max_uneven * *middle;
}

double angle_between(const Vec2& a, const Vec2& b) { return portable_atan2(cross(a, b), glm::dot(a, b)); }

/// All points of a closed chain; of an open one, the points between its ends, which may lie on a chord.
struct Line {
  const Chain& chain;
  double tolerance;
  const KnownCircles& known;
  std::span<const int> circles;  ///< KnownCircles::of_chain

  [[nodiscard]] int before() const { return chain.closed ? 0 : 1; }
  [[nodiscard]] int size() const { return static_cast<int>(chain.points.size()) - 2 * before(); }
  [[nodiscard]] std::size_t place(int i) const { return static_cast<std::size_t>(before() + (i + size()) % size()); }
  [[nodiscard]] const Vec2& point(int i) const { return chain.points[place(i)]; }
  [[nodiscard]] double turn(int i) const { return angle_between(point(i) - point(i - 1), point(i + 1) - point(i)); }

  // The shortest run that turns far enough or no longer turns in one direction.
  [[nodiscard]] int window(int first, int max) const {
    if (first < max && fit_known(first, first + 1)) return first + 1;
    double turned = 0;
    for (int last = first + 2; last <= max; ++last) {
      const double turning = turn(last - 1);
      if (!(turned * turning >= 0) || turning == 0) return last;
      turned += turning;
      if (last - first >= min_edges_of_arc && std::abs(turned) >= max_step) return last;
    }
    return max;
  }

  // The known circle on which a whole run lies; -1 if there is none.
  [[nodiscard]] int circle_of(int first, int last) const {
    if (circles.empty()) return -1;
    const auto circle = [&](int i) { return circles[place(i)]; };
    for (int i = first + 1; i < last; ++i)
      if (circle(i) != circle(first)) return -1;
    return circle(first);
  }

  // Whether a deviation is more than rounding.
  [[nodiscard]] bool is_noise(double deviation) const { return deviation > 0.02 * tolerance; }
  [[nodiscard]] std::vector<Vec2> points_of(int first, int last) const {
    std::vector<Vec2> points;
    for (int i = first; i <= last; ++i) points.push_back(point(i));
    return points;
  }
  [[nodiscard]] std::optional<Fit> fit(int first, int last) const;
  [[nodiscard]] std::optional<Fit> fit_known(int first, int last) const;
  [[nodiscard]] std::optional<Fit> fit_any(int first, int last) const;
  [[nodiscard]] std::optional<Fit> along(const Ellipse& ellipse, const std::vector<Vec2>& points,
                                         bool is_known = false) const;
};

// Returns the fit if the corners lie on the curve in order.
std::optional<Fit> Line::along(const Ellipse& ellipse, const std::vector<Vec2>& points, bool is_known) const {
  const double min = is_known ? 0 : std::max(min_radius, min_radius_in_tolerances * tolerance);
  if (!(std::min(glm::length(ellipse.u), glm::length(ellipse.v)) >= min)) return std::nullopt;
  if (!(std::max(glm::length(ellipse.u), glm::length(ellipse.v)) <= max_radius)) return std::nullopt;
  const bool circle = glm::length(ellipse.u) == glm::length(ellipse.v);
  Fit fit{ellipse, circle, ellipse.angle_of(points.front()), 0, 0, 0, 0, tolerance};
  std::vector<double> steps, rises;
  double previous = fit.from;
  for (std::size_t i = 0; i < points.size(); ++i) {
    fit.deviation = std::max(fit.deviation, ellipse.distance(points[i]));
    if (!(fit.deviation <= tolerance)) return std::nullopt;
    if (i == 0) continue;
    const double angle = ellipse.angle_of(points[i]);
    const double step = std::remainder(angle - previous, 2 * std::numbers::pi);
    const double most = (is_known ? max_known_step : max_step) + told_apart_sine;
    if (!(std::abs(step) <= most) || !(step * fit.sweep >= 0) || step == 0) return std::nullopt;
    fit.sweep += step;
    fit.longest_step = std::max(fit.longest_step, std::abs(step));
    steps.push_back(std::abs(step));
    rises.push_back(rise_over(ellipse, previous, step));
    previous = angle;
  }
  check(!rises.empty(), "an arc has corners");
  fit.rise = *std::max_element(rises.begin(), rises.end());
  // Corners of a curve are evenly spaced, in angle or by their chords' deviation. An ellipse also passes through the
  // corners of a small fillet and the far ends of the straight lines beside it.
  if (!is_known && fit.rise > tolerance && !is_even(steps) && !is_even(rises)) return std::nullopt;
  return std::abs(fit.sweep) <= 2 * std::numbers::pi + on_line_part ? std::optional(fit) : std::nullopt;
}

std::optional<Fit> Line::fit_known(int first, int last) const {
  const int circle = circle_of(first, last);
  if (circle < 0) return std::nullopt;
  return along(known.ellipses[static_cast<std::size_t>(circle)], points_of(first, last), true);
}

std::optional<Fit> Line::fit_any(int first, int last) const {
  if (last - first < min_edges_of_arc) return std::nullopt;
  const std::vector<Vec2> points = points_of(first, last);
  std::optional<Fit> found;
  if (const auto circle = fit_circle(points))
    found = along({circle->centre, {circle->radius, 0}, {0, circle->radius}}, points);
  if (!found || is_noise(found->deviation)) {
    const auto ellipse = fit_ellipse(points);
    const auto other = ellipse ? along(*ellipse, points) : std::nullopt;
    // An ellipse always fits better, but much better only if the curve is one.
    if (!found || (other && much_better * other->deviation < found->deviation)) found = other;
  }
  return found;
}

std::optional<Fit> Line::fit(int first, int last) const {
  std::optional<Fit> found = fit_known(first, last);
  if (!found) found = fit_any(first, last);
  const bool whole = chain.closed && last - first == size();
  const bool round = found && std::abs(std::abs(found->sweep) - 2 * std::numbers::pi) < on_line_part;
  return found && round == whole ? found : std::nullopt;
}

// The rise over the longest step, wherever it is; largest in the direction of the longer semi-axis.
double bulge_of(const Fit& fit) {
  return std::max(glm::length(fit.ellipse.u), glm::length(fit.ellipse.v)) * (1 - portable_cos(fit.longest_step / 2));
}

// An end of an open chain lies on the curve, or on a chord if the line becomes hidden or is covered by another there.
bool ends_on_chord(const Fit& fit, const Vec2& end, double step, double tolerance) {
  const bool onward = step * fit.sweep > 0 && std::abs(step) <= fit.longest_step * 1.001;
  return onward && fit.ellipse.distance(end) <= bulge_of(fit) * 1.001 + tolerance;
}

CurvePart part_of(Chain& chain, const Line& line, const CurveRun<Fit>& run) {
  const Fit& fit = run.curve;
  // Of a known circle, chords are known, too.
  const int circle = chain.closed ? -1 : line.circle_of(run.first, run.last);
  const auto may_go_on = [&](int chord) {
    return circle < 0 || line.circles[static_cast<std::size_t>(chord)] == circle;
  };
  const Ellipse& e = fit.ellipse;
  const int before = chain.closed ? 0 : 1;
  CurvePart part{run.first + before, run.last + before, e.centre, e.u, e.v, fit.from, fit.from + fit.sweep};
  if (chain.closed) return part;
  const int end = static_cast<int>(chain.points.size()) - 1;
  if (part.first == 1 && may_go_on(0)) {
    const double step = std::remainder(fit.from - e.angle_of(chain.points.front()), 2 * std::numbers::pi);
    if (ends_on_chord(fit, chain.points.front(), step, line.tolerance)) {
      part.first = 0;
      part.from -= step;
      chain.points.front() = e.at(part.from);
    }
  }
  if (part.last == end - 1 && may_go_on(end - 1)) {
    const double step = std::remainder(e.angle_of(chain.points.back()) - part.to, 2 * std::numbers::pi);
    if (ends_on_chord(fit, chain.points.back(), step, line.tolerance)) {
      part.last = end;
      part.to += step;
      chain.points.back() = e.at(part.to);
    }
  }
  check(0 <= part.first && part.first < part.last && part.last <= end, "an arc begins and ends on its line");
  return part;
}

// Makes a closed line begin where no curve continues past its end.
void begin_at(Chain& chain, int first) {
  const bool side_by_side = chain.segments.size() == chain.points.size();
  std::rotate(chain.points.begin(), chain.points.begin() + first, chain.points.end());
  if (side_by_side) std::rotate(chain.segments.begin(), chain.segments.begin() + first, chain.segments.end());
}

CurveReport report_of(const Fit& fit) { return {fit.circle ? 1 : 0, fit.circle ? 0 : 1, fit.deviation, fit.rise}; }

// Points first ... last of an open line on the known circle of their chords; ends of the line may lie on chords.
struct KnownArc {
  Fit fit;
  std::vector<Vec2> points;
};

std::optional<KnownArc> known_arc(const Line& line, std::size_t first, std::size_t last, double max_rise) {
  if (line.circles.empty() || line.circles[first] < 0 || line.circles[first] != line.circles[last - 1])
    return std::nullopt;
  const Ellipse& ellipse = line.known.ellipses[static_cast<std::size_t>(line.circles[first])];
  const std::vector<Vec2>& all = line.chain.points;
  std::vector<Vec2> points(all.begin() + static_cast<std::ptrdiff_t>(first),
                           all.begin() + static_cast<std::ptrdiff_t>(last) + 1);
  if (first == 0) points.front() = ellipse.at(ellipse.angle_of(points.front()));
  if (last == all.size() - 1) points.back() = ellipse.at(ellipse.angle_of(points.back()));
  const std::optional<Fit> fit = line.along(ellipse, points, true);
  if (!fit || fit->rise > max_rise) return std::nullopt;
  return KnownArc{*fit, std::move(points)};
}

CurvePart add_arc(Chain& chain, std::size_t first, const KnownArc& arc) {
  std::copy(arc.points.begin(), arc.points.end(), chain.points.begin() + static_cast<std::ptrdiff_t>(first));
  const Ellipse& ellipse = arc.fit.ellipse;
  return {static_cast<int>(first),
          static_cast<int>(first + arc.points.size()) - 1,
          ellipse.centre,
          ellipse.u,
          ellipse.v,
          arc.fit.from,
          arc.fit.from + arc.fit.sweep};
}

// What is left of a few facets between lines that hide the rest.
CurveReport find_whole(Chain& chain, const Line& line, double max_rise) {
  const std::optional<KnownArc> arc = known_arc(line, 0, chain.points.size() - 1, max_rise);
  if (!arc) return {};
  chain.curves = {add_arc(chain, 0, *arc)};
  return report_of(arc->fit);
}

// The same of one facet at either end of an open line, which goes on along something else.
CurveReport find_at_ends(Chain& chain, const Line& line, double max_rise) {
  CurveReport report;
  const std::size_t last = chain.points.size() - 1;
  if (chain.curves.empty() || chain.curves.front().first > 0)
    if (const auto arc = known_arc(line, 0, 1, max_rise)) {
      chain.curves.insert(chain.curves.begin(), add_arc(chain, 0, *arc));
      report += report_of(arc->fit);
    }
  if (chain.curves.empty() || chain.curves.back().last < static_cast<int>(last))
    if (const auto arc = known_arc(line, last - 1, last, max_rise)) {
      chain.curves.push_back(add_arc(chain, last - 1, *arc));
      report += report_of(arc->fit);
    }
  return report;
}

CurveReport find_in(Chain& chain, const Line& line, double max_rise) {
  if (chain.points.size() <= min_known_corners) {
    if (chain.closed) return {};
    const CurveReport whole = find_whole(chain, line, max_rise);
    return chain.curves.empty() ? find_at_ends(chain, line, max_rise) : whole;
  }
  const double tolerance = line.tolerance;
  const auto window = [&](int first, int max) { return line.window(first, max); };
  const auto fit = [&](int first, int last) { return line.fit(first, last); };
  std::vector<CurveRun<Fit>> runs = find_curve_runs<Fit>(line.size(), chain.closed, window, fit);
  std::erase_if(runs, [max_rise](const CurveRun<Fit>& run) { return run.curve.rise > max_rise; });
  if (!runs.empty() && runs.back().last > line.size()) {
    begin_at(chain, runs.back().first);
    std::rotate(runs.begin(), runs.end() - 1, runs.end());
    const int shift = runs.front().first;
    for (CurveRun<Fit>& run : runs) {
      const int from_start = (run.first - shift + line.size()) % line.size();
      run = {from_start, from_start + run.last - run.first, run.curve};
    }
  }
  CurveReport report;
  for (const CurveRun<Fit>& run : runs) {
    check(run.first < run.last && run.curve.deviation <= tolerance, "corners of an arc lie on it");
    chain.curves.push_back(part_of(chain, line, run));
    report += report_of(run.curve);
  }
  if (!chain.closed) report += find_at_ends(chain, line, max_rise);
  for (std::size_t i = 1; i < chain.curves.size(); ++i)
    check(chain.curves[i - 1].last <= chain.curves[i].first, "the arcs of a line are in order");
  return report;
}

}  // namespace

CurveReport& CurveReport::operator+=(const CurveReport& other) {
  circles += other.circles;
  ellipses += other.ellipses;
  deviation = std::max(deviation, other.deviation);
  bulge = std::max(bulge, other.bulge);
  return *this;
}

CurveReport find_curves(std::vector<Chain>& chains, const CurveLimits& limits, const KnownCircles& known,
                        const Progress& progress) {
  progress.begin("finding arcs", chains.size());
  std::vector<CurveReport> reports(chains.size());
  parallel_for(chains.size(), grain::heavy, progress, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const std::span<const int> circles = known.of_chain.empty() ? std::span<const int>() : known.of_chain[i];
      const bool exact = !limits.exact.empty() && limits.exact[i] != 0;
      const double tolerance = exact ? part_if_exact * limits.tolerance : limits.tolerance;
      if (chains[i].points.size() > min_edges_of_arc || !circles.empty())
        reports[i] = find_in(chains[i], {chains[i], tolerance, known, circles}, limits.max_rise);
    }
    progress.advance(end - begin);
  });
  CurveReport all;
  for (const CurveReport& report : reports) all += report;
  return all;
}

}  // namespace epura::drawing
