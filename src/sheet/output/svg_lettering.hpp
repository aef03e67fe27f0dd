// SPDX-License-Identifier: Apache-2.0
// Pictures, filled areas and texts of an SVG layer.
#pragma once

#include <string>
#include <string_view>

#include "output/svg_paths.hpp"
#include "sheet/lettering.hpp"
#include "sheet/sheet.hpp"

namespace epura::output {

/// A name in the form allowed for ids and classes.
std::string identifier(std::string_view name);

/// Appends the pictures, each with its bytes.
void append_pictures(std::string& svg, const sheet::Layer& layer, const SvgDocument& document);

/// Appends a line of text for each area, in a group.
void append_fills(std::string& svg, const sheet::Layer& layer, const SvgDocument& document);

/// Appends a line of text for each text, in a group. Outlines have their text as `aria-label`. `first_text`: how many
/// texts the document has before.
void append_texts(std::string& svg, const sheet::Layer& layer, const SvgDocument& document,
                  const sheet::Lettering& lettering, std::size_t first_text);

}  // namespace epura::output
