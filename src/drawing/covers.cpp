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
#include "visibility/choose_grid.hpp"
#include "visibility/line_cells.hpp"

namespace epura {

namespace {

constexpr std::size_t grain = 1024;
constexpr double cells_for_piece = 0.5;
constexpr double cuts_of_piece = 8;

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
  PieceGrid(const std::vector<Piece>& pieces, double tolerance) : pieces_(pieces), tolerance_(tolerance), grid_{} {
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
  }

  [[nodiscard]] std::size_t cells() const { return first_.size() - 1; }

  [[nodiscard]] std::size_t cell_of(const Vec2& p) const {
    return static_cast<std::size_t>(grid_.cell(grid_.column(p.x), grid_.row(p.y)));
  }

  /// Calls `visit(a, b)` for pairs of pieces in a cell whose lines come near each other and differ in direction by no
  /// more than `spread`.
  template <class Visit>
  void near_pairs(std::size_t cell, float spread, const Visit& visit) const {
    constexpr float turn = std::numbers::pi_v<float>;
    const float widest = spread + 2 * one_direction;
    const auto members = std::span(members_).subspan(first_[cell], first_[cell + 1] - first_[cell]);
    for (std::size_t a = 0; a < members.size(); a = end_of_direction(members, a)) {
      const auto own = members.subspan(a, end_of_direction(members, a) - a);
      for (std::size_t i = 0; i < own.size(); ++i) visit_near(own[i], own.subspan(i + 1), 0, 1, visit);
      for (std::size_t b = a + own.size(); b < members.size(); b = end_of_direction(members, b)) {
        const auto others = members.subspan(b, end_of_direction(members, b) - b);
        const float angle = others[0].angle - own[0].angle;
        // Directions 0 and pi are neighbours, with the sides of the line exchanged.
        if (angle <= widest)
          for (const Member& member : own) visit_near(member, others, angle, 1, visit);
        else if (angle >= turn - widest)
          for (const Member& member : own) visit_near(member, others, turn - angle, -1, visit);
      }
    }
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

  // Those of one direction, in order of offset, whose lines may coincide with that of `a` somewhere in the cell.
  template <class Visit>
  void visit_near(const Member& a, std::span<const Member> others, float angle, float side, const Visit& visit) const {
    const double radius = 0.5 * glm::length(grid_.side);
    const auto reach = static_cast<float>(4 * tolerance_ + radius * (angle + 4 * one_direction));
    const float offset = side * a.offset;
    auto b = std::lower_bound(others.begin(), others.end(), offset - reach,
                              [](const Member& m, float x) { return m.offset < x; });
    for (; b != others.end() && b->offset <= offset + reach; ++b) visit(a.piece, b->piece);
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

  const std::vector<Piece>& pieces_;
  double tolerance_;
  CellGrid grid_;
  std::vector<std::size_t> first_;
  std::vector<Member> members_;
};

}  // namespace

std::vector<Cover> find_covers(const std::vector<Piece>& pieces, double tolerance, double least) {
  std::vector<Cover> covers;
  if (pieces.empty()) return covers;
  const PieceGrid grid(pieces, tolerance);
  // Two lines that stay within the tolerance over `least` differ in direction by no more than this.
  const float spread = static_cast<float>(std::min(2.5 * tolerance / least, 1.5));
  std::mutex adding;
  parallel_for(grid.cells(), grain, [&](std::size_t begin, std::size_t end) {
    std::vector<Cover> found;
    for (std::size_t cell = begin; cell < end; ++cell)
      grid.near_pairs(cell, spread, [&](int a, int b) {
        if (rank(pieces[a]) < rank(pieces[b])) std::swap(a, b);
        if (!(rank(pieces[b]) < rank(pieces[a]))) return;
        const Ruler line(pieces[a].from, pieces[a].to);
        const auto [from, to] = covered_part(line, pieces[b].from, pieces[b].to, tolerance, least);
        // Pairs meet in several cells. The one where the cover begins counts.
        if (to > from && grid.cell_of(line.from + from * line.along) == cell) found.push_back({a, from, to});
      });
    const std::lock_guard lock(adding);
    covers.insert(covers.end(), found.begin(), found.end());
  });
  parallel_sort(covers.begin(), covers.end());
  return covers;
}

}  // namespace epura
