// SPDX-License-Identifier: Apache-2.0
#include "drawing/piece_grid.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/parallel.hpp"
#include "visibility/choose_grid.hpp"

namespace epura {

namespace {

constexpr std::size_t grain = 1024;
constexpr double cells_for_piece = 0.5;
constexpr double cuts_of_piece = 8;
// A cell is crowded where a piece has more others near its line, on average.
constexpr std::size_t crowd = 256;

// Directions that differ by less count as one. It is more than single precision loses.
constexpr float one_direction = 1e-6F;

// The direction of a line without its sense. Upwards, from 0 to 2, it is measured around a square instead of a circle:
// by no more than the angle in radians, and by no less than half of that.
struct Direction {
  Vec2 along;
  float measure;

  explicit Direction(const Piece& p) : along((p.to - p.from) / length_of(p)) {
    if (along.y < 0 || (along.y == 0 && along.x < 0)) along = -along;
    const double x = along.x, y = along.y;
    measure = static_cast<float>(x >= 0 ? y / (x + y) : 1 - x / (y - x));
  }
};

}  // namespace

PieceGrid::PieceGrid(const std::vector<Piece>& pieces, double tolerance, float spread, const Progress& progress)
    : pieces_(pieces), tolerance_(tolerance), widest_(spread + 2 * one_direction) {
  grid_ =
      grid_over_lines(pieces, {cells_for_piece * static_cast<double>(pieces.size()), 16 * tolerance, cuts_of_piece, 0});
  radius_ = 0.5 * glm::length(grid_.side);
  fill(progress);
  find_crowds(progress);
  plant_trees(progress);
}

void PieceGrid::fill(const Progress& progress) {
  members_ = Groups<Member>(static_cast<std::size_t>(grid_.count()), [&](const auto& add) {
    parallel_for(pieces_.size(), grain, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) {
        const Piece& piece = pieces_[i];
        progress.expect_time();
        const Direction direction(piece);
        visit_cells(grid_, piece.from, piece.to, tolerance_, [&](int cell, double, double) {
          const Vec2 d = piece.from - grid_.middle(cell);
          const auto offset = static_cast<float>(direction.along.x * d.y - direction.along.y * d.x);
          add(static_cast<std::size_t>(cell), Member{direction.measure, offset, static_cast<int>(i)});
        });
      }
    });
  });
  parallel_for(cells(), grain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t cell = begin; cell < end; ++cell) {
      progress.expect_time();
      sort_cell(members_[cell]);
    }
  });
}

void PieceGrid::sort_cell(std::span<Member> members) {
  std::sort(members.begin(), members.end(), [](const Member& a, const Member& b) { return a.direction < b.direction; });
  for (std::size_t begin = 0, end = 0; begin < members.size(); begin = end) {
    const float first = members[begin].direction;
    for (; end < members.size() && members[end].direction - first < one_direction; ++end)
      members[end].direction = first;
    std::sort(members.begin() + begin, members.begin() + end,
              [](const Member& a, const Member& b) { return a.offset < b.offset; });
  }
}

std::size_t PieceGrid::end_of_direction(std::span<const Member> members, std::size_t begin) {
  std::size_t end = begin + 1;
  while (end < members.size() && members[end].direction == members[begin].direction) ++end;
  return end;
}

std::size_t PieceGrid::first_from(std::span<const Member> members, float direction) {
  const auto first = std::partition_point(members.begin(), members.end(),
                                          [&](const Member& member) { return member.direction < direction; });
  return static_cast<std::size_t>(first - members.begin());
}

// Those of one direction, in order of offset, whose lines may coincide with that of `a` somewhere in the cell.
std::span<const PieceGrid::Member> PieceGrid::near(const Member& a, std::span<const Member> others, float turn,
                                                   float side) const {
  const auto reach = static_cast<float>(4 * tolerance_ + 2 * radius_ * (turn + 4 * one_direction));
  const float offset = side * a.offset;
  if (others.size() == 1) {  // nearly always, where lines run in all directions
    const bool is_near = others[0].offset >= offset - reach && others[0].offset <= offset + reach;
    return is_near ? others : others.first(0);
  }
  const auto begin = std::lower_bound(others.begin(), others.end(), offset - reach,
                                      [](const Member& m, float x) { return m.offset < x; });
  const auto end =
      std::upper_bound(begin, others.end(), offset + reach, [](float x, const Member& m) { return x < m.offset; });
  return {begin, end};
}

// Pairs without any near are work, too.
bool PieceGrid::has_many_pairs(std::size_t cell) const {
  const std::size_t most = crowd * members_[cell].size();
  std::size_t pairs = 0;
  visit_directions(cell, [&](const Member& a, std::span<const Member> others, float turn, float side) {
    pairs += 1 + near(a, others, turn, side).size();
    return pairs <= most;
  });
  return pairs > most;
}

void PieceGrid::find_crowds(const Progress& progress) {
  std::vector<char> crowded(cells(), 0);
  parallel_for(cells(), grain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t cell = begin; cell < end; ++cell) {
      progress.expect_time();
      crowded[cell] = members_[cell].size() > crowd && has_many_pairs(cell) ? 1 : 0;
    }
  });
  if (std::find(crowded.begin(), crowded.end(), 1) == crowded.end()) return;
  crowded_ = std::move(crowded);
  in_crowd_.resize(pieces_.size(), 0);
  for (std::size_t cell = 0; cell < cells(); ++cell) {
    if (crowded_[cell] == 0) continue;
    for (const Member& member : members_[cell]) in_crowd_[member.piece] = 1;
  }
}

// Wherever a piece of a crowd runs.
void PieceGrid::plant_trees(const Progress& progress) {
  if (crowded_.empty()) return;
  tree_of_.assign(cells(), -1);
  std::vector<std::size_t> planted;
  for (std::size_t cell = 0; cell < cells(); ++cell) {
    const auto members = members_[cell];
    if (std::none_of(members.begin(), members.end(), [&](const Member& m) { return is_in_crowd(m.piece); })) continue;
    tree_of_[cell] = static_cast<int>(planted.size());
    planted.push_back(cell);
  }
  trees_.resize(planted.size());
  parallel_for(planted.size(), 1, progress, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      std::vector<int> members;
      for (const Member& member : members_[planted[i]]) members.push_back(member.piece);
      trees_[i] = PieceTree(pieces_, std::move(members), tolerance_, widest_);
    }
  });
}

}  // namespace epura
