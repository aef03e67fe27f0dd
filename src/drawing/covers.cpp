#include "drawing/covers.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <mutex>
#include <numbers>
#include <numeric>
#include <span>
#include <utility>

#include "base/parallel.hpp"
#include "base/portable_math.hpp"
#include "drawing/piece_tree.hpp"
#include "visibility/choose_grid.hpp"
#include "visibility/line_cells.hpp"
#include "visibility/spans.hpp"

namespace epura {

namespace {

constexpr std::size_t grain = 1024;
constexpr double cells_for_piece = 0.5;
constexpr double cuts_of_piece = 8;
// A cell is crowded where a piece has more others near its line, on average.
constexpr std::size_t crowd = 256;

// The direction of a line without its sense: upwards, as an angle in [0, pi].
struct Direction {
  Vec2 along;
  double angle;

  explicit Direction(const Piece& p) : along((p.to - p.from) / length_of(p)) {
    if (along.y < 0 || (along.y == 0 && along.x < 0)) along = -along;
    angle = portable_atan2(along.y, along.x);
  }
};

// Directions that differ by less count as one. It is more than single precision loses.
constexpr float one_direction = 1e-6F;

// Pieces by cell of the paper, within a cell by direction, within a direction by the distance of their lines from the
// cell's middle.
class PieceGrid {
 public:
  /// `spread` is by how much pieces that are near may differ in direction.
  PieceGrid(const std::vector<Piece>& pieces, double tolerance, float spread)
      : pieces_(pieces), tolerance_(tolerance), widest_(spread + 2 * one_direction), grid_{} {
    PageBox page{Vec2(HUGE_VAL), Vec2(-HUGE_VAL)};
    for (const Piece& p : pieces)
      page = {glm::min(page.least, glm::min(p.from, p.to)), glm::max(page.most, glm::max(p.from, p.to))};
    const GridLimits limits{cells_for_piece * static_cast<double>(pieces.size()), 16 * tolerance, cuts_of_piece, 0};
    Cuts lines;
    const Vec2 size = glm::max(page.most - page.least, Vec2(limits.side));
    for (const Piece& p : pieces) lines.add(glm::abs(p.to - p.from), size);
    grid_ = choose_grid(page, lines, {}, limits);
    count();
    fill();
    sort();
    find_crowds();
    plant_trees();
  }

  [[nodiscard]] std::size_t cells() const { return first_.size() - 1; }

  [[nodiscard]] std::size_t cell_of(const Vec2& p) const {
    return static_cast<std::size_t>(grid_.cell(grid_.column(p.x), grid_.row(p.y)));
  }

  [[nodiscard]] bool is_crowded(std::size_t cell) const { return !crowded_.empty() && crowded_[cell] != 0; }

  /// Whether a piece runs through a crowded cell.
  [[nodiscard]] bool is_in_crowd(int piece) const { return !in_crowd_.empty() && in_crowd_[piece] != 0; }

  /// Calls `visit(tree, from, to)` for the cells along a piece in a crowd, with page parameters of the part there.
  template <class Visit>
  void visit_trees(int piece, const Visit& visit) const {
    const Piece& p = pieces_[piece];
    visit_cells(grid_, p.from, p.to, tolerance_,
                [&](int cell, double from, double to) { visit(trees_[tree_of_[cell]], from, to); });
  }

  /// Calls `visit(a, b)` for pairs of pieces in a cell whose lines come near each other and differ little in direction.
  template <class Visit>
  void near_pairs(std::size_t cell, const Visit& visit) const {
    visit_directions(cell, [&](const Member& a, std::span<const Member> others, float angle, float side) {
      for (const Member& b : near(a, others, angle, side)) visit(a.piece, b.piece);
      return true;
    });
  }

 private:
  // Candidates need no more than single precision. `angle` is that of the first of those in one direction.
  struct Member {
    float angle, offset;
    int piece;
  };

  static std::size_t end_of_direction(std::span<const Member> members, std::size_t begin) {
    std::size_t end = begin + 1;
    while (end < members.size() && members[end].angle == members[begin].angle) ++end;
    return end;
  }

