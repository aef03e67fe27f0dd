// SPDX-License-Identifier: Apache-2.0
// Contours that are drawn on the surface instead of on the mesh (edges/smooth_contours.hpp), found by where they are in
// the mesh.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "base/nearest.hpp"
#include "drawing/ink.hpp"
#include "search/bounds_tree.hpp"
#include "view/paper_map.hpp"
#include "visibility/visibility.hpp"

namespace epura::drawing {

inline const edges::FeatureEdge& edge_of(const visibility::ResolvedView& lines, const Piece& piece) {
  return lines.drawn.edges[static_cast<std::size_t>(piece.edge)];
}

/// Returns where an end of a piece is in the mesh.
Vec2 in_mesh(const visibility::ResolvedView& lines, const view::PaperMap& paper, const Piece& piece, std::size_t end);

/// A visible piece of a contour that is not drawn where it is in the mesh.
struct MovedContour {
  std::size_t piece;
  std::array<Vec2, 2> in_mesh, drawn;  ///< its ends
};

class MovedContours {
 public:
  /// Two places within `tolerance` mm are the same.
  MovedContours(const visibility::ResolvedView& lines, const view::PaperMap& paper, double tolerance,
                const std::vector<Piece>& pieces);

  [[nodiscard]] bool empty() const { return contours_.empty(); }

  /// Calls `visit(contour, parameter)` for contours of other edges on which a place in the mesh lies, with its
  /// position, 0 to 1, until it returns false.
  template <class Visit>
  void visit_at(const Vec2& place, int edge, const Visit& visit) const {
    const search::Bounds<2> wanted{
        {{place.x - tolerance_, place.x + tolerance_}, {place.y - tolerance_, place.y + tolerance_}}};
    bool goes_on = true;
    tree_.visit(wanted, [&](std::size_t i) {
      if (pieces_[contours_[i].piece].edge == edge) return true;
      if (const auto at = parameter_of(contours_[i], place)) goes_on = visit(contours_[i], *at);
      return goes_on;
    });
  }

  /// Whether a contour ends at a place in the mesh, inside its edge.
  [[nodiscard]] bool has_inner_end(const MovedContour& contour, const Vec2& place) const;

 private:
  [[nodiscard]] std::optional<double> parameter_of(const MovedContour& contour, const Vec2& place) const;

  double tolerance_;
  const std::vector<Piece>& pieces_;
  std::vector<MovedContour> contours_;
  search::BoundsTree<2> tree_;
};

}  // namespace epura::drawing
