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
#include "sizes/place_joins.hpp"

namespace epura::sheet {

namespace {

// What a text allows a size to be; the same twice if it is one number.
struct Allowed {
  double least, most;
  double slack;  // half a unit of the last digit
};

struct Number {
  double value = 0;
  double slack = 0.5;  // half a unit of its last digit
};

bool starts_with_digit(std::string_view text) {
  const auto is_digit = [&text](std::size_t i) {
    return i < text.size() && std::isdigit(static_cast<unsigned char>(text[i])) != 0;
  };
  return is_digit(0) || (text.starts_with(".") && is_digit(1));
}

// Takes it off the text.
std::optional<Number> take_number(std::string_view& text) {
  Number number;
  if (!starts_with_digit(text)) return std::nullopt;
  const auto [end, error] =
      std::from_chars(text.data(), text.data() + text.size(), number.value, std::chars_format::fixed);
  if (error != std::errc()) return std::nullopt;
  const std::string_view digits = text.substr(0, static_cast<std::size_t>(end - text.data()));
  if (const std::size_t point = digits.find('.'); point != std::string_view::npos)
    number.slack = std::pow(10.0, -static_cast<double>(digits.size() - point - 1)) / 2;
  text.remove_prefix(digits.size());
  return number;
}

bool take(std::string_view& text, std::string_view sign) {
  if (!text.starts_with(sign)) return false;
  text.remove_prefix(sign.size());
  return true;
}

void skip_spaces(std::string_view& text) {
  while (take(text, " ")) continue;
}

// Behind degrees: "30'", and perhaps "15''".
Number with_minutes(Number angle, std::string_view rest) {
  double part = 60;
  for (const std::string_view sign : {"'", "\""}) {
    const std::optional<Number> number = take_number(rest);
    if (!number || !(take(rest, sign) || take(rest, sign == "'" ? "′" : "″"))) break;
    angle = {angle.value + number->value / part, number->slack / part};
    part *= 60;
  }
  return angle;
}

// Of "60.2-60.1" the other limit; what is far less is a deviation.
std::optional<Number> other_limit(const Number& one, std::string_view rest) {
  skip_spaces(rest);
  const bool is_dash = take(rest, "-") || take(rest, "–") || take(rest, "−");
  if (!is_dash && !take(rest, "/")) return std::nullopt;
  skip_spaces(rest);
  const std::optional<Number> other = take_number(rest);
  if (!other || !rest.empty() || other->value < one.value / 2) return std::nullopt;
  return is_dash || (one.slack < 0.5 && other->slack < 0.5) ? other : std::nullopt;
}

// The size with which a text begins, behind its count and sign; of "3× 20 (=60)" the sum. Nothing where the first
// number may be something else, as in "6 holes ⌀8" and "1/2".
std::optional<Allowed> allowed_by(const std::string& whole) {
  std::string with_points = whole;
  std::replace(with_points.begin(), with_points.end(), ',', '.');
  std::string_view text = with_points;
  text.remove_prefix(count_of(text).end);
  const std::size_t sum = text.find('=');
  if (sum != std::string_view::npos) text.remove_prefix(sum + 1);
  bool is_signed = sum != std::string_view::npos;
  skip_spaces(text);
  for (const std::string_view sign : {"S", "⌀", "Ø", "R", "□"}) {
    is_signed = take(text, sign) || is_signed;
    skip_spaces(text);
  }
  std::optional<Number> number = take_number(text);
  if (!number) return std::nullopt;
  check(number->slack > 0, "a number has a last digit");
  if (const std::optional<Number> other = other_limit(*number, text)) {
    const auto [least, most] = std::minmax(number->value, other->value);
    return Allowed{least, most, std::max(number->slack, other->slack)};
  }
  const bool is_angle = take(text, "°");
  if (is_angle) number = with_minutes(*number, text);
  skip_spaces(text);
  const auto goes_on_with = [&text](std::string_view sign) { return text.starts_with(sign); };
  constexpr std::array<std::string_view, 10> known{"±", "+", "-", "−", "(", "[", ")", "×", "↧", "'"};
  const bool is_fit = text.size() < 6 && text.size() > 1 && std::isalpha(static_cast<unsigned char>(text[0])) != 0 &&
                      std::isdigit(static_cast<unsigned char>(text.back())) != 0;
  const bool is_size = is_signed || is_angle || is_fit || text.empty() || std::ranges::any_of(known, goes_on_with);
  return is_size ? std::optional(Allowed{number->value, number->value, number->slack}) : std::nullopt;
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
  text.erase(0, count_of(text).end);
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
      const auto before = std::find_if(numbers.rbegin(), numbers.rend(),
                                       [](const NotedNumber& one) { return one.kind == NumberKind::diameter; });
      numbers.push_back({kind == NumberKind::degrees ? value : value * scene::millimetres(notation.unit), kind,
                         before == numbers.rend() ? 0 : before->value});
    }
    check(behind > i, "each step goes on in the text");
    i = behind;
  }
  return numbers;
}

std::optional<StatedSize> stated_size(const AnchoredDimension& dimension, const DimensionsInView& view,
                                      const Notation& notation) {
  std::optional<Allowed> allowed = allowed_by(dimension.text);
  if (const auto& stated = dimension.stated; !allowed && stated)
    allowed = Allowed{stated->value, stated->value, std::pow(10.0, -stated->decimals) / 2};
  const std::optional<double> measured = measured_size(dimension, view);
  if (!allowed || !measured) return std::nullopt;
  const double unit = dimension.type == DimensionType::angular ? 1 : scene::millimetres(notation.unit);
  return StatedSize{std::clamp(*measured, allowed->least * unit, allowed->most * unit), *measured,
                    allowed->slack * unit, unit};
}

bool gives_thread(std::string_view text) {
  for (std::size_t i = 0; i + 1 < text.size(); ++i)
    if ((text[i] == 'M' || text[i] == 'G') && starts_with_digit(text.substr(i + 1))) return true;
  return false;
}

bool gives_size(const AnchoredDimension& dimension, const DimensionsInView& view, const Notation& notation) {
  const std::string& text = dimension.text;
  const std::optional<double> measured = measured_size(dimension, view);
  if (!measured || text.empty() || text.find("<>") != std::string::npos || dimension.is_label || gives_thread(text) ||
      stated_size(dimension, view, notation))
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
