// SPDX-License-Identifier: Apache-2.0
// Numbers as text and back, independent of the locale; suggestions for misspelt names.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace epura {

/// Parses all of `text` as a number: decimal or scientific, with an optional '+'. Nothing else is allowed. "nan" and
/// "inf" are numbers here; callers that need finite values must check.
std::optional<double> parse_number(std::string_view text);

/// Parses all of `text` as an integer.
std::optional<long long> parse_integer(std::string_view text);

/// Parses comma-separated numbers; returns nothing unless all are valid.
std::optional<std::vector<double>> parse_numbers(std::string_view text);

/// Returns the shortest text that reads back as the same double; never a negative zero.
std::string format_number(double value);
void append_number(std::string& text, double value);

/// Formats with at most `decimals` digits after the point, without trailing zeros; never "-0".
std::string format_fixed(double value, int decimals);
void append_fixed(std::string& text, double value, int decimals);

/// The same with all decimals, also zeros: "20.000".
std::string format_with_zeros(double value, int decimals);

/// Formats with at most `digits` significant digits, for people; never "-0".
std::string format_rounded(double value, int digits);

/// Returns the parts of `text` between separators; an empty text has one empty part.
std::vector<std::string_view> split(std::string_view text, char separator);

/// Returns the text with each `old`, which is not empty, replaced.
std::string replaced(std::string text, std::string_view old, std::string_view with);

/// Adds an item to a list in words: "a", then "a, b".
void append_to_list(std::string& list, std::string_view item);

std::string to_lower(std::string_view text);

/// Returns the candidate closest to `name` by edit distance, if it is close enough to have been meant.
std::optional<std::string> nearest_name(std::string_view name, std::span<const std::string> candidates);

/// Returns "did you mean 'x'?" or the list of candidates (if there are very many, the three nearest), for the hint of
/// an error.
std::string did_you_mean(std::string_view name, std::span<const std::string> candidates);

}  // namespace epura
