// SPDX-License-Identifier: Apache-2.0
#include "drawing/moved_contours.hpp"

#include <algorithm>

#include "base/error.hpp"

namespace epura::drawing {

Vec2 in_mesh(const visibility::ResolvedView& lines, const view::PaperMap& paper, const Piece& piece, std::size_t end) {
  const edges::FeatureEdge& edge = edge_of(lines, piece);
  const Vec2 a = paper(lines.view.vertices[edge.vertex[0]]), b = paper(lines.view.vertices[edge.vertex[1]]);
  return a + piece.s[end] * (b - a);
}

MovedContours::MovedContours(const visibility::ResolvedView& lines, const view::PaperMap& paper, double tolerance,
                             const std::vector<Piece>& pieces)
    : tolerance_(tolerance), pieces_(pieces) {
  for (std::size_t i = 0; i < pieces.size(); ++i)
    if (pieces[i].visible && edge_of(lines, pieces[i]).is_moved())
      contours_.push_back({i,
                           {in_mesh(lines, paper, pieces[i], 0), in_mesh(lines, paper, pieces[i], 1)},
                           {pieces[i].from, pieces[i].to}});
  std::stable_sort(contours_.begin(), contours_.end(),
                   [](const MovedContour& a, const MovedContour& b) { return a.in_mesh[0].x < b.in_mesh[0].x; });
  tree_ = search::BoundsTree<2>(contours_.size(), [&](std::size_t i) {
    const auto& [a, b] = contours_[i].in_mesh;
    const Vec2 low = glm::min(a, b), high = glm::max(a, b);
    return search::Bounds<2>{{{low.x, high.x}, {low.y, high.y}}};
  });
}

bool MovedContours::has_inner_end(const MovedContour& contour, const Vec2& place) const {
  const std::array<double, 2>& s = pieces_[contour.piece].s;
  for (std::size_t end = 0; end < 2; ++end)
    if (s[end] > 0 && s[end] < 1 && glm::distance(contour.in_mesh[end], place) <= 2 * tolerance_) return true;
  return false;
}

// Returns the position of a place on a contour of the mesh, or nothing if it is not on it.
std::optional<double> MovedContours::parameter_of(const MovedContour& contour, const Vec2& place) const {
  const auto& [from, to] = contour.in_mesh;
  if (from == to || distance_to_segment(place, from, to) > tolerance_) return std::nullopt;
  const double parameter = nearest_parameter(place, from, to);
  check(parameter >= 0 && parameter <= 1, "a contour is met between its ends");
  return parameter;
}

}  // namespace epura::drawing
