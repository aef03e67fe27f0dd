// SPDX-License-Identifier: Apache-2.0
#include "visibility/hiding_rule.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <utility>

#include "base/error.hpp"
#include "visibility/limits.hpp"

namespace epura::visibility {

namespace {

// For a triangle that is a line on the page, depth alone decides.
double steepness(const std::optional<Vec2>& slope) { return slope ? 1 + glm::length(*slope) : 1; }

// Moves the parameter of a crossing to the part of the line where integers place it: before the edge, on it or behind
// it.
double placed(double t, std::int64_t numerator, std::int64_t denominator) {
  if (numerator <= 0) return std::min(t, 0.0);
  if (numerator >= denominator) return std::max(t, 1.0);
  return std::clamp(t, 0.0, 1.0);
}

// Where the side u, v crosses the edge on the grid: t as a fraction of integers with a positive denominator.
struct GridCrossing {
  std::int64_t numerator, denominator;
  double slack;  // how far rounding to the grid may have moved the numerator

  [[nodiscard]] double t() const { return static_cast<double>(numerator) / static_cast<double>(denominator); }
  // Far beyond an end of the edge, t multiplies the rounding of the denominator.
  [[nodiscard]] bool confirms(double other) const {
    return std::abs(other * static_cast<double>(denominator) - static_cast<double>(numerator)) <=
           slack * std::max(1.0, std::abs(other));
  }
};

GridCrossing cross_on_grid(const view::ProjectedScene& view, const PageEdge& edge, int u, int v) {
  const view::GridPoint& p = view.grid[edge.p];
  const view::GridPoint& q = view.grid[edge.q];
  const view::GridPoint& a = view.grid[u];
  const view::GridPoint& b = view.grid[v];
  const std::int64_t sx = std::int64_t{b.x} - a.x, sy = std::int64_t{b.y} - a.y;
  const std::int64_t denominator = (std::int64_t{q.x} - p.x) * sy - (std::int64_t{q.y} - p.y) * sx;
  const std::int64_t numerator = (std::int64_t{a.x} - p.x) * sy - (std::int64_t{a.y} - p.y) * sx;
  // Rounding moves both ends of both lines by less than a cell.
  const double slack = 4 * static_cast<double>(std::abs(sx) + std::abs(sy));
  return denominator < 0 ? GridCrossing{-numerator, -denominator, slack} : GridCrossing{numerator, denominator, slack};
}

// A side of a triangle that the line of the edge crosses, its ends in order of their numbers.
struct CrossedSide {
  int u = 0, v = 0;
  GridCrossing decided{};
};

// The crossing is decided on the grid and computed from unrounded coordinates. Where these do not confirm it (lines
// that are parallel within the grid cross anywhere or nowhere), its position on the grid is used.
SideCrossing place_crossing(const view::ProjectedScene& view, const PageEdge& edge, const CrossedSide& crossed) {
  const view::PageVertex& u = view.vertices[crossed.u];
  const view::PageVertex& v = view.vertices[crossed.v];
  const GridCrossing& decided = crossed.decided;
  const Vec2 p = view.vertices[edge.p].at();
  const Vec2 along = view.vertices[edge.q].at() - p;
  const Vec2 side = v.at() - u.at();
  const double length2 = glm::dot(side, side);
  const auto on_side = [&](double t) { return glm::dot(p + t * along - u.at(), side); };  // times length2

  const double turn = cross(along, side);
  const double computed = cross(u.at() - p, side) / turn;
  const double s = on_side(computed);
  const double cell = view.cell * std::sqrt(length2);
  const auto is_within = [&](double cells) { return s >= -cells * cell && s <= length2 + cells * cell; };
  const bool agrees = decided.confirms(computed);
  const bool confirmed = agrees && is_within(crossing_cells);
  const auto place = [&](double t) { return placed(t, decided.numerator, decided.denominator); };
  // Rounding turns the line of a short edge, so that far beyond the edge it hits a side which the edge's own line
  // misses. The plane of the triangle goes on there.
  const bool is_turned = agrees && !confirmed && std::abs(turn) > min_turn * cell;
  if (is_turned && is_within(crossing_cells * std::abs(computed)) && place(computed) == computed)
    return {computed, s / length2, crossed.u, crossed.v};
  const double t = place(confirmed ? computed : decided.t());
  return {t, std::clamp((t == computed ? s : on_side(t)) / length2, 0.0, 1.0), crossed.u, crossed.v};
}

// The two sides that the line of the edge crosses. `left` tells which corners lie to its left.
std::array<CrossedSide, 2> crossed_sides(const view::ProjectedScene& view, const PageEdge& edge,
                                         const view::ViewTriangle& triangle, const std::array<bool, 3>& left) {
  std::array<CrossedSide, 2> sides{};
  std::size_t count = 0;
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3;
    if (left[i] == left[j]) continue;
    const auto [u, v] = std::minmax(triangle.vertex[i], triangle.vertex[j]);
    sides[count++] = {u, v, cross_on_grid(view, edge, u, v)};
  }
  return sides;
}

// Whether both crossings lie before p, or both behind q.
bool lie_beyond_an_end(const std::array<CrossedSide, 2>& sides) {
  const GridCrossing& a = sides[0].decided;
  const GridCrossing& b = sides[1].decided;
  return (a.numerator <= 0 && b.numerator <= 0) || (a.numerator >= a.denominator && b.numerator >= b.denominator);
}

// The sides that the line of the edge crosses, if the edge and the triangle overlap as the grid decides.
std::optional<std::array<CrossedSide, 2>> sides_over(const view::ProjectedScene& view, const PageEdge& edge,
                                                     const view::ViewTriangle& triangle) {
  std::array<bool, 3> left{};
  for (int i = 0; i < 3; ++i)
    left[i] = epura::view::cross(view.grid[edge.p], view.grid[edge.q], view.grid[triangle.vertex[i]]) >= 0;
  if (left[0] == left[1] && left[1] == left[2]) return std::nullopt;
  const std::array<CrossedSide, 2> sides = crossed_sides(view, edge, triangle, left);
  return lie_beyond_an_end(sides) ? std::nullopt : std::optional(sides);
}

// The part of [from, to] where a linear difference exceeds the tolerance.
std::optional<std::array<double, 2>> exceeding(double from, double to, double at_from, double at_to, double tolerance) {
  const double over_from = at_from - tolerance;
  const double over_to = at_to - tolerance;
  if (!(over_from > 0) && !(over_to > 0)) return std::nullopt;
  if (over_from > 0 && over_to > 0) return std::array{from, to};
  const double root = std::clamp(from + (to - from) * (over_from / (over_from - over_to)), from, to);
  return over_from > 0 ? std::array{from, root} : std::array{root, to};
}

}  // namespace

