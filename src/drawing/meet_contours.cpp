// SPDX-License-Identifier: Apache-2.0
#include "drawing/meet_contours.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>

#include "base/error.hpp"
#include "base/nearest.hpp"
#include "base/parallel.hpp"
#include "search/bounds_tree.hpp"

namespace epura::drawing {

namespace {

// How far a line is extended to a contour, at most, as a multiple of the distance by which the contour is moved.
constexpr double farthest = 2;

/// A visible piece of a contour that is not drawn where it is in the mesh.
struct MovedContour {
  std::size_t piece;
  std::array<Vec2, 2> in_mesh, drawn;  ///< its ends
};

bool is_moved(const edges::FeatureEdge& edge) { return edge.shown[0] >= 0 || edge.shown[1] >= 0; }

class ContourMeetings {
 public:
  ContourMeetings(const visibility::ResolvedView& lines, const view::PaperMap& paper, double tolerance,
                  const std::vector<Piece>& pieces)
      : lines_(lines), paper_(paper), tolerance_(tolerance), pieces_(pieces) {
    for (std::size_t i = 0; i < pieces.size(); ++i)
      if (pieces[i].visible && is_moved(edge_of(pieces[i])))
        contours_.push_back({i, {in_mesh(pieces[i], 0), in_mesh(pieces[i], 1)}, {pieces[i].from, pieces[i].to}});
    std::stable_sort(contours_.begin(), contours_.end(),
                     [](const MovedContour& a, const MovedContour& b) { return a.in_mesh[0].x < b.in_mesh[0].x; });
    tree_ = search::BoundsTree<2>(contours_.size(), [&](std::size_t i) { return box_of(contours_[i]); });
  }

  [[nodiscard]] bool empty() const { return contours_.empty(); }

  /// Returns where an end of a piece inside its edge is drawn, or nothing if it stays where it is.
  [[nodiscard]] std::optional<Vec2> met(std::size_t number, int end) const {
    const Piece& piece = pieces_[number];
    if (piece.s[end] <= 0 || piece.s[end] >= 1) return std::nullopt;
    const Vec2 place = in_mesh(piece, end), drawn = end == 0 ? piece.from : piece.to;
    const bool moved = is_moved(edge_of(piece));
    std::optional<Vec2> met;
    bool ends_there = false;
    const search::Bounds<2> wanted{
        {{place.x - tolerance_, place.x + tolerance_}, {place.y - tolerance_, place.y + tolerance_}}};
    tree_.visit(wanted, [&](std::size_t i) {
      const MovedContour& contour = contours_[i];
      if (pieces_[contour.piece].edge == piece.edge || ends_there) return true;
      const auto at = parameter_of(contour, place);
      if (!at) return true;
      const Vec2 there = contour.drawn[0] + *at * (contour.drawn[1] - contour.drawn[0]);
      // Two contours of one surface that end there meet half way; other lines that end there continue in their own
      // direction.
      ends_there = moved && has_inner_end(contour, place);
      if (ends_there)
        met = 0.5 * (drawn + there);
      else if (!met)
        met = moved ? there : crossing(piece, contour, drawn, farthest * glm::distance(there, place)).value_or(there);
      return !ends_there;
    });
    return met;
  }

 private:
  [[nodiscard]] const edges::FeatureEdge& edge_of(const Piece& piece) const { return lines_.drawn.edges[piece.edge]; }

  [[nodiscard]] Vec2 in_mesh(const Piece& piece, int end) const {
    const edges::FeatureEdge& edge = edge_of(piece);
    const Vec2 a = paper_(lines_.view.vertices[edge.vertex[0]]), b = paper_(lines_.view.vertices[edge.vertex[1]]);
    return a + piece.s[end] * (b - a);
  }

  static search::Bounds<2> box_of(const MovedContour& contour) {
    const Vec2 low = glm::min(contour.in_mesh[0], contour.in_mesh[1]);
    const Vec2 high = glm::max(contour.in_mesh[0], contour.in_mesh[1]);
    return {{{low.x, high.x}, {low.y, high.y}}};
  }

  // Returns the position of a place on a contour of the mesh, 0 to 1, or nothing if it is not on it.
  [[nodiscard]] std::optional<double> parameter_of(const MovedContour& contour, const Vec2& place) const {
    const auto& [from, to] = contour.in_mesh;
    if (from == to || distance_to_segment(place, from, to) > tolerance_) return std::nullopt;
    const double parameter = nearest_parameter(place, from, to);
    check(parameter >= 0 && parameter <= 1, "a contour is met between its ends");
    return parameter;
  }

  // Whether a contour ends there, inside its edge.
  [[nodiscard]] bool has_inner_end(const MovedContour& contour, const Vec2& place) const {
    const std::array<double, 2>& s = pieces_[contour.piece].s;
    for (std::size_t end = 0; end < 2; ++end)
      if (s[end] > 0 && s[end] < 1 && glm::distance(contour.in_mesh[end], place) <= 2 * tolerance_) return true;
    return false;
  }

  // Returns where the line of a piece crosses a contour as drawn, if that is within a distance from its end.
  static std::optional<Vec2> crossing(const Piece& piece, const MovedContour& contour, const Vec2& end, double within) {
    const Vec2 along = piece.to - piece.from, across = contour.drawn[1] - contour.drawn[0];
    const double area = cross(along, across);
    if (area == 0) return std::nullopt;
    const Vec2 to = contour.drawn[0] - piece.from;
    const double s = cross(to, across) / area;
    const Vec2 place = piece.from + s * along;
    return glm::distance(place, end) <= within ? std::optional(place) : std::nullopt;
  }

  const visibility::ResolvedView& lines_;
  const view::PaperMap& paper_;
  double tolerance_;
  const std::vector<Piece>& pieces_;
  std::vector<MovedContour> contours_;
  search::BoundsTree<2> tree_;
};

}  // namespace

void meet_contours(const visibility::ResolvedView& lines, const view::PaperMap& paper, double tolerance,
                   std::vector<Piece>& pieces) {
  const ContourMeetings meeting(lines, paper, tolerance, pieces);
  if (meeting.empty()) return;
  std::vector<std::array<std::optional<Vec2>, 2>> met(pieces.size());
  parallel_for(pieces.size(), 1024, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) met[i] = {meeting.met(i, 0), meeting.met(i, 1)};
  });
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    if (met[i][0]) pieces[i].from = *met[i][0];
    if (met[i][1]) pieces[i].to = *met[i][1];
  }
}

}  // namespace epura::drawing
