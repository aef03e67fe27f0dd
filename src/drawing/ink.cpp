#include "drawing/ink.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <tuple>
#include <utility>

#include "base/parallel.hpp"
#include "visibility/line_cells.hpp"

namespace epura {

namespace {

auto rank(const Piece& p) { return std::tuple(!p.visible, p.kind, p.edge, p.s[0]); }

// The ends in an order that does not depend on the direction of drawing.
auto place(const Piece& p) {
  const std::pair a(p.from.x, p.from.y);
  const std::pair b(p.to.x, p.to.y);
  return a < b ? std::pair(a, b) : std::pair(b, a);
}

// The direction as an angle in [0, pi).
double angle_of(const Piece& p) {
  const double angle = std::atan2(p.to.y - p.from.y, p.to.x - p.from.x);
  return angle < 0 ? angle + std::numbers::pi : angle >= std::numbers::pi ? 0 : angle;
}

double length_of(const Piece& p) { return glm::length(p.to - p.from); }

// Pieces at exactly the same place: only the first in rank stays.
std::vector<Piece> without_copies(std::vector<Piece> pieces) {
  std::vector<std::size_t> order(pieces.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return std::tuple(place(pieces[a]), rank(pieces[a])) < std::tuple(place(pieces[b]), rank(pieces[b]));
  });
  std::vector<bool> copy(pieces.size(), false);
  for (std::size_t i = 1; i < order.size(); ++i)
    copy[order[i]] = place(pieces[order[i]]) == place(pieces[order[i - 1]]);
  std::vector<Piece> kept;
  for (std::size_t i = 0; i < pieces.size(); ++i)
    if (!copy[i]) kept.push_back(pieces[i]);
  return kept;
}

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
    fill();
  }

  /// Calls `visit` for pieces whose lines come near that of `piece`, within `spread` of its direction; some more than
  /// once.
  template <class Visit>
  void near(const Piece& piece, double spread, Visit visit) const {
    const double angle = angle_of(piece);
    visit_cells(grid_, piece.from, piece.to, tolerance_, [&](int cell, double, double) {
      const Line line{angle, offset(piece, angle, cell)};
      visit_range(cell, line, spread, visit);
      // Directions 0 and pi are neighbours, with the sides of the line exchanged.
      const Line reversed{angle < spread ? angle + std::numbers::pi : angle - std::numbers::pi, -line.offset};
      if (angle < spread || angle > std::numbers::pi - spread) visit_range(cell, reversed, spread, visit);
    });
  }

 private:
  struct Line {
    double angle, offset;
  };
  struct Member {
    Line line;
    int piece;
  };

  [[nodiscard]] double offset(const Piece& piece, double angle, int cell) const {
    const Vec2 middle = grid_.origin + grid_.side * Vec2(cell % grid_.columns + 0.5, cell / grid_.columns + 0.5);
    const Vec2 d = piece.from - middle;
    return std::cos(angle) * d.y - std::sin(angle) * d.x;
  }

  void fill() {
    first_.assign(static_cast<std::size_t>(grid_.count()) + 1, 0);
    const auto each = [&](const Piece& p, auto visit) {
      visit_cells(grid_, p.from, p.to, tolerance_, [&](int cell, double, double) { visit(cell); });
    };
    for (const Piece& p : pieces_) each(p, [&](int cell) { ++first_[cell + 1]; });
    std::partial_sum(first_.begin(), first_.end(), first_.begin());
    members_.resize(first_.back());
    std::vector<std::size_t> next(first_.begin(), first_.end() - 1);
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
      const double angle = angle_of(pieces_[i]);
      each(pieces_[i], [&](int cell) {
        members_[next[cell]++] = {{angle, offset(pieces_[i], angle, cell)}, static_cast<int>(i)};
      });
    }
    parallel_for(first_.size() - 1, 4096, [&](std::size_t begin, std::size_t end) {
      for (std::size_t c = begin; c < end; ++c)
        std::sort(members_.begin() + first_[c], members_.begin() + first_[c + 1], [](const Member& a, const Member& b) {
          return std::pair(a.line.angle, a.piece) < std::pair(b.line.angle, b.piece);
        });
    });
  }

  template <class Visit>
  void visit_range(int cell, const Line& line, double spread, Visit visit) const {
    const auto begin = members_.begin() + first_[cell];
    const auto end = members_.begin() + first_[cell + 1];
    auto it = std::lower_bound(begin, end, line.angle - spread,
                               [](const Member& m, double angle) { return m.line.angle < angle; });
    for (; it != end && it->line.angle <= line.angle + spread; ++it) {
      // Lines that coincide somewhere in the cell are this close at its middle.
      const double reach = 4 * tolerance_ + grid_.side * std::abs(it->line.angle - line.angle);
      if (std::abs(it->line.offset - line.offset) <= reach) visit(static_cast<std::size_t>(it->piece));
    }
  }

  const std::vector<Piece>& pieces_;
  double tolerance_;
  CellGrid grid_;
  std::vector<std::size_t> first_;
  std::vector<Member> members_;
};

