// SPDX-License-Identifier: Apache-2.0
#include "sheet/dash.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>

#include "base/error.hpp"
#include "drawing/curve_part.hpp"

namespace epura::sheet {

namespace {

const Vec2& at(const std::vector<Vec2>& points, int index) {
  return points[static_cast<std::size_t>(index) % points.size()];
}

// The point before or after another one (`step` is -1 or 1), if that is an end of the line or farther than `reach`;
// otherwise the next one in that direction for which this holds.
const Vec2& next_beyond(const std::vector<Vec2>& points, bool closed, int index, int step, double reach) {
  const int count = static_cast<int>(points.size());
  int next = index + count + step;
  for (int i = 2; i < count && glm::distance(at(points, next), at(points, index)) <= reach; ++i) {
    if (!closed && (next % count == 0 || next % count == count - 1)) break;
    next += step;
  }
  return at(points, next);
}

// Steps no longer than `reach`, with which lines are joined that end beside each other, are no corners.
bool is_corner(const std::vector<Vec2>& points, bool closed, int index, double reach,
               std::span<const drawing::CurvePart> curves) {
  const int count = static_cast<int>(points.size());
  const auto inside = [&](const drawing::CurvePart& curve) {
    return curve.first < index % count && index % count < curve.last;
  };
  if (std::any_of(curves.begin(), curves.end(), inside)) return false;
  const Vec2 in = at(points, index) - next_beyond(points, closed, index, -1, reach);
  const Vec2 out = next_beyond(points, closed, index, 1, reach) - at(points, index);
  constexpr double cosine = 0.8660254037844386;  // of 30 degrees
  return glm::dot(in, out) < cosine * glm::length(in) * glm::length(out);
}

constexpr double shortest_dash = 8, longest_dash = 16, longest_ink = 32;  // line widths

bool inks_all(const Dashes& dashes, std::span<const double> crossings) {
  const double period = dashes.dash + dashes.gap, slack = 1e-9 * period;
  return std::all_of(crossings.begin(), crossings.end(),
                     [&](double s) { return std::fmod(s + slack, period) <= dashes.dash + 2 * slack; });
}

// Dashes of equal length that have ink at all crossings, as close to the usual ones as possible.
std::optional<Dashes> try_lengths(double length, double width, bool closed, std::span<const double> crossings) {
  for (const double gap_widths : {3.0, 2.5, 3.5}) {
    const double gap = gap_widths * width, usual = scene::dashed.dash * width + gap;
    const double dashes_more = closed ? 0 : 1;  // more dashes than gaps
    const double gaps = std::round((length + gap * dashes_more) / usual) - dashes_more;
    for (const double more : {0.0, 1.0, -1.0, 2.0, -2.0, 3.0, -3.0}) {
      const double n = gaps + more;
      if (n < 1) continue;
      const Dashes dashes{(length - n * gap) / (n + dashes_more), gap};
      const double widths = dashes.dash / width;
      if (widths >= shortest_dash && widths <= longest_dash && inks_all(dashes, crossings)) return dashes;
    }
  }
  return std::nullopt;
}

// A dash around each crossing and at the ends; the intervals between them are filled as evenly as possible.
std::vector<double> pattern_for(double length, double width, bool closed, std::span<const double> crossings) {
  const double half = scene::dashed.dash / 2 * width, gap = scene::dashed.gap * width,
               dash = scene::dashed.dash * width;
  const double at_ends = closed ? half : dash;  // the halves at the seam of a closed line form one dash
  std::vector<std::array<double, 2>> inked{{0, at_ends}};
  const auto add = [&](double from, double to) {
    if (from - inked.back()[1] < gap) {
      inked.back()[1] = std::max(inked.back()[1], to);
    } else {
      inked.push_back({from, to});
    }
  };
  for (const double s : crossings) add(std::max(s - half, 0.0), std::min(s + half, length));
  add(length - at_ends, length);

  std::vector<double> pattern{inked.front()[1]};
  for (std::size_t i = 1; i < inked.size(); ++i) {
    const double room = inked[i][0] - inked[i - 1][1];
    const double dashes = std::max(0.0, std::round((room - gap) / (dash + gap)));
    // Without room for a dash, the gap would be too wide: the dashes next to it are extended.
    const double grow = dashes > 0 ? 0 : (room - gap) / 2;
    pattern.back() += grow;
    for (int k = 0; k < static_cast<int>(dashes); ++k)
      pattern.insert(pattern.end(), {gap, (room - (dashes + 1) * gap) / dashes});
    pattern.insert(pattern.end(), {gap, inked[i][1] - inked[i][0] + grow});
  }
  double sum = 0;
  for (const double part : pattern) {
    check(part >= 0, "dashes and gaps have a length");
    sum += part;
  }
  check(std::abs(sum - length) <= 1e-9 * length, "dashes and gaps are as long as their line");
  pattern.push_back(gap);  // beyond the end: writers need pairs
  return pattern;
}

// The number of periods is a multiple of `of`.
Dashes fit_multiple(double length, double width, const scene::DashType& type, double of) {
  if (!(length >= (type.dots == 0 ? shortest_dashed : type.shortest()) * width)) return {};
  const double rest = type.rest() * width;
  const double usual = of * std::round((length - type.dash * width) / (of * (type.dash * width + rest)));
  const double periods = std::max(of, usual);
  const double dash = (length - rest * periods) / (periods + 1);
  check(dash > 0, "a line long enough for dashes has dashes");
  return {dash, type.gap * width, type.dot * width, type.dots};
}

}  // namespace

Dashes fit_open(double length, double width, const scene::DashType& type) {
  return fit_multiple(length, width, type, 1);
}

Dashes fit_centred(double length, double width, const scene::DashType& type) {
  return fit_multiple(length, width, type, 2);
}

Dashes fit_closed(double length, double width, const scene::DashType& type) {
  if (!(length >= type.shortest() * width)) return {};
  const double rest = type.rest() * width;
  const double periods = std::round(length / (type.dash * width + rest));
  check(periods >= 1 && length / periods > rest, "a closed line long enough for dashes has dashes");
  return {length / periods - rest, type.gap * width, type.dot * width, type.dots};
}

FittedDashes fit_crossings(double length, double width, bool closed, std::span<const double> crossings) {
  const Dashes usual = closed ? fit_closed(length, width) : fit_open(length, width);
  const bool is_short = length < scene::dashed.shortest() * width;
  if (usual.dash == 0 || is_short || inks_all(usual, crossings)) return {usual};
  if (const auto dashes = try_lengths(length, width, closed, crossings)) return {*dashes};
  std::vector<double> pattern = pattern_for(length, width, closed, crossings);
  double longest = closed ? pattern.front() + pattern[pattern.size() - 2] : 0;  // across the seam
  for (std::size_t dash = 0; dash < pattern.size(); dash += 2) longest = std::max(longest, pattern[dash]);
  if (longest > longest_ink * width) return {usual};
  return {{}, std::move(pattern)};
}

std::vector<DashRun> cut_at_corners(const std::vector<Vec2>& points, bool closed, double shortest,
                                    std::span<const drawing::CurvePart> curves) {
  const int count = static_cast<int>(points.size());
  const double reach = shortest / 256;  // a tenth of a line's width
  const auto turns = [&](int i) { return is_corner(points, closed, i, reach, curves); };
  int first = 0, last = count - 1;
  if (closed) {
    while (first < count && !turns(first)) ++first;
    if (first == count) return {{0, count, true}};
    last = first + count;
  }
  const std::vector<double> distances = drawing::distances_along(points, closed, curves);
  const auto travelled = [&](int i) { return i < count ? distances[i] : distances[i - count] + distances.back(); };
  const auto length = [&](int from, int to) { return travelled(to) - travelled(from); };

  std::vector<DashRun> runs;
  for (int i = first + 1, begin = first; i <= last; ++i) {
    const bool cut = i < last && turns(i) && length(begin, i) >= shortest && length(i, last) >= shortest;
    if (!cut && i < last) continue;
    runs.push_back({begin, i, false});
    begin = i;
  }
  check(runs.empty() || (runs.front().first == first && runs.back().last == last), "runs between corners are the line");
  return runs;
}

double length_of(const std::vector<Vec2>& points, bool closed, std::span<const drawing::CurvePart> curves) {
  return points.empty() ? 0 : drawing::distances_along(points, closed, curves).back();
}

}  // namespace epura::sheet
