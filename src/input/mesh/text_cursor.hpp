// SPDX-License-Identifier: Apache-2.0
// Reads the words of a text file, line by line, and keeps the position for error messages.
//
// Lines end with LF, CR or CRLF; '#' begins a comment; a backslash at the end of a line continues it on the next one.
// Words such as "-1.#IND" are not split: the C library of Windows wrote them for non-finite values.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <string_view>

#include "base/decimal_text.hpp"

namespace epura::mesh {

class TextCursor {
 public:
  /// `name` denotes the file in errors; `first_line` counts from 1. Both views must outlive the cursor.
  TextCursor(std::string_view text, std::string_view name, std::size_t first_line = 1);

  /// Returns the next word of this line; empty if there is none left.
  std::string_view word();
  /// Returns the next word of this line or a later one; empty at the end of the text.
  std::string_view word_of_any_line();
  /// Returns the rest of this line including comments, without surrounding blanks.
  std::string_view rest_of_line();
  /// Skips the rest of this line; false if no line follows.
  bool next_line();
  /// Makes the last `bytes` of the previous word a separate word, which comes next.
  void put_back(std::size_t bytes) { at_ -= bytes; }

  [[nodiscard]] std::size_t line() const { return line_; }
  [[nodiscard]] std::size_t bytes_left() const { return static_cast<std::size_t>(end_ - at_); }

  /// Returns `word` as a number. Otherwise throws an error with this line; for an empty word it states that `what` is
  /// missing. NaN and infinity are accepted as numbers.
  [[nodiscard]] double number(std::string_view word, std::string_view what = "a number") const;
  [[nodiscard]] long long integer(std::string_view word, std::string_view what = "a number") const;
  /// Takes the next word if it is a number on this line, between plain blanks, and returns whether it is. This is what
  /// nearly all words are, and faster than finding the word first; what it does not take, the functions above may.
  template <class Number>
  bool take(Number& number) {
    const char* at = at_;
    while (at != end_ && (*at == ' ' || *at == '\t')) ++at;
    at = read_number(at, end_, number);
    if (at == nullptr) return false;
    at_ = at;
    return true;
  }
  /// Returns the next three numbers of this line.
  [[nodiscard]] std::array<double, 3> point();
  [[noreturn]] void fail(const std::string& reason, const std::string& hint = {}) const;

 private:
  [[nodiscard]] bool at_end_of_line(const char* at) const;
  void skip_line_end();
  void skip_blanks();

  const char* at_;
  const char* end_;
  std::size_t line_;
  std::string_view name_;
};

/// Formats a word of a file for a message: quoted, shortened, without unprintable bytes.
std::string quoted(std::string_view word);

}  // namespace epura::mesh
