// SPDX-License-Identifier: Apache-2.0
#include "drawing/ink.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <deque>
#include <span>
#include <tuple>
#include <utility>

#include "base/error.hpp"
#include "base/same_key.hpp"
#include "drawing/covers.hpp"
#include "drawing/limits.hpp"

namespace epura::drawing {

namespace {

double ink_of(const std::vector<Piece>& pieces) {
  double ink = 0;
  for (const Piece& piece : pieces) ink += length_of(piece);
  return ink;
}

// The ends in an order that does not depend on the drawing direction.
std::array<double, 4> place(const Piece& p) {
  const std::array a{p.from.x, p.from.y}, b{p.to.x, p.to.y};
  return a < b ? std::array{a[0], a[1], b[0], b[1]} : std::array{b[0], b[1], a[0], a[1]};
}

// Of pieces at exactly the same place, only the first in rank is kept.
void drop_copies(std::vector<Piece>& pieces, const Progress& progress) {
  std::vector<char> copy(pieces.size(), false);
  const auto place_of = [&](int i) { return place(pieces[i]); };
  const auto by_rank = [&](int a, int b) { return outranks(pieces[a], pieces[b]); };
  visit_same_keys(static_cast<int>(pieces.size()), place_of, progress, [&](std::span<const int> same) {
    for (const int i : same) copy[i] = true;
    copy[*std::min_element(same.begin(), same.end(), by_rank)] = false;
  });
  std::size_t kept = 0;
  for (std::size_t i = 0; i < pieces.size(); ++i)
    if (!copy[i]) pieces[kept++] = pieces[i];
  pieces.erase(pieces.begin() + static_cast<std::ptrdiff_t>(kept), pieces.end());
}

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

// Appends what remains of a piece when parts of its length are removed.
void append_rest(const Piece& piece, std::span<const Cover> covers, double min, std::deque<Piece>& rest) {
  double from = 0;
  for (const Cover& part : covers) {
    check(part.from >= 0 && part.from < part.to, "a cover is a part of its line");
    if (part.from - from >= min) rest.push_back(part_of(piece, from, part.from));
    from = std::max(from, part.to);
  }
  const double length = length_of(piece);
  if (from == 0 || length - from >= min) rest.push_back(part_of(piece, from, length));
}

}  // namespace

bool outranks(const Piece& a, const Piece& b) {
  if (a.drawn != b.drawn) return a.drawn;
  if (a.visible != b.visible) return a.visible;
  // The outline of a cut face stays whole where an edge behind it coincides with it.
  const bool cut = a.kind == EdgeKind::section;
  if (cut != (b.kind == EdgeKind::section)) return cut;
  if (a.is_step != b.is_step) return b.is_step;
  if (a.kind != b.kind) return a.kind < b.kind;
  // Compared as floats, so that rounding does not decide.
  const auto length = [](const Piece& p) { return static_cast<float>(std::max(p.line, length_of(p))); };
  if (length(a) != length(b)) return length(a) > length(b);
  const auto middle = [](const Piece& p) {
    const Vec2 m = (p.from + p.to) / 2.0;
    return std::pair(static_cast<float>(m.x), static_cast<float>(m.y));
  };
  return std::tuple(middle(a), a.edge, a.s[0]) < std::tuple(middle(b), b.edge, b.s[0]);
}

std::array<double, 2> covered_part(const Ruler& line, Vec2 a, Vec2 b, double tolerance, double min) {
  a = line.local(a);
  b = line.local(b);
  if (std::min(a.y, b.y) > tolerance || std::max(a.y, b.y) < -tolerance) return {0, 0};
  if (a.x > b.x) std::swap(a, b);
  const double from = std::max(a.x, 0.0);
  const double to = std::min(b.x, line.length);
  if (to - from < min) return {0, 0};
  const auto offset = [&](double x) { return std::abs(a.y + (b.y - a.y) * ((x - a.x) / (b.x - a.x))); };
  if (offset(from) > tolerance || offset(to) > tolerance) return {0, 0};
  check(from >= 0 && from <= to && to <= line.length, "a covered part lies on its line");
  return {from, to};
}

std::vector<Piece> resolve_coincident(std::vector<Piece> pieces, double tolerance, double min,
                                      const Progress& progress) {
  // Edges along the line of sight are points on paper.
  std::erase_if(pieces, [&](const Piece& p) { return !(length_of(p) > tolerance); });
  drop_copies(pieces, progress);
  const std::vector<Cover> covers = find_covers(pieces, tolerance, min, progress);
  if (covers.empty()) return pieces;
  const double ink = ink_of(pieces);

  // In place, since there may be no memory for a second list: results that do not fit in front of the remaining pieces
  // wait.
  std::deque<Piece> waiting;
  std::size_t next = 0, kept = 0;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const std::size_t first = next;
    while (next < covers.size() && covers[next].piece == static_cast<int>(i)) ++next;
    append_rest(pieces[i], std::span(covers).subspan(first, next - first), min, waiting);
    for (; !waiting.empty() && kept <= i; waiting.pop_front()) pieces[kept++] = waiting.front();
  }
  pieces.erase(pieces.begin() + static_cast<std::ptrdiff_t>(kept), pieces.end());
  pieces.insert(pieces.end(), waiting.begin(), waiting.end());
  check(next == covers.size(), "every cover is of a line");
  check(ink_of(pieces) <= ink * (1 + rounding_part), "of lines that coincide, no more ink is left than there was");
  return pieces;
}

}  // namespace epura::drawing
