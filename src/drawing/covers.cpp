// SPDX-License-Identifier: Apache-2.0
#include "drawing/covers.hpp"

#include <algorithm>
#include <cstddef>
#include <mutex>
#include <utility>

#include "base/parallel.hpp"
#include "drawing/piece_grid.hpp"
#include "visibility/spans.hpp"

namespace epura {

namespace {

constexpr std::size_t grain = 1024;

struct Limits {
  double tolerance, least;
};

// Every pair in a cell is tried. Of pieces in crowds, it is not this that finds the covers.
void add_covers_of_pairs(const std::vector<Piece>& pieces, const PieceGrid& grid, std::size_t cell,
                         const Limits& limits, std::vector<Cover>& covers) {
  grid.near_pairs(cell, [&](int a, int b) {
    if (rank(pieces[a]) < rank(pieces[b])) std::swap(a, b);
    if (grid.is_in_crowd(a) || !(rank(pieces[b]) < rank(pieces[a]))) return;
    const Ruler line(pieces[a].from, pieces[a].to);
    const auto [from, to] = covered_part(line, pieces[b].from, pieces[b].to, limits.tolerance, limits.least);
    // Pairs meet in several cells. The one where the cover begins counts.
    if (to > from && grid.cell_of(line.from + from * line.along) == cell) covers.push_back({a, from, to});
  });
}

// In a crowd a piece is covered bit by bit, until nothing is left to be covered.
void add_covers_in_crowd(const std::vector<Piece>& pieces, const PieceGrid& grid, int piece, const Limits& limits,
                         std::vector<Cover>& covers) {
  const Ruler line(pieces[piece].from, pieces[piece].to);
  Spans covered;
  grid.visit_trees(piece, [&](const PieceTree& tree, double begin, double end) {
    const auto open = [&] {
      return open_part(covered, begin * line.length, end * line.length, limits.least, line.length);
    };
    auto rest = open();
    if (!rest) return;
    PieceTree::Bounds wanted = tree.covering(piece, *rest);
    tree.visit(wanted, [&](int upper) {
      const auto part = covered_part(line, pieces[upper].from, pieces[upper].to, limits.tolerance, limits.least);
      if (!(part[1] > part[0])) return true;
      add_span(covered, part);
      rest = open();
      if (rest) wanted = tree.covering(piece, *rest);
      return rest.has_value();
    });
  });
  for (const auto& [from, to] : covered) covers.push_back({piece, from, to});
}

using Parts = std::vector<std::vector<Cover>>;

Parts covers_in_parts(const std::vector<Piece>& pieces, double tolerance, double least, const Progress& progress) {
  // Two lines that stay within the tolerance over `least` differ in direction by no more than this.
  const auto spread = static_cast<float>(std::min(2.5 * tolerance / least, 1.5));
  const PieceGrid grid(pieces, tolerance, spread, progress);
  progress.begin("merging lines", grid.cells() + pieces.size());
  const Limits limits{tolerance, least};
  Parts parts;
  std::mutex adding;
  const auto in_parallel = [&](std::size_t count, const auto& add) {
    parallel_for(count, grain, [&](std::size_t begin, std::size_t end) {
      std::vector<Cover> found;
      for (std::size_t i = begin; i < end; ++i) {
        progress.expect_time();
        add(i, found);
      }
      found.shrink_to_fit();
      progress.advance(end - begin);
      const std::lock_guard lock(adding);
      parts.push_back(std::move(found));
    });
  };
  in_parallel(grid.cells(), [&](std::size_t cell, std::vector<Cover>& found) {
    if (!grid.is_crowded(cell)) add_covers_of_pairs(pieces, grid, cell, limits, found);
  });
  in_parallel(pieces.size(), [&](std::size_t piece, std::vector<Cover>& found) {
    const int number = static_cast<int>(piece);
    if (grid.is_in_crowd(number)) add_covers_in_crowd(pieces, grid, number, limits, found);
  });
  return parts;
}

}  // namespace

std::vector<Cover> find_covers(const std::vector<Piece>& pieces, double tolerance, double least,
                               const Progress& progress) {
  if (pieces.empty()) return {};
  Parts parts = covers_in_parts(pieces, tolerance, least, progress);
  std::size_t count = 0;
  for (const std::vector<Cover>& part : parts) count += part.size();
  std::vector<Cover> covers;
  covers.reserve(count);
  for (std::vector<Cover>& part : parts) {
    covers.insert(covers.end(), part.begin(), part.end());
    part = std::vector<Cover>();  // so that covers are hardly ever there twice
  }
  parallel_sort(covers.begin(), covers.end());
  return covers;
}

}  // namespace epura
