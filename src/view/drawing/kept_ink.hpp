// SPDX-License-Identifier: Apache-2.0
// Parts of pieces that stay on paper, and parts that are removed because others lie near them.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <compare>
#include <cstddef>
#include <span>
#include <vector>

#include "base/nearest.hpp"
#include "base/progress.hpp"
#include "base/same_key.hpp"
#include "drawing/continuations.hpp"
#include "drawing/ink.hpp"
#include "drawing/ink_cells.hpp"
#include "search/occupied_cells.hpp"

namespace epura::drawing {

/// A part of a piece; `from` and `to` are 0 at the beginning of the piece and 1 at its end.
struct InkPart {
  int piece;
  double from, to;

  auto operator<=>(const InkPart&) const = default;
};

inline Vec2 place_on(const Piece& piece, double u) {
  return u <= 0 ? piece.from : u >= 1 ? piece.to : piece.from + u * (piece.to - piece.from);
}

inline Vec2 nearest_on(const std::array<Vec2, 2>& line, const Vec2& p) {
  return nearest_on_segment(p, line[0], line[1]);
}

/// False if the box of the line proves that it lies farther away, even with rounding.
inline bool may_be_within(const std::array<Vec2, 2>& line, const Vec2& p, double distance) {
  const double reach = distance * (1 + 0x1p-20) + 0x1p-20;
  return std::min(line[0].x, line[1].x) - p.x <= reach && p.x - std::max(line[0].x, line[1].x) <= reach &&
         std::min(line[0].y, line[1].y) - p.y <= reach && p.y - std::max(line[0].y, line[1].y) <= reach;
}

/// Parts of pieces in the order of addition, which can be found by their positions.
class InkParts {
 public:
  InkParts(const std::vector<Piece>& pieces, const Vec2& min, const Vec2& max, double cell)
      : pieces_(&pieces), cells_(min, max, cell) {}

  void add(const InkPart& part, int sector = 0) {
    const Piece& piece = (*pieces_)[part.piece];
    parts_.push_back(part);
    lines_.push_back({place_on(piece, part.from), place_on(piece, part.to)});
    cells_.add(lines_.back()[0], lines_.back()[1], sector);
  }

  [[nodiscard]] bool empty() const { return parts_.empty(); }
  [[nodiscard]] const std::vector<Piece>& pieces() const { return *pieces_; }
  [[nodiscard]] const std::vector<InkPart>& all() const { return parts_; }
  [[nodiscard]] const InkPart& operator[](int number) const { return parts_[static_cast<std::size_t>(number)]; }
  [[nodiscard]] const std::vector<std::array<Vec2, 2>>& lines() const { return lines_; }
  [[nodiscard]] const std::array<Vec2, 2>& line(int number) const { return lines_[static_cast<std::size_t>(number)]; }

  /// The cells within `margin` of a part; `side` is their least width.
  [[nodiscard]] search::OccupiedCells cells_within(double margin, double side) const {
    Vec2 min(HUGE_VAL), max(-HUGE_VAL);
    for (const auto& [from, to] : lines_) {
      min = glm::min(min, glm::min(from, to));
      max = glm::max(max, glm::max(from, to));
    }
    search::OccupiedCells cells(min - margin, max + margin, side);
    for (const auto& [from, to] : lines_) cells.add(from, to, margin);
    return cells;
  }

  /// Work like those of InkCells.
  [[nodiscard]] std::vector<int> find_in_any_order(const Vec2& from, const Vec2& to, double margin) const {
    return cells_.find_in_any_order(from, to, margin);
  }
  [[nodiscard]] std::vector<int> find(const Vec2& from, const Vec2& to, double margin,
                                      Sectors sectors = ~Sectors{}) const {
    std::vector<int> found = cells_.find(from, to, margin, sectors);
    for (const int number : found) __builtin_prefetch(&lines_[number]);
    return found;
  }

 private:
  const std::vector<Piece>* pieces_;
  InkCells cells_;
  std::vector<InkPart> parts_{};
  std::vector<std::array<Vec2, 2>> lines_{};
};

/// Whole pieces that can be found by their positions, of those whose number is `wanted`.
template <class Wanted>
InkParts parts_of(const std::vector<Piece>& pieces, const Wanted& wanted, double cell) {
  Vec2 min(HUGE_VAL), max(-HUGE_VAL);
  for (std::size_t i = 0; i < pieces.size(); ++i)
    if (wanted(i)) {
      min = glm::min(min, glm::min(pieces[i].from, pieces[i].to));
      max = glm::max(max, glm::max(pieces[i].from, pieces[i].to));
    }
  InkParts parts(pieces, min, max, cell);
  for (std::size_t i = 0; i < pieces.size(); ++i)
    if (wanted(i)) parts.add({static_cast<int>(i), 0, 1});
  return parts;
}

/// Calls visit(ends) with the ends of lines that lie in one point; line_at(i) are both ends of line i.
template <class LineAt, class Visit>
void visit_meetings(std::size_t lines, const LineAt& line_at, const Progress& progress, const Visit& visit) {
  const auto place = [&](End end) {
    const Vec2 at = line_at(line_of(end))[static_cast<std::size_t>(end % 2)];
    return std::array{std::round(at.x * 0x1p30), std::round(at.y * 0x1p30)};
  };
  visit_same_keys(2 * static_cast<int>(lines), place, progress, visit);
}

/// Parts that are removed, and for each the kept parts that are drawn instead.
struct TakenInk {
  std::vector<InkPart> parts{};
  std::vector<int> by{};
  std::vector<std::size_t> last{};  ///< by part: end of its kept parts in `by`

  [[nodiscard]] std::span<const int> kept_for(int part) const {
    const std::size_t first = part == 0 ? 0 : last[part - 1];
    return std::span(by).subspan(first, last[part] - first);
  }
};

}  // namespace epura::drawing
