// SPDX-License-Identifier: Apache-2.0
#include "drawing/facet_doubts.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <utility>

#include "base/disjoint_sets.hpp"
#include "base/error.hpp"
#include "drawing/kept_ink.hpp"
#include "drawing/limits.hpp"

namespace epura::drawing {

namespace {

/// The pieces in doubt, with places on each that have no other visible line beside them.
class Doubts {
 public:
  Doubts(const std::vector<Piece>& pieces, double distance)
      : pieces_(pieces),
        distance_(distance),
        parts_(parts_of(
            pieces, [&](std::size_t i) { return pieces[i].by_facets; }, distance)),
        alone_(parts_.all().size(), std::vector<char>(places_in_doubt, 1)) {}

  /// Takes note of visible lines.
  void look_at_others(const Progress& progress) {
    const search::OccupiedCells near = parts_.cells_within(distance_, dangle_cell * distance_);
    Pace pace(progress, pieces_.size());
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
      pace.left(pieces_.size() - i);
      const Piece& piece = pieces_[i];
      if (!piece.visible || piece.by_facets || !near.may_meet(piece.from, piece.to)) continue;
      for (const int part : parts_.find(piece.from, piece.to, distance_)) note({piece.from, piece.to}, part);
    }
  }

  /// Returns for each piece whether it belongs to a run of which enough is alone.
  [[nodiscard]] std::vector<char> close_gaps(const Progress& progress) const {
    DisjointSets runs(alone_.size());
    const auto line = [&](int part) { return parts_.line(part); };
    visit_meetings(alone_.size(), line, progress, [&](std::span<const End> ends) {
      for (const End end : ends) runs.join(line_of(ends.front()), line_of(end));
    });
    const std::vector<int> run = std::move(runs).roots();
    std::vector<double> alone(run.size(), 0), length(run.size(), 0);
    for (std::size_t part = 0; part < run.size(); ++part) {
      const double own = length_of(pieces_[parts_[static_cast<int>(part)].piece]);
      length[run[part]] += own;
      alone[run[part]] += own * static_cast<double>(std::ranges::count(alone_[part], 1)) / places_in_doubt;
    }
    std::vector<char> closes(pieces_.size(), 0);
    for (std::size_t part = 0; part < run.size(); ++part) {
      const int piece = parts_[static_cast<int>(part)].piece;
      check(pieces_[piece].by_facets, "a gap is closed by what facets hide");
      closes[piece] = alone[run[part]] > alone_in_gap * length[run[part]] ? 1 : 0;
    }
    return closes;
  }

 private:
  // A line is beside a place if it crosses the perpendicular there.
  void note(const std::array<Vec2, 2>& line, int part) {
    const Piece& piece = pieces_[parts_[part].piece];
    if (!(length_of(piece) > 0)) return;
    const Vec2 along = glm::normalize(piece.to - piece.from);
    std::vector<char>& alone = alone_[static_cast<std::size_t>(part)];
    for (std::size_t i = 0; i < places_in_doubt; ++i) {
      const Vec2 place = place_on(piece, (static_cast<double>(i) + 0.5) / places_in_doubt);
      const Vec2 from = line[0] - place, to = line[1] - place;
      const double before = glm::dot(along, from), after = glm::dot(along, to);
      if ((before > 0) == (after > 0)) continue;
      const double at = before / (before - after);
      if (std::abs(cross(along, from + at * (to - from))) <= distance_) alone[i] = 0;
    }
  }

  const std::vector<Piece>& pieces_;
  double distance_;
  InkParts parts_;
  std::vector<std::vector<char>> alone_;  ///< by part and place
};

std::vector<char> closing_gaps(const std::vector<Piece>& pieces, double distance, const Progress& progress) {
  Doubts doubts(pieces, distance);
  doubts.look_at_others(progress);
  return doubts.close_gaps(progress);
}

// Joins pieces that continue each other on an edge.
std::vector<Piece> joined_on_edges(std::vector<Piece> pieces) {
  std::size_t kept = 0;
  for (const Piece& piece : pieces) {
    Piece* last = kept > 0 ? &pieces[kept - 1] : nullptr;
    if (last != nullptr && last->edge == piece.edge && last->visible == piece.visible && last->s[1] == piece.s[0]) {
      last->to = piece.to;
      last->s[1] = piece.s[1];
    } else {
      pieces[kept++] = piece;
    }
  }
  pieces.resize(kept);
  return pieces;
}

}  // namespace

std::vector<Piece> settle_doubts(std::vector<Piece> pieces, double distance, const Progress& progress) {
  if (std::ranges::none_of(pieces, &Piece::by_facets)) return pieces;
  const std::vector<char> closes =
      distance > 0 ? closing_gaps(pieces, distance, progress) : std::vector<char>(pieces.size(), 0);
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    if (!pieces[i].by_facets) continue;
    pieces[i].visible = closes[i] != 0;
    pieces[i].by_facets = false;
  }
  return joined_on_edges(std::move(pieces));
}

}  // namespace epura::drawing
