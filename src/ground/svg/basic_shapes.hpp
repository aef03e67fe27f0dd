// SPDX-License-Identifier: Apache-2.0
// SVG values and basic shapes.
#pragma once

#include <functional>
#include <optional>
#include <pugixml.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "base/colour.hpp"

namespace epura::svg {

/// "3.5", "3.5px", "10pt", "2mm" ... in user units, of which an inch has 96. Nothing for other texts.
std::optional<double> length_of(std::string_view text);

/// The parts of a list separated by commas and blanks.
std::vector<std::string_view> split_lengths(std::string_view text);

/// "#rgb", "#rrggbb", "rgb(r, g, b)" or one of the 16 names of HTML 4.
std::optional<Colour> named_colour(std::string_view text);

/// Path data of a path, rect, line, polyline, polygon, circle or ellipse; nothing for other elements. `length` returns
/// the value of an attribute. SVG 1.1, 9.
std::optional<std::string> path_of_shape(const pugi::xml_node& element,
                                         const std::function<double(const char*)>& length);

}  // namespace epura::svg
