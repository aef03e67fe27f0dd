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

// The part of `lower`, in its own length, that `upper` covers.
std::array<double, 2> covered_part(const Piece& lower, const Piece& upper, double tolerance, double least) {
  const double length = length_of(lower);
  const Vec2 along = (lower.to - lower.from) / length;
  const auto local = [&](const Vec2& p) {
    const Vec2 d = p - lower.from;
    return Vec2(glm::dot(d, along), along.x * d.y - along.y * d.x);
  };
  Vec2 a = local(upper.from);
  Vec2 b = local(upper.to);
  if (a.x > b.x) std::swap(a, b);
  const double from = std::max(a.x, 0.0);
  const double to = std::min(b.x, length);
  if (to - from < least) return {0, 0};
  const auto offset = [&](double x) { return std::abs(a.y + (b.y - a.y) * ((x - a.x) / (b.x - a.x))); };
  if (offset(from) > tolerance || offset(to) > tolerance) return {0, 0};
  return {from, to};
}

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

// Pieces by cell of the paper, within a cell by direction.
class PieceGrid {
 public:
  PieceGrid(const std::vector<Piece>& pieces, double tolerance) : pieces_(pieces), tolerance_(tolerance), grid_{} {
    Vec2 least(HUGE_VAL), most(-HUGE_VAL);
    for (const Piece& p : pieces) {
      least = glm::min(least, glm::min(p.from, p.to));
      most = glm::max(most, glm::max(p.from, p.to));
    }
    grid_ = make_cell_grid(least, most, static_cast<double>(pieces.size()));
    for (const Piece& p : pieces) angles_.push_back(angle_of(p));
    fill();
  }

  /// Calls `visit` for pieces that run near `piece` in nearly its direction; some more than once.
  template <class Visit>
  void near(std::size_t piece, double spread, Visit visit) const {
    const double angle = angles_[piece];
    visit_cells(grid_, pieces_[piece].from, pieces_[piece].to, tolerance_, [&](int cell, double, double) {
      visit_range(cell, angle - spread, angle + spread, visit);
      // Directions 0 and pi are neighbours.
      if (angle < spread) visit_range(cell, angle - spread + std::numbers::pi, std::numbers::pi, visit);
      if (angle > std::numbers::pi - spread) visit_range(cell, 0, angle + spread - std::numbers::pi, visit);
    });
  }

 private:
  void fill() {
    first_.assign(static_cast<std::size_t>(grid_.columns) * grid_.rows + 1, 0);
    const auto each = [&](const Piece& p, auto visit) {
      visit_cells(grid_, p.from, p.to, tolerance_, [&](int cell, double, double) { visit(cell); });
    };
    for (const Piece& p : pieces_) each(p, [&](int cell) { ++first_[cell + 1]; });
    std::partial_sum(first_.begin(), first_.end(), first_.begin());
    members_.resize(first_.back());
    std::vector<int> next(first_.begin(), first_.end() - 1);
    for (std::size_t i = 0; i < pieces_.size(); ++i)
      each(pieces_[i], [&](int cell) { members_[next[cell]++] = static_cast<int>(i); });
    for (std::size_t c = 0; c + 1 < first_.size(); ++c)
      std::sort(members_.begin() + first_[c], members_.begin() + first_[c + 1],
                [&](int a, int b) { return std::pair(angles_[a], a) < std::pair(angles_[b], b); });
  }

  template <class Visit>
  void visit_range(int cell, double from, double to, Visit visit) const {
    const auto begin = members_.begin() + first_[cell];
    const auto end = members_.begin() + first_[cell + 1];
    auto it = std::lower_bound(begin, end, from, [&](int piece, double angle) { return angles_[piece] < angle; });
    for (; it != end && angles_[*it] <= to; ++it) visit(static_cast<std::size_t>(*it));
  }

  const std::vector<Piece>& pieces_;
  double tolerance_;
  CellGrid grid_;
  std::vector<double> angles_;
  std::vector<int> first_, members_;
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
      grid.near(i, spread, [&](std::size_t j) {
        if (!(rank(pieces[j]) < rank(pieces[i]))) return;
        const auto part = covered_part(pieces[i], pieces[j], tolerance, least);
        if (part[1] > part[0]) covered.push_back(part);
      });
      append_rest(pieces[i], covered, least, rests[i]);
    }
  });
  std::vector<Piece> resolved;
  for (const auto& rest : rests) resolved.insert(resolved.end(), rest.begin(), rest.end());
  return resolved;
}

}  // namespace epura
