// SPDX-License-Identifier: Apache-2.0
#include "base/text.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <numeric>

#include "base/decimal_text.hpp"

namespace epura {

namespace {

template <class Number>
std::optional<Number> parse_whole(std::string_view text) {
  // from_chars does not accept a leading '+', which people and programs write.
  if (text.size() > 1 && text[0] == '+' && text[1] != '-') text.remove_prefix(1);
  Number value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  return value;
}

std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t substituted = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
      diagonal = row[j];
      row[j] = std::min({substituted, row[j] + 1, row[j - 1] + 1});
    }
  }
  return row[b.size()];
}

std::string format_exactly(double value, int decimals) {
  std::array<char, 400> buffer{};
  const auto [end, error] =
      std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, std::chars_format::fixed, decimals);
  std::string text(buffer.data(), end);
  if (text.find('.') != std::string::npos) {
    text.erase(text.find_last_not_of('0') + 1);
    if (text.back() == '.') text.pop_back();
  }
  return text == "-0" ? "0" : text;
}

}  // namespace

std::optional<double> parse_number(std::string_view text) { return parse_whole<double>(text); }

std::optional<long long> parse_integer(std::string_view text) { return parse_whole<long long>(text); }

std::optional<std::vector<double>> parse_numbers(std::string_view text) {
  std::vector<double> numbers;
  for (const std::string_view part : split(text, ',')) {
    const auto number = parse_number(part);
    if (!number) return std::nullopt;
    numbers.push_back(*number);
  }
  return numbers;
}

void append_number(std::string& text, double value) {
  std::array<char, 32> buffer{};
  const auto [end, error] = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value == 0 ? 0.0 : value);
  text.append(buffer.data(), end);
}

std::string format_number(double value) {
  std::string text;
  append_number(text, value);
  return text;
}

void append_fixed(std::string& text, double value, int decimals) {
  constexpr std::array<double, 7> powers = {1, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6};
  if (decimals < static_cast<int>(powers.size())) {
    const double scaled = std::abs(value) * powers[static_cast<std::size_t>(decimals)];
    const double whole = std::floor(scaled + 0.5);
    // The last bits of the product may be wrong, which matters only halfway between two texts.
    if (scaled < 1e11 && std::abs(scaled - whole) < 0.4999) {
      std::array<char, longest_decimal> buffer{};
      const auto rounded = static_cast<long long>(value < 0 ? -whole : whole);
      text.append(buffer.data(), write_scaled(buffer.data(), rounded, decimals, LeadingZero::written));
      return;
    }
  }
  text += format_exactly(value, decimals);
}

std::string format_fixed(double value, int decimals) {
  std::string text;
  append_fixed(text, value, decimals);
  return text;
}

std::string format_with_zeros(double value, int decimals) {
  std::string text = format_fixed(value, decimals);
  if (decimals == 0) return text;
  std::size_t point = text.find('.');
  if (point == std::string::npos) {
    point = text.size();
    text += '.';
  }
  text.append(static_cast<std::size_t>(decimals) - (text.size() - point - 1), '0');
  return text;
}

std::string format_rounded(double value, int digits) {
  std::array<char, 64> buffer{};
  const auto [end, error] = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value == 0 ? 0.0 : value,
                                          std::chars_format::general, digits);
  return {buffer.data(), end};
}

std::vector<std::string_view> split(std::string_view text, char separator) {
  std::vector<std::string_view> parts;
  for (std::size_t begin = 0;;) {
    const std::size_t end = text.find(separator, begin);
    parts.push_back(text.substr(begin, end - begin));
    if (end == std::string_view::npos) return parts;
    begin = end + 1;
  }
}

std::string replaced(std::string text, std::string_view old, std::string_view with) {
  for (std::size_t at = text.find(old); at != std::string::npos; at = text.find(old, at + with.size()))
    text.replace(at, old.size(), with);
  return text;
}

void append_to_list(std::string& list, std::string_view item) {
  if (!list.empty()) list += ", ";
  list += item;
}

std::string to_lower(std::string_view text) {
  std::string lower(text);
  for (char& c : lower)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return lower;
}

std::optional<std::string> nearest_name(std::string_view name, std::span<const std::string> candidates) {
  const std::string lower = to_lower(name);
  std::optional<std::string> best;
  // Some of the name must be right: any two letters can be changed into any other two in two steps.
  std::size_t best_distance = std::min(std::max<std::size_t>(2, name.size() / 3) + 1, name.size());
  for (const std::string& candidate : candidates) {
    const std::size_t distance = edit_distance(lower, to_lower(candidate));
    if (distance < best_distance) {
      best_distance = distance;
      best = candidate;
    }
  }
  return best;
}

std::string did_you_mean(std::string_view name, std::span<const std::string> candidates) {
  if (const auto nearest = nearest_name(name, candidates)) return "did you mean '" + *nearest + "'?";
  constexpr std::size_t max_listed = 24, few = 3;
  std::vector<std::string> listed(candidates.begin(), candidates.end());
  const bool all = listed.size() <= max_listed;
  if (!all) {
    const std::string lower = to_lower(name);
    std::stable_sort(listed.begin(), listed.end(), [&lower](const std::string& a, const std::string& b) {
      return edit_distance(lower, to_lower(a)) < edit_distance(lower, to_lower(b));
    });
    listed.resize(few);
  }
  std::string list;
  for (const std::string& candidate : listed)
    list += (!list.empty() ? ", " : all ? "known: " : "the nearest are: ") + candidate;
  return list;
}

}  // namespace epura
