#include "sheet/dash.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace epura {

namespace {

// Two dashes and a gap.
constexpr double shortest_widths = 2 * dash_widths + gap_widths;

const Vec2& at(const std::vector<Vec2>& points, int index) {
  return points[static_cast<std::size_t>(index) % points.size()];
}

bool is_corner(const std::vector<Vec2>& points, int index) {
  const int count = static_cast<int>(points.size());
  const Vec2 in = at(points, index) - at(points, index + count - 1), out = at(points, index + 1) - at(points, index);
  constexpr double cosine = 0.8660254037844386;  // of 30 degrees
  return glm::dot(in, out) < cosine * glm::length(in) * glm::length(out);
}

}  // namespace

Dashes fit_open(double length, double width) {
  if (!(length >= shortest_widths * width)) return {};
  const double gap = gap_widths * width;
  const double gaps = std::round((length - dash_widths * width) / ((dash_widths + gap_widths) * width));
  return {(length - gap * gaps) / (gaps + 1), gap};
}

Dashes fit_closed(double length, double width) {
  if (!(length >= shortest_widths * width)) return {};
  const double gap = gap_widths * width;
  const double periods = std::round(length / ((dash_widths + gap_widths) * width));
  return {length / periods - gap, gap};
}

std::vector<DashRun> cut_at_corners(const std::vector<Vec2>& points, bool closed, double width) {
  const int count = static_cast<int>(points.size());
  int first = 0, last = count - 1;
  if (closed) {
    while (first < count && !is_corner(points, first)) ++first;
    if (first == count) return {{0, count, true}};
    last = first + count;
  }
  std::vector<double> travelled{0};
  for (int i = first; i < last; ++i)
    travelled.push_back(travelled.back() + glm::distance(at(points, i), at(points, i + 1)));
  const auto length = [&](int from, int to) { return travelled[to - first] - travelled[from - first]; };

  std::vector<DashRun> runs;
  const double shortest = shortest_widths * width;
  for (int i = first + 1, begin = first; i <= last; ++i) {
    const bool cut = i < last && is_corner(points, i) && length(begin, i) >= shortest && length(i, last) >= shortest;
    if (!cut && i < last) continue;
    runs.push_back({begin, i, false});
    begin = i;
  }
  return runs;
}

double length_of(const std::vector<Vec2>& points, bool closed) {
  double length = 0;
  for (std::size_t i = 1; i < points.size(); ++i) length += glm::distance(points[i - 1], points[i]);
  return closed && !points.empty() ? length + glm::distance(points.back(), points.front()) : length;
}

}  // namespace epura
