// SPDX-License-Identifier: Apache-2.0
#include "drawing/dangles.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <utility>

#include "base/error.hpp"
#include "drawing/kept_ink.hpp"
#include "drawing/limits.hpp"
#include "drawing/polylines.hpp"

namespace epura::drawing {

namespace {

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
    if (links_only && length > unseen_up_to * most) {
      if (needless.empty()) needless = find_needless(pieces, progress);
      if (needless[line_of(lines[i].front())] == 0) continue;
    }
    for (const End end : lines[i]) is_short[line_of(end)] = strength[line_of(end)] >= 0 ? 1 : 0;
  }
  return is_short;
}

/// Pieces of one visibility that continue each other.
struct Stretch {
  std::vector<int> pieces{};
  bool is_visible = false;
  double length = 0;
  bool is_moved = true;  ///< all of them
};

/// Pieces that are drawn, from end to end, where no more than two meet.
class Runs {
 public:
  Runs(const std::vector<Piece>& pieces, const std::vector<char>& is_moved, const Progress& progress)
      : pieces_(pieces), is_moved_(is_moved), next_(2 * pieces.size(), no_end), used_(pieces.size(), 0) {
    const auto line_at = [&](int piece) { return ends_of(pieces[piece]); };
    visit_meetings(pieces.size(), line_at, progress, [&](std::span<const End> ends) {
      std::array<End, 2> drawn{no_end, no_end};
      std::size_t count = 0;
      for (const End end : ends)
        if (pieces[line_of(end)].drawn && count++ < 2) drawn[count - 1] = end;
      if (count != 2) return;
      next_[drawn[0]] = drawn[1];
      next_[drawn[1]] = drawn[0];
    });
  }

  /// Calls visit(stretches) for each run. A closed one begins at its longest piece and ends with it again.
  template <class Visit>
  void visit(const Visit& visit) {
    for (End end = 0; end < static_cast<End>(next_.size()); ++end)
      if (next_[end] == no_end && pieces_[line_of(end)].drawn && used_[line_of(end)] == 0) visit(follow(end));
    for (End end = 0; end < static_cast<End>(next_.size()); end += 2) {
      if (!pieces_[line_of(end)].drawn || used_[line_of(end)] != 0) continue;
      std::vector<Stretch> ring = follow(longest_in_ring(end));
      ring.push_back(ring.front());
      visit(ring);
    }
  }

 private:
  [[nodiscard]] End longest_in_ring(End start) const {
    End longest = start;
    for (End end = next_[other(start)]; end != start; end = next_[other(end)])
      if (length_of(pieces_[line_of(end)]) > length_of(pieces_[line_of(longest)])) longest = end;
    return longest;
  }

  [[nodiscard]] std::vector<Stretch> follow(End start) {
    std::vector<Stretch> stretches;
    for (End end = start; end != no_end && used_[line_of(end)] == 0; end = next_[other(end)]) {
      const int number = line_of(end);
      used_[number] = 1;
      const Piece& piece = pieces_[number];
      if (stretches.empty() || stretches.back().is_visible != piece.visible)
        stretches.push_back({.is_visible = piece.visible});
      Stretch& last = stretches.back();
      last.pieces.push_back(number);
      last.length += length_of(piece);
      last.is_moved = last.is_moved && is_moved_[number] != 0;
    }
    return stretches;
  }

  const std::vector<Piece>& pieces_;
  const std::vector<char>& is_moved_;
  std::vector<End> next_;  ///< by end: the one that continues it
  std::vector<char> used_;
};

// Whether short stretches in a row are to be visible: as those before and after them are, or as most of them if there
// is more between these than a person overlooks.
bool is_most_visible(std::span<const Stretch> spurious, bool before, bool after, double most) {
  double visible = 0, all = 0;
  for (const Stretch& stretch : spurious) {
    all += stretch.length;
    visible += stretch.is_visible ? stretch.length : 0;
  }
  return before == after && all <= 2 * most ? before : 2 * visible >= all;
}

}  // namespace

std::vector<Piece> vote_on_visibility(std::vector<Piece> pieces, const std::vector<char>& is_moved, double most,
                                      const Progress& progress) {
  bool any = false;
  for (std::size_t i = 0; i < pieces.size() && !any; ++i)
    any = is_moved[i] != 0 && pieces[i].drawn && length_of(pieces[i]) <= most;
  if (!any) return pieces;
  const auto is_short = [&](const Stretch& stretch) { return stretch.is_moved && stretch.length <= most; };
  std::vector<std::pair<int, bool>> turned;
  Runs(pieces, is_moved, progress).visit([&](const std::vector<Stretch>& stretches) {
    for (std::size_t i = 1; i + 1 < stretches.size(); ++i) {
      std::size_t end = i;
      while (end + 1 < stretches.size() && is_short(stretches[end])) ++end;
      if (end == i) continue;
      const std::span<const Stretch> spurious = std::span(stretches).subspan(i, end - i);
      const bool visible = is_most_visible(spurious, stretches[i - 1].is_visible, stretches[end].is_visible, most);
      for (const Stretch& stretch : spurious)
        for (const int piece : stretch.pieces) turned.emplace_back(piece, visible);
      i = end;
    }
  });
  for (const auto& [piece, visible] : turned) {
    check(pieces[piece].drawn, "what is turned has ink");
    pieces[piece].visible = visible;
  }
  return pieces;
}

LeftInk drop_dangles(std::vector<Piece> pieces, const std::vector<signed char>& strength,
                     const ContinuingLimits& limits, const Progress& progress) {
  const double distance = limits.distance;
  const std::vector<char> is_short = find_short(pieces, strength, limits, progress);
  if (std::find(is_short.begin(), is_short.end(), 1) == is_short.end()) return {std::move(pieces)};
  const InkParts dangles = parts_of(
      pieces, [&](std::size_t i) { return is_short[i] != 0; }, distance);
  const search::OccupiedCells near_dangles = dangles.cells_within(distance, dangle_cell * distance);
  std::vector<std::array<double, 2>> away(pieces.size(), {HUGE_VAL, HUGE_VAL});  // from lines that stay, by end
  for (std::size_t p = 0; p < pieces.size(); ++p) {
    if (is_short[p] != 0 || strength[p] < 0) continue;
    const std::array<Vec2, 2> line{pieces[p].from, pieces[p].to};
    if (!near_dangles.may_meet(line[0], line[1])) continue;
    for (const int part : dangles.find(line[0], line[1], distance)) {
      const int dangle = dangles[part].piece;
      if (pieces[dangle].visible && !pieces[p].visible) continue;
      for (std::size_t end = 0; end < 2; ++end) {
        const Vec2& at = dangles.line(part)[end];
        away[dangle][end] = std::min(away[dangle][end], glm::distance(nearest_on(line, at), at));
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
  check(kept <= pieces.size() && kept > 0, "a dangle lies on lines that stay");
  pieces.resize(kept);
  return {std::move(pieces), within};
}

}  // namespace epura::drawing
