// SPDX-License-Identifier: Apache-2.0
#include "drawing/settled_pieces.hpp"

#include <algorithm>
#include <cstddef>
#include <span>

#include "base/error.hpp"
#include "base/parallel.hpp"
#include "drawing/facet_doubts.hpp"
#include "drawing/meet_contours.hpp"
#include "drawing/moved_contours.hpp"

namespace epura::drawing {

namespace {

// Hidden pieces of contours that are drawn on the surface are among them in any case.
std::vector<Piece> pieces_of(const visibility::ResolvedView& lines, const view::PaperMap& paper, bool keep_hidden,
                             const Progress& progress) {
  const edges::FeatureEdges& drawn = lines.drawn;
  const auto visit_drawn = [&](std::size_t e, const auto& visit) {
    const bool keeps = keep_hidden || is_moved(drawn.edges[e]);
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
  parallel_for(drawn.edges.size(), 1024, progress, [&](std::size_t begin, std::size_t end) {
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

}  // namespace

SettledPieces settled_pieces(const visibility::ResolvedView& lines, const view::PaperMap& paper,
                             const DrawingOptions& options, const Progress& progress) {
  const double near = options.near.distance;
  SettledPieces made{pieces_of(lines, paper, options.hidden || !options.leave_out, progress), {}, 0};
  settle_doubts(made.pieces, near > 0 ? std::max(near, lines.drawn.moved * paper.scale) : 0, progress);
  made.meeting = 4 * coincidence_on_paper(lines.view, paper).tolerance;
  made.settled = meet_contours(lines, paper, made.meeting, made.pieces);
  return made;
}

}  // namespace epura::drawing
