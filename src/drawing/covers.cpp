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
#include "visibility/line_cells.hpp"

namespace epura {

namespace {

constexpr std::size_t grain = 1024;

// The direction of a line without its sense: upwards, as an angle in [0, pi].
struct Direction {
  Vec2 along;
  double angle;

  explicit Direction(const Piece& p) : along((p.to - p.from) / length_of(p)) {
    if (along.y < 0 || (along.y == 0 && along.x < 0)) along = -along;
    angle = std::atan2(along.y, along.x);
  }
};

// Pieces by cell of the paper, within a cell by direction, each with the distance of its line from the cell's middle.
class PieceGrid {
 public:
  PieceGrid(const std::vector<Piece>& pieces, double tolerance) : pieces_(pieces), tolerance_(tolerance), grid_{} {
    Vec2 least(HUGE_VAL), most(-HUGE_VAL);
    for (const Piece& p : pieces) {
      least = glm::min(least, glm::min(p.from, p.to));
      most = glm::max(most, glm::max(p.from, p.to));
    }
    grid_ = make_cell_grid(least, most, 0.5 * static_cast<double>(pieces.size()));
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
    const auto members = std::span(members_).subspan(first_[cell], first_[cell + 1] - first_[cell]);
    for (std::size_t i = 0; i < members.size(); ++i) {
      const Member& a = members[i];
      for (std::size_t j = i + 1; j < members.size() && members[j].angle <= a.angle + spread; ++j)
        if (near(members[j].angle - a.angle, members[j].offset - a.offset)) visit(a.piece, members[j].piece);
      // Directions 0 and pi are neighbours, with the sides of the line exchanged.
      for (std::size_t j = members.size() - 1; j > i && members[j].angle >= a.angle + turn - spread; --j)
        if (near(a.angle + turn - members[j].angle, members[j].offset + a.offset)) visit(a.piece, members[j].piece);
    }
  }

 private:
  // Candidates need no more than single precision.
  struct Member {
    float angle, offset;
    int piece;
  };

  // Lines that coincide somewhere in a cell are this close at its middle. The last term is for single precision.
  [[nodiscard]] bool near(float angle, float distance) const {
    const double reach = 4 * tolerance_ + grid_.side.x * (angle + 1e-6);
    return std::abs(distance) <= static_cast<float>(reach);
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
        std::sort(members_.begin() + first_[c], members_.begin() + first_[c + 1],
                  [](const Member& a, const Member& b) { return a.angle < b.angle; });
    });
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
