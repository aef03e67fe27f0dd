// SPDX-License-Identifier: Apache-2.0
#include "compare/pdf_operations.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/text.hpp"

namespace epura::compare {

namespace {

// ISO 32000-1, 7.2.2.
constexpr std::string_view blanks("\0\t\n\f\r ", 6), delimiters("()<>[]{}/%");

bool is_in(std::string_view set, char c) { return set.find(c) != std::string_view::npos; }

// The tokens of a content stream: an operator or a number, a name with its slash, or one of [ ] << >>.
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
        pass_text();
      } else if (left_[0] == '<' && !left_.starts_with("<<")) {
        take(std::min(left_.find('>'), left_.size() - 1) + 1);
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

  void pass_text() {
    int open = 0;
    do {
      if (left_[0] == '\\') take(1);
      open += left_.starts_with('(') ? 1 : left_.starts_with(')') ? -1 : 0;
      take(1);
    } while (open > 0 && !left_.empty());
  }

  std::string_view left_;
};

bool begins_number(char c) { return (c >= '0' && c <= '9') || is_in("+-.", c); }

}  // namespace

void for_each_operation(std::string_view content, const std::function<void(const PdfOperation&)>& take) {
  PdfWords words(content);
  PdfOperation next;
  int dictionaries = 0;
  for (std::string_view word = words.next(); !word.empty(); word = words.next()) {
    if (word == "<<") ++dictionaries;
    if (word == ">>" && dictionaries > 0) --dictionaries;
    if (dictionaries > 0 || is_in("[]<>", word[0])) continue;
    if (word[0] == '/') {
      next.words.emplace_back(word);
    } else if (begins_number(word[0])) {
      next.numbers.push_back(parse_number(word).value_or(std::numeric_limits<double>::quiet_NaN()));
    } else {
      next.name = word;
      take(next);
      next.numbers.clear();
      next.words.clear();
    }
  }
}

}  // namespace epura::compare
