// SPDX-License-Identifier: Apache-2.0
#include "svg/basic_shapes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "base/text.hpp"
#include "base/vec.hpp"

namespace epura::svg {

namespace {

constexpr std::array<std::pair<std::string_view, double>, 7> units = {
    {{"px", 1}, {"mm", 96 / 25.4}, {"cm", 960 / 25.4}, {"in", 96}, {"pt", 96.0 / 72}, {"pc", 16}, {"", 1}}};

constexpr std::array<std::pair<std::string_view, const char*>, 18> names = {{{"black", "#000000"},
                                                                             {"silver", "#c0c0c0"},
                                                                             {"gray", "#808080"},
                                                                             {"grey", "#808080"},
                                                                             {"white", "#ffffff"},
                                                                             {"maroon", "#800000"},
                                                                             {"red", "#ff0000"},
                                                                             {"purple", "#800080"},
                                                                             {"fuchsia", "#ff00ff"},
                                                                             {"green", "#008000"},
                                                                             {"lime", "#00ff00"},
                                                                             {"olive", "#808000"},
                                                                             {"yellow", "#ffff00"},
                                                                             {"navy", "#000080"},
                                                                             {"blue", "#0000ff"},
                                                                             {"teal", "#008080"},
                                                                             {"aqua", "#00ffff"},
                                                                             {"currentcolor", "#000000"}}};

/// Appends path data.
class Pen {
 public:
  Pen& operator()(char command, std::initializer_list<double> numbers) {
    data_ += command;
    for (const double number : numbers) {
      data_ += ' ';
      append_number(data_, number);
    }
    return *this;
  }
  std::string take() { return std::move(data_); }

 private:
  std::string data_;
};

std::string ellipse(const Vec2& c, const Vec2& r) {
  if (!(r.x > 0 && r.y > 0)) return {};
  Pen pen;
  pen('M', {c.x - r.x, c.y})('A', {r.x, r.y, 0, 1, 1, c.x + r.x, c.y})('A', {r.x, r.y, 0, 1, 1, c.x - r.x, c.y})('Z',
                                                                                                                 {});
  return pen.take();
}

std::string rectangle(const Vec2& at, const Vec2& size, Vec2 corner) {
  if (!(size.x > 0 && size.y > 0)) return {};
  corner = glm::min(corner, size / 2.0);
  const Vec2 end = at + size;
  Pen pen;
  if (!(corner.x > 0 && corner.y > 0)) {
    pen('M', {at.x, at.y})('H', {end.x})('V', {end.y})('H', {at.x})('Z', {});
    return pen.take();
  }
  const auto arc = [&](double x, double y) { pen('A', {corner.x, corner.y, 0, 0, 1, x, y}); };
  pen('M', {at.x + corner.x, at.y})('H', {end.x - corner.x});
  arc(end.x, at.y + corner.y);
  pen('V', {end.y - corner.y});
  arc(end.x - corner.x, end.y);
  pen('H', {at.x + corner.x});
  arc(at.x, end.y - corner.y);
  pen('V', {at.y + corner.y});
  arc(at.x + corner.x, at.y);
  pen('Z', {});
  return pen.take();
}

}  // namespace

std::optional<double> length_of(std::string_view text) {
  for (const auto& [unit, factor] : units) {
    if (!text.ends_with(unit)) continue;
    const auto number = parse_number(text.substr(0, text.size() - unit.size()));
    if (number && std::isfinite(*number)) return *number * factor;
  }
  return std::nullopt;
}

std::vector<std::string_view> split_lengths(std::string_view text) {
  constexpr std::string_view between = " ,\t\r\n";
  std::vector<std::string_view> parts;
  while (true) {
    text.remove_prefix(std::min(text.find_first_not_of(between), text.size()));
    if (text.empty()) return parts;
    const std::size_t end = std::min(text.find_first_of(between), text.size());
    parts.push_back(text.substr(0, end));
    text.remove_prefix(end);
  }
}

std::optional<Colour> named_colour(std::string_view text) {
  const std::string lower = to_lower(text);
  for (const auto& [name, value] : names)
    if (name == lower) return parse_colour(value);
  if (!lower.starts_with("rgb(") || !lower.ends_with(")")) return parse_colour(text);
  const auto parts = split_lengths(std::string_view(lower).substr(4, lower.size() - 5));
  std::vector<int> numbers;
  for (const std::string_view part : parts)
    if (const auto number = parse_number(part); number && *number >= 0 && *number <= 255)
      numbers.push_back(static_cast<int>(*number));
  if (parts.size() != 3 || numbers.size() != 3) return std::nullopt;
  return Colour{numbers[0], numbers[1], numbers[2]};
}

std::optional<std::string> path_of_shape(const pugi::xml_node& element,
                                         const std::function<double(const char*)>& length) {
  const std::string_view name = element.name();
  if (name == "path") return element.attribute("d").value();
  if (name == "circle") return ellipse({length("cx"), length("cy")}, Vec2(length("r")));
  if (name == "ellipse") return ellipse({length("cx"), length("cy")}, {length("rx"), length("ry")});
  if (name == "rect") {
    // One radius stands for both.
    const bool has_x = element.attribute("rx"), has_y = element.attribute("ry");
    const double rx = length(has_x ? "rx" : "ry"), ry = length(has_y ? "ry" : "rx");
    return rectangle({length("x"), length("y")}, {length("width"), length("height")}, {rx, ry});
  }
  if (name == "line") {
    Pen pen;
    pen('M', {length("x1"), length("y1")})('L', {length("x2"), length("y2")});
    return pen.take();
  }
  if (name == "polyline" || name == "polygon")
    return "M" + std::string(element.attribute("points").value()) + (name == "polygon" ? "Z" : "");
  return std::nullopt;
}

}  // namespace epura::svg
