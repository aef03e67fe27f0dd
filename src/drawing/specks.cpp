// SPDX-License-Identifier: Apache-2.0
#include "drawing/specks.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <utility>

#include "base/error.hpp"
#include "drawing/kept_ink.hpp"
#include "drawing/polylines.hpp"

namespace epura::drawing {

namespace {

// Width of the cells that tell where no specks are, as a multiple of the distance.
constexpr double cells_a_distance = 8;

std::array<Vec2, 2> ends_of(const Piece& piece) { return {piece.from, piece.to}; }

/// Returns for each link whether two other pieces that are drawn meet where it begins: they continue each other.
std::vector<char> find_needless(const std::vector<Piece>& pieces, const Progress& progress) {
  std::vector<char> needless(pieces.size(), 0);
  const auto line_at = [&](int piece) { return ends_of(pieces[piece]); };
  visit_meetings(pieces.size(), line_at, progress, [&](std::span<const End> ends) {
    const auto others = std::count_if(ends.begin(), ends.end(), [&](End end) {
      return pieces[line_of(end)].drawn && !is_link(pieces[line_of(end)]);
    });
    for (const End end : ends)
      if (end % 2 == 0 && others >= 2) needless[line_of(end)] = is_link(pieces[line_of(end)]) ? 1 : 0;
  });
  return needless;
}

/// Returns for each piece whether it belongs to a polyline no longer than the distance. Links alone connect others,
/// unless these continue each other anyway, or the link is too short for a gap to be seen.
std::vector<char> find_short(const std::vector<Piece>& pieces, const std::vector<signed char>& strength,
                             const ContinuingLimits& limits, const Progress& progress) {
  const double most = limits.distance;
  constexpr double unseen = 0.1;
  std::vector<char> is_short(pieces.size(), 0), needless;
  const Polylines lines(pieces, strength, progress, limits.touching);
  check(lines.size() <= pieces.size(), "a polyline has a piece");
  for (std::size_t i = 0; i < lines.size(); ++i) {
    double length = 0;
    bool links_only = true;
    for (const End end : lines[i]) {
      const Piece& piece = pieces[line_of(end)];
      length += length_of(piece);
      links_only = links_only && is_link(piece);
      if (length > most) break;
    }
    if (length > most) continue;
    if (links_only && length > unseen * most) {
      if (needless.empty()) needless = find_needless(pieces, progress);
      if (needless[line_of(lines[i].front())] == 0) continue;
    }
    for (const End end : lines[i]) is_short[line_of(end)] = strength[line_of(end)] >= 0 ? 1 : 0;
  }
  return is_short;
}

// The pieces that end at a place: how many are visible, and how many are not.
using EndsHere = std::array<int, 2>;

}  // namespace

void turn_glints(std::vector<Piece>& pieces, const std::vector<char>& is_moved, double most, const Progress& progress) {
  std::vector<char> is_glint(pieces.size(), 0);
  for (std::size_t i = 0; i < pieces.size(); ++i)
    is_glint[i] = is_moved[i] != 0 && pieces[i].drawn && length_of(pieces[i]) <= most ? 1 : 0;
  if (std::find(is_glint.begin(), is_glint.end(), 1) == is_glint.end()) return;
  std::vector<EndsHere> meeting(2 * pieces.size());
  const auto line_at = [&](int piece) { return ends_of(pieces[piece]); };
  visit_meetings(pieces.size(), line_at, progress, [&](std::span<const End> ends) {
    EndsHere there{0, 0};
    for (const End end : ends)
      if (pieces[line_of(end)].drawn) ++there[pieces[line_of(end)].visible ? 0 : 1];
    for (const End end : ends) meeting[end] = there;
  });
  std::vector<char> turns(pieces.size(), 0);
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const std::size_t own = pieces[i].visible ? 0 : 1;
    const auto is_between = [&](const EndsHere& there) {
      check(is_glint[i] == 0 || there[own] > 0 || there[1 - own] == 0, "a line is among those that end where it ends");
      return there[own] == 1 && there[1 - own] == 1;
    };
    turns[i] = is_glint[i] != 0 && is_between(meeting[2 * i]) && is_between(meeting[2 * i + 1]) ? 1 : 0;
  }
  for (std::size_t i = 0; i < pieces.size(); ++i)
    if (turns[i] != 0) pieces[i].visible = !pieces[i].visible;
}

LeftInk drop_specks(std::vector<Piece> pieces, const std::vector<signed char>& strength, const ContinuingLimits& limits,
                    const Progress& progress) {
  const double distance = limits.distance;
  const std::vector<char> is_short = find_short(pieces, strength, limits, progress);
  if (std::find(is_short.begin(), is_short.end(), 1) == is_short.end()) return {std::move(pieces)};
  const InkParts specks = parts_of(
      pieces, [&](std::size_t i) { return is_short[i] != 0; }, distance);
  const search::OccupiedCells near_specks = specks.cells_within(distance, cells_a_distance * distance);
  std::vector<std::array<double, 2>> away(pieces.size(), {HUGE_VAL, HUGE_VAL});  // from lines that stay, by end
  for (std::size_t p = 0; p < pieces.size(); ++p) {
    if (is_short[p] != 0 || strength[p] < 0) continue;
    const std::array<Vec2, 2> line{pieces[p].from, pieces[p].to};
    if (!near_specks.may_meet(line[0], line[1])) continue;
    for (const int part : specks.find(line[0], line[1], distance)) {
      const int speck = specks[part].piece;
      if (pieces[speck].visible && !pieces[p].visible) continue;
      for (std::size_t end = 0; end < 2; ++end) {
        const Vec2& at = specks.line(part)[end];
        away[speck][end] = std::min(away[speck][end], glm::distance(nearest_on(line, at), at));
      }
    }
  }
  std::size_t kept = 0;
  double within = 0;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const double farthest = std::max(away[i][0], away[i][1]);
    if (farthest <= distance)
      within = std::max(within, farthest + length_of(pieces[i]) / 2);
    else
      pieces[kept++] = pieces[i];
  }
  check(kept <= pieces.size() && kept > 0, "a speck lies on lines that stay");
  pieces.resize(kept);
  return {std::move(pieces), within};
}

}  // namespace epura::drawing
