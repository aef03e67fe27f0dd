// SPDX-License-Identifier: Apache-2.0
// A text that is being read: what is left of it, and the elements that were found.
#pragma once

#include <cstddef>
#include <string_view>

#include "sizes/note_cursor.hpp"

namespace epura::sheet {

/// What the number behind a word is.
NotedRole role_of(WordUse use);

struct NoteReading {
  NoteCursor at;
  double unit;  ///< of numbers without one, mm
  NotedText found{};

  /// A number that is not added yet.
  [[nodiscard]] NotedElement sized(NotedRole role, NotedSign sign, const NumberText& number) const;
  /// A depth and a length belong to the diameter before them.
  NotedElement& add(NotedRole role, NotedSign sign, const NumberText& number);
  /// An angle, which is the size if it comes first.
  void add_degrees(const NumberText& angle);
  /// Gives an element another unit, mm.
  void scale(NotedElement& element, double other) const;
  /// Takes deviations behind an element, if there are some.
  bool take_deviations(NotedElement& size);
  /// The last one of a hole or of a recess, as a diameter.
  [[nodiscard]] NotedElement diameter_before() const;
  /// Says what the note is about.
  void speak_of(WordUse use);
  /// `taken`: how many elements of it are there already.
  void unread_from(std::string_view before, std::size_t taken = 0);
  /// A word or a number.
  void leave_unread();
};

}  // namespace epura::sheet
