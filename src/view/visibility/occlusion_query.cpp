// SPDX-License-Identifier: Apache-2.0
#include "visibility/occlusion_query.hpp"

#include <algorithm>

#include "base/error.hpp"

namespace epura::visibility {

OcclusionQuery::OcclusionQuery(const view::ProjectedScene& view, const OccluderGrid& occluders, const PageEdge& line,
                               const OwnTriangles& own, int max_tries)
    : view_(view), occluders_(occluders), line_(line), own_(own), max_tries_(max_tries) {
  tried_.fill(-1);
  for (const int end : {line.p, line.q})
    for (const int triangle : occluders.copies_around(end)) hide_by(triangle);
}

void OcclusionQuery::hide(const CellSegment& stretch) {
  check(stretch.from <= stretch.to, "a part of an edge goes forwards");
  if (covers(spans_, stretch.from, stretch.to)) return;
  const auto [farthest, nearest] = occluders_.depths(line_, stretch.from, stretch.to);
  if (nearest < stretch.cover) return add_span(spans_, {stretch.from, stretch.to});
  if (stretch.tree != nullptr) return hide_by_tree(stretch);
  const double reach = occluders_.distance(farthest);
  for (const Candidate& candidate : stretch.candidates) {
    if (candidate.distance() > reach) return;
    if (hide_by(candidate.triangle()) && covers(spans_, stretch.from, stretch.to)) return;
  }
}

Spans OcclusionQuery::spans() && {
  absorb_slivers(spans_, min_span(view_, line_));
  check(spans_.empty() || (spans_.front()[0] >= 0 && spans_.back()[1] <= 1), "what is hidden lies on the edge");
  return std::move(spans_);
}

bool OcclusionQuery::hide_by(const Pile& pile) {
  ++tries_;
  if (!meets_on_grid(view_, line_, view_.triangles[pile.triangles().front()])) return false;
  if (pile.is_exact()) return hide_by_exact(pile);
  bool any = false;
  for (const int triangle : pile.triangles()) {
    any = hide_by(triangle) || any;
    if (covers(spans_, 0, 1) || tries_ >= max_tries_) break;
  }
  return any;
}

bool OcclusionQuery::hide_by_exact(const Pile& pile) {
  const auto overlap = overlap_of(view_, line_, view_.triangles[pile.triangles().front()]);
  if (!overlap) return false;
  check(overlap->from < overlap->to, "an overlap has a length");
  bool any = false;
  const auto go_on = [&](int triangle) {
    any = hide_by(triangle) || any;
    return !covers(spans_, overlap->from, overlap->to) && tries_ < max_tries_;
  };
  // A triangle must be nearer by more than contact at one end of the overlap; half of that is far more than rounding.
  const auto may_hide = [&](const Pile::Depths& depths) {
    const auto depth_of = [&](int corner) {
      const auto& corners = pile.corners();
      return depths[static_cast<std::size_t>(std::find(corners.begin(), corners.end(), corner) - corners.begin())][1];
    };
    const auto is_ahead = [&](double t) {
      return overlap->depth(t, depth_of) - occluders_.depths(line_, t, t)[0] > view_.contact.touching / 2;
    };
    return is_ahead(overlap->from) || is_ahead(overlap->to);
  };
  pile.visit(may_hide, go_on);
  return any;
}

void OcclusionQuery::hide_by_tree(const CellSegment& stretch) {
  const double min = min_span(view_, line_);
  const auto open = [&] { return open_part(spans_, stretch.from, stretch.to, min); };
  const auto before = [&](const std::array<double, 2>& part) {
    return stretch.tree->before(view_, line_, {occluders_.point(line_, part[0]), occluders_.point(line_, part[1])});
  };
  stretch.tree->visit_joined(view_, line_, [&](int triangle) { hide_by(triangle); });
  auto rest = open();
  if (!rest) return;
  CandidateTree::Bounds wanted = before(*rest);
  stretch.tree->visit(wanted, [&](const auto& thing) {
    if (hide_by(thing)) {
      rest = open();
      if (!rest) return false;
      wanted = before(*rest);
    }
    return tries_ < max_tries_;
  });
}

}  // namespace epura::visibility
