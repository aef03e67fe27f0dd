// SPDX-License-Identifier: Apache-2.0
#include "drawing/exact_contours.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "base/error.hpp"
#include "drawing/conic_fit.hpp"
#include "drawing/drawn_lines.hpp"
#include "drawing/limits.hpp"
#include "drawing/places.hpp"

namespace epura::drawing {

namespace {

using surfaces::PartSurface;
using surfaces::SurfaceKind;

/// The generators of a cylinder or cone at which it turns away from the viewer: directions away from its axis.
std::optional<std::array<Vec3, 2>> generators_of(const PartSurface& surface, const Vec3& towards_viewer) {
  const double along = glm::dot(surface.axis, towards_viewer);
  const Vec3 across = towards_viewer - along * surface.axis;
  const double length = glm::length(across);
  // A normal is u - slope * axis, for the unit vector u away from the axis.
  const double cosine = surface.slope * along / length;
  if (!(std::abs(cosine) < 1)) return std::nullopt;
  const Vec3 u = across / length, v = glm::cross(surface.axis, u);
  const double sine = std::sqrt(1 - cosine * cosine);
  return std::array{cosine * u + sine * v, cosine * u - sine * v};
}

// Whether an edge runs along a generator rather than across facets.
bool is_along_generator(const PartSurface& surface, const Vec3& from, const Vec3& to) {
  const auto away = [&](const Vec3& point) {
    const Vec3 out = point - surface.origin;
    return glm::normalize(out - glm::dot(out, surface.axis) * surface.axis);
  };
  return glm::length(glm::cross(away(from), away(to))) < told_apart_sine;
}

// The point of a surface at the height of another point, in a direction away from the axis.
Vec3 on_surface(const PartSurface& surface, const Vec3& point, const Vec3& away) {
  const double height = glm::dot(point - surface.origin, surface.axis);
  return surface.origin + height * surface.axis + (surface.radius + surface.slope * height) * away;
}

/// A contour of facets, and where it is on the surface.
struct Moved {
  std::array<Vec2, 2> facets, surface;
  std::array<bool, 2> ends_in_edge;  ///< something hides the rest of the edge
  bool visible;
};

// Moves one end of an arc along it. Returns false if nothing would be left of the arc.
bool move_end(double& moved, double other, double turn) {
  if (!((moved + turn - other) * (moved - other) > 0)) return false;
  moved += turn;
  return true;
}

class Mover {
 public:
  Mover(const PartEdges& edges, const ExactCrossings& crossings, const std::vector<EndsOnFacets>& ends, double touching,
        ViewDrawing& drawing)
      : edges_(edges),
        crossings_(crossings),
        ends_(ends),
        drawing_(drawing),
        touching_(touching),
        towards_viewer_(glm::normalize(drawing.projection.projector)),
        moved_(drawing.distances.coincident) {}

  void move() {
    std::vector<Moved> contours;
    for (const Segment& segment : drawing_.segments)
      if (segment.kind == EdgeKind::contour && !is_link(segment))
        if (const auto moved = moved_contour(segment)) contours.push_back(*moved);
    const std::vector<std::vector<Vec2>> facets = all_facets();
    const DrawnLines before = lines_with({}, facets);
    std::erase_if(contours,
                  [&](const Moved& contour) { return !can_move(before, contour, 0) || !can_move(before, contour, 1); });
    keep_what_would_vanish(before, contours);
    const DrawnLines lines = lines_with(contours, facets);
    // Ends of edges first: where two contours lie on each other, since the facet between them is seen edge-on, the rest
    // of one begins where the other ends.
    for (const bool in_edge : {false, true})
      for (const Moved& contour : contours)
        for (const std::size_t end : {0, 1})
          if (contour.ends_in_edge[end] == in_edge && moved_.find(contour.facets[end]) == nullptr)
            moved_.add(contour.facets[end], place_of_end(lines, contour, end));
    for (std::size_t i = 0; i < drawing_.chains.size(); ++i) move(lines, facets[i], drawing_.chains[i]);
    const DrawnLines drawn = lines_with(contours, facets);
    // Visible lines first: their hidden parts end at the same places.
    for (const bool visible : {true, false})
      for (std::size_t i = 0; i < drawing_.chains.size(); ++i)
        if (drawing_.chains[i].visible == visible && !drawing_.chains[i].closed) move_ends(drawn, i);
  }

 private:
  [[nodiscard]] Vec2 on_page(const Vec3& point) const { return Vec2(drawing_.world_to_page * Vec4(point, 1)); }