  [[nodiscard]] std::span<const Member> members_of(std::size_t cell) const {
    return std::span(members_).subspan(first_[cell], first_[cell + 1] - first_[cell]);
  }

  // Calls `visit(member, others, angle, side)` for each member and those of each direction near its own, until it
  // returns false.
  template <class Visit>
  void visit_directions(std::size_t cell, const Visit& visit) const {
    constexpr float turn = std::numbers::pi_v<float>;
    const auto members = members_of(cell);
    for (std::size_t a = 0; a < members.size(); a = end_of_direction(members, a)) {
      const auto own = members.subspan(a, end_of_direction(members, a) - a);
      for (std::size_t i = 0; i < own.size(); ++i)
        if (!visit(own[i], own.subspan(i + 1), 0.0F, 1.0F)) return;
      for (std::size_t b = a + own.size(); b < members.size(); b = end_of_direction(members, b)) {
        const auto others = members.subspan(b, end_of_direction(members, b) - b);
        const float angle = others[0].angle - own[0].angle;
        // Directions 0 and pi are neighbours, with the sides of the line exchanged.
        const bool turned = angle >= turn - widest_;
        if (!turned && angle > widest_) continue;
        for (const Member& member : own)
          if (!visit(member, others, turned ? turn - angle : angle, turned ? -1.0F : 1.0F)) return;
      }
    }
  }

  // Those of one direction, in order of offset, whose lines may coincide with that of `a` somewhere in the cell.
  [[nodiscard]] std::span<const Member> near(const Member& a, std::span<const Member> others, float angle,
                                             float side) const {
    const double radius = 0.5 * glm::length(grid_.side);
    const auto reach = static_cast<float>(4 * tolerance_ + radius * (angle + 4 * one_direction));
    const float offset = side * a.offset;
    const auto begin = std::lower_bound(others.begin(), others.end(), offset - reach,
                                        [](const Member& m, float x) { return m.offset < x; });
    const auto end =
        std::upper_bound(begin, others.end(), offset + reach, [](float x, const Member& m) { return x < m.offset; });
    return {begin, end};
  }

  template <class Visit>
  void each_cell(const Piece& piece, const Visit& visit) const {
    visit_cells(grid_, piece.from, piece.to, tolerance_,
                [&](int cell, double, double) { visit(static_cast<std::size_t>(cell)); });
  }

  void count() {
    first_.assign(static_cast<std::size_t>(grid_.count()) + 1, 0);
    parallel_for(pieces_.size(), grain, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i)
        each_cell(pieces_[i],
                  [&](std::size_t cell) { std::atomic_ref(first_[cell + 1]).fetch_add(1, std::memory_order_relaxed); });
    });
    std::partial_sum(first_.begin(), first_.end(), first_.begin());
    members_.resize(first_.back());
  }

