// SPDX-License-Identifier: Apache-2.0
#include "mesh/resolution.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include "base/parallel.hpp"
#include "base/text.hpp"

namespace epura::mesh {

namespace {

// With fewer decimals, coordinates are as likely to be chosen as rounded.
constexpr int fewest_decimals = 5;
constexpr int most_decimals = 9;
constexpr int fewest_digits = 5;
constexpr int most_digits = 8;
constexpr std::size_t least_points = 100;
constexpr std::size_t points_at_once = 4096;
constexpr std::array<double, most_decimals + 1> powers{1, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9};

bool is_multiple(double coordinate, int decimals) {
  const double scaled = coordinate * powers[decimals];
  // Beyond 2^50 every double is nearly an integer, which is no evidence.
  return std::abs(scaled - std::nearbyint(scaled)) <= 0x1p-50 * std::abs(scaled) && std::abs(scaled) < 0x1p50;
}

template <class Holds>
bool all_coordinates(const Points& points, const Holds& holds) {
  std::atomic<bool> all = true;
  parallel_for(points.size(), points_at_once, [&](std::size_t begin, std::size_t end) {
    const auto is_one = [&](const auto& p) { return std::all_of(p.begin(), p.end(), holds); };
    if (!std::all_of(points.begin() + begin, points.begin() + end, is_one)) all = false;
  });
  return all;
}

template <class Holds>
std::size_t count_coordinates(const Points& points, const Holds& holds) {
  std::size_t count = 0;
  for (const auto& p : points) count += static_cast<std::size_t>(std::count_if(p.begin(), p.end(), holds));
  return count;
}

bool all_multiples(const Points& points, int decimals) {
  return all_coordinates(points, [&](double c) { return is_multiple(c, decimals); });
}

// The double nearest to 10^exponent, which the powers and logarithms of the C library miss on some processors; 0 below
// the range of doubles.
double power_of_ten(int exponent) {
  constexpr int min = -323, max = 308;
  static const std::vector<double> all = [] {
    std::vector<double> powers_of_ten;
    for (int e = min; e <= max; ++e) powers_of_ten.push_back(*parse_number("1e" + std::to_string(e)));
    return powers_of_ten;
  }();
  if (exponent < min) return 0;
  return exponent > max ? HUGE_VAL : all[static_cast<std::size_t>(exponent - min)];
}

// The decimal exponent of the first digit.
int first_place(double coordinate) {
  constexpr double log10_of_2 = 0.30102999566398120;
  int place = static_cast<int>(std::floor(std::ilogb(coordinate) * log10_of_2));
  // The estimate is that of the next lower power of two.
  if (std::abs(coordinate) >= power_of_ten(place + 1)) ++place;
  return place;
}

bool has_digits(double coordinate, int digits) {
  if (coordinate == 0) return true;
  const double place = power_of_ten(first_place(coordinate) - digits + 1);
  const double scaled = coordinate / place;
  return std::abs(scaled - std::nearbyint(scaled)) <= 0x1p-48 * std::abs(scaled);
}

double decimals_of(const Points& points) {
  if (!all_multiples(points, most_decimals)) return 0;
  int decimals = most_decimals;
  while (decimals > fewest_decimals && all_multiples(points, decimals - 1)) --decimals;
  const std::size_t needing = count_coordinates(points, [&](double c) { return !is_multiple(c, decimals - 1); });
  return 4 * needing >= 3 * points.size() ? 1 / powers[decimals] : 0;
}

// The place of the last digit of the largest coordinate that needs it, if all coordinates have the same number of
// digits: smaller coordinates then have more decimals.
double digits_of(const Points& points) {
  const auto all_have = [&](int digits) {
    return all_coordinates(points, [&](double c) { return has_digits(c, digits); });
  };
  if (!all_have(most_digits)) return 0;
  int digits = most_digits;
  while (digits > fewest_digits && all_have(digits - 1)) --digits;
  const auto needs_all = [&](double c) { return !has_digits(c, digits - 1); };
  double largest = 0;
  for (const auto& p : points)
    for (const double c : p)
      if (needs_all(c)) largest = std::max(largest, std::abs(c));
  if (largest == 0) return 0;
  const double last = power_of_ten(first_place(largest) - digits + 1);
  const auto is_finer = [&](double c) { return std::abs(c / last - std::nearbyint(c / last)) > 0x1p-10; };
  const bool rounded = 4 * count_coordinates(points, needs_all) >= 3 * points.size() &&
                       8 * count_coordinates(points, is_finer) >= 3 * points.size();
  return rounded ? last : 0;
}

}  // namespace

double decimal_resolution(const Points& points) {
  if (points.size() < least_points) return 0;
  const bool finite = all_coordinates(points, [](double c) { return std::isfinite(c); });
  const double decimals = decimals_of(points);
  return decimals > 0 || !finite ? decimals : digits_of(points);
}

}  // namespace epura::mesh
