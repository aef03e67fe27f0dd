// SPDX-License-Identifier: Apache-2.0
#include "mesh/text_cursor.hpp"

#include <algorithm>
#include <limits>
#include <optional>

#include "base/error.hpp"
#include "base/text.hpp"

namespace epura::mesh {

namespace {

bool is_blank(char c) { return static_cast<unsigned char>(c) <= ' '; }

std::optional<double> windows_value(std::string_view word) {
  const bool negative = word.starts_with('-');
  if (negative || word.starts_with('+')) word.remove_prefix(1);
  for (const std::string_view name : {"1.#INF", "1.#IND", "1.#QNAN", "1.#SNAN"}) {
    // Padded with zeros to the requested decimals.
    if (!word.starts_with(name) || word.find_first_not_of('0', name.size()) != std::string_view::npos) continue;
    if (name != "1.#INF") return std::numeric_limits<double>::quiet_NaN();
    return negative ? -std::numeric_limits<double>::infinity() : std::numeric_limits<double>::infinity();
  }
  return std::nullopt;
}

}  // namespace

TextCursor::TextCursor(std::string_view text, std::string_view name, std::size_t first_line)
    : at_(text.data()), end_(text.data() + text.size()), line_(first_line), name_(name) {}

bool TextCursor::at_end_of_line(const char* at) const { return at == end_ || *at == '\n' || *at == '\r'; }

void TextCursor::skip_line_end() {
  const bool two = end_ - at_ > 1 && at_[0] == '\r' && at_[1] == '\n';
  at_ += two ? 2 : 1;
  ++line_;
}

void TextCursor::skip_blanks() {
  while (!at_end_of_line(at_)) {
    if (is_blank(*at_)) {
      ++at_;
    } else if (*at_ == '\\' && at_end_of_line(at_ + 1)) {
      ++at_;
      if (at_ != end_) skip_line_end();
    } else {
      return;
    }
  }
}

std::string_view TextCursor::word() {
  skip_blanks();
  const char* const begin = at_;
  while (at_ != end_ && !is_blank(*at_) && *at_ != '#') {
    if (*at_ == '\\' && at_end_of_line(at_ + 1)) break;
    ++at_;
  }
  if (at_ != end_ && *at_ == '#') {
    const char* const behind = std::find_if(at_ + 1, end_, [](char c) { return is_blank(c) || c == '#'; });
    if (windows_value({begin, behind})) at_ = behind;
  }
  return {begin, at_};
}

std::string_view TextCursor::word_of_any_line() {
  while (true) {
    const std::string_view found = word();
    if (!found.empty() || !next_line()) return found;
  }
}

std::string_view TextCursor::rest_of_line() {
  skip_blanks();
  const char* const begin = at_;
  const char* behind = at_;
  for (; !at_end_of_line(at_); ++at_)
    if (!is_blank(*at_)) behind = at_ + 1;
  return {begin, static_cast<std::size_t>(behind - begin)};
}

bool TextCursor::next_line() {
  while (!word().empty()) {
  }
  while (!at_end_of_line(at_)) ++at_;
  if (at_ == end_) return false;
  skip_line_end();
  return at_ != end_;
}

double TextCursor::number(std::string_view word, std::string_view what) const {
  if (const auto value = parse_number(word)) return *value;
  if (const auto value = windows_value(word)) return *value;
  if (word.empty()) fail(std::string(what) + " is missing");
  fail(quoted(word) + " is not a number, or too large",
       word.find(',') == std::string_view::npos ? "" : "write numbers with a decimal point, separated by blanks");
}

long long TextCursor::integer(std::string_view word, std::string_view what) const {
  if (const auto value = parse_integer(word)) return *value;
  if (word.empty()) fail(std::string(what) + " is missing");
  fail(quoted(word) + " is not a whole number");
}

std::array<double, 3> TextCursor::point() {
  constexpr std::array<std::string_view, 3> names{"the x coordinate", "the y coordinate", "the z coordinate"};
  std::array<double, 3> point{};
  for (std::size_t axis = 0; axis < 3; ++axis)
    if (!take(point[axis])) point[axis] = number(word(), names[axis]);
  return point;
}

void TextCursor::fail(const std::string& reason, const std::string& hint) const {
  throw Error(ErrorKind::input, std::string(name_) + ":" + std::to_string(line_), reason, hint);
}

std::string quoted(std::string_view word) {
  constexpr std::size_t longest = 24;
  std::string text = "'";
  for (const char c : word.substr(0, longest)) text += c >= ' ' && c <= '~' ? c : '?';
  return text + (word.size() > longest ? "...'" : "'");
}

}  // namespace epura::mesh
