// SPDX-License-Identifier: Apache-2.0
#include "sizes/tolerance.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "base/error.hpp"
#include "base/text.hpp"
#include "scene/choices.hpp"

namespace epura::sheet {

namespace {

constexpr std::string_view plus_minus = "±";
constexpr int max_decimals = 8;

[[noreturn]] void refuse_text(std::string_view text, const std::string& where) {
  refuse_input(where, "'" + std::string(text) + "' is not a tolerance", "±0.1, +0.2 -0.1, H7, g6 or H7/g6");
}

std::vector<std::string> words_of(std::string_view text) {
  std::vector<std::string> words;
  for (const std::string_view word : split(text, ' '))
    if (!word.empty()) words.emplace_back(word);
  return words;
}

// A number that may have a sign: "+0.2".
std::optional<double> number_of(std::string_view word) {
  if (word.starts_with('+')) {
    word.remove_prefix(1);
    if (word.starts_with('-') || word.starts_with('+')) return {};
  }
  return parse_number(word);
}

int decimals_of(std::string_view word) {
  const std::size_t point = word.find('.');
  return point == std::string_view::npos ? 0 : static_cast<int>(word.size() - point - 1);
}

std::optional<Tolerance> symmetric(std::string_view text) {
  for (const std::string_view sign : {plus_minus, std::string_view("+/-"), std::string_view("+-")}) {
    if (!text.starts_with(sign)) continue;
    std::string_view rest = text.substr(sign.size());
    while (rest.starts_with(' ')) rest.remove_prefix(1);
    const auto value = parse_number(rest);
    if (!value || !(*value > 0)) return {};
    return Tolerance{.deviations = Deviations{*value, -*value}, .decimals = decimals_of(rest)};
  }
  return {};
}

std::optional<Tolerance> two_deviations(const std::vector<std::string>& words) {
  if (words.size() != 2) return {};
  const auto upper = number_of(words[0]), lower = number_of(words[1]);
  if (!upper || !lower) return {};
  // Without signs these would be read as limits.
  const auto has_sign = [](const std::string& word) { return word.starts_with('+') || word.starts_with('-'); };
  if ((*upper != 0 && !has_sign(words[0])) || (*lower != 0 && !has_sign(words[1]))) return {};
  return Tolerance{.deviations = Deviations{*upper, *lower},
                   .decimals = std::max(decimals_of(words[0]), decimals_of(words[1]))};
}

Tolerance fit_of(std::string_view text, const std::string& where) {
  Tolerance tolerance;
  const std::size_t slash = text.find('/');
  const ToleranceClass first = parse_tolerance_class(text.substr(0, slash), where);
  (first.is_hole() ? tolerance.hole : tolerance.shaft) = first;
  if (slash == std::string_view::npos) return tolerance;
  const ToleranceClass second = parse_tolerance_class(text.substr(slash + 1), where);
  if (!first.is_hole() || second.is_hole())
    refuse_input(where, "'" + std::string(text) + "' is not a fit", "the class of the hole comes first, as in H7/g6");
  tolerance.shaft = second;
  return tolerance;
}

// With all decimals: "20.000". ISO 129-1 wants the same number for both limits.
std::string padded(double value, int decimals, const Notation& notation) {
  std::string text = format_with_zeros(value, decimals);
  if (notation.unit == Unit::in && text.starts_with("0.")) text.erase(0, 1);
  return with_decimal_sign(text, notation.sign);
}

std::string signed_text(double value, const Tolerance& tolerance, const Notation& notation) {
  if (value == 0) return "0";
  return (value > 0 ? "+" : "-") + padded(std::abs(value), tolerance.decimals, notation);
}

// The least number of decimals that a number needs.
int needed_decimals(double value) {
  const std::string text = format_fixed(value, max_decimals);
  return decimals_of(text);
}

// The number as it is written, in the unit of dimensions, so that limits agree with it to the last digit.
double written_value(const MeasuredValue& measured, const Notation& notation) {
  constexpr int angle_decimals = 2;
  if (measured.stated) return measured.stated->value;
  const double value = measured.is_angle || notation.unit == Unit::mm
                           ? measured.value
                           : measured.value / scene::millimetres(notation.unit);
  return parse_number(format_fixed(value, measured.is_angle ? angle_decimals : notation.decimals)).value_or(value);
}

std::string number_text(const MeasuredValue& measured, const Notation& notation) {
  if (measured.stated)
    return padded(measured.stated->value, measured.stated->decimals, notation) + (measured.is_angle ? "°" : "");
  return measured.is_angle ? angle_text(measured.value, notation) : length_text(measured.value, notation);
}

TextPiece limits_of(const MeasuredValue& measured, Deviations deviations, int decimals, const Notation& notation) {
  const double value = written_value(measured, notation);
  const int own = measured.stated ? measured.stated->decimals : needed_decimals(value);
  const int all = std::min(max_decimals, std::max(decimals, own));
  const std::string unit = measured.is_angle ? "°" : "";
  return {padded(value + deviations.upper, all, notation) + unit,
          padded(value + deviations.lower, all, notation) + unit};
}

// Limits by the tables, which are in mm.
TextPiece limits_of(const MeasuredValue& measured, const ToleranceClass& one, const std::string& where,
                    const Notation& notation) {
  const double mm = notation.unit == Unit::mm ? 1 : scene::millimetres(notation.unit);
  Deviations deviations = deviations_of(one, written_value(measured, notation) * mm, where);
  deviations = {deviations.upper / mm, deviations.lower / mm};
  constexpr int inch_decimals = 5;
  const auto needed = [&](double value) { return notation.unit == Unit::in ? inch_decimals : needed_decimals(value); };
  return limits_of(measured, deviations, std::max(needed(deviations.upper), needed(deviations.lower)), notation);
}

void add_fit(DimensionText& text, const MeasuredValue& measured, const Tolerance& tolerance, const Notation& notation) {
  if (measured.is_angle || measured.sign == "R")
    refuse_input(tolerance.where, "a class of ISO 286 is for diameters and widths",
                 "give the deviations, as +0.2 -0.1");
  std::string between = " ";
  for (const auto* one : {&tolerance.hole, &tolerance.shaft}) {
    if (!*one) continue;
    const TextPiece limits = limits_of(measured, **one, tolerance.where, notation);
    text.add(between + (*one)->text());
    between = "/";
    if (!tolerance.limits) continue;
    text.add(std::string(" ("));
    text.pieces.push_back(limits);
    text.add(std::string(")"));
    between = " / ";
  }
}

}  // namespace

Tolerance parse_tolerance(std::string_view text, const std::string& where) {
  while (text.starts_with(' ')) text.remove_prefix(1);
  while (text.ends_with(' ')) text.remove_suffix(1);
  std::string plain(text);
  for (std::size_t at; (at = plain.find("−")) != std::string::npos;) plain.replace(at, std::string("−").size(), "-");
  std::optional<Tolerance> tolerance = symmetric(plain);
  if (!tolerance) tolerance = two_deviations(words_of(plain));
  if (!tolerance) {
    const bool is_class = !plain.empty() && std::isalpha(static_cast<unsigned char>(plain.front()));
    if (!is_class) refuse_text(text, where);
    tolerance = fit_of(plain, where);
  }
  tolerance->where = where;
  if (!tolerance->deviations) return *tolerance;
  const Deviations& given = *tolerance->deviations;
  if (!std::isfinite(given.upper) || !std::isfinite(given.lower) || tolerance->decimals > max_decimals)
    refuse_text(text, where);
  if (!(given.upper > given.lower))
    refuse_input(where, "'" + std::string(text) + "' permits no size",
                 "the upper deviation comes first, as in +0.2 -0.1");
  return *tolerance;
}

DimensionText text_of(const MeasuredValue& measured, const std::optional<Tolerance>& tolerance,
                      const Notation& notation) {
  DimensionText text(measured.sign + number_text(measured, notation));
  if (!tolerance) return text;
  if (tolerance->is_fit()) {
    add_fit(text, measured, *tolerance, notation);
    return text;
  }
  const Deviations& deviations = *tolerance->deviations;
  check(deviations.lower < deviations.upper, "limits are in order");
  if (written_value(measured, notation) + deviations.lower <= 0)
    refuse_input(tolerance->where, "the lower limit of the dimension " + text.line() + " is not positive",
                 "deviations are in the unit of the dimension");
  if (tolerance->limits) {
    DimensionText limits(measured.sign);
    limits.pieces.push_back(limits_of(measured, deviations, tolerance->decimals, notation));
    return limits;
  }
  const std::string unit = measured.is_angle ? "°" : "";
  if (deviations.upper == -deviations.lower) {
    text.add(" ±" + padded(deviations.upper, tolerance->decimals, notation) + unit);
    return text;
  }
  text.add(std::string(" "));
  text.pieces.push_back({signed_text(deviations.upper, *tolerance, notation) + unit,
                         signed_text(deviations.lower, *tolerance, notation) + unit});
  return text;
}

}  // namespace epura::sheet
