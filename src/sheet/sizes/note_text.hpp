// SPDX-License-Identifier: Apache-2.0
// Reads the text of a dimension or note: a count, a size, tolerances, and what is said of a hole behind it.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "sheet/notation.hpp"

namespace epura::sheet {

/// What a number, or a word, says. A size is what the dimension measures; a sum is that of equal ones ("(=60)"),
/// another unit is the same size in brackets.
enum class NotedRole { size, sum, other_unit, counterbore, countersink, depth, angle, thread, through, blind, unread };

enum class NotedSign { none, diameter, radius, sphere, sphere_radius, square, degrees };

struct NotedElement {
  NotedRole role;
  NotedSign sign = NotedSign::none;
  double least = 0, most = 0;  ///< what it allows: mm or degrees; the same twice unless there are limits
  double slack = 0;            ///< half a unit of its last digit, mm or degrees
  double unit = 0;             ///< in which it is written, mm; 0: degrees, or whatever in brackets
  double of = 0;               ///< the diameter before it, in mm, to which a depth or an angle belongs; 0: the first
  NotedRole of_role = NotedRole::size;  ///< the role of that diameter

  [[nodiscard]] bool allows(double value, double doubt) const {
    return value >= least - slack - doubt && value <= most + slack + doubt;
  }
  [[nodiscard]] bool is_recess() const { return role == NotedRole::counterbore || role == NotedRole::countersink; }
};

struct NotedText {
  int count = 1;
  std::vector<NotedElement> elements;  ///< in their order
  std::string unread;                  ///< from the first word that nobody understands; empty: there is none
  std::size_t understood = 0;          ///< how many elements stand before that

  /// What is measured: the sum of equal ones, or the size; nothing where the first number may be something else, as in
  /// "60 along the edge" and "1/2".
  [[nodiscard]] const NotedElement* size() const;
};

/// Signs are those of ISO 129-1, ISO 15786 and ASME Y14.5, and the words and abbreviations of workshops: "CBORE", "X 5
/// DEEP", "CSK", "THRU". Numbers have the unit of the sheet unless one is behind them. Brackets around all of it do not
/// count. Numbers among what is not understood are elements, `unread`.
NotedText read_text(std::string_view text, const Notation& notation);

}  // namespace epura::sheet
