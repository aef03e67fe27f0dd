#include "visibility/edge_hider.hpp"

#include <utility>

namespace epura {

EdgeHider::EdgeHider(const View& view, const Contact& contact, const OccluderGrid& occluders, const Sightline& line,
                     const OwnTriangles& own, int most_tries)
    : view_(view),
      contact_(contact),
      occluders_(occluders),
      line_(line),
      own_(own),
      least_(least_span(view, line)),
      most_tries_(most_tries) {
  tried_.fill(-1);
}

void EdgeHider::hide(const Stretch& stretch) {
  const auto part = open(stretch);
  if (!part) return;
  const auto [farthest, nearest] = occluders_.depths(line_, stretch.from, stretch.to);
  if (nearest < stretch.cover) return add_span(spans_, {stretch.from, stretch.to});
  if (stretch.tree != nullptr) return hide_by_tree(stretch, *part);
  hide_by_list(stretch, occluders_.distance(farthest));
}

Spans EdgeHider::spans() && {
  absorb_slivers(spans_, least_);
  return std::move(spans_);
}

std::optional<std::array<double, 2>> EdgeHider::open(const Stretch& stretch) const {
  return open_part(spans_, stretch.from, stretch.to, least_);
}

// Whether a triangle hides something, and was not tried just now.
bool EdgeHider::hide_by(int triangle) {
  if (std::exchange(tried_[triangle % tried_.size()], triangle) == triangle) return false;
  if (own_.contain(view_.triangles[triangle].source)) return false;
  ++tries_;
  const auto part = hidden_part(view_, line_, view_.triangles[triangle], contact_);
  if (part) add_span(spans_, *part);
  return part.has_value();
}

void EdgeHider::hide_by_list(const Stretch& stretch, double reach) {
  for (const Candidate& candidate : stretch.candidates) {
    if (candidate.distance() > reach) return;
    if (hide_by(candidate.triangle()) && !open(stretch)) return;
  }
}

void EdgeHider::hide_by_tree(const Stretch& stretch, const std::array<double, 2>& open_at_first) {
  const auto before = [&](const std::array<double, 2>& part) {
    return stretch.tree->before(occluders_.point(line_, part[0]), occluders_.point(line_, part[1]));
  };
  CandidateTree::Bounds wanted = before(open_at_first);
  stretch.tree->visit(wanted, [&](int triangle) {
    if (hide_by(triangle)) {
      const auto rest = open(stretch);
      if (!rest) return false;
      wanted = before(*rest);
    }
    return tries_ < most_tries_;
  });
}

}  // namespace epura
