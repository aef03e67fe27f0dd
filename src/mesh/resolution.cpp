#include "mesh/resolution.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstddef>

#include "base/parallel.hpp"

namespace epura {

namespace {

// With fewer, coordinates are as likely chosen as rounded.
constexpr int fewest_decimals = 5;
constexpr int most_decimals = 9;
constexpr std::size_t least_points = 100;
constexpr std::size_t grain = 4096;
constexpr std::array<double, most_decimals + 1> powers{1, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9};

bool is_multiple(double coordinate, int decimals) {
  const double scaled = coordinate * powers[decimals];
  // Beyond 2^50 every double is nearly whole, which says nothing.
  return std::abs(scaled - std::nearbyint(scaled)) <= 0x1p-50 * std::abs(scaled) && std::abs(scaled) < 0x1p50;
}

bool all_multiples(const Points& points, int decimals) {
  std::atomic<bool> all = true;
  parallel_for(points.size(), grain, [&](std::size_t begin, std::size_t end) {
    const auto is_one = [&](const auto& p) {
      return std::all_of(p.begin(), p.end(), [&](double c) { return is_multiple(c, decimals); });
    };
    if (!std::all_of(points.begin() + begin, points.begin() + end, is_one)) all = false;
  });
  return all;
}

}  // namespace

double decimal_resolution(const Points& points) {
  if (points.size() < least_points || !all_multiples(points, most_decimals)) return 0;
  int decimals = most_decimals;
  while (decimals > fewest_decimals && all_multiples(points, decimals - 1)) --decimals;
  std::size_t needing = 0;
  for (const auto& p : points)
    for (const double c : p) needing += is_multiple(c, decimals - 1) ? 0 : 1;
  return 4 * needing >= 3 * points.size() ? 1 / powers[decimals] : 0;
}

}  // namespace epura
