// The <path> elements of an SVG layer: Cairo draws them, in pieces, and what it wrote is put into millimetres.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "output/canvas.hpp"
#include "sheet/sheet.hpp"

namespace epura {

/// Millimetres as SVG files have them: at most five decimals.
void append_millimetres(std::string& text, double value);

/// Value of stroke-dasharray.
std::string dash_array(const Dashes& dashes);
std::string dash_array(const Stroke& stroke);

/// Text that XML can hold, which has no way to write control characters.
std::string xml_text(std::string_view text);

/// Text of an element, and an attribute, in which nothing can be taken for markup.
void append_escaped(std::string& text, std::string_view value);
void append_attribute(std::string& text, std::string_view name, std::string_view value);

/// Whether there is anything to draw.
bool has_ink(const Layer& layer);

/// About as many bytes as append_paths appends, rather more.
std::size_t most_bytes(const Layer& layer, const std::string& id);

/// Appends one line of text for each stroke, its id beginning with `id`. `plain`: one for each dash pattern, without
/// id and origin. `height` of the sheet in mm: the paths have y down.
void append_paths(std::string& text, const Layer& layer, const Canvas& canvas, double height, const std::string& id,
                  bool plain);

}  // namespace epura