  // The surface of the cylinder or cone inside which an edge lies along a generator.
  [[nodiscard]] const PartSurface* surface_of(const Segment& segment) const {
    const surfaces::PartFace* face = edges_.face_around(segment);
    if (face == nullptr) return nullptr;
    const PartSurface& surface = face->surface;
    if (surface.kind != SurfaceKind::cylinder && surface.kind != SurfaceKind::cone) return nullptr;
    const bool along = is_along_generator(surface, edges_.place_on(segment, 0), edges_.place_on(segment, 1));
    return along ? &surface : nullptr;
  }

  [[nodiscard]] std::optional<Moved> moved_contour(const Segment& segment) const {
    const PartSurface* surface = surface_of(segment);
    if (surface == nullptr) return std::nullopt;
    const auto generators = generators_of(*surface, towards_viewer_);
    if (!generators) return std::nullopt;
    const Vec3 out = edges_.place_on(segment, 0.5) - surface->origin;
    const bool first = glm::dot(out, (*generators)[0]) > glm::dot(out, (*generators)[1]);
    const Vec3& away = (*generators)[first ? 0 : 1];
    // Not those of the segment: its ends may have moved along the edge, to what hides the rest of it.
    const Vec2 begin = on_page(edges_.place_on(segment, 0)), along = on_page(edges_.place_on(segment, 1)) - begin;
    const auto parameter = [&](const Vec2& end) { return glm::dot(end - begin, along) / glm::dot(along, along); };
    const double first_t = parameter(segment.from), last_t = parameter(segment.to);
    if (!(glm::distance(begin + first_t * along, segment.from) <= on_line_mm)) return std::nullopt;
    if (!(glm::distance(begin + last_t * along, segment.to) <= on_line_mm)) return std::nullopt;
    const Vec3 from = edges_.place_on(segment, first_t), to = edges_.place_on(segment, last_t);
    const auto moved = [&](const Vec3& point) { return on_page(on_surface(*surface, point, away)); };
    const auto is_inside = [](double t) { return t != 0 && t != 1; };
    return Moved{{segment.from, segment.to},
                 {moved(from), moved(to)},
                 {is_inside(segment.t[0]), is_inside(segment.t[1])},
                 segment.visible};
  }

  [[nodiscard]] static DrawnLine line_of(const Moved& contour) {
    return {contour.facets, PageCurve(contour.surface[0], contour.surface[1]), true, false, contour.visible};
  }

  // Crossings with other surfaces may have moved ends of contours in their chains already.
  [[nodiscard]] DrawnLines lines_with(const std::vector<Moved>& contours,
                                      const std::vector<std::vector<Vec2>>& facets) const {
    std::vector<DrawnLine> all = drawn_lines(drawing_.chains, facets);
    for (const Moved& contour : contours) all.push_back(line_of(contour));
    return {std::move(all), drawing_.distances.coincident, touching_};
  }

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

  // Whether a contour still meets what it ends at: the arc of a rim, the crossing with another surface, or what hides
  // the rest of it.
  [[nodiscard]] bool can_move(const DrawnLines& lines, const Moved& contour, std::size_t number) const {
    const Vec2& end = contour.facets[number];
    if (!contour.ends_in_edge[number]) return lines.has_arc_through(contour.surface[number], end);
    return !crossings_.is_node(end) || crossings_.moved(end);
  }

  // Where a contour ends on the surface.
  [[nodiscard]] Vec2 place_of_end(const DrawnLines& lines, const Moved& contour, std::size_t number) const {
    const Vec2& end = contour.facets[number];
    if (const auto met = crossings_.moved(end)) return *met;
    const Vec2& place = contour.surface[number];
    return contour.ends_in_edge[number] ? lines.end_in_edge(line_of(contour), end).value_or(place) : place;
  }

  // Contours stay where they, or arcs that end where they do, are so short that the surface would turn them over:
  // something hides them before the place where both meet on the surface.
  void keep_what_would_vanish(const DrawnLines& lines, std::vector<Moved>& contours) const {
    Places<Vec2> ends(drawing_.distances.coincident);
    Places<bool> stuck(drawing_.distances.coincident);
    for (const Moved& contour : contours) {
      check(contour.facets[0] != contour.facets[1], "a contour on facets has a length");
      const std::array places{place_of_end(lines, contour, 0), place_of_end(lines, contour, 1)};
      for (const std::size_t end : {0, 1})
        if (!contour.ends_in_edge[end]) ends.add(contour.facets[end], places[end]);
      // Of two contours on each other, nothing is left of the rest of one.
      const Vec2 along = glm::normalize(contour.facets[1] - contour.facets[0]);
      if (glm::dot(places[1] - places[0], along) >= -drawing_.distances.coincident) continue;
      for (const Vec2& end : contour.facets) stuck.add(end, true);
    }
    for (const Chain& chain : drawing_.chains)
      for (std::size_t i = 0; i < chain.points.size(); ++i) {
        const Vec2* place = ends.find(chain.points[i]);
        if (place == nullptr) continue;
        Chain moved = chain;
        if (!move_point(moved, static_cast<int>(i), *place)) stuck.add(chain.points[i], true);
      }
    std::erase_if(contours, [&](const Moved& contour) {
      const auto is_stuck = [&](std::size_t end) {
        return !contour.ends_in_edge[end] && stuck.find(contour.facets[end]) != nullptr;
      };
      return is_stuck(0) || is_stuck(1);
    });
  }

