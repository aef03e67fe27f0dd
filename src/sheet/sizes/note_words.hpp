// SPDX-License-Identifier: Apache-2.0
// The signs and words of notes, in several languages, and what each of them is for.
#pragma once

#include <cstddef>
#include <span>
#include <string_view>

namespace epura::sheet {

enum class WordUse {
  counterbore,
  countersink,
  recess,  ///< either
  depth,
  length,
  thickness,
  through,
  blind,
  diameter,
  drilled,  ///< before a number its diameter is meant
  radius,
  square,
  times,
  on_circle,     ///< the diameter behind it is that of a pitch circle
  pitch_circle,  ///< before or behind its diameter
  evenly,
  holes,
  places,
  fillets,
  chamfers,
  threads,
  others,  ///< things that faces alone do not tell, such as ribs
  all,
  otherwise,  ///< of all that the sheet does not give elsewhere
  standard,   ///< whose number is behind it
  silent      ///< says nothing that a part could contradict
};

struct NoteWords {
  WordUse use;
  std::string_view words;  ///< with "|" between them, in capitals, without accents
};

std::span<const NoteWords> note_words();

inline bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// A Latin letter at the beginning of a text, as a capital without accents, and its bytes; 0 for anything else.
struct FoldedLetter {
  char capital;
  std::size_t bytes;
};
FoldedLetter folded_letter(std::string_view text);

/// The bytes of a word at the beginning of a text, with a point behind an abbreviation; 0 if it is not there, or only
/// as the beginning of a longer word.
std::size_t word_at(std::string_view text, std::string_view word);
/// The longest one of a row.
std::size_t word_at(std::string_view text, const NoteWords& row);

}  // namespace epura::sheet
