// SPDX-License-Identifier: Apache-2.0
// Tolerance classes such as H7 and g6. ISO 286-1:2010.
#pragma once

#include <string>
#include <string_view>

namespace epura::sheet {

/// Largest size of the tables, mm.
inline constexpr double largest_fit_size = 500;

/// Limit deviations from the nominal size, mm: ES and EI of a hole, es and ei of a shaft.
struct Deviations {
  double upper, lower;
};

/// A fundamental deviation and a standard tolerance grade: "H7", "js6".
struct ToleranceClass {
  std::string letters;  ///< capitals for holes
  int grade;            ///< of IT1 to IT18

  [[nodiscard]] bool is_hole() const { return letters.front() < 'a'; }
  [[nodiscard]] std::string text() const { return letters + std::to_string(grade); }
};

/// Throws Error{input} with `where` as the location for letters and grades that ISO 286-1 does not have, or that are
/// not in the tables here: C to U and c to u.
ToleranceClass parse_tolerance_class(std::string_view text, const std::string& where);

/// The deviations of a nominal size in mm. Throws Error{input} for sizes that are not in (0, 500], and for classes that
/// the standard does not define at this size.
Deviations deviations_of(const ToleranceClass& tolerance, double size, const std::string& where);

}  // namespace epura::sheet
