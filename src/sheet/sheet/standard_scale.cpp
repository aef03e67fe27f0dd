// SPDX-License-Identifier: Apache-2.0
#include "sheet/standard_scale.hpp"

#include <algorithm>
#include <cmath>

#include "base/text.hpp"

namespace epura::sheet {

namespace {

constexpr double rounding_of_scales = 1e-12;
constexpr int min_power = -300, max_power = 300;
constexpr double largest_ratio = 1e9;  // larger ratios are not written as such

// Correctly rounded, unlike pow: 1:5 is the double nearest to 0.2.
double by_tens(int digit, int power) { return *parse_number(std::to_string(digit) + "e" + std::to_string(power)); }

}  // namespace

double standard_scale_up_to(double scale) {
  const double max = scale * (1 + rounding_of_scales);
  const double power = std::clamp<double>(std::floor(std::log10(max)), min_power, max_power);
  // The logarithm may be off by one at powers of ten.
  for (int tens = static_cast<int>(power) + 1; tens >= min_power; --tens)
    for (const int digit : {5, 2, 1})
      if (const double standard = by_tens(digit, tens); standard <= max) return standard;
  return by_tens(1, min_power);
}

double next_standard_scale(double standard) {
  constexpr double to_next = 2.6;  // times 1, 2 or 5 is above the next one, and below the one after that
  return standard_scale_up_to(to_next * standard);
}

double nearest_standard_scale(double scale) {
  const double below = standard_scale_up_to(scale), above = next_standard_scale(below);
  return scale / below < above / scale ? below : above;
}

std::string ratio_text(double scale) {
  const double larger = std::max(scale, 1 / scale);
  if (!(larger <= largest_ratio)) return {};
  const std::string text = format_rounded(larger, 3);
  const auto rounded = parse_number(text);
  if (!rounded || !(std::abs(*rounded - larger) <= rounding_of_scales * larger)) return {};
  const std::string plain = format_fixed(*rounded, 2);
  return scale >= 1 ? plain + ":1" : "1:" + plain;
}

}  // namespace epura::sheet
