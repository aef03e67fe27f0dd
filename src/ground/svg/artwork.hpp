// SPDX-License-Identifier: Apache-2.0
// Drawings by other programs (such as Inkscape) as lines, areas and texts in millimetres: frames of sheets, logos.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "base/colour.hpp"
#include "base/vec.hpp"
#include "svg/path.hpp"

namespace epura::svg {

/// Lines, or an area filled by the even-odd rule. Curves are lines; mm, y up from the lower left corner.
struct Shape {
  std::vector<Line> lines;
  std::optional<Colour> fill{}, stroke{};
  double width = 0;              ///< of the stroke, mm
  std::vector<double> dashes{};  ///< ink, gap, ink, gap ...; mm
};

enum class TextAnchor { start, middle, end };

/// A line of text.
struct Words {
  std::string text;
  Vec2 at{0, 0};     ///< on the base line
  double size = 0;   ///< of the font (its em), mm
  double angle = 0;  ///< of the base line, degrees counterclockwise
  TextAnchor anchor = TextAnchor::start;
  Colour colour{};
  std::string name{};     ///< as of Area, or of the field; empty if it has none
  bool is_field = false;  ///< it is declared a field, as FreeCAD does: freecad:editable, freecad:autofill
  std::string where{};    ///< "frame.svg:12"
};

/// An element with a name: its label in Inkscape, or its id; lower case, with _ for blanks and hyphens. Or what a
/// comment of FreeCAD's templates states: drawing_area for "Working space", title_block.
struct Area {
  std::string name;
  Vec2 min, max;
};

struct Artwork {
  Vec2 size{0, 0};                                  ///< mm
  std::vector<std::variant<Shape, Words>> items{};  ///< in painting order
  std::vector<Area> areas{};                        ///< those that were asked for
  std::vector<std::string> warnings{};  ///< sentences with a place: what is drawn otherwise than it is meant
};

/// Reads an SVG file: groups, paths, rectangles, lines, polygons, circles, ellipses and texts, with their transforms
/// and styles. Gradients are drawn in their middle colour, transparent colours as they are on white paper. `areas` are
/// the names of elements whose places are wanted. Throws Error{input}, with the line, for everything else that would be
/// seen, for scripts and for references.
Artwork read_artwork(std::string_view bytes, const std::string& where, std::span<const std::string_view> areas = {});

}  // namespace epura::svg
