#include "visibility/edge_hider.hpp"

namespace epura {

EdgeHider::EdgeHider(const View& view, const Contact& contact, const OccluderGrid& occluders, const Sightline& line,
                     const OwnTriangles& own, int most_tries)
    : view_(view), contact_(contact), occluders_(occluders), line_(line), own_(own), most_tries_(most_tries) {
  tried_.fill(-1);
}

void EdgeHider::hide(const Stretch& stretch) {
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

Spans EdgeHider::spans() && {
  absorb_slivers(spans_, least_span(view_, line_));
  return std::move(spans_);
}

void EdgeHider::hide_by_tree(const Stretch& stretch) {
  const double least = least_span(view_, line_);
  const auto open = [&] { return open_part(spans_, stretch.from, stretch.to, least); };
  const auto before = [&](const std::array<double, 2>& part) {
    return stretch.tree->before(occluders_.point(line_, part[0]), occluders_.point(line_, part[1]));
  };
  auto rest = open();
  if (!rest) return;
  CandidateTree::Bounds wanted = before(*rest);
  stretch.tree->visit(wanted, [&](int triangle) {
    if (hide_by(triangle)) {
      rest = open();
      if (!rest) return false;
      wanted = before(*rest);
    }
    return tries_ < most_tries_;
  });
}

}  // namespace epura
