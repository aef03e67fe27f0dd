// SPDX-License-Identifier: Apache-2.0
#include "drawing/exact_lines.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

#include "base/error.hpp"
#include "drawing/conic_fit.hpp"
#include "drawing/curve_part.hpp"
#include "drawing/drawn_lines.hpp"
#include "drawing/exact_crossings.hpp"
#include "drawing/known_circles.hpp"
#include "drawing/limits.hpp"
#include "drawing/part_edges.hpp"
#include "drawing/places.hpp"

namespace epura::drawing {

namespace {

// Moves one end of an arc along it. Returns false if nothing would be left of the arc.
bool move_end(double& moved, double other, double turn) {
  if (!((moved + turn - other) * (moved - other) > 0)) return false;
  moved += turn;
  return true;
}

/// Where the first and the last point of a line are on facets.
using EndsOnFacets = std::array<Vec2, 2>;

/// Ends lines of a parallel projection where what hides the rest of them is drawn. Facets hide lines where their own
/// sides are. Arcs are drawn beside these, and so are crossings of surfaces: lines that they hide end at them, and so
/// do arcs that anything hides. No end moves by more than a facet.
class EndMover {
 public:
  /// `ends` are those of each chain before curves were found.
  EndMover(const ExactCrossings& crossings, const std::vector<EndsOnFacets>& ends, double touching,
           ViewDrawing& drawing)
      : crossings_(crossings),
        ends_(ends),
        drawing_(drawing),
        touching_(touching),
        moved_(drawing.distances.coincident) {}

  void move() {
    const DrawnLines drawn(drawn_lines(drawing_.chains, all_facets()), drawing_.distances.coincident, touching_);
    // Visible lines first: their hidden parts end at the same places.
    for (const bool visible : {true, false})
      for (std::size_t i = 0; i < drawing_.chains.size(); ++i)
        if (drawing_.chains[i].visible == visible && !drawing_.chains[i].closed) move_ends(drawn, i);
  }

 private:
  // The places of lines before any of them moves.
  [[nodiscard]] std::vector<std::vector<Vec2>> all_facets() const {
    std::vector<std::vector<Vec2>> all;
    for (std::size_t number = 0; number < drawing_.chains.size(); ++number) {
      const Chain& chain = drawing_.chains[number];
      all.push_back(chain.points);
      if (chain.closed) continue;
      all.back().front() = ends_[number][0];
      all.back().back() = ends_[number][1];
    }
    return all;
  }

  static bool is_inside_arc(const Chain& chain, int i) {
    const int count = static_cast<int>(chain.points.size());
    return std::any_of(chain.curves.begin(), chain.curves.end(), [&](const CurvePart& curve) {
      return (curve.first < i && i < curve.last) || (curve.first < i + count && i + count < curve.last);
    });
  }

  // Moves nothing if nothing would be left of an arc.
  static void move_point(Chain& chain, int i, const Vec2& place) {
    const int count = static_cast<int>(chain.points.size());
    check(0 <= i && i < count, "a line is moved where it has a point");
    if (is_inside_arc(chain, i)) return;
    Vec2 on_arc = place;
    std::vector<CurvePart> curves = chain.curves;
    for (CurvePart& curve : curves) {
      const Ellipse ellipse{curve.centre, curve.u, curve.v};
      const Vec2& point = chain.points[static_cast<std::size_t>(i)];
      const double turn = std::remainder(ellipse.angle_of(place) - ellipse.angle_of(point), 2 * std::numbers::pi);
      if (curve.first == i) {
        if (!move_end(curve.from, curve.to, turn)) return;
        on_arc = ellipse.at(curve.from);
      }
      if (curve.last == i || curve.last == i + count) {
        if (!move_end(curve.to, curve.from, turn)) return;
        on_arc = ellipse.at(curve.to);
      }
    }
    chain.points[static_cast<std::size_t>(i)] = on_arc;
    chain.curves = std::move(curves);
  }

  // Whether something hides the rest of the edge at the end of a line.
  [[nodiscard]] bool ends_in_edge(const Segment& segment, const Vec2& end) const {
    const bool is_first = glm::distance(segment.from, end) < glm::distance(segment.to, end);
    const double t = segment.t[is_first ? 0 : 1];
    return glm::distance(is_first ? segment.from : segment.to, end) <= drawing_.distances.coincident && t != 0 &&
           t != 1;
  }