Piece part_of(const Piece& piece, double from, double to) {
  const double length = length_of(piece);
  const auto at = [&](double x) {
    if (x <= 0) return std::pair(piece.from, piece.s[0]);
    if (x >= length) return std::pair(piece.to, piece.s[1]);
    const double part = x / length;
    return std::pair(piece.from + part * (piece.to - piece.from), piece.s[0] + part * (piece.s[1] - piece.s[0]));
  };
  Piece result = piece;
  std::tie(result.from, result.s[0]) = at(from);
  std::tie(result.to, result.s[1]) = at(to);
  return result;
}

// What remains of a piece when parts of its length are taken away.
void append_rest(const Piece& piece, std::vector<std::array<double, 2>>& covered, double least,
                 std::vector<Piece>& rest) {
  std::sort(covered.begin(), covered.end());
  double from = 0;
  for (const auto& part : covered) {
    if (part[0] - from >= least) rest.push_back(part_of(piece, from, part[0]));
    from = std::max(from, part[1]);
  }
  const double length = length_of(piece);
  if (from == 0 || length - from >= least) rest.push_back(part_of(piece, from, length));
}

}  // namespace

std::array<double, 2> covered_part(const Ruler& line, Vec2 a, Vec2 b, double tolerance, double least) {
  a = line.local(a);
  b = line.local(b);
  if (std::min(a.y, b.y) > tolerance || std::max(a.y, b.y) < -tolerance) return {0, 0};
  if (a.x > b.x) std::swap(a, b);
  const double from = std::max(a.x, 0.0);
  const double to = std::min(b.x, line.length);
  if (to - from < least) return {0, 0};
  const auto offset = [&](double x) { return std::abs(a.y + (b.y - a.y) * ((x - a.x) / (b.x - a.x))); };
  if (offset(from) > tolerance || offset(to) > tolerance) return {0, 0};
  return {from, to};
}

std::vector<Piece> resolve_coincident(std::vector<Piece> pieces, double tolerance, double least) {
  // Edges along the line of sight are points on the paper.
  std::erase_if(pieces, [&](const Piece& p) { return !(length_of(p) > tolerance); });
  pieces = without_copies(std::move(pieces));
  if (pieces.empty()) return pieces;
  const PieceGrid grid(pieces, tolerance);
  // Two lines that stay within the tolerance over `least` differ in direction by no more than this.
  const double spread = std::min(2.5 * tolerance / least, 1.5);

  std::vector<std::vector<Piece>> rests(pieces.size());
  parallel_for(pieces.size(), 256, [&](std::size_t begin, std::size_t end) {
    std::vector<std::array<double, 2>> covered;
    for (std::size_t i = begin; i < end; ++i) {
      covered.clear();
      const Ruler line(pieces[i].from, pieces[i].to);
      grid.near(pieces[i], spread, [&](std::size_t j) {
        const auto part = covered_part(line, pieces[j].from, pieces[j].to, tolerance, least);
        if (part[1] > part[0] && rank(pieces[j]) < rank(pieces[i])) covered.push_back(part);
      });
      append_rest(pieces[i], covered, least, rests[i]);
    }
  });
  std::vector<Piece> resolved;
  for (const auto& rest : rests) resolved.insert(resolved.end(), rest.begin(), rest.end());
  return resolved;
}

}  // namespace epura
