// SPDX-License-Identifier: Apache-2.0
// Equal features, which share one note: "4× ⌀8".
#pragma once

#include <algorithm>
#include <charconv>
#include <cmath>
#include <functional>
#include <string>
#include <system_error>
#include <vector>

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

/// The number before "×" at the beginning of a text; 1 if there is none.
inline int repeats_of(const std::string& text) {
  int count = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), count);
  const bool is_count = error == std::errc() && text.compare(std::size_t(end - text.data()), 2, "×") == 0;
  return is_count ? std::max(count, 1) : 1;
}

}  // namespace epura::sheet
