// SPDX-License-Identifier: Apache-2.0
// Reads the text of a dimension or note: a count, a size, tolerances, and what is said of a hole behind it.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "sheet/notation.hpp"

namespace epura::sheet {

/// What a number, or a word, says. A size is what the dimension measures; a sum is that of equal ones ("(=60)"),
/// another unit is the same size in brackets.
enum class NotedRole {
  size,
  sum,
  other_unit,
  limits,  ///< both, in brackets
  counterbore,
  countersink,
  depth,
  length,  ///< along the axis of the diameter before it; of a chamfer, its second leg
  angle,
  thread,
  drill,   ///< the diameter behind a thread, of the hole for it
  circle,  ///< on which holes are
  evenly,  ///< spaced on it; the angle between neighbours, if it is given
  through,
  blind,
  unread
};

constexpr bool is_recess(NotedRole role) { return role == NotedRole::counterbore || role == NotedRole::countersink; }

enum class NotedSign { none, diameter, radius, sphere, sphere_radius, square, degrees };

struct NotedElement {
  NotedRole role;
  NotedSign sign = NotedSign::none;
  double least = 0, most = 0;  ///< what it allows: mm or degrees; the same twice unless there are limits
  double slack = 0;            ///< half a unit of its last digit, mm or degrees
  double unit = 0;             ///< in which it is written, mm; 0: degrees, or whatever in brackets
  double middle = 0;           ///< of its deviations, as models may have it; 0: there are none
  double of = 0;               ///< the diameter before it, in mm, to which a depth or an angle belongs; 0: the first
  NotedRole of_role = NotedRole::size;  ///< the role of that diameter
  double pitch = 0;                     ///< of a thread, mm; 0: not known

  [[nodiscard]] bool allows(double value, double doubt) const {
    const bool is_middle = middle > 0 && std::abs(value - middle) <= slack + doubt;
    return is_middle || (value >= least - slack - doubt && value <= most + slack + doubt);
  }
  [[nodiscard]] bool is_recess() const { return sheet::is_recess(role); }
};

/// Of what general notes speak.
enum class NotedKind { none, holes, threads, fillets, chamfers, lengths, thickness, others };

struct NotedText {
  int count = 1;
  NotedKind kind = NotedKind::none;
  bool is_of_all = false;              ///< of a kind, or of those that have no note of their own
  std::string fit;                     ///< the first class of tolerances: "H7"; empty: there is none
  std::vector<NotedElement> elements;  ///< in their order
  std::string unread;                  ///< from the first word that nobody understands; empty: there is none
  std::size_t understood = 0;          ///< how many elements stand before that

  [[nodiscard]] std::span<const NotedElement> all_understood() const { return std::span(elements).first(understood); }
  [[nodiscard]] bool gives_thread() const {
    return std::ranges::any_of(elements, [](const NotedElement& one) { return one.role == NotedRole::thread; });
  }
  /// What is measured: the sum of equal ones, or the size; nothing where the first number may be something else, as in
  /// "60 along the edge" and "1/2".
  [[nodiscard]] const NotedElement* size() const;
};

/// Signs are those of ISO 129-1, ISO 15786 and ASME Y14.5, and the words and abbreviations of workshops
/// (note_words.hpp): "CBORE", "X 5 DEEP", "12 tief", "débouchant". Numbers have the unit of the sheet unless one is
/// behind them. Brackets around all of it do not count. Numbers among what is not understood are elements, `unread`.
NotedText read_text(std::string_view text, const Notation& notation);

}  // namespace epura::sheet
