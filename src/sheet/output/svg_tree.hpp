// SPDX-License-Identifier: Apache-2.0
// Roles and names for people who do not see a drawing: a view has its features, these have their lines and dimensions,
// dimensions have their texts. Ink stays in its layers; `aria-owns` says where it belongs. WAI-ARIA 1.2, WAI-ARIA
// Graphics Module 1.0.
#pragma once

#include <cstddef>
#include <span>
#include <string>

#include "sheet/sheet.hpp"

namespace epura::output {

/// The language of the names.
std::string language_of_names(const sheet::Sheet& sheet);

/// "visible line 30": an edge, and its length in space if it is known.
std::string name_of(const sheet::Stroke& stroke, const sheet::Layer& layer, const sheet::Sheet& sheet);

/// Role and name of a line.
void append_name(std::string& svg, const std::string& name);

/// The id of a text, by its number in the document; `prefix` as of SvgDocument.
std::string text_id(const std::string& prefix, std::size_t number);

/// Where the ids of a view begin.
struct FirstIds {
  std::size_t line, text;
};

/// Role and name of a view, or of the frame and title block, as attributes.
void append_view_name(std::string& svg, const sheet::Sheet& sheet, const std::string& view);

/// What a view has beside its ink: elements for features and dimensions. `layers` are all of it, in their order.
void append_tree(std::string& svg, const sheet::Sheet& sheet, std::span<const sheet::Layer* const> layers,
                 const std::string& prefix, FirstIds first);

}  // namespace epura::output
