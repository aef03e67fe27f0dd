// SPDX-License-Identifier: Apache-2.0
#include "part21.hpp"

#include <algorithm>
#include <charconv>
#include <fstream>
#include <stdexcept>

namespace occt {

namespace {

constexpr std::string_view blanks = " \t\r\n";

bool is_letter(char c) {
  return ('A' <= c && c <= 'Z') || ('a' <= c && c <= 'z') || ('0' <= c && c <= '9') || c == '_';
}

// Behind what begins here, if that is a text or a comment; otherwise behind one character.
std::size_t behind(std::string_view text, std::size_t at) {
  const auto end = [&](std::size_t found, std::size_t length) {
    return found == std::string_view::npos ? text.size() : found + length;
  };
  if (text[at] == '\'') return end(text.find('\'', at + 1), 1);
  if (text.substr(at, 2) == "/*") return end(text.find("*/", at + 2), 2);
  return at + 1;
}

// The place of this character outside of texts, comments and parentheses; the size of the text if there is none.
std::size_t find_outside(std::string_view text, std::size_t at, char wanted) {
  std::size_t depth = 0;
  while (at < text.size()) {
    const char c = text[at];
    if (c == wanted && depth == 0) return at;
    if (c == '(') ++depth;
    if (c == ')' && depth > 0) --depth;
    at = behind(text, at);
  }
  return text.size();
}

std::size_t skip_blanks(std::string_view text, std::size_t at) {
  while (at < text.size()) {
    if (text.substr(at, 2) == "/*")
      at = behind(text, at);
    else if (blanks.find(text[at]) != std::string_view::npos)
      ++at;
    else
      break;
  }
  return at;
}

std::string_view trimmed(std::string_view text) {
  text.remove_prefix(std::min(skip_blanks(text, 0), text.size()));
  return text.substr(0, text.find_last_not_of(blanks) + 1);
}

// Records one after the other, each a keyword and parentheses.
void add_records(std::string_view text, std::vector<Record>& records) {
  std::size_t at = skip_blanks(text, 0);
  while (at < text.size() && is_letter(text[at])) {
    const std::size_t begin = at;
    while (at < text.size() && is_letter(text[at])) ++at;
    const std::string_view keyword = text.substr(begin, at - begin);
    at = skip_blanks(text, at);
    if (at >= text.size() || text[at] != '(') return;
    const std::size_t close = find_outside(text, at + 1, ')');
    records.push_back({keyword, text.substr(at + 1, close - at - 1)});
    at = skip_blanks(text, std::min(close + 1, text.size()));
  }
}

}  // namespace

void visit_statements(std::string_view text, const std::function<void(const Statement&)>& visit) {
  Statement statement;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = find_outside(text, at, ';');
    const std::string_view whole = trimmed(text.substr(at, end - at));
    at = end + 1;
    statement.number = reference_in(whole);
    const std::size_t equals = whole.find('=');
    if (statement.number == 0 || equals == std::string_view::npos) continue;
    std::string_view right = trimmed(whole.substr(equals + 1));
    if (right.size() > 1 && right.front() == '(') right = right.substr(1, right.size() - 2);
    statement.records.clear();
    add_records(right, statement.records);
    visit(statement);
  }
}

std::vector<std::string_view> arguments_of(std::string_view text) {
  text = trimmed(text);
  if (text.size() > 1 && text.front() == '(') text = text.substr(1, text.size() - 2);
  return separated(text);
}

std::vector<std::string_view> separated(std::string_view text) {
  std::vector<std::string_view> arguments;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = find_outside(text, at, ',');
    arguments.push_back(trimmed(text.substr(at, end - at)));
    at = end + 1;
  }
  return arguments;
}

unsigned long long reference_in(std::string_view text) {
  unsigned long long number = 0;
  if (text.substr(0, 1) == "#") std::from_chars(text.data() + 1, text.data() + text.size(), number);
  return number;
}

std::string text_of(const std::string& path) {
  std::ifstream file(path, std::ios::binary | std::ios::ate);
  const std::streamoff size = file.tellg();
  if (!file || size < 0) throw std::runtime_error("cannot be opened");
  std::string bytes(static_cast<std::size_t>(size), '\0');
  file.seekg(0);
  file.read(bytes.data(), size);
  if (!file) throw std::runtime_error("cannot be read to its end");
  return bytes;
}

}  // namespace occt