  void move_ends(const DrawnLines& lines, std::size_t number) {
    Chain& chain = drawing_.chains[number];
    for (const bool front : {true, false}) {
      const Vec2& end = ends_[number][front ? 0 : 1];
      const int segment = front ? chain.segments.front() : chain.segments.back();
      auto place = end_on_page(lines, number, front, drawing_.segments[static_cast<std::size_t>(segment)]);
      while (place && is_before_last_line(chain, front, *place)) {
        drop_end(chain, front);
        place = end_on_page(lines, number, front, drawing_.segments[static_cast<std::size_t>(segment)]);
      }
      if (!place) continue;
      move_point(chain, front ? 0 : static_cast<int>(chain.points.size()) - 1, *place);
      if (moved_.find(end) == nullptr) moved_.add(end, *place);
    }
  }

  // Whether a line of many chords ends before the last of them.
  static bool is_before_last_line(const Chain& chain, bool front, const Vec2& place) {
    const std::size_t last = chain.points.size() - 1;
    if (last < 2) return false;
    for (const CurvePart& curve : chain.curves)
      if (front ? curve.first <= 1 : curve.last >= static_cast<int>(last) - 1) return false;
    const Vec2 &end = chain.points[front ? 0 : last], &before = chain.points[front ? 1 : last - 1];
    return glm::dot(place - before, end - before) < 0;
  }

  static void drop_end(Chain& chain, bool front) {
    if (!front) return chain.points.pop_back();
    chain.points.erase(chain.points.begin());
    for (CurvePart& curve : chain.curves) {
      --curve.first;
      --curve.last;
    }
  }

  // Where a line ends; nothing if it ends where it is.
  [[nodiscard]] std::optional<Vec2> end_on_page(const DrawnLines& lines, std::size_t number, bool front,
                                                const Segment& segment) const {
    const Chain& chain = drawing_.chains[number];
    const Vec2& end = ends_[number][front ? 0 : 1];
    if (const Vec2* moved = moved_.find(end)) return *moved;
    if (const auto crossed = crossings_.moved(end)) return crossed;
    if (is_link(segment)) return std::nullopt;
    const std::size_t last = chain.points.size() - 1;
    const Vec2 &before = chain.points[front ? 1 : last - 1], &drawn_end = chain.points[front ? 0 : last];
    DrawnLine own{{before, drawn_end}, PageCurve(before, drawn_end), false, chain.visible, static_cast<int>(number)};
    for (const CurvePart& curve : chain.curves)
      if (front ? curve.first == 0 : curve.last == static_cast<int>(last)) {
        own.drawn = PageCurve(curve);
        own.is_moved = true;
        own.curve = static_cast<int>(&curve - chain.curves.data());
      }
    const bool is_crossing = segment.crossing >= 0 && segment.kind != EdgeKind::contour;
    own.is_moved = own.is_moved || is_crossing;
    if (!ends_in_edge(segment, end)) {
      if (own.curve < 0 || is_crossing) return std::nullopt;
      return lines.end_at_vertex(own, end, drawn_end);
    }
    return lines.end_in_edge(own, end);
  }

  const ExactCrossings& crossings_;
  const std::vector<EndsOnFacets>& ends_;
  ViewDrawing& drawing_;
  double touching_;
  Places<Vec2> moved_;  ///< by the place of the end on facets
};

void widen_box(ViewDrawing& drawing) {
  for (const Chain& chain : drawing.chains) {
    const auto add = [&](const Vec2& place) {
      drawing.box.min = glm::min(drawing.box.min, place);
      drawing.box.max = glm::max(drawing.box.max, place);
    };
    for (const Vec2& point : chain.points) add(point);
    for (const CurvePart& curve : chain.curves)
      for (const Vec2& place : outermost_places(curve)) add(place);
  }
}

}  // namespace

CurveReport draw_exactly(const world::World& world, ViewDrawing& drawing, CurveLimits limits,
                         const Progress& progress) {
  const PartEdges edges(world);
  const ExactCrossings crossings(edges, drawing);
  std::vector<EndsOnFacets> ends;
  for (Chain& chain : drawing.chains) {
    ends.push_back({chain.points.front(), chain.points.back()});
    limits.exact.push_back(crossings.refine(chain, part_if_exact * limits.tolerance) ? 1 : 0);
  }
  const KnownCircles known = known_circles(edges, drawing);
  const CurveReport found = find_curves(drawing.chains, limits, known, progress);
  if (!drawing.projection.central) EndMover(crossings, ends, limits.tolerance, drawing).move();
  widen_box(drawing);
  return found;
}

}  // namespace epura::drawing
