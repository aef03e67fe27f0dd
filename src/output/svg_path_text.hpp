// SPDX-License-Identifier: Apache-2.0
// Compact SVG path data. SVG 1.1, 8.3.
#pragma once

#include <array>
#include <string>

#include "base/vec.hpp"

namespace epura::output {

/// Points are rounded to `decimals` of a millimetre before the way from one to the next is written, so that errors do
/// not add up along a line. Each line begins with an absolute place: readers that add up in 32 bits stay near.
class SvgPathText {
 public:
  SvgPathText(std::string& text, int decimals);

  void move(const Vec2& point);
  void line(const Vec2& point);
  /// Quadratic.
  void curve(const Vec2& control, const Vec2& end);
  /// Of an ellipse whose first axis is turned by this angle in degrees; `clockwise` as seen on the page.
  void arc(const Vec2& radii, double turn, bool clockwise, const Vec2& end);
  void close();

 private:
  using Rounded = std::array<long long, 2>;

  [[nodiscard]] Rounded round(const Vec2& point) const;
  void command(char letter);
  void number(long long rounded);

  std::string& text_;
  int decimals_;
  double parts_;  ///< of a millimetre
  Rounded here_{};
  char command_ = 0;
  bool after_number_ = false;
};

/// How many times a part of a millimetre, of which a millimetre has `parts`, is in a length, rounded.
long long parts_of(double millimetres, double parts);

/// The number without a zero before its point: .25
void append_short(std::string& text, double value, int decimals);

/// Millimetres outside lines: at most four decimals.
void append_millimetres(std::string& text, double value);

}  // namespace epura::output