std::optional<Vec2> slope_of(const view::ProjectedScene& view, const view::ViewTriangle& triangle) {
  const view::PageVertex& a = view.vertices[triangle.vertex[0]];
  const view::PageVertex& b = view.vertices[triangle.vertex[1]];
  const view::PageVertex& c = view.vertices[triangle.vertex[2]];
  const double bx = b.x - a.x, by = b.y - a.y, bz = b.depth - a.depth;
  const double cx = c.x - a.x, cy = c.y - a.y, cz = c.depth - a.depth;
  const double area = bx * cy - by * cx;
  if (std::abs(area) <= thinnest * std::max(bx * bx + by * by, cx * cx + cy * cy)) return std::nullopt;
  return Vec2(bz * cy - by * cz, bx * cz - bz * cx) / area;
}

double rise_along(const view::ProjectedScene& view, const view::ViewTriangle& triangle, const Vec2& way) {
  std::array<const view::PageVertex*, 3> corners{};
  for (int i = 0; i < 3; ++i) corners[i] = &view.vertices[triangle.vertex[i]];
  const auto squared = [&](int i, int j) {
    const Vec2 side = corners[j]->at() - corners[i]->at();
    return glm::dot(side, side);
  };
  while (squared(0, 1) < std::max(squared(1, 2), squared(2, 0)))
    std::rotate(corners.begin(), corners.begin() + 1, corners.end());
  const auto& [a, b, c] = corners;
  const Vec2 base = b->at() - a->at(), other = c->at() - a->at();
  const double along = (b->depth - a->depth) / glm::dot(base, base);
  const double across = (c->depth - a->depth - along * glm::dot(base, other)) / cross(base, other);
  return along * glm::dot(base, way) + across * cross(base, way);
}

