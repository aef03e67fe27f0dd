// SPDX-License-Identifier: Apache-2.0
// The style of an SVG element: style sheets with class rules, attributes, and inheritance.
#pragma once

#include <map>
#include <optional>
#include <pugixml.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "compare/affine_map.hpp"

namespace epura::compare {

/// Of an attribute `transform`: matrix, translate, scale and rotate. Nothing for other text.
std::optional<AffineMap> read_svg_transform(std::string_view text);

/// Rules of one class each by the class; others do not count.
using SvgRules = std::map<std::string, std::map<std::string, std::string, std::less<>>, std::less<>>;

SvgRules read_svg_rules(std::string_view style_sheet);

/// Properties by name, those of the parents included.
struct SvgStyle {
  std::map<std::string, std::string, std::less<>> properties{};

  /// Empty where it is not set.
  [[nodiscard]] std::string_view of(std::string_view property) const;
  [[nodiscard]] bool is_shown() const { return of("display") != "none" && of("visibility") != "hidden"; }

  bool has_fitted_dashes = false;  ///< they are those of one line, and no style
};

/// The style of an element in a parent of such a style. Attributes count less than rules, these less than `style`. An
/// attribute stroke-dasharray inside dashed lines fits their dashes to a line, and leaves their style as it is.
SvgStyle style_of(const pugi::xml_node& element, const SvgStyle& parent, const SvgRules& rules);

/// "#1f7a3d", also of the short form and of nothing, which is black. Other words stay as they are.
std::string svg_colour(std::string_view text);

/// Numbers with spaces or commas between them; empty for "none" and what is not a list of numbers.
std::vector<double> svg_numbers(std::string_view text);

}  // namespace epura::compare
