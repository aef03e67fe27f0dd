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

/// Properties of a whole document.
struct SvgDocument {
  double height;         ///< of the sheet, mm: SVG has y down
  int decimals;          ///< decimals of a millimetre in the coordinates of lines
  bool plain;            ///< one path for each dash pattern of a layer, without id and origin
  SvgText text;          ///< how lettering is written
  std::string prefix;    ///< of ids and classes, including its hyphen
  bool in_html = false;  ///< no names for Inkscape, but roles for screen readers
  /// The sheet, if this is part of a page of its own: no ids, and the facts of lines.
  const sheet::Sheet* page = nullptr;
  /// The sheet, if its lines have names and its texts ids: what svg_tree.hpp refers to.
  const sheet::Sheet* named = nullptr;
  bool lines = true;      ///< whether layers of edges have their lines
  std::size_t spare = 0;  ///< bytes that a line of a page may be longer than the bound on it
};

/// Value of stroke-dasharray.
std::string dash_array(const sheet::Dashes& dashes);

/// The common model of all edges of the layer; nothing if there are several, or no edges.
std::optional<int> common_model(const sheet::Layer& layer);

/// Upper estimate of the number of bytes that append_paths appends.
std::size_t max_bytes(const sheet::Layer& layer);

/// Appends one line of text for each stroke; in a plain document, for each dash pattern. The ids are the prefix and a
/// number, counted from `first_line`. Throws OutOfTime.
void append_paths(std::string& svg, const sheet::Layer& layer, const SvgDocument& document, std::size_t first_line,
                  const Progress& progress);

}  // namespace epura::output
