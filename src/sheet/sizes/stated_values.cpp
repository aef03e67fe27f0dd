// SPDX-License-Identifier: Apache-2.0
#include "sizes/stated_values.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <string_view>
#include <system_error>

#include "base/angle.hpp"
#include "base/error.hpp"
#include "base/text.hpp"
#include "scene/choices.hpp"
#include "sizes/equal_features.hpp"
#include "sizes/note_text.hpp"
#include "sizes/place_joins.hpp"

namespace epura::sheet {

namespace {

// By what it says; of sizes and what nobody understands, by the sign.
NumberKind kind_of(const NotedElement& element) {
  const bool is_round = element.sign == NotedSign::diameter || element.is_recess();
  const bool is_along = element.role == NotedRole::depth || (element.role == NotedRole::length && element.of > 0);
  return is_along                             ? NumberKind::depth
         : element.sign == NotedSign::degrees ? NumberKind::degrees
         : is_round                           ? NumberKind::diameter
                                              : NumberKind::any;
}

}  // namespace

std::optional<double> measured_size(const AnchoredDimension& dimension, const DimensionsInView& view) {
  const std::vector<Vec3>& at = dimension.points;
  if (dimension.arrangement) return std::nullopt;
  if (dimension.type == DimensionType::overall)
    return std::abs((at[1] - at[0])[axis_of(*dimension.direction)]) + dimension.beyond_vertices;
  if (const std::optional<Vec3> along = measured_along(dimension, view))
    return std::abs(glm::dot(at[1] - at[0], *along)) + dimension.beyond_vertices;
  if (dimension.type == DimensionType::angular) {
    const double cosine = glm::dot(glm::normalize(at[1] - at[0]), glm::normalize(at[2] - at[0]));
    return std::acos(std::clamp(cosine, -1.0, 1.0)) * degrees;
  }
  const bool is_diameter = dimension.type == DimensionType::diameter;
  if (!is_diameter && dimension.type != DimensionType::radius) return std::nullopt;
  check(!dimension.circles.empty(), "a radius or diameter is that of a circle");
  return (is_diameter ? 2 : 1) * dimension.circles.front().radius;
}

std::vector<NotedNumber> noted_numbers(const std::string& text, const Notation& notation) {
  std::vector<NotedNumber> numbers;
  constexpr std::array elsewhere{NotedRole::thread, NotedRole::circle, NotedRole::evenly, NotedRole::limits};
  for (const NotedElement& one : read_text(text, notation).elements) {
    if (!(one.least > 0) || std::ranges::find(elsewhere, one.role) != elsewhere.end()) continue;
    const double twice = one.is_recess() && one.sign == NotedSign::radius ? 2 : 1;
    numbers.push_back({twice * one.least, kind_of(one), one.of_role == NotedRole::thread ? 0 : one.of});
  }
  return numbers;
}

std::optional<StatedSize> stated_size(const AnchoredDimension& dimension, const DimensionsInView& view,
                                      const Notation& notation) {
  const NotedText text = read_text(dimension.text, notation);
  const bool is_angle = dimension.type == DimensionType::angular;
  const double unit = is_angle ? 1 : scene::millimetres(notation.unit);
  std::optional<NotedElement> allowed;
  if (const NotedElement* size = text.size()) allowed = *size;
  if (const auto& stated = dimension.stated; !allowed && stated)
    allowed = NotedElement{NotedRole::size, NotedSign::none, stated->value * unit, stated->value * unit,
                           std::pow(10.0, -stated->decimals) / 2 * unit};
  const std::optional<double> measured = measured_size(dimension, view);
  if (!allowed || !measured) return std::nullopt;
  return StatedSize{std::clamp(*measured, allowed->least, allowed->most), *measured, allowed->slack, unit};
}

bool gives_thread(const std::string& text, const Notation& notation) {
  return read_text(text, notation).gives_thread();
}

bool gives_size(const AnchoredDimension& dimension, const DimensionsInView& view, const Notation& notation) {
  const std::string& text = dimension.text;
  const std::optional<double> measured = measured_size(dimension, view);
  if (!measured || text.empty() || text.find("<>") != std::string::npos || dimension.is_label ||
      gives_thread(text, notation) || stated_size(dimension, view, notation))
    return true;
  return std::ranges::any_of(noted_numbers(text, notation), [&](const NotedNumber& number) {
    return are_written_alike(number.value, *measured, notation);
  });
}

std::string text_of(const AnchoredDimension& dimension, const DimensionsInView& view, const Notation& notation) {
  constexpr std::string_view value = "<>";
  std::string text = dimension.text.empty() ? std::string(value) : dimension.text;
  const std::size_t at = text.find(value);
  if (at == std::string::npos) return text;
  if (dimension.arrangement) return "a row of " + std::to_string(dimension.points.size() - 1) + " lengths";
  const std::optional<double> measured = measured_size(dimension, view);
  if (!measured) return dimension.where;
  const bool is_angle = dimension.type == DimensionType::angular;
  const char* sign = dimension.type == DimensionType::radius     ? "R"
                     : dimension.type == DimensionType::diameter ? "⌀"
                                                                 : "";
  std::string number = is_angle ? angle_text(*measured, notation) : length_text(*measured, notation);
  if (const auto& stated = dimension.stated)
    number = format_with_zeros(stated->value, stated->decimals) + (is_angle ? "°" : "");
  return text.replace(at, value.size(), sign + number);
}

}  // namespace epura::sheet
