// SPDX-License-Identifier: Apache-2.0
#include "study/accuracy/ink_distance.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "base/nearest.hpp"
#include "search/lines_at.hpp"

namespace epura::study {

namespace {

constexpr double precision = 1e-3;
constexpr double negligible = 1e-9;  // mm; smaller differences are ignored

double distance_to(const InkLine& line, const Vec2& p) { return distance_to_segment(p, line.from, line.to); }

/// Ink by cells of the paper.
class InkGrid {
 public:
  explicit InkGrid(const std::vector<InkLine>& ink) : ink_(ink), cells_(lines_of(ink), negligible) {}

  struct Nearest {
    double distance = HUGE_VAL;
    InkLine line{};
  };

  /// Examines rings of cells around the point until no farther ring can contain anything closer.
  [[nodiscard]] Nearest nearest(const Vec2& place) const {
    const search::CellGrid& grid = cells_.grid();
    const int column = grid.column(place.x), row = grid.row(place.y);
    Nearest nearest;
    for (int ring = 0; ring <= std::max(grid.columns, grid.rows); ++ring) {
      if (ring > 0 && (ring - 1) * std::min(grid.side.x, grid.side.y) > nearest.distance) break;
      visit_ring(column, row, ring, [&](int cell) {
        for (const int i : cells_.in_cell(cell)) {
          const InkLine& line = ink_[i];
          const double distance = distance_to(line, place);
          if (distance < nearest.distance) nearest = {distance, line};
        }
      });
    }
    return nearest;
  }

 private:
  static std::vector<search::LinesAt::Line> lines_of(const std::vector<InkLine>& ink) {
    std::vector<search::LinesAt::Line> lines;
    for (const InkLine& line : ink) lines.push_back({line.from, line.to});
    return lines;
  }

  template <class Visit>
  void visit_ring(int column, int row, int ring, const Visit& visit_one) const {
    const search::CellGrid& grid = cells_.grid();
    for (int r = std::max(row - ring, 0); r <= std::min(row + ring, grid.rows - 1); ++r) {
      const bool whole = r == row - ring || r == row + ring;
      for (int c = column - ring; c <= column + ring; c += whole || ring == 0 ? 1 : 2 * ring)
        if (c >= 0 && c < grid.columns) visit_one(grid.cell(c, r));
    }
  }

  const std::vector<InkLine>& ink_;
  search::LinesAt cells_;
};

// Distance changes no faster than position, and the distance from one line of ink is greatest at an end of another
// line.
double farthest(const InkGrid& grid, const InkLine& line, double known) {
  const Vec2 middle = 0.5 * line.from + 0.5 * line.to;
  const InkGrid::Nearest nearest = grid.nearest(middle);
  const double best = std::max(known, nearest.distance);
  const double from_ends = std::max(distance_to(nearest.line, line.from), distance_to(nearest.line, line.to));
  const double from_middle = nearest.distance + 0.5 * glm::distance(line.from, line.to);
  if (std::min(from_ends, from_middle) <= std::max(best * (1 + precision), negligible)) return best;
  return farthest(grid, {middle, line.to}, farthest(grid, {line.from, middle}, best));
}

// A piece of a line by its middle.
struct MeasuredPiece {
  double distance, length;
};

std::vector<MeasuredPiece> pieces_of(const std::vector<InkLine>& lines, const std::vector<InkLine>& ink) {
  constexpr double shortest = 0.5;  // mm
  const InkGrid grid(ink);
  std::vector<MeasuredPiece> pieces;
  for (const InkLine& line : lines) {
    const double length = glm::distance(line.from, line.to);
    const int parts = std::max(1, static_cast<int>(length / shortest));
    for (int i = 0; i < parts; ++i)
      pieces.push_back(
          {grid.nearest(line.from + (line.to - line.from) * ((i + 0.5) / parts)).distance, length / parts});
  }
  return pieces;
}

}  // namespace

double farthest_from_ink(const std::vector<InkLine>& lines, const std::vector<InkLine>& ink) {
  if (lines.empty()) return 0;
  if (ink.empty()) return HUGE_VAL;
  const InkGrid grid(ink);
  double known = 0;
  for (const InkLine& line : lines) known = farthest(grid, line, known);
  return known;
}

double distance_of_share(const std::vector<InkLine>& lines, const std::vector<InkLine>& ink, double share) {
  std::vector<MeasuredPiece> pieces = pieces_of(lines, ink);
  std::sort(pieces.begin(), pieces.end(),
            [](const MeasuredPiece& a, const MeasuredPiece& b) { return a.distance < b.distance; });
  double whole = 0, within = 0;
  for (const MeasuredPiece& piece : pieces) whole += piece.length;
  for (const MeasuredPiece& piece : pieces)
    if ((within += piece.length) >= share * whole) return piece.distance;
  return pieces.empty() ? 0 : pieces.back().distance;
}

double length_beyond(const std::vector<InkLine>& lines, const std::vector<InkLine>& ink, double most) {
  double beyond = 0;
  for (const MeasuredPiece& piece : pieces_of(lines, ink)) beyond += piece.distance > most ? piece.length : 0;
  return beyond;
}

}  // namespace epura::study
