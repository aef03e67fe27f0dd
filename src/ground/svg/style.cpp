// SPDX-License-Identifier: Apache-2.0
#include "svg/style.hpp"

#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "base/portable_math.hpp"
#include "base/text.hpp"

namespace epura::svg {

namespace {

constexpr std::array<std::string_view, 20> drawn_properties = {
    "stroke",      "fill",         "stroke-width", "stroke-dasharray", "display",        "visibility",  "font-size",
    "text-anchor", "font-family",  "opacity",      "fill-opacity",     "stroke-opacity", "clip-path",   "mask",
    "filter",      "marker-start", "marker-mid",   "marker-end",       "vector-effect",  "shape-inside"};

constexpr std::string_view blanks = " \t\r\n";

std::string_view trimmed(std::string_view text) {
  const std::size_t begin = text.find_first_not_of(blanks);
  if (begin == std::string_view::npos) return {};
  return text.substr(begin, text.find_last_not_of(blanks) + 1 - begin);
}

void take_over(Declarations& all, const Declarations& more) {
  for (const auto& [property, value] : more) all.insert_or_assign(property, value);
}

// "path", ".frame" or "#border".
bool is_simple(std::string_view selector) {
  return !selector.empty() && selector.find_first_of(" .>#:[*+~@", 1) == std::string_view::npos &&
         std::string_view("*:[@").find(selector[0]) == std::string_view::npos;
}

std::optional<AffineMap> map_of(std::string_view name, const std::vector<double>& n) {
  if (name == "matrix" && n.size() == 6) return AffineMap{{n[0], n[1]}, {n[2], n[3]}, {n[4], n[5]}};
  if (name == "translate" && !n.empty() && n.size() <= 2)
    return AffineMap{{1, 0}, {0, 1}, {n[0], n.size() > 1 ? n[1] : 0}};
  if (name == "scale" && !n.empty() && n.size() <= 2) return AffineMap{{n[0], 0}, {0, n.back()}, {0, 0}};
  if (name == "rotate" && (n.size() == 1 || n.size() == 3)) {
    const double angle = n[0] * std::numbers::pi / 180, c = portable_cos(angle), s = portable_sin(angle);
    const AffineMap turn{{c, s}, {-s, c}, {0, 0}};
    const Vec2 centre = n.size() == 3 ? Vec2(n[1], n[2]) : Vec2(0, 0);
    return AffineMap{turn.along, turn.across, centre - turn(centre)};
  }
  return std::nullopt;
}

}  // namespace

std::optional<AffineMap> read_transform(std::string_view text) {
  AffineMap whole;
  for (text = trimmed(text); !text.empty(); text = trimmed(text)) {
    const std::size_t open = text.find('('), close = text.find(')');
    if (open == std::string_view::npos || close == std::string_view::npos || close < open) return std::nullopt;
    const auto map = map_of(trimmed(text.substr(0, open)), numbers_in(text.substr(open + 1, close - open - 1)));
    if (!map) return std::nullopt;
    whole = whole.after(*map);
    text.remove_prefix(close + 1);
    if (text.starts_with(',')) text.remove_prefix(1);
  }
  return whole;
}

void Rules::merge(Rules more) {
  for (const auto& [selector, declarations] : more.of) take_over(of[selector], declarations);
  others.insert(others.end(), more.others.begin(), more.others.end());
}

Declarations read_declarations(std::string_view text) {
  Declarations read;
  for (const std::string_view declaration : split(text, ';')) {
    const std::size_t colon = declaration.find(':');
    if (colon == std::string_view::npos) continue;
    read.insert_or_assign(std::string(trimmed(declaration.substr(0, colon))),
                          std::string(trimmed(declaration.substr(colon + 1))));
  }
  return read;
}

Rules read_rules(std::string_view style_sheet) {
  Rules rules;
  for (const std::string_view rule : split(style_sheet, '}')) {
    const std::size_t brace = rule.find('{');
    if (brace == std::string_view::npos) continue;
    for (const std::string_view part : split(rule.substr(0, brace), ',')) {
      const std::string selector(trimmed(part));
      if (selector == "@page") continue;  // of printers
      if (is_simple(selector))
        take_over(rules.of[selector], read_declarations(rule.substr(brace + 1)));
      else
        rules.others.push_back(selector);
    }
  }
  return rules;
}

std::string_view Style::of(std::string_view property) const {
  const auto found = properties.find(property);
  return found == properties.end() ? std::string_view() : std::string_view(found->second);
}

Style style_of(const pugi::xml_node& element, const Style& parent, const Rules& rules) {
  Style style = parent;
  for (const std::string_view name : drawn_properties) {
    const pugi::xml_attribute attribute = element.attribute(name.data());
    const bool fits_dashes = name == "stroke-dasharray" && !numbers_in(parent.of(name)).empty();
    if (attribute && !fits_dashes) style.properties.insert_or_assign(std::string(name), attribute.value());
  }
  const auto apply = [&](const std::string& selector) {
    if (const auto rule = rules.of.find(selector); rule != rules.of.end()) take_over(style.properties, rule->second);
  };
  apply(element.name());
  for (const std::string_view name : split(element.attribute("class").value(), ' ')) apply("." + std::string(name));
  apply("#" + std::string(element.attribute("id").value()));
  take_over(style.properties, read_declarations(element.attribute("style").value()));
  const pugi::xml_attribute dashes = element.attribute("stroke-dasharray");
  style.has_fitted_dashes = dashes && style.of("stroke-dasharray") == dashes.value();
  return style;
}

std::string colour_of(std::string_view text) {
  const std::string colour = to_lower(text);
  if (colour.empty() || colour == "black") return "#000000";
  if (colour.size() != 4 || colour[0] != '#') return colour;
  return {'#', colour[1], colour[1], colour[2], colour[2], colour[3], colour[3]};
}

std::vector<double> numbers_in(std::string_view text) {
  std::vector<double> numbers;
  while (true) {
    text.remove_prefix(std::min(text.find_first_not_of(" \t\r\n,"), text.size()));
    if (text.empty()) return numbers;
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc{}) return {};
    text.remove_prefix(static_cast<std::size_t>(end - text.data()));
    numbers.push_back(value);
  }
}

}  // namespace epura::svg
