// SPDX-License-Identifier: Apache-2.0
#include "drawing/near_prefilter.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "base/error.hpp"
#include "base/groups.hpp"
#include "base/parallel.hpp"
#include "drawing/beside.hpp"
#include "drawing/limits.hpp"
#include "search/choose_grid.hpp"

namespace epura::drawing {

namespace {

// With more pieces than this in a cell, a prefilter costs more than it saves.
constexpr std::size_t crowd_of_pieces = 96;

// A piece in a cell. Those that are taken last come first.
struct Entry {
  int turn, piece;
};

}  // namespace

/// The properties of a piece that are compared, apart from its ends.
struct NearPrefilter::Seen {
  std::array<float, 2> direction;
  int turn = -1;  ///< when it is taken
};

NearPrefilter::NearPrefilter(const std::vector<Piece>& pieces, const Polylines& polylines, const AlongLimits& limits,
                             const Progress& progress)
    : pieces_(&pieces) {
  const std::vector<std::size_t> ranked = polylines.by_rank();
  first_.reserve(ranked.size() + 1);
  first_.push_back(0);
  closed_.reserve(ranked.size());
  for (const std::size_t line : ranked) {
    first_.push_back(first_.back() + polylines[line].size());
    closed_.push_back(polylines.is_closed(line) ? 1 : 0);
  }
  members_.resize(first_.back());
  measure(polylines, ranked, limits, progress);
  find_last_along(limits, progress);
}

void NearPrefilter::measure(const Polylines& polylines, const std::vector<std::size_t>& ranked,
                            const AlongLimits& limits, const Progress& progress) {
  parallel_for(ranked.size(), grain::medium, progress, [&](std::size_t begin, std::size_t end) {
    for (std::size_t line = begin; line < end; ++line) {
      Member* member = members_.data() + first(line);
      double at = 0;
      for (const End entered : polylines[ranked[line]]) {
        const double from = at;
        at += length_of((*pieces_)[line_of(entered)]);
        *member++ = {entered, -1, from, at};
      }
      const MeasuredPolyline polyline = (*this)[line];
      for (std::size_t i = 0; i < polyline.size(); ++i)
        members_[first(line) + i].direction = polyline.direction_of(i, limits.with_direction(), limits.touching);
    }
  });
}

void NearPrefilter::find_last_along(const AlongLimits& limits, const Progress& progress) {
  const std::vector<Piece>& pieces = *pieces_;
  std::vector<Seen> seen(pieces.size());
  parallel_for(members_.size(), grain::medium, progress, [&](std::size_t begin, std::size_t end) {
    for (std::size_t turn = begin; turn < end; ++turn) {
      const Vec2& d = members_[turn].direction;
      seen[line_of(members_[turn].end)] = {{static_cast<float>(d.x), static_cast<float>(d.y)}, static_cast<int>(turn)};
    }
  });
  const double distance = limits.distance * (1 + on_line_part), least = limits.touching * (1 - on_line_part);
  const search::CellGrid grid =
      search::grid_over_lines(pieces, {static_cast<double>(pieces.size()) + 1, 4 * distance, cuts_a_piece, HUGE_VAL});
  // In the order of pieces, since neighbours in that order mostly lie side by side.
  const auto visit_pieces = [&](const auto& visit) {
    parallel_for(pieces.size(), grain::medium, progress, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i)
        if (seen[i].turn >= 0) visit(static_cast<int>(i));
    });
  };
  Groups<Entry> by_cell(static_cast<std::size_t>(grid.count()), [&](const auto& add) {
    visit_pieces([&](int piece) {
      search::visit_cells(grid, pieces[piece].from, pieces[piece].to, 0, [&](int cell, double, double) {
        add(static_cast<std::size_t>(cell), Entry{seen[piece].turn, piece});
      });
    });
  });
  parallel_for(by_cell.size(), grain::medium, progress, [&](std::size_t begin, std::size_t end) {
    for (std::size_t cell = begin; cell < end; ++cell)
      std::sort(by_cell[cell].begin(), by_cell[cell].end(),
                [](const Entry& a, const Entry& b) { return a.turn > b.turn; });
  });
  const auto run_along = [&](const Piece& piece, const Vec2& direction, int other) {
    const Vec2 facing(seen[other].direction[0], seen[other].direction[1]), step = piece.to - piece.from;
    if (std::abs(glm::dot(direction, facing)) < along_cosine - on_line_part) return false;
    const std::array line{pieces[other].from - piece.from, pieces[other].to - piece.from};
    const Interval range = Beside(direction, step, line, distance, steepest_along + on_line_part).range;
    return (range[1] - range[0]) * glm::length(step) > least;
  };
  visit_pieces([&](int piece) {
    const int turn = seen[piece].turn;
    Member& own = members_[static_cast<std::size_t>(turn)];
    search::visit_cells(grid, pieces[piece].from, pieces[piece].to, distance, [&](int cell, double, double) {
      const std::span<const Entry> others = std::as_const(by_cell)[static_cast<std::size_t>(cell)];
      if (others.size() > crowd_of_pieces) own.after = turn - 1;  // it may run along any of them
      auto other = std::partition_point(others.begin(), others.end(), [&](const Entry& e) { return e.turn >= turn; });
      while (other != others.end() && other->turn > own.after && !run_along(pieces[piece], own.direction, other->piece))
        ++other;
      if (other != others.end()) own.after = std::max(own.after, other->turn);
    });
    check(own.after < turn, "what a line may run along comes before it");
  });
}

}  // namespace epura::drawing
