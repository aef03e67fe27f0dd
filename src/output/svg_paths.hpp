// SPDX-License-Identifier: Apache-2.0
// The strokes of a layer as SVG <path> elements.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "base/progress.hpp"
#include "scene/choices.hpp"
#include "sheet/sheet.hpp"

namespace epura::output {

/// What holds of a whole document.
struct SvgDocument {
  double height;       ///< of the sheet, mm: SVG has y down
  int decimals;        ///< of a millimetre, of the coordinates of lines
  bool plain;          ///< one path for each dash pattern of a layer, without id and origin
  SvgText text;        ///< how lettering is written
  std::string prefix;  ///< of ids and classes, with its hyphen
};

/// Value of stroke-dasharray.
std::string dash_array(const sheet::Dashes& dashes);

/// The model that has all edges of the layer; nothing when there are several, or no edges.
std::optional<int> common_model(const sheet::Layer& layer);

/// About as many bytes as append_paths appends, rather more.
std::size_t most_bytes(const sheet::Layer& layer);

/// Appends one line of text for each stroke; of a plain document, for each dash pattern. The ids are numbers behind the
/// prefix, counted from `first_line` on. Throws OutOfTime.
void append_paths(std::string& svg, const sheet::Layer& layer, const SvgDocument& document, std::size_t first_line,
                  const Progress& progress);

}  // namespace epura::output
