// SPDX-License-Identifier: Apache-2.0
// Tolerances of dimensions: deviations or classes of ISO 286. ISO 129-1, ISO 406.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "scene/description.hpp"
#include "sheet/dimension_text.hpp"
#include "sheet/notation.hpp"
#include "sizes/fits.hpp"

namespace epura::sheet {

/// As given by the user.
struct Tolerance {
  std::optional<Deviations> deviations{};         ///< in the unit of the text: of dimensions, or degrees
  int decimals = 0;                               ///< of the deviations as written
  std::optional<ToleranceClass> hole{}, shaft{};  ///< otherwise
  bool limits = false;                            ///< whether limits of size are written
  std::string where{};                            ///< for errors

  [[nodiscard]] bool is_fit() const { return hole || shaft; }
};

/// "±0.1", "+0.2 -0.1", "0 -0.1", "H7", "g6" or "H7/g6". Throws Error{input} with `where` as the location.
Tolerance parse_tolerance(std::string_view text, const std::string& where);

/// What a dimension measures.
struct MeasuredValue {
  double value;        ///< mm, or degrees
  std::string sign{};  ///< before the number: "R", "⌀"
  bool is_angle = false;
  std::optional<scene::StatedValue> stated{};  ///< written instead of it
};

/// The value as written, with its tolerance: "20", "20 ±0.1", "20 H7"; deviations that differ, and limits, are stacked.
/// Limits of size are written instead of deviations, and after a fit in brackets. Throws Error{input} if the tolerance
/// does not suit the value.
DimensionText text_of(const MeasuredValue& measured, const std::optional<Tolerance>& tolerance,
                      const Notation& notation);

}  // namespace epura::sheet