  void fill() {
    std::vector<std::size_t> next(first_.begin(), first_.end() - 1);
    parallel_for(pieces_.size(), grain, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) {
        const Direction direction(pieces_[i]);
        each_cell(pieces_[i], [&](std::size_t cell) {
          const std::size_t place = std::atomic_ref(next[cell]).fetch_add(1, std::memory_order_relaxed);
          members_[place] = {static_cast<float>(direction.angle), offset(i, direction.along, cell),
                             static_cast<int>(i)};
        });
      }
    });
  }

  [[nodiscard]] float offset(std::size_t piece, const Vec2& along, std::size_t cell) const {
    const int number = static_cast<int>(cell);
    const Vec2 middle = grid_.middle(number);
    const Vec2 d = pieces_[piece].from - middle;
    return static_cast<float>(along.x * d.y - along.y * d.x);
  }

  void sort() {
    parallel_for(cells(), grain, [&](std::size_t begin, std::size_t end) {
      for (std::size_t c = begin; c < end; ++c)
        sort_cell(std::span(members_).subspan(first_[c], first_[c + 1] - first_[c]));
    });
  }

  static void sort_cell(std::span<Member> members) {
    std::sort(members.begin(), members.end(), [](const Member& a, const Member& b) { return a.angle < b.angle; });
    for (std::size_t begin = 0, end = 0; begin < members.size(); begin = end) {
      const float angle = members[begin].angle;
      for (; end < members.size() && members[end].angle - angle < one_direction; ++end) members[end].angle = angle;
      std::sort(members.begin() + begin, members.begin() + end,
                [](const Member& a, const Member& b) { return a.offset < b.offset; });
    }
  }

  // Pairs without any near are work, too.
  [[nodiscard]] bool has_many_pairs(std::size_t cell) const {
    const std::size_t most = crowd * members_of(cell).size();
    std::size_t pairs = 0;
    visit_directions(cell, [&](const Member& a, std::span<const Member> others, float angle, float side) {
      pairs += 1 + near(a, others, angle, side).size();
      return pairs <= most;
    });
    return pairs > most;
  }

  void find_crowds() {
    for (std::size_t cell = 0; cell < cells(); ++cell) {
      if (members_of(cell).size() <= crowd || !has_many_pairs(cell)) continue;
      crowded_.resize(cells(), 0);
      in_crowd_.resize(pieces_.size(), 0);
      crowded_[cell] = 1;
      for (const Member& member : members_of(cell)) in_crowd_[member.piece] = 1;
    }
  }

  // Wherever a piece of a crowd runs.
  void plant_trees() {
    if (crowded_.empty()) return;
    tree_of_.assign(cells(), -1);
    std::vector<std::size_t> planted;
    for (std::size_t cell = 0; cell < cells(); ++cell) {
      const auto members = members_of(cell);
      if (std::none_of(members.begin(), members.end(), [&](const Member& m) { return is_in_crowd(m.piece); })) continue;
      tree_of_[cell] = static_cast<int>(planted.size());
      planted.push_back(cell);
    }
    trees_.resize(planted.size());
    parallel_for(planted.size(), 1, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) {
        std::vector<int> members;
        for (const Member& member : members_of(planted[i])) members.push_back(member.piece);
        trees_[i] = PieceTree(pieces_, std::move(members), tolerance_, widest_);
      }
    });
  }

  const std::vector<Piece>& pieces_;
  double tolerance_;
  float widest_;  ///< difference in direction
  CellGrid grid_;
  std::vector<std::size_t> first_;
  std::vector<Member> members_;
  std::vector<char> crowded_;   ///< by cell; empty if none is
  std::vector<char> in_crowd_;  ///< by piece
  std::vector<int> tree_of_;    ///< by cell, or -1
  std::vector<PieceTree> trees_;
};

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

}  // namespace

std::vector<Cover> find_covers(const std::vector<Piece>& pieces, double tolerance, double least) {
  std::vector<Cover> covers;
  if (pieces.empty()) return covers;
  // Two lines that stay within the tolerance over `least` differ in direction by no more than this.
  const auto spread = static_cast<float>(std::min(2.5 * tolerance / least, 1.5));
  const PieceGrid grid(pieces, tolerance, spread);
  const Limits limits{tolerance, least};
  std::mutex adding;
  const auto in_parallel = [&](std::size_t count, const auto& add) {
    parallel_for(count, grain, [&](std::size_t begin, std::size_t end) {
      std::vector<Cover> found;
      for (std::size_t i = begin; i < end; ++i) add(i, found);
      const std::lock_guard lock(adding);
      covers.insert(covers.end(), found.begin(), found.end());
    });
  };
  in_parallel(grid.cells(), [&](std::size_t cell, std::vector<Cover>& found) {
    if (!grid.is_crowded(cell)) add_covers_of_pairs(pieces, grid, cell, limits, found);
  });
  in_parallel(pieces.size(), [&](std::size_t piece, std::vector<Cover>& found) {
    const int number = static_cast<int>(piece);
    if (grid.is_in_crowd(number)) add_covers_in_crowd(pieces, grid, number, limits, found);
  });
  parallel_sort(covers.begin(), covers.end());
  return covers;
}

}  // namespace epura
