// SPDX-License-Identifier: Apache-2.0
// SVG path data. SVG 1.1, 8.3.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "base/vec.hpp"
#include "svg/flatten.hpp"

namespace epura::svg {

/// An unbroken line; a closed one does not repeat its first point.
struct Line {
  std::vector<Vec2> points;
  bool closed = false;
};

struct Path {
  std::vector<Line> lines{};     ///< curves as lines
  std::vector<Vec2> controls{};  ///< control points of Bezier curves
};

/// The commands M L H V C Q A Z and m l h v c q a z, y down. Nothing if the text is not such a path. Throws
/// Error{input} if it is too long.
std::optional<Path> read_path(std::string_view data, PieceRoom& room);

}  // namespace epura::svg