  // Arcs through a place go on as they are; those that end there end where the contour touches them, also if its own
  // end is covered by the chord of a rim that is seen edge-on.
  void move(const DrawnLines& lines, const std::vector<Vec2>& facets, Chain& chain) {
    const int count = static_cast<int>(chain.points.size());
    for (int i = 0; i < count; ++i) {
      if (is_inside_arc(chain, i)) continue;
      const Vec2& end = facets[static_cast<std::size_t>(i)];
      if (const Vec2* moved = moved_.find(end)) {
        move_point(chain, i, *moved);
        continue;
      }
      for (std::size_t c = 0; c < chain.curves.size(); ++c) {
        const CurvePart curve = chain.curves[c];  // moving a point replaces all of them
        const bool begins = curve.first == i;
        if (!begins && curve.last % count != i) continue;
        const int other = begins ? i - 1 : i + 1;
        if (!chain.closed && (other < 0 || other == count)) continue;
        const auto touch =
            lines.touch_of_contour(curve, {end, facets[static_cast<std::size_t>((other + count) % count)]});
        if (touch && move_point(chain, i, *touch)) moved_.add(end, *touch);
      }
    }
  }

  static bool is_inside_arc(const Chain& chain, int i) {
    const int count = static_cast<int>(chain.points.size());
    return std::any_of(chain.curves.begin(), chain.curves.end(), [&](const CurvePart& curve) {
      return (curve.first < i && i < curve.last) || (curve.first < i + count && i + count < curve.last);
    });
  }

  // Returns false, and moves nothing, if nothing would be left of an arc.
  static bool move_point(Chain& chain, int i, const Vec2& place) {
    const int count = static_cast<int>(chain.points.size());
    check(0 <= i && i < count, "a line is moved where it has a point");
    if (is_inside_arc(chain, i)) return true;
    Vec2 on_arc = place;
    std::vector<CurvePart> curves = chain.curves;
    for (CurvePart& curve : curves) {
      const Ellipse ellipse{curve.centre, curve.u, curve.v};
      const Vec2& point = chain.points[static_cast<std::size_t>(i)];
      const double turn = std::remainder(ellipse.angle_of(place) - ellipse.angle_of(point), 2 * std::numbers::pi);
      if (curve.first == i) {
        if (!move_end(curve.from, curve.to, turn)) return false;
        on_arc = ellipse.at(curve.from);
      }
      if (curve.last == i || curve.last == i + count) {
        if (!move_end(curve.to, curve.from, turn)) return false;
        on_arc = ellipse.at(curve.to);
      }
    }
    chain.points[static_cast<std::size_t>(i)] = on_arc;
    chain.curves = std::move(curves);
    return true;
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
    DrawnLine own{{before, drawn_end}, PageCurve(before, drawn_end), false, false,
                  chain.visible,       static_cast<int>(number)};
    for (const CurvePart& curve : chain.curves)
      if (front ? curve.first == 0 : curve.last == static_cast<int>(last)) {
        own.drawn = PageCurve(curve);
        own.is_moved = true;
        own.curve = static_cast<int>(&curve - chain.curves.data());
      }
    own.is_moved = own.is_moved || segment.crossing >= 0;
    if (!ends_in_edge(segment, end)) {
      if (own.curve < 0 || segment.crossing >= 0) return std::nullopt;
      return lines.end_at_vertex(own, end, drawn_end);
    }
    return lines.end_in_edge(own, end);
  }

  const PartEdges& edges_;
  const ExactCrossings& crossings_;
  const std::vector<EndsOnFacets>& ends_;
  ViewDrawing& drawing_;
  double touching_;
  Vec3 towards_viewer_;
  Places<Vec2> moved_;  ///< by the place of the end on facets
};

}  // namespace

void move_contours(const PartEdges& edges, const ExactCrossings& crossings, const std::vector<EndsOnFacets>& ends,
                   double touching, ViewDrawing& drawing) {
  if (!drawing.projection.central) Mover(edges, crossings, ends, touching, drawing).move();
}

}  // namespace epura::drawing
