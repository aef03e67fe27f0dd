// SPDX-License-Identifier: Apache-2.0
// The <path> elements of an SVG layer: the paths that Cairo draws, put into millimetres.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "base/progress.hpp"
#include "output/canvas.hpp"
#include "sheet/sheet.hpp"

namespace epura {

/// Millimetres beside the lines: at most four decimals.
void append_millimetres(std::string& text, double value);

/// Value of stroke-dasharray.
std::string dash_array(const Dashes& dashes);
std::string dash_array(const Stroke& stroke);

/// The model that has all edges of the layer; nothing when there are several, or no edges.
std::optional<int> common_model(const Layer& layer);

/// Text that XML can hold, which has no way to write control characters.
std::string xml_text(std::string_view text);

/// Text of an element, and an attribute, in which nothing can be taken for markup.
void append_escaped(std::string& text, std::string_view value);
void append_attribute(std::string& text, std::string_view name, std::string_view value);

/// Whether there is anything to draw.
bool has_ink(const Layer& layer);

/// About as many bytes as append_paths appends, rather more.
std::size_t most_bytes(const Layer& layer);

/// How paths are written.
struct PathStyle {
  double height;           ///< of the sheet, mm: the paths have y down
  int decimals;            ///< of a millimetre
  bool plain;              ///< one path for each dash pattern, without id and origin
  std::size_t first_line;  ///< the strokes have the ids line_id(first_line), line_id(first_line + 1) ...
};

std::string line_id(std::size_t number);

/// Appends one line of text for each stroke; with PathStyle::plain, for each dash pattern.
/// Throws OutOfTime.
void append_paths(std::string& text, const Layer& layer, const Canvas& canvas, const PathStyle& style,
                  const Progress& progress);

}  // namespace epura
