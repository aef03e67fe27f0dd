// SPDX-License-Identifier: Apache-2.0
#include "sheet/notation.hpp"

#include <algorithm>
#include <cmath>
#include <string_view>

#include "base/text.hpp"
#include "scene/choices.hpp"

namespace epura::sheet {

namespace {

constexpr int angle_decimals = 2;

// "0.5" -> ".500"
std::string inches_text(double inches, int decimals) {
  const std::string text = format_with_zeros(inches, decimals);
  return text.starts_with("0.") ? text.substr(1) : text;
}

// Conversion from inches leaves most ties inexact: 3.175 is one, although the nearest double is less. Ties are even.
double without_tie(double value, int decimals) {
  constexpr double slack = 1e-6;  // of the last decimal
  const double steps = std::pow(10, decimals), scaled = value * steps, low = std::floor(scaled);
  if (!(std::abs(scaled - low - 0.5) <= slack)) return value;
  return (std::fmod(low, 2) == 0 ? low : low + 1) / steps;
}

}  // namespace

std::string with_decimal_sign(std::string number, DecimalSign sign) {
  if (sign == DecimalSign::comma) std::replace(number.begin(), number.end(), '.', ',');
  return number;
}

std::string with_repeats(std::string text, const Notation& notation) {
  constexpr std::string_view times = "× ";
  for (std::size_t at = 0; notation.is_asme && (at = text.find(times, at)) != std::string::npos; ++at)
    if (at > 0 && '0' <= text[at - 1] && text[at - 1] <= '9') text.replace(at, times.size() - 1, "X");
  return text;
}

std::string length_text(double millimetres, const Notation& notation) {
  const double value = without_tie(
      notation.unit == Unit::mm ? millimetres : millimetres / scene::millimetres(notation.unit), notation.decimals);
  const std::string text =
      notation.unit == Unit::in ? inches_text(value, notation.decimals) : format_fixed(value, notation.decimals);
  return with_decimal_sign(text, notation.sign);
}

std::string angle_text(double degrees, const Notation& notation) {
  return with_decimal_sign(format_fixed(degrees, angle_decimals), notation.sign) + "°";
}

std::string mass_text(double kilograms, DecimalSign sign, double heaviest) {
  constexpr double three_digits = 100;
  constexpr int max_decimals = 12;
  const bool small = heaviest < 0.1;
  const double mass = small ? 1000 * kilograms : kilograms;
  int decimals = 0;
  for (double least = three_digits; mass < least && decimals < max_decimals; least /= 10) ++decimals;
  return with_decimal_sign(format_fixed(mass, decimals), sign) + (small ? " g" : " kg");
}

std::string mass_text(double kilograms, DecimalSign sign) { return mass_text(kilograms, sign, kilograms); }

int usual_decimals(double largest_size, Unit unit) {
  constexpr int most = 8, finer_in_inches = 1, finer_in_metres = 3;
  int decimals = 2;
  for (double least = 10; largest_size < least && decimals < most; least /= 10) ++decimals;
  if (unit == Unit::in) decimals += finer_in_inches;
  if (unit == Unit::m) decimals += finer_in_metres;
  return std::min(decimals, most);
}

}  // namespace epura::sheet
