// SPDX-License-Identifier: Apache-2.0
#include "drawing/meet_contours.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <optional>

#include "base/error.hpp"
#include "base/parallel.hpp"
#include "drawing/limits.hpp"
#include "drawing/moved_contours.hpp"

namespace epura::drawing {

namespace {

// Returns where the line of a piece crosses a contour as drawn, if that is within a distance from its end.
std::optional<Vec2> crossing_with(const MovedContour& contour, const Piece& piece, const Vec2& end, double within) {
  const Vec2 along = piece.to - piece.from, across = contour.drawn[1] - contour.drawn[0];
  const double area = cross(along, across);
  if (area == 0) return std::nullopt;
  const Vec2 to = contour.drawn[0] - piece.from;
  const double s = cross(to, across) / area;
  const Vec2 place = piece.from + s * along;
  return glm::distance(place, end) <= within ? std::optional(place) : std::nullopt;
}

// Returns where an end of a piece inside its edge is drawn, given its place in the mesh and as drawn so far; nothing if
// it stays there. `moved`: the piece itself is of a contour that is drawn on the surface.
std::optional<Vec2> met(const MovedContours& contours, const Piece& piece, bool moved, const Vec2& place,
                        const Vec2& drawn) {
  std::optional<Vec2> met;
  contours.visit_at(place, piece.edge, [&](const MovedContour& contour, double at) {
    const Vec2 there = contour.drawn[0] + at * (contour.drawn[1] - contour.drawn[0]);
    // Two contours of one surface that end there meet half way; other lines that end there continue in their own
    // direction.
    if (moved && contours.has_inner_end(contour, place)) {
      met = 0.5 * (drawn + there);
      return false;
    }
    if (!met)
      met = moved ? there
                  : crossing_with(contour, piece, drawn, max_extension * glm::distance(there, place)).value_or(there);
    return true;
  });
  return met;
}

}  // namespace

std::vector<SettledEnds> meet_contours(const visibility::ResolvedView& lines, const view::PaperMap& paper,
                                       double tolerance, std::vector<Piece>& pieces) {
  std::vector<SettledEnds> settled = move_t_junctions(lines, paper, pieces);
  check(settled.size() == pieces.size(), "each piece tells whether its ends are settled");
  const MovedContours contours(lines, paper, tolerance, pieces);
  if (contours.empty()) return settled;
  std::vector<std::array<std::optional<Vec2>, 2>> places(pieces.size());
  parallel_for(pieces.size(), 1024, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      for (const std::size_t k : {0, 1})
        if (!settled[i][k] && pieces[i].s[k] > 0 && pieces[i].s[k] < 1)
          places[i][k] = met(contours, pieces[i], is_moved(edge_of(lines, pieces[i])),
                             in_mesh(lines, paper, pieces[i], k), k == 0 ? pieces[i].from : pieces[i].to);
  });
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    if (places[i][0]) pieces[i].from = *places[i][0];
    if (places[i][1]) pieces[i].to = *places[i][1];
  }
  return settled;
}

}  // namespace epura::drawing
