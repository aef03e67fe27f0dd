// SPDX-License-Identifier: Apache-2.0
// What shows how a projection is made: points, lines and curves on paper with their symbols, in millimetres, y up.
#pragma once

#include <numbers>
#include <string>
#include <vector>

#include "base/vec.hpp"

namespace epura::construction {

/// A symbol as it is lettered, such as VP with the index x.
struct Symbol {
  std::string base{}, index{};

  /// "VP_x"
  [[nodiscard]] std::string text() const { return index.empty() ? base : base + "_" + index; }
  [[nodiscard]] bool empty() const { return base.empty(); }
  bool operator==(const Symbol&) const = default;
};

struct Point {
  Symbol symbol;
  Vec2 at;
  Vec2 guide{0, 0};            ///< another point of the line on which it lies, for the arrow to it from the sheet
  bool marked = true;          ///< false: the symbol alone is written there
  bool on_sheet = false;       ///< it does not stand for a point of space; no arrow leads to it
  std::vector<Symbol> also{};  ///< of other points in the same position
};

/// How far a line is drawn: between its points, beyond the second, or beyond both as far as the sheet has room.
enum class Extent { segment, ray, line };

struct Line {
  Vec2 from, to;
  Extent extent = Extent::segment;
  Symbol symbol{};
};

/// centre + cos(a) u + sin(a) v, where a runs from `from` to `to`. u is perpendicular to v.
struct Curve {
  Vec2 centre, u, v;
  double from = 0, to = 2 * std::numbers::pi;
  Symbol symbol{};
};

/// A row of the legend.
struct Term {
  std::string symbol, meaning;

  bool operator==(const Term&) const = default;
};

struct Figure {
  std::vector<Point> points{};
  std::vector<Line> lines{};
  std::vector<Curve> curves{};
  std::vector<Term> terms{};
  bool legend = false;         ///< the terms are asked for
  std::vector<Figure> keys{};  ///< figures of their own beside the view, of constant size around (0, 0)

  [[nodiscard]] bool empty() const { return points.empty() && lines.empty() && curves.empty() && keys.empty(); }
};

/// Adds a point unless there is one with this symbol; its symbol to that of a point in the same position if both are
/// marked.
void add_point(Figure& figure, Point point);
/// Adds a row of the legend unless it is there.
void add_term(Figure& figure, const std::string& symbol, const std::string& meaning);

/// Returns the ellipse through the ends of two conjugate radii, with its semi-axes, the longer first.
Curve ellipse_of(const Vec2& centre, const Vec2& p, const Vec2& q);

}  // namespace epura::construction
