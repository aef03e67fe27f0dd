// SPDX-License-Identifier: Apache-2.0
#include "drawing/settled_pieces.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <span>
#include <utility>

#include "base/error.hpp"
#include "base/parallel.hpp"
#include "drawing/facet_doubts.hpp"
#include "drawing/limits.hpp"
#include "drawing/moved_contours.hpp"

namespace epura::drawing {

namespace {

// Hidden pieces of contours that are drawn on the surface are among them in any case.
std::vector<Piece> pieces_of(const visibility::ResolvedView& lines, const view::PaperMap& paper, bool keep_hidden,
                             const Progress& progress) {
  const edges::FeatureEdges& drawn = lines.drawn;
  const auto visit_drawn = [&](std::size_t e, const auto& visit) {
    const bool keeps = keep_hidden || drawn.edges[e].is_moved();
    // What is in such spans is drawn in another way.
    const auto visit_around = [&](double from, double to, std::span<const visibility::FacetsSpan> spans, bool visible) {
      for (const visibility::FacetsSpan& span : spans) {
        const double begin = std::clamp(span.from, from, to), end = std::clamp(span.to, from, to);
        if (!(begin < end)) continue;
        if (from < begin) visit(from, begin, visible, false);
        if (visible) visit(begin, end, true, true);
        from = end;
      }
      if (from < to) visit(from, to, visible, false);
    };
    lines.hidden.visit_parts(e, [&](double from, double to, bool visible) {
      if (visible || keeps)
        visit_around(from, to, visible ? lines.hidden.hidden_by_facets(e) : lines.hidden.folds_of(e), visible);
    });
  };
  std::vector<std::size_t> first(drawn.edges.size() + 1, 0);  // index of the first piece, by edge
  for (std::size_t e = 0; e < drawn.edges.size(); ++e) {
    first[e + 1] = first[e];
    visit_drawn(e, [&](double, double, bool, bool) { ++first[e + 1]; });
  }
  std::vector<Piece> pieces(first.back());
  parallel_for(drawn.edges.size(), grain::medium, progress, [&](std::size_t begin, std::size_t end) {
    for (std::size_t e = begin; e < end; ++e) {
      const edges::FeatureEdge& edge = drawn.edges[e];
      Piece* piece = pieces.data() + first[e];
      visit_drawn(e, [&](double from, double to, bool visible, bool by_facets) {
        *piece++ = {position_on_paper(lines.view, paper, edge, from),
                    position_on_paper(lines.view, paper, edge, to),
                    visible,
                    /*drawn=*/true,
                    edge.kind,
                    static_cast<int>(e),
                    {from, to},
                    /*is_step=*/false,
                    by_facets};
      });
      check(piece == pieces.data() + first[e + 1], "every piece of an edge has its place");
    }
  });
  return pieces;
}

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
  parallel_for(pieces.size(), grain::medium, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      for (const std::size_t k : {0, 1})
        if (!settled[i][k] && pieces[i].s[k] > 0 && pieces[i].s[k] < 1)
          places[i][k] = met(contours, pieces[i], edge_of(lines, pieces[i]).is_moved(),
                             in_mesh(lines, paper, pieces[i], k), k == 0 ? pieces[i].from : pieces[i].to);
  });
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    if (places[i][0]) pieces[i].from = *places[i][0];
    if (places[i][1]) pieces[i].to = *places[i][1];
  }
  return settled;
}

SettledPieces settled_pieces(const visibility::ResolvedView& lines, const view::PaperMap& paper,
                             const DrawingOptions& options, const Progress& progress) {
  const double near = options.near.distance;
  SettledPieces made{settle_doubts(pieces_of(lines, paper, options.hidden || !options.leave_out, progress),
                                   near > 0 ? std::max(near, lines.drawn.moved * paper.scale) : 0, progress),
                     {},
                     0};
  made.meeting = 4 * coincidence_on_paper(lines.view, paper).tolerance;
  made.settled = meet_contours(lines, paper, made.meeting, made.pieces);
  return made;
}

}  // namespace epura::drawing
