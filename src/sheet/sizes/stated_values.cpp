// SPDX-License-Identifier: Apache-2.0
#include "sizes/stated_values.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <string_view>

#include "base/angle.hpp"
#include "base/error.hpp"
#include "base/text.hpp"
#include "scene/choices.hpp"
#include "sizes/equal_features.hpp"
#include "sizes/place_joins.hpp"

namespace epura::sheet {

namespace {

struct Number {
  double value;
  int decimals;
};

// The one number of a text; nothing if it says more.
std::optional<Number> only_number(std::string text) {
  constexpr std::string_view times = "×";
  if (repeats_of(text) > 1) text.erase(0, text.find(times) + times.size());
  std::replace(text.begin(), text.end(), ',', '.');
  for (const std::string_view sign : {" ", "S", "⌀", "R", "□"})
    while (text.starts_with(sign)) text.erase(0, sign.size());
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc()) return std::nullopt;
  const std::string_view number(text.data(), static_cast<std::size_t>(end - text.data()));
  std::string_view rest(end, static_cast<std::size_t>(text.data() + text.size() - end));
  if (rest.starts_with("°")) rest.remove_prefix(std::string_view("°").size());
  while (rest.starts_with(" ")) rest.remove_prefix(1);
  if (!rest.empty() && !rest.starts_with("±")) return std::nullopt;
  const std::size_t point = number.find('.');
  return Number{value, point == std::string_view::npos ? 0 : static_cast<int>(number.size() - point - 1)};
}

// By the signs before and behind it.
NumberKind kind_of(std::string_view before, std::string_view behind, const Notation& notation) {
  while (before.ends_with(" ")) before.remove_suffix(1);
  if (behind.starts_with("°")) return NumberKind::degrees;
  if (before.ends_with("↧")) return NumberKind::depth;
  const bool is_own = !notation.diameter.empty() && before.ends_with(notation.diameter);
  return is_own || before.ends_with("⌀") || before.ends_with("Ø") ? NumberKind::diameter : NumberKind::any;
}

// Millimetres or degrees.
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

}  // namespace

std::vector<NotedNumber> noted_numbers(std::string text, const Notation& notation) {
  if (repeats_of(text) > 1) text.erase(0, text.find("×"));
  if (notation.sign == DecimalSign::comma) std::replace(text.begin(), text.end(), ',', '.');
  const auto is_digit = [&text](std::size_t i) {
    return i < text.size() && std::isdigit(static_cast<unsigned char>(text[i])) != 0;
  };
  std::vector<NotedNumber> numbers;
  for (std::size_t i = 0; i < text.size();) {
    double value = 0;
    const auto [end, error] = std::from_chars(text.data() + i, text.data() + text.size(), value);
    const bool is_number = error == std::errc() && (is_digit(i) || (text[i] == '.' && is_digit(i + 1)));
    const std::size_t behind = is_number ? static_cast<std::size_t>(end - text.data()) : i + 1;
    if (is_number) {
      const std::string_view all = text;
      const NumberKind kind = kind_of(all.substr(0, i), all.substr(behind), notation);
      numbers.push_back({kind == NumberKind::degrees ? value : value * scene::millimetres(notation.unit), kind});
    }
    check(behind > i, "each step goes on in the text");
    i = behind;
  }
  return numbers;
}

std::optional<StatedSize> stated_size(const AnchoredDimension& dimension, const DimensionsInView& view,
                                      const Notation& notation) {
  std::optional<Number> number = only_number(dimension.text);
  if (!number && dimension.stated) number = Number{dimension.stated->value, dimension.stated->decimals};
  const std::optional<double> measured = measured_size(dimension, view);
  if (!number || !measured) return std::nullopt;
  const double unit = dimension.type == DimensionType::angular ? 1 : scene::millimetres(notation.unit);
  return StatedSize{number->value * unit, *measured, std::pow(10.0, -number->decimals) / 2 * unit, unit};
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
