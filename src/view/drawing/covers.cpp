// SPDX-License-Identifier: Apache-2.0
#include "drawing/covers.hpp"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <utility>

#include "base/error.hpp"
#include "base/parallel.hpp"
#include "drawing/piece_tree.hpp"
#include "drawing/strands.hpp"
#include "visibility/spans.hpp"

namespace epura::drawing {

namespace {

// A cell that cannot be divided and contains more ends of strands than this is a crowd: many of its strands lie on one
// line.
constexpr std::ptrdiff_t crowd_of_ends = 128;

bool is_crowd(const Strands& strands) {
  return std::count_if(strands.begin(), strands.end(), [](const Strand& s) { return s.begins || s.ends; }) >
         crowd_of_ends;
}

// Cells with more strands are searched on several threads.
constexpr std::size_t alone = 4096;

class CoverSearch {
 public:
  CoverSearch(const std::vector<Piece>& pieces, double tolerance, double min, const Progress& progress,
              Order has_higher_rank)
      : pieces_(pieces),
        tolerance_(tolerance),
        min_(min),
        // Two lines within the tolerance of each other over `min` differ in direction by at most this.
        spread_(std::min(2.5 * tolerance / min, 1.5)),
        progress_(progress),
        has_higher_rank_(has_higher_rank),
        directions_(pieces, spread_, progress) {}

  std::vector<Cover> find() const {
    progress_.begin("merging lines", pieces_.size());
    std::vector<std::vector<Cover>> found(directions_.size());
    const std::size_t grain = pieces_.size() > alone ? 1 : std::max<std::size_t>(directions_.size(), 1);
    parallel_for(directions_.size(), grain, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) {
        Strands strands = directions_.strands(i);
        const auto own = std::count_if(strands.begin(), strands.end(), [](const Strand& s) { return !s.is_guest; });
        add_covers(std::move(strands), static_cast<std::size_t>(own), found[i]);
      }
    });
    return joined(found);
  }

 private:
  static std::vector<Cover> joined(std::vector<std::vector<Cover>>& parts) {
    std::size_t count = 0;
    for (const std::vector<Cover>& part : parts) count += part.size();
    std::vector<Cover> all;
    all.reserve(count);
    for (std::vector<Cover>& part : parts) {
      all.insert(all.end(), part.begin(), part.end());
      part = std::vector<Cover>();  // so that memory hardly ever holds covers twice
    }
    return all;
  }

  // `work` is the amount of progress to report.
  void add_covers(Strands strands, std::size_t work, std::vector<Cover>& found) const {
    progress_.expect_time();
    auto parts = divide(strands, tolerance_, directions_.go_along());
    if (!parts) {
      progress_.advance(work);
      return is_crowd(strands) ? add_covers_in_crowd(strands, found) : add_covers_of_pairs(strands, found);
    }
    const bool is_large = strands.size() > alone;
    strands = Strands();  // so that memory hardly ever holds strands twice
    Strands &one = parts->first, &other = parts->second;
    check(one.size() + other.size() > 0, "a cell that is divided has lines");
    const std::size_t first = work * one.size() / (one.size() + other.size());
    if (!is_large) {
      add_covers(std::move(one), first, found);
      return add_covers(std::move(other), work - first, found);
    }
    std::vector<Cover> others;
    parallel_both([&] { add_covers(std::move(one), first, found); },
                  [&] { add_covers(std::move(other), work - first, others); });
    found.insert(found.end(), others.begin(), others.end());
  }

  // Compares those that begin here, which are few, with all others.
  void add_covers_of_pairs(Strands& strands, std::vector<Cover>& found) const {
    const auto can_begin = [&](const Strand& s) { return s.begins || (s.ends && !directions_.go_along()); };
    const auto rest = std::partition(strands.begin(), strands.end(), can_begin);
    for (auto a = strands.begin(); a != rest; ++a)
      for (auto b = a + 1; b != strands.end(); ++b) {
        if ((a->is_guest && b->is_guest) || !begin_together(*a, *b) || !are_near(*a, *b)) continue;
        const bool is_a_lower = has_higher_rank_(pieces_[b->piece], pieces_[a->piece]);
        add_cover(is_a_lower ? a->piece : b->piece, is_a_lower ? b->piece : a->piece, found);
      }
  }

