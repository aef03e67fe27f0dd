// SPDX-License-Identifier: Apache-2.0
#include "large_numbers.hpp"

#include <Precision.hxx>
#include <algorithm>
#include <charconv>
#include <cmath>
#include <sstream>
#include <stdexcept>
#include <string>
#include <system_error>

#include "part21.hpp"

namespace occt {

namespace {

// FORTRAN, and IGES with it, writes exponents of doubles with D.
bool is_too_large(std::string word) {
  std::replace_if(
      word.begin(), word.end(), [](char c) { return c == 'D' || c == 'd' || c == 'e'; }, 'E');
  const char* const end = word.data() + word.size();
  double number = 0;
  const auto [stop, error] = std::from_chars(word.data() + (word[0] == '+' ? 1 : 0), end, number);
  if (stop != end) return false;
  if (error == std::errc::result_out_of_range) return word.find("E-") == std::string::npos;
  return std::abs(number) > largest_number && std::abs(number) != Precision::Infinite();
}

// What C libraries write instead of a number: "nan", "-inf", "1.#QNAN".
bool is_no_number(std::string word) {
  std::transform(word.begin(), word.end(), word.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  const std::size_t sign = word.find_first_not_of("+-");
  if (sign == std::string::npos) return false;
  const std::string_view bare = std::string_view(word).substr(sign);
  return bare == "nan" || bare == "inf" || bare.find(".#") != std::string_view::npos;
}

/// The first number that is too large, or none at all, as it is written; empty if there is none.
std::string_view large_number_in(std::string_view text) {
  constexpr std::string_view between = " \t\r\n(),;", of_numbers = "+-.0123456789EeDd";
  constexpr std::size_t digits = 50;  // of `largest_number`: a longer one needs no exponent
  for (std::size_t at = 0; at < text.size();) {
    if (text[at] == '\'') at = std::min(text.find('\'', at + 1), text.size() - 1);
    const std::size_t end = std::min(text.find_first_of(between, at), text.size());
    const std::string_view word = text.substr(at, end - at);
    const bool may_be = word.find_first_of("EeDd") != std::string_view::npos || word.size() > digits;
    if (may_be && word.find_first_not_of(of_numbers) == std::string_view::npos && is_too_large(std::string(word)))
      return word;
    if (word.find_first_of("nNiI#") != std::string_view::npos && word[0] != '#' && word.size() <= digits &&
        is_no_number(std::string(word)))
      return word;
    at = end + 1;
  }
  return {};
}

void expect_none(std::string_view text, const std::string& where) {
  const std::string_view number = large_number_in(text);
  if (number.empty()) return;
  std::ostringstream sentence;
  sentence << where << " has the number " << number << ", allowed is up to " << largest_number
           << ": is the file whole, and is its unit right? Export it again, or mend the number";
  throw std::runtime_error(sentence.str());
}

template <class Take>
void expect_none_in_lines(std::string_view text, const Take& take) {
  for (std::size_t line = 1; !text.empty(); ++line) {
    const std::size_t end = std::min(text.find('\n'), text.size() - 1);
    expect_none(take(text.substr(0, end)), "line " + std::to_string(line));
    text.remove_prefix(end + 1);
  }
}

}  // namespace

void expect_drawable_step(std::string_view text) {
  visit_statements(text, [](const Statement& statement) {
    for (const Record& record : statement.records)
      expect_none(record.arguments, "#" + std::to_string(statement.number) + "=" + std::string(record.keyword));
  });
}

void expect_drawable_iges(std::string_view text) {
  constexpr std::size_t section = 72, parameters = 64;
  expect_none_in_lines(text, [](std::string_view line) {
    return line.size() > section && line[section] == 'P' ? line.substr(0, parameters) : std::string_view();
  });
}

void expect_drawable_brep(std::string_view text) {
  expect_none_in_lines(text, [](std::string_view line) { return line; });
}

}  // namespace occt
