// SPDX-License-Identifier: Apache-2.0
// Single lines beside, through and along plates.
#include <algorithm>
#include <array>
#include <cmath>

#include "study/stability/case.hpp"
#include "study/stability/forms.hpp"

namespace epura::stability {

namespace {

// A wide ground far below, so that lines beside the plates lie inside the drawing.
Shape ground() { return plate(-4, -4, 4, 4, -10); }

using Interval = std::array<double, 2>;

// Length of the parts hidden in only one of the two, outside `excused`.
double differing(const visibility::Spans& got, const Interval& expected, const Interval& excused) {
  std::vector<double> ends{0, 1, expected[0], expected[1], excused[0], excused[1]};
  for (const auto& span : got) ends.insert(ends.end(), span.begin(), span.end());
  std::sort(ends.begin(), ends.end());
  const auto holds = [](const Interval& i, double t) { return i[0] < t && t < i[1]; };
  double sum = 0;
  for (std::size_t i = 1; i < ends.size(); ++i) {
    const double t = (ends[i - 1] + ends[i]) / 2;
    const bool hidden = std::any_of(got.begin(), got.end(), [&](const Interval& span) { return holds(span, t); });
    if (hidden != holds(expected, t) && !holds(excused, t)) sum += ends[i] - ends[i - 1];
  }
  return sum;
}

// Where a line crosses a border of a plate at a small slope, the two are merged as long as they are closer than the
// merge width: there, either answer leaves the ink unchanged.
Measured beside_a_border(const HiddenLine& line, const Interval& expected, double slope, const Interval& border) {
  const double reach = slope > 0 ? line.merge_width() / slope : HUGE_VAL;
  const Interval excused{std::max(0.5 - reach, border[0]), std::min(0.5 + reach, border[1])};
  return {length("misclassified", 0, differing(line.spans, expected, excused), 1)};
}

Measured almost_along_a_border(const Lab& lab, double e) {
  const HiddenLine line = lab.hidden_of_line(lab.world_of({plate(0, 0, 1, 1, 1), ground()}), from_above(),
                                             {-1, e * -1.5, 0}, {2, e * 1.5, 0});
  return beside_a_border(line, {0.5, 2.0 / 3}, 3 * e, {1.0 / 3, 2.0 / 3});
}

// The upper plate's border crosses the line at the angle a.
Measured crossing_at_an_angle(const Lab& lab, double a) {
  const Shape upper{{{-1, -a, 1}, {1, a, 1}, {1, 1, 1}, {-1, 1, 1}}, {{0, 1, 2, 3}}, {}};
  const HiddenLine line = lab.hidden_of_line(lab.world_of({upper, ground()}), from_above(), {-2, 0, 0}, {2, 0, 0});
  return beside_a_border(line, {0.25, 0.5}, 4 * a, {0.25, 0.75});
}

// The contact tolerance lengthens the visible part of a piercing line.
Measured piercing(const Lab& lab, double slope) {
  const HiddenLine line = lab.hidden_of_line(lab.world_of({plate(-2, -1, 2, 1, 0), ground()}), from_above(),
                                             {-1, 0, -slope}, {1, 0, slope});
  const double end = 0.5 - line.contact / (2 * slope);
  if (end > 0) return one_span(line, 0, end);
  return {count("hidden pieces", 0, static_cast<double>(line.spans.size()))};
}

Measured lying_in_a_plate(const Lab& lab, double slope) {
  const Shape tilted{
      {{-2, -1, -2 * slope}, {2, -1, 2 * slope}, {2, 1, 2 * slope}, {-2, 1, -2 * slope}}, {{0, 1, 2, 3}}, {}};
  const Vec3 from(-1, -0.3, -slope), to(1, 0.7, slope);
  const Shape below = ground().moved(0, 0, -4 * slope);
  const HiddenLine line = lab.hidden_of_line(lab.world_of({tilted, below}), from_above(), from, to);
  return {count("hidden pieces", 0, static_cast<double>(line.spans.size()))};
}

Measured behind_a_narrow_plate(const Lab& lab, double w) {
  const auto hidden = [&](const Shape& narrow) {
    double sum = 0;
    const HiddenLine line = lab.hidden_of_line(lab.world_of({narrow, ground()}), from_above(), {-1, 0, 0}, {1, 0, 0});
    for (const auto& [from, to] : line.spans) sum += 2 * (to - from);
    return sum;
  };
  const Shape steep{{{0, -1, -1}, {w, -1, 1}, {w, 1, 1}, {0, 1, -1}}, {{0, 1, 2, 3}}, {}};
  return {length("behind", w, hidden(plate(0, -1, w, 1, 1)), 8),
          length("at half of the depth", w / 2, hidden(steep), 8)};
}

// A corner of the fan lies at (1, 0); on the other side there is a corner or the middle of a side.
Measured through_a_hub(const Lab& lab, double blades) {
  const int n = static_cast<int>(blades);
  const HiddenLine line = lab.hidden_of_line(lab.world_of({fan(n), ground()}), from_above(), {-2, 0, 0}, {2, 0, 0});
  return one_span(line, (2 - (n % 2 == 0 ? 1 : std::cos(M_PI / n))) / 4, 0.75);
}

Measured through_a_bow_tie(const Lab& lab, double half) {
  const Shape bow{{{0, 0, 1}, {-half, 1, 1}, {half, 1, 1}, {-half, -1, 1}, {half, -1, 1}}, {{0, 2, 1}, {0, 3, 4}}, {}};
  const HiddenLine line = lab.hidden_of_line(lab.world_of({bow, ground()}), from_above(), {-1, 0, 0}, {1, 0, 0});
  return {count("hidden pieces", 0, static_cast<double>(line.spans.size()))};
}

}  // namespace

std::vector<Case> line_cases() {
  return {
      {"V4",
       "line almost along the border of a plate",
       "slope",
       {1e-1, 1e-2, 1e-3, 1e-4, 1e-6, 1e-8, 1e-10, 1e-12, 0},
       almost_along_a_border},
      {"V5", "line piercing a plate", "slope", {1, 1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-9, 1e-12, 1e-15}, piercing},
      {"V6",
       "line lying in a plate",
       "slope of the plate",
       {0, 1e-12, 1e-8, 1e-4, 1e-1, 1, 1e1, 1e2, 1e3},
       lying_in_a_plate},
      {"V7",
       "line behind, and through the middle of, a narrow plate",
       "width",
       {1e-1, 1e-2, 1e-3, 1e-4, 1e-6, 1e-8, 1e-10, 1e-12},
       behind_a_narrow_plate},
      {"V8", "line through the hub of a fan", "blades", {3, 4, 7, 16, 101, 1000, 3001, 10000}, through_a_hub},
      {"V9",
       "line through the vertex of a bow tie",
       "half width of the bow",
       {0.5, 1e-1, 1e-2, 1e-3, 1e-4, 1e-6, 1e-8, 1e-10},
       through_a_bow_tie},
      {"V13",
       "long edges that cross at a small angle",
       "angle",
       {1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-10, 1e-12},
       crossing_at_an_angle},
  };
}

}  // namespace epura::stability
