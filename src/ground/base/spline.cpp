// SPDX-License-Identifier: Apache-2.0
#include "base/spline.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace epura {

Vec4 point_of(const Spline& spline, double parameter) {
  const std::vector<double>& knots = spline.knots;
  const auto degree = static_cast<std::size_t>(spline.degree);
  // The span that holds the parameter: its knots are different, and it has all its poles.
  const auto first = knots.begin() + spline.degree,
             last = knots.begin() + static_cast<std::ptrdiff_t>(spline.poles.size());
  auto after = std::upper_bound(first + 1, last, parameter);
  while (after != last && *after == *(after - 1)) ++after;
  while (after != first + 1 && *(after - 1) == *after) --after;
  const auto span = static_cast<std::size_t>(after - knots.begin()) - 1;
  std::vector<Vec4> poles(spline.poles.begin() + static_cast<std::ptrdiff_t>(span - degree),
                          spline.poles.begin() + static_cast<std::ptrdiff_t>(span + 1));
  for (std::size_t level = 1; level <= degree; ++level)
    for (std::size_t i = degree; i >= level; --i) {
      const double low = knots[span - degree + i], high = knots[span + 1 + i - level];
      const double share = (parameter - low) / (high - low);
      poles[i] = (1 - share) * poles[i - 1] + share * poles[i];
    }
  return poles[degree];
}

double nearest_parameter(const Spline& spline, double from, double to,
                         const std::function<double(const Vec4&)>& distance) {
  const double golden = (std::sqrt(5.0) - 1) / 2;
  constexpr int steps = 64;  // by which a piece is as short as rounding
  double a = from, b = to;
  double low = b - golden * (b - a), high = a + golden * (b - a);
  const auto at = [&](double parameter) { return distance(point_of(spline, parameter)); };
  double of_low = at(low), of_high = at(high);
  for (int i = 0; i < steps; ++i) {
    if (of_low < of_high) {
      b = high, high = low, of_high = of_low;
      of_low = at(low = b - golden * (b - a));
    } else {
      a = low, low = high, of_low = of_high;
      of_high = at(high = a + golden * (b - a));
    }
  }
  double best = (a + b) / 2;
  for (const double end : {from, to})
    if (at(end) <= at(best)) best = end;
  return best;
}

}  // namespace epura
