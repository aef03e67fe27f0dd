// What an element of SVG looks like: style sheets with rules for classes, attributes, and what is inherited.
#pragma once

#include <map>
#include <optional>
#include <pugixml.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "base/vec.hpp"

namespace epura {

/// x' = along * x + across * y + shift. SVG 1.1, 7.4.
struct SvgMap {
  Vec2 along{1, 0}, across{0, 1}, shift{0, 0};

  [[nodiscard]] Vec2 operator()(const Vec2& p) const { return along * p.x + across * p.y + shift; }
  /// First `inner`, then this.
  [[nodiscard]] SvgMap after(const SvgMap& inner) const;
  /// By how much it enlarges lengths, on average.
  [[nodiscard]] double scale() const;
};

/// Of an attribute `transform`: matrix, translate, scale and rotate. Nothing for other text.
std::optional<SvgMap> read_svg_transform(std::string_view text);

/// Rules of one class each by the class; others do not count.
using SvgRules = std::map<std::string, std::map<std::string, std::string, std::less<>>, std::less<>>;

SvgRules read_svg_rules(std::string_view style_sheet);

/// Properties by name, those of the parents included.
struct SvgStyle {
  std::map<std::string, std::string, std::less<>> properties{};

  /// Empty where it is not set.
  [[nodiscard]] std::string_view of(std::string_view property) const;
  [[nodiscard]] bool is_shown() const { return of("display") != "none" && of("visibility") != "hidden"; }
};

/// The style of an element in a parent of such a style. Attributes count less than rules, these less than `style`. An
/// attribute stroke-dasharray inside dashed lines fits their dashes to a line, and leaves their style as it is.
SvgStyle style_of(const pugi::xml_node& element, const SvgStyle& parent, const SvgRules& rules);

/// Numbers with spaces or commas between them; empty for "none" and what is no list of numbers.
std::vector<double> svg_numbers(std::string_view text);

}  // namespace epura