double steepness_of(const view::ProjectedScene& view, const view::ViewTriangle& triangle) {
  return steepness(slope_of(view, triangle));
}

double min_span(const view::ProjectedScene& view, const PageEdge& edge) {
  return min_piece * view.extent / glm::distance(view.vertices[edge.p].at(), view.vertices[edge.q].at());
}

bool meets_on_grid(const view::ProjectedScene& view, const PageEdge& edge, const view::ViewTriangle& triangle) {
  return sides_over(view, edge, triangle).has_value();
}

std::optional<Overlap> overlap_of(const view::ProjectedScene& view, const PageEdge& edge,
                                  const view::ViewTriangle& triangle) {
  const auto sides = sides_over(view, edge, triangle);
  if (!sides) return std::nullopt;
  auto in = place_crossing(view, edge, (*sides)[0]), out = place_crossing(view, edge, (*sides)[1]);
  if (in.t > out.t) std::swap(in, out);
  check(in.t <= out.t, "a line enters a triangle before it leaves it");
  const double from = std::max(in.t, 0.0), to = std::min(out.t, 1.0);
  if (!(from < to)) return std::nullopt;
  return Overlap{from, to, in, out};
}

std::optional<std::array<double, 2>> hidden_part(const view::ProjectedScene& view, const PageEdge& edge,
                                                 const view::ViewTriangle& triangle) {
  const std::optional<Overlap> overlap = overlap_of(view, edge, triangle);
  if (!overlap) return std::nullopt;
  const double from = overlap->from, to = overlap->to;
  const view::PageVertex& p = view.vertices[edge.p];
  const view::PageVertex& q = view.vertices[edge.q];
  const auto in_front = [&](double t) {
    return overlap->depth(t, [&](int v) { return view.vertices[v].depth; }) - (p.depth + t * (q.depth - p.depth));
  };
  const auto& own = triangle.vertex;
  const bool holds_p = std::find(own.begin(), own.end(), edge.p) != own.end();
  const bool holds_q = std::find(own.begin(), own.end(), edge.q) != own.end();
  if (!holds_p && !holds_q) {
    const double at_from = in_front(from), at_to = in_front(to);
    if (!(at_from > 0) && !(at_to > 0)) return std::nullopt;
    return exceeding(from, to, at_from, at_to, view.contact.touching * steepness_of(view, triangle));
  }

  // At a common corner, the difference is zero by definition, and the other end decides for the whole edge. The
  // difference is measured in the triangle's plane: where the edge runs along a side, the place at which it leaves the
  // triangle is uncertain.
  const std::optional<Vec2> slope = slope_of(view, triangle);
  const view::PageVertex& corner = holds_p ? p : q;
  const view::PageVertex& end = holds_p ? q : p;
  const double part = holds_p ? to : 1 - from;
  const Vec2 way = end.at() - corner.at();
  const double ahead =
      slope ? part * (rise_along(view, triangle, way) + corner.depth - end.depth) : in_front(holds_p ? to : from);
  return ahead > view.contact.joined * steepness(slope) ? std::optional(std::array{from, to}) : std::nullopt;
}

}  // namespace epura::visibility
