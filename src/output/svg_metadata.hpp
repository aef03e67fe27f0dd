// SPDX-License-Identifier: Apache-2.0
// Title, description and metadata of an SVG document, as Inkscape shows them under Document Properties.
#pragma once

#include <pugixml.hpp>

#include "sheet/sheet.hpp"

namespace epura {

/// Appends <title>, <desc> and <metadata>: RDF with the elements of Dublin Core, as Creative Commons' works have them.
void add_svg_metadata(pugi::xml_node svg, const Sheet& sheet);

}  // namespace epura
