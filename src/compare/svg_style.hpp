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

/// Parses the attribute `transform`: matrix, translate, scale and rotate. Nothing for other text.
std::optional<AffineMap> read_svg_transform(std::string_view text);

/// Rules for a single class, by class; others are ignored.
using SvgRules = std::map<std::string, std::map<std::string, std::string, std::less<>>, std::less<>>;

SvgRules read_svg_rules(std::string_view style_sheet);

/// Properties by name, including those of the parents.
struct SvgStyle {
  std::map<std::string, std::string, std::less<>> properties{};

  /// Empty if it is not set.
  [[nodiscard]] std::string_view of(std::string_view property) const;
  [[nodiscard]] bool is_shown() const { return of("display") != "none" && of("visibility") != "hidden"; }

  bool has_fitted_dashes = false;  ///< the dashes are those of a single line, not of the style
};

/// The style of an element whose parent has the given style. Attributes are overridden by rules, and these by `style`.
/// An attribute stroke-dasharray inside dashed lines fits their dashes to a line, and leaves their style as it is.
SvgStyle style_of(const pugi::xml_node& element, const SvgStyle& parent, const SvgRules& rules);

/// "#1f7a3d", also for the short form; black if the text is empty. Other words are returned unchanged.
std::string svg_colour(std::string_view text);

/// Numbers separated by spaces or commas; empty for "none" and for text that is not a list of numbers.
std::vector<double> svg_numbers(std::string_view text);

}  // namespace epura::compare
