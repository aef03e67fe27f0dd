// SPDX-License-Identifier: Apache-2.0
// The style of an SVG element: style sheets with class rules, attributes, and inheritance.
#pragma once

#include <map>
#include <optional>
#include <pugixml.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "svg/affine_map.hpp"

namespace epura::svg {

/// Parses the attribute `transform`: matrix, translate, scale and rotate. Nothing for other text.
std::optional<AffineMap> read_transform(std::string_view text);

/// Values by property.
using Declarations = std::map<std::string, std::string, std::less<>>;

struct Rules {
  std::map<std::string, Declarations, std::less<>> of{};  ///< by selector: an element, a class (".x") or an id ("#x")
  std::vector<std::string> others{};                      ///< selectors of other forms, whose rules are not here

  void merge(Rules more);
};

/// "stroke: #000; fill: none".
Declarations read_declarations(std::string_view text);

Rules read_rules(std::string_view style_sheet);

/// Properties by name, including those of the parents.
struct Style {
  Declarations properties{};

  /// Empty if it is not set.
  [[nodiscard]] std::string_view of(std::string_view property) const;
  [[nodiscard]] bool is_shown() const { return of("display") != "none" && of("visibility") != "hidden"; }

  bool has_fitted_dashes = false;  ///< the dashes are those of a single line, not of the style
};

/// The style of an element whose parent has the given style. Attributes are overridden by rules, and these by `style`.
/// An attribute stroke-dasharray inside dashed lines fits their dashes to a line, and leaves their style as it is.
Style style_of(const pugi::xml_node& element, const Style& parent, const Rules& rules);

/// "#1f7a3d", also for the short form; black if the text is empty. Other words are returned unchanged.
std::string colour_of(std::string_view text);

/// Numbers separated by spaces or commas; empty for "none" and for text that is not a list of numbers.
std::vector<double> numbers_in(std::string_view text);

}  // namespace epura::svg
