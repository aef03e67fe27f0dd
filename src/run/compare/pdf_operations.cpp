// SPDX-License-Identifier: Apache-2.0
#include "compare/pdf_operations.hpp"

#include <algorithm>
#include <limits>

#include "base/text.hpp"

namespace epura::compare {

namespace {

// ISO 32000-1, 7.2.2.
constexpr std::string_view blanks("\0\t\n\f\r ", 6), delimiters("()<>[]{}/%");

bool is_in(std::string_view set, char c) { return set.find(c) != std::string_view::npos; }

// The tokens of a content stream: an operator or a number, a name with its slash, a string with its brackets, or one of
// [ ] << >>.
class PdfWords {
 public:
  explicit PdfWords(std::string_view content) : left_(content) {}

  /// Returns the next token; empty at the end.
  std::string_view next() {
    while (true) {
      left_.remove_prefix(std::min(left_.find_first_not_of(blanks), left_.size()));
      if (left_.empty()) return {};
      if (left_[0] == '%') {
        take(std::min(left_.find_first_of("\r\n"), left_.size()));
      } else if (left_[0] == '(') {
        return take(length_of_string());
      } else if (left_[0] == '<' && !left_.starts_with("<<")) {
        return take(std::min(left_.find('>'), left_.size() - 1) + 1);
      } else {
        return word();
      }
    }
  }

 private:
  std::string_view take(std::size_t bytes) {
    const std::string_view taken = left_.substr(0, bytes);
    left_.remove_prefix(taken.size());
    return taken;
  }

  std::string_view word() {
    if (left_.starts_with("<<") || left_.starts_with(">>")) return take(2);
    if (left_[0] != '/' && is_in(delimiters, left_[0])) return take(1);
    const auto ends = [](char c) { return is_in(blanks, c) || is_in(delimiters, c); };
    return take(static_cast<std::size_t>(std::find_if(left_.begin() + 1, left_.end(), ends) - left_.begin()));
  }

  // With both brackets; brackets inside it are in pairs, or escaped.
  [[nodiscard]] std::size_t length_of_string() const {
    int open = 0;
    for (std::size_t i = 0; i < left_.size(); ++i) {
      if (left_[i] == '\\') {
        ++i;
        continue;
      }
      open += left_[i] == '(' ? 1 : left_[i] == ')' ? -1 : 0;
      if (open == 0) return i + 1;
    }
    return left_.size();
  }

  std::string_view left_;
};

bool begins_number(char c) { return (c >= '0' && c <= '9') || is_in("+-.", c); }

// The bytes of a string in round brackets. ISO 32000-1, 7.3.4.2.
std::string literal_bytes(std::string_view token) {
  constexpr std::string_view letters = "nrtbf", meant = "\n\r\t\b\f";
  const auto is_octal = [&](std::size_t i) { return i < token.size() && token[i] >= '0' && token[i] <= '7'; };
  std::string bytes;
  for (std::size_t i = 1; i + 1 < token.size(); ++i) {
    if (token[i] != '\\') {
      bytes += token[i];
      continue;
    }
    ++i;
    if (is_octal(i)) {
      int code = 0, digits = 0;
      for (; digits < 3 && is_octal(i + static_cast<std::size_t>(digits)); ++digits)
        code = 8 * code + (token[i + static_cast<std::size_t>(digits)] - '0');
      bytes += static_cast<char>(code);
      i += static_cast<std::size_t>(digits) - 1;
    } else if (const std::size_t letter = letters.find(token[i]); letter != std::string_view::npos) {
      bytes += meant[letter];
    } else if (token[i] != '\n') {  // which would continue it on the next line
      bytes += token[i];
    }
  }
  return bytes;
}

// The bytes of a string of hexadecimal digits; the last one may lack its second half. ISO 32000-1, 7.3.4.3.
std::string hexadecimal_bytes(std::string_view token) {
  std::string bytes;
  int digits = 0, value = 0;
  const auto add = [&](int digit) {
    value = 16 * value + digit;
    if (++digits % 2 != 0) return;
    bytes += static_cast<char>(value);
    value = 0;
  };
  for (const char c : token) {
    if (c >= '0' && c <= '9') add(c - '0');
    if (c >= 'a' && c <= 'f') add(c - 'a' + 10);
    if (c >= 'A' && c <= 'F') add(c - 'A' + 10);
  }
  if (digits % 2 != 0) add(0);
  return bytes;
}

}  // namespace

void for_each_operation(std::string_view content, const std::function<void(const PdfOperation&)>& take) {
  PdfWords words(content);
  PdfOperation next;
  int dictionaries = 0;
  for (std::string_view word = words.next(); !word.empty(); word = words.next()) {
    if (word == "<<") ++dictionaries;
    if (word == ">>" && dictionaries > 0) --dictionaries;
    if (dictionaries > 0 || word == ">>" || is_in("[]>", word[0])) continue;
    if (word[0] == '(') {
      next.strings.push_back({literal_bytes(word), next.numbers.size()});
    } else if (word[0] == '<') {
      next.strings.push_back({hexadecimal_bytes(word), next.numbers.size()});
    } else if (word[0] == '/') {
      next.words.emplace_back(word);
    } else if (begins_number(word[0])) {
      next.numbers.push_back(parse_number(word).value_or(std::numeric_limits<double>::quiet_NaN()));
    } else {
      next.name = word;
      take(next);
      next.numbers.clear();
      next.words.clear();
      next.strings.clear();
    }
  }
}

}  // namespace epura::compare