  // Whether their overlap begins in the cell: a pair that meets in several cells counts only there.
  [[nodiscard]] bool begin_together(const Strand& a, const Strand& b) const {
    if (!directions_.go_along()) return a.begins || a.ends || b.begins || b.ends;
    const double margin = 2 * tolerance_, ahead = a.from.x - b.from.x;
    return (a.begins && ahead >= -margin) || (b.begins && ahead <= margin);
  }

  [[nodiscard]] bool are_near(const Strand& a, const Strand& b) const {
    const double margin = 2 * tolerance_;
    const auto [a_low, a_high] = std::minmax(a.from.y, a.to.y);
    const auto [b_low, b_high] = std::minmax(b.from.y, b.to.y);
    if (a.from.x > b.to.x + margin || b.from.x > a.to.x + margin || a_low > b_high + margin || b_low > a_high + margin)
      return false;
    if (!directions_.go_along()) return true;
    // Compares them where their overlap begins and where it ends.
    return (a.from.x < b.from.x ? is_beside(a, b.from) : is_beside(b, a.from)) &&
           (a.to.x > b.to.x ? is_beside(a, b.to) : is_beside(b, a.to));
  }

  // Whether a point lies near the line through a strand.
  [[nodiscard]] bool is_beside(const Strand& s, const Vec2& p) const {
    const Vec2 along = s.to - s.from, d = p - s.from;
    const double turn = cross(along, d), margin = 2 * tolerance_;
    return turn * turn <= margin * margin * glm::dot(along, along);
  }

  void add_cover(int lower, int upper, std::vector<Cover>& found) const {
    const Piece &low = pieces_[lower], &high = pieces_[upper];
    if (!has_higher_rank_(high, low)) return;
    const auto [from, to] = covered_part(Ruler(low.from, low.to), high.from, high.to, tolerance_, min_);
    if (to > from) found.push_back({lower, from, to});
  }

  // In a crowd, a piece is covered step by step until nothing that could be covered remains: no pair is skipped that
  // would have changed the remainder. The whole piece counts, not its part in the cell, since covers that begin in the
  // cell are found nowhere else.
  void add_covers_in_crowd(const Strands& strands, std::vector<Cover>& found) const {
    std::vector<int> members;
    for (const Strand& s : strands) members.push_back(s.piece);
    const PieceTree tree(pieces_, std::move(members), tolerance_, spread_, has_higher_rank_);
    for (const Strand& s : strands) {
      progress_.expect_time();
      for (const auto& [from, to] : parts_covered(tree, s.piece)) found.push_back({s.piece, from, to});
    }
  }

  [[nodiscard]] visibility::Spans parts_covered(const PieceTree& tree, int piece) const {
    const Ruler line(pieces_[piece].from, pieces_[piece].to);
    visibility::Spans covered;
    const auto open = [&] { return visibility::open_part(covered, 0, line.length, min_, line.length); };
    auto rest = open();
    if (!rest) return covered;
    PieceTree::Bounds wanted = tree.covering(piece, *rest);
    tree.visit(wanted, [&](int upper) {
      const auto part = covered_part(line, pieces_[upper].from, pieces_[upper].to, tolerance_, min_);
      if (!(part[1] > part[0])) return true;
      visibility::add_span(covered, part);
      rest = open();
      if (rest) wanted = tree.covering(piece, *rest);
      return rest.has_value();
    });
    return covered;
  }

  const std::vector<Piece>& pieces_;
  double tolerance_, min_, spread_;
  const Progress& progress_;
  Order has_higher_rank_;
  DirectionClasses directions_;
};

}  // namespace

std::vector<Cover> find_covers(const std::vector<Piece>& pieces, double tolerance, double min, const Progress& progress,
                               Order has_higher_rank) {
  if (pieces.empty()) return {};
  std::vector<Cover> covers = CoverSearch(pieces, tolerance, min, progress, has_higher_rank).find();
  parallel_sort(covers.begin(), covers.end());
  // At the border between cells, a pair is found in both.
  covers.erase(std::unique(covers.begin(), covers.end()), covers.end());
  check(covers.empty() || (covers.front().piece >= 0 && covers.back().piece < static_cast<int>(pieces.size())),
        "covers are of lines");
  return covers;
}

}  // namespace epura::drawing
