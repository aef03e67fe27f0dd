// SPDX-License-Identifier: Apache-2.0
#include "drawing/continue_lines.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <tuple>
#include <utility>

#include "base/error.hpp"
#include "base/nearest.hpp"
#include "drawing/limits.hpp"
#include "drawing/polylines.hpp"

namespace epura::drawing {

namespace {

/// A line followed from one of its ends.
struct LooseEnd {
  std::vector<End> members;  ///< at which its pieces are entered, in order
  Vec2 at, outwards;         ///< its place, and the direction in which the line would go on
};

/// What decides whether an end may continue another one.
struct Candidate {
  Vec2 at, outwards;
  int model, number;
  bool visible;
};

/// A position on a line.
struct Foot {
  std::size_t member;
  double part;  ///< of the member from where it is entered
  double distance;
};

class Continuation {
 public:
  Continuation(std::vector<Piece>& pieces, const std::vector<int>& models, const ContinuingLimits& limits)
      : pieces_(pieces),
        models_(models),
        distance_(limits.distance),
        touching_(limits.touching),
        is_dropped_(pieces.size(), 0),
        links_(pieces.size()) {}

  void run(const Progress& progress) {
    const Polylines lines(pieces_, std::vector<signed char>(pieces_.size(), 1), progress, touching_);
    for (std::size_t i = 0; i < lines.size(); ++i) {
      if (lines.is_closed(i)) continue;
      std::vector<End> members(lines[i].begin(), lines[i].end());
      add_end(members);
      std::reverse(members.begin(), members.end());
      std::transform(members.begin(), members.end(), members.begin(), other);
      add_end(std::move(members));
    }
    check(ends_.size() <= 2 * pieces_.size(), "a piece has two ends");
    // Of two lines, the first stays whole: the numbering of faces does not tell which one that is.
    std::ranges::stable_sort(ends_, {}, [](const LooseEnd& end) { return std::pair(end.at.x, end.at.y); });
    for (const auto& [cost, one, two] : pairs()) {
      progress.expect_time();
      if (is_joined_[one] != 0 || is_joined_[two] != 0 || cost <= touching_) continue;
      if (join(one, two) || join(two, one)) is_joined_[one] = is_joined_[two] = 1;
    }
  }

  /// Within which distance of what is cut off there is ink, mm.
  [[nodiscard]] double within() const { return within_; }

  /// Adds what is left of a piece, with the links at its ends. A link belongs to the point where it begins.
  void add(std::size_t number, std::vector<Piece>& to) const {
    if (is_dropped_[number] != 0) return;
    const Piece& piece = pieces_[number];
    const auto& [before, after] = links_[number];
    Piece link = piece;
    if (before) {
      link.from = piece.from, link.to = *before, link.s = {piece.s[0], piece.s[0]};
      to.push_back(link);
    }
    to.push_back(piece);
    if (after) {
      link.from = piece.to, link.to = *after, link.s = {piece.s[1], piece.s[1]};
      to.push_back(link);
    }
  }

 private:
  using Pair = std::tuple<double, std::size_t, std::size_t>;
  using Cell = std::array<long, 2>;

  [[nodiscard]] Vec2 place(End end) const {
    const Piece& piece = pieces_[line_of(end)];
    return end % 2 == 0 ? piece.from : piece.to;
  }

  void add_end(std::vector<End> members) {
    LooseEnd end{std::move(members), {}, {}};
    end.at = place(end.members.front());
    Vec2 inside = end.at;
    for (std::size_t i = 0; i < end.members.size() && glm::distance(inside, end.at) < with_direction_at_end * distance_;
         ++i)
      inside = place(other(end.members[i]));
    const double length = glm::distance(inside, end.at);
    if (!(length > 0)) return;
    end.outwards = (end.at - inside) / length;
    ends_.push_back(std::move(end));
    is_joined_.push_back(0);
  }

  // Whether two ends may continue each other: the first line goes a little beyond the end of the second one.
  [[nodiscard]] bool may_continue(const Candidate& one, const Candidate& two) const {
    if (one.model != two.model || one.visible != two.visible) return false;
    if (glm::dot(one.outwards, two.outwards) > -continuing_cosine) return false;
    const double along = glm::dot(one.at - two.at, one.outwards);
    return along >= -distance_ && along <= max_overlap * distance_;
  }

  [[nodiscard]] Candidate candidate(std::size_t number) const {
    const LooseEnd& end = ends_[number];
    const int piece = line_of(end.members.front());
    return {end.at, end.outwards, models_[piece], static_cast<int>(number), pieces_[piece].visible};
  }

  // Pairs of ends that may continue each other, the closest first.
  [[nodiscard]] std::vector<Pair> pairs() const {
    const double size = (max_overlap + 1) * distance_;
    std::vector<std::pair<Cell, Candidate>> cells;
    cells.reserve(ends_.size());
    for (std::size_t i = 0; i < ends_.size(); ++i) {
      const Candidate end = candidate(i);
      cells.emplace_back(Cell{std::lround(std::floor(end.at.x / size)), std::lround(std::floor(end.at.y / size))}, end);
    }
    const auto by_cell = [](const auto& a, const auto& b) {
      return std::tie(a.first, a.second.number) < std::tie(b.first, b.second.number);
    };
    std::sort(cells.begin(), cells.end(), by_cell);
    const auto begin_of = [&](const Cell& cell) {
      return std::partition_point(cells.begin(), cells.end(), [&](const auto& c) { return c.first < cell; });
    };
    std::vector<Pair> found;
    for (auto own = cells.begin(); own != cells.end();) {
      const auto [x, y] = own->first;
      const auto end = std::find_if(own, cells.end(), [&](const auto& c) { return c.first != own->first; });
      // Those of the three cells of a column are neighbours.
      for (const long column : {x - 1, x, x + 1}) {
        const auto first = begin_of({column, y - 1}), last = begin_of({column, y + 2});
        for (auto one = own; one != end; ++one)
          for (auto other = first; other != last; ++other)
            if (other->second.number > one->second.number && may_continue(one->second, other->second))
              found.emplace_back(glm::distance(one->second.at, other->second.at), one->second.number,
                                 other->second.number);
      }
      own = end;
    }
    std::sort(found.begin(), found.end());
    check(std::adjacent_find(found.begin(), found.end()) == found.end(), "two ends are one pair");
    return found;
  }

