// SPDX-License-Identifier: Apache-2.0
// Equal features, which share one note: "4× ⌀8".
#pragma once

#include <algorithm>
#include <charconv>
#include <cmath>
#include <functional>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include "base/error.hpp"
#include "sheet/notation.hpp"

namespace epura::sheet {

/// Lists of features that one note can describe, in the order of their first members.
template <class Feature>
std::vector<std::vector<const Feature*>> groups_of(const std::vector<Feature>& features,
                                                   const std::function<bool(const Feature&, const Feature&)>& equal) {
  std::vector<std::vector<const Feature*>> groups;
  for (const Feature& feature : features) {
    const auto same =
        std::find_if(groups.begin(), groups.end(), [&](const auto& group) { return equal(*group.front(), feature); });
    if (same == groups.end())
      groups.push_back({&feature});
    else
      same->push_back(&feature);
  }
  return groups;
}

/// Whether two lengths that nearly agree are the same number on paper: those of fitted surfaces are not exact.
inline bool are_written_alike(double a, double b, const Notation& notation) {
  constexpr double most = 0.01;  // relative
  return std::abs(a - b) <= most * std::max(std::abs(a), std::abs(b)) &&
         length_text(a, notation) == length_text(b, notation);
}

/// The beginning of the note of several features; empty for one.
inline std::string times(std::size_t count) { return count > 1 ? std::to_string(count) + "× " : ""; }

/// The count at the beginning of a text, "4×", or "4x" as ASME Y14.5 has it.
struct Count {
  int number = 1;       ///< 1 if there is none
  std::size_t end = 0;  ///< where the text goes on
};

/// Neither "3×45°", "3 × 45°" nor "20x30" begins with a count; "2× 80°" does.
inline Count count_of(std::string_view text) {
  const auto is_digit = [&text](std::size_t i) { return i < text.size() && text[i] >= '0' && text[i] <= '9'; };
  int number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  auto sign = static_cast<std::size_t>(end - text.data());
  const bool is_spaced = text.substr(std::min(sign, text.size())).starts_with(" ");
  while (sign < text.size() && text[sign] == ' ') ++sign;
  if (error != std::errc() || sign == text.size()) return {};
  const bool is_times = text.substr(sign).starts_with("×"), is_letter = text[sign] == 'x' || text[sign] == 'X';
  const std::size_t behind = sign + (is_times ? std::string_view("×").size() : 1);
  if ((!is_times && !is_letter) || (is_letter && is_digit(behind))) return {};
  std::size_t from = behind;
  while (is_spaced && from < text.size() && text[from] == ' ') ++from;
  check(from > sign, "what is counted is behind the sign");
  std::size_t digits = from;
  while (is_digit(digits) || (digits > from && text.substr(digits).starts_with("."))) ++digits;
  if (digits > from && text.substr(digits).starts_with("°")) return {};
  return {std::max(number, 1), behind};
}

inline int repeats_of(std::string_view text) { return count_of(text).number; }

}  // namespace epura::sheet
