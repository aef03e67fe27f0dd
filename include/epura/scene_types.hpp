// SPDX-License-Identifier: Apache-2.0
// Values of the parts of a scene that are more than a number, a text or a word.
#pragma once

#include <array>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace epura {

/// A surface in memory. Shared points are given once; faces have three or more corners, which are indices of points,
/// counterclockwise as seen from outside.
struct Polygons {
  std::vector<std::array<double, 3>> points{};
  std::vector<std::vector<int>> faces{};
  std::vector<int> bodies{};                  ///< by face: the number of its body; empty: connected faces are a body
  std::vector<std::string> body_names{};      ///< by body, for styles and layers; needed with `bodies`
  std::vector<std::vector<int>> polylines{};  ///< lines that bound no face: two or more indices of points each
  bool single_precision = false;              ///< points were rounded to 32 bits, which widens the contact tolerance
};

/// Position of a model, applied after unit and axis: steps such as "rotate:z,30 translate:0,0,5", or the first three
/// rows of an affine matrix for column vectors.
using Transform = std::variant<std::string, std::array<double, 12>>;

/// A number, several numbers, or a word.
using ParameterValue = std::variant<double, std::vector<double>, std::string>;

/// A part of a view that is left out, between two places on an axis of the world (0: x, 1: y, 2: z); infinite: up to
/// the end of the view.
struct Break {
  int axis = 0;
  double from = 0, to = 0;
};

/// A model and a vertex of it, both counted from 0; or a point of the world; or a feature of the only model, "hole 3".
using DimensionAnchor = std::variant<std::array<int, 2>, std::array<double, 3>, std::string>;

/// Where a leader ends: likewise on the models; or on the sheet, mm from its lower left corner.
using LeaderTarget = std::variant<std::array<int, 2>, std::array<double, 3>, std::array<double, 2>, std::string>;

/// Largest scale that fits, largest standard scale that fits (ISO 5455), or millimetres on paper per unit.
enum class AutomaticScale { fit, standard };
using Scale = std::variant<AutomaticScale, double>;

/// ISO 216 size, "A4" to "A0", or ASME Y14.1 size, "ANSI-A" to "ANSI-E"; cut to the drawing; the smallest of these
/// sizes that fits at the given scale; or width and height in mm.
enum class AutomaticSize { cut, smallest };
using PaperSize = std::variant<std::string, AutomaticSize, std::array<double, 2>>;

/// Title block fields by the names in docs/scenes.md ("title", "owner", "number", "date" ...) or any other name.
using TitleBlock = std::vector<std::pair<std::string, std::string>>;

}  // namespace epura