  // The point of a line that is nearest to `p`, within `reach` mm along it from its end.
  [[nodiscard]] Foot foot(const LooseEnd& line, const Vec2& p, double reach) const {
    Foot nearest{0, 0, glm::distance(p, line.at)};
    double walked = 0;
    for (std::size_t i = 0; i < line.members.size() && walked <= reach; ++i) {
      const Vec2 from = place(line.members[i]), to = place(other(line.members[i]));
      const double part = nearest_parameter(p, from, to), away = glm::distance(p, from + part * (to - from));
      if (away < nearest.distance) nearest = {i, part, away};
      walked += glm::distance(from, to);
    }
    return nearest;
  }

  // How far what is cut off up to `end` is from the other line.
  [[nodiscard]] double distance_between(const LooseEnd& cut, const Foot& end, const LooseEnd& line,
                                        double reach) const {
    double farthest = end.distance;
    for (std::size_t i = 0; i <= end.member && farthest <= distance_; ++i)
      farthest = std::max(farthest, foot(line, place(cut.members[i]), reach).distance);
    return farthest;
  }

  // Moves a position on a line away from its end, not to a link; nothing if the line is too short.
  [[nodiscard]] std::optional<Foot> beyond(const LooseEnd& line, Foot at, double by) const {
    for (; at.member < line.members.size(); ++at.member, at.part = 0) {
      const double length = glm::distance(place(line.members[at.member]), place(other(line.members[at.member])));
      if (length > 0 && (1 - at.part) * length > by && !is_link(pieces_[line_of(line.members[at.member])])) {
        at.part += by / length;
        return at;
      }
      by = std::max(0.0, by - (1 - at.part) * length);  // a link may be longer than that
    }
    return std::nullopt;
  }

  // Makes the second line begin where the first one ends.
  bool join(std::size_t first, std::size_t second) {
    const LooseEnd& line = ends_[first];
    LooseEnd& cut = ends_[second];
    const double reach = 2 * glm::distance(line.at, cut.at) + 2 * distance_;
    const Foot end = foot(cut, line.at, reach);
    const double between = distance_between(cut, end, line, reach);
    if (between > distance_) return false;
    const auto begin = beyond(cut, end, max_approach * end.distance);
    if (!begin || is_cut_off(line, 0) || is_cut_off(cut, begin->member)) return false;
    for (std::size_t i = 0; i < begin->member; ++i) is_dropped_[line_of(cut.members[i])] = 1;
    const End entered = cut.members[begin->member];
    Piece& piece = pieces_[line_of(entered)];
    const auto side = static_cast<std::size_t>(entered % 2);
    check(begin->part >= 0 && begin->part <= 1, "a line is cut between its ends");
    const Vec2 at = place(entered) + begin->part * (place(other(entered)) - place(entered));
    piece.s[side] += begin->part * (piece.s[1 - side] - piece.s[side]);
    (side == 0 ? piece.from : piece.to) = at;
    if (at != line.at) links_[line_of(entered)][side] = line.at;
    within_ = std::max(within_, between);
    return true;
  }

  // Whether a short line has been cut off up to here from its other end.
  [[nodiscard]] bool is_cut_off(const LooseEnd& line, std::size_t member) const {
    return is_dropped_[line_of(line.members[member])] != 0;
  }

  std::vector<Piece>& pieces_;
  const std::vector<int>& models_;
  double distance_, touching_;
  double within_ = 0;
  std::vector<LooseEnd> ends_;
  std::vector<char> is_joined_, is_dropped_;
  std::vector<std::array<std::optional<Vec2>, 2>> links_;  ///< by piece and side: where another line ends
};

}  // namespace

LeftInk continue_lines(std::vector<Piece> pieces, const std::vector<int>& models, const ContinuingLimits& limits,
                       const Progress& progress) {
  std::vector<std::size_t> numbers;  // of the lines
  std::vector<Piece> lines;
  std::vector<int> their_models;
  for (std::size_t i = 0; i < pieces.size(); ++i)
    if (pieces[i].drawn && pieces[i].kind == EdgeKind::contour) {
      numbers.push_back(i);
      lines.push_back(pieces[i]);
      their_models.push_back(models[i]);
    }
  if (lines.empty() || !(limits.distance > 0)) return {std::move(pieces)};
  Continuation continuation(lines, their_models, limits);
  continuation.run(progress);
  std::vector<Piece> result;
  result.reserve(pieces.size());
  std::size_t next = 0;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    if (next < numbers.size() && numbers[next] == i)
      continuation.add(next++, result);
    else
      result.push_back(pieces[i]);
  }
  check(next == numbers.size(), "every line is continued or not");
  return {std::move(result), continuation.within()};
}

}  // namespace epura::drawing
