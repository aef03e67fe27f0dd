// SPDX-License-Identifier: Apache-2.0
// A place in the text of a note, from which signs, words and numbers are taken.
#pragma once

#include <optional>
#include <string_view>

#include "sizes/note_lexemes.hpp"
#include "sizes/note_text.hpp"
#include "sizes/note_words.hpp"

namespace epura::sheet {

/// What is not there is not taken.
struct NoteCursor {
  std::string_view rest;

  bool take(std::string_view sign);
  void skip_spaces();
  std::optional<NumberText> take_number();
  std::optional<NumberText> take_degrees();
  std::optional<double> take_unit();  ///< mm
  /// Before a number, by a sign or a word; spaces between them, too.
  NotedSign take_sign();

  /// The next word, if it has one of these uses.
  template <class... Use>
  std::optional<WordUse> take_use(Use... uses) {
    for (const NoteWords& one : note_words()) {
      const std::size_t bytes = ((one.use == uses) || ...) ? word_at(rest, one) : 0;
      rest.remove_prefix(bytes);
      if (bytes > 0) return one.use;
    }
    return std::nullopt;
  }
};

}  // namespace epura::sheet
