// SPDX-License-Identifier: Apache-2.0
// Compact SVG path data. SVG 1.1, 8.3.
#pragma once

#include <array>
#include <string>

#include "base/vec.hpp"

namespace epura::output {

/// Points are rounded to `decimals` of a millimetre before the step from one to the next is written, so that errors do
/// not add up along a line. Each line begins with an absolute position, which limits the errors of readers that add up
/// in 32 bits.
class SvgPathText {
 public:
  SvgPathText(std::string& text, int decimals);
  SvgPathText(const SvgPathText&) = delete;
  SvgPathText& operator=(const SvgPathText&) = delete;

  void move(const Vec2& point);
  void line(const Vec2& point);
  /// A quadratic curve.
  void curve(const Vec2& control, const Vec2& end);
  /// Part of an ellipse with its first axis turned by `turn` degrees; `clockwise` as seen on the page.
  void arc(const Vec2& radii, double turn, bool clockwise, const Vec2& end);
  void close();
  /// Must be called last: until then, the end of the text is missing.
  void end() { append_written(); }

 private:
  using Rounded = std::array<long long, 2>;

  [[nodiscard]] Rounded round(const Vec2& point) const;
  void command(char letter);
  void number(long long rounded);
  /// Appends what has been written since the last call. Pieces of a few characters would cost more than their digits.
  void append_written();
  void make_room();

  std::string& text_;
  int decimals_;
  double parts_ = 1;  ///< per millimetre
  Rounded here_{};
  char command_ = 0;
  bool after_number_ = false;
  std::array<char, 1024> written_;  ///< not appended yet
  char* end_ = written_.data();
};

/// The number of parts in a length, rounded; a millimetre has `parts` parts.
long long parts_of(double millimetres, double parts);

/// The number without a zero before its point: .25
void append_short(std::string& text, double value, int decimals);

/// Millimetres outside path data: at most four decimals.
void append_millimetres(std::string& text, double value);

}  // namespace epura::output
