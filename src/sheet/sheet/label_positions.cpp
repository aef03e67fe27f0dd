// SPDX-License-Identifier: Apache-2.0
#include "sheet/label_positions.hpp"

#include <optional>
#include <string>

#include "sheet/standard_scale.hpp"

namespace epura::sheet {

namespace {

constexpr double height = 5;
constexpr double above_ink = 3;  // together with the height less than label_room

}  // namespace

std::string view_label(const std::string& label, std::optional<double> scale, double main_scale, DecimalSign sign) {
  const std::string ratio = scale && *scale != main_scale ? with_decimal_sign(ratio_text(*scale), sign) : "";
  if (ratio.empty()) return label;
  return (label.empty() ? "" : label + " ") + "(" + ratio + ")";
}

Text label_above(const std::string& label, const Rectangle& ink) {
  return {label, {ink.centre().x, ink.max.y + above_ink}, height, 0, Align::middle, "label"};
}

}  // namespace epura::sheet
