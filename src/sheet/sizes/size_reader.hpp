// SPDX-License-Identifier: Apache-2.0
// Reads numbers in notes with what belongs to them: signs, units, tolerances, fits, limits, brackets.
#pragma once

#include <string_view>

#include "sizes/note_reading.hpp"

namespace epura::sheet {

class SizeReader {
 public:
  explicit SizeReader(NoteReading& reading) : reading_(reading) {}

  /// A fit, something in brackets, or a size; false, and nothing is taken, if there is none.
  bool take();

 private:
  bool take_fit();
  bool take_bracket();
  bool take_limits(NotedElement limits, std::string_view end);
  bool take_size();
  void finish_size(NotedElement& added, const NumberText& number);
  bool is_depth_behind(const NumberText& number, NotedSign sign);
  bool take_limit(NotedElement& size, const NumberText& one);

  NoteReading& reading_;
  NoteCursor& at_ = reading_.at;
  NotedText& found_ = reading_.found;
};

}  // namespace epura::sheet
