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
#include "base/nearest.hpp"
#include "drawing/conic_fit.hpp"
#include "drawing/page_curve.hpp"
#include "drawing/places.hpp"
#include "search/lines_by_cell.hpp"

namespace epura::drawing {

namespace {

using features::PartSurface;
using features::SurfaceKind;

// Millimetres between a line and the edge of the mesh that it shows; others are on the surface already.
constexpr double same_place = 1e-6;
// How much farther an end moves than both lines, at most: where they cross at less than 6 degrees, facets do not tell
// which of them ends.
constexpr double most_slant = 10;
// Radians about the axis between the ends of a generator, which files round.
constexpr double most_turn = 1e-3;

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
  return glm::length(glm::cross(away(from), away(to))) < most_turn;
}

// The point of a surface at the height of another point, in a direction away from the axis.
Vec3 on_surface(const PartSurface& surface, const Vec3& point, const Vec3& away) {
  const double height = glm::dot(point - surface.origin, surface.axis);
  return surface.origin + height * surface.axis + (surface.radius + surface.slope * height) * away;
}

struct Line {
  Vec2 from, to;
};

/// A contour of facets, and where it is on the surface.
struct Moved {
  Line facets, surface;
  std::array<bool, 2> ends_in_edge;  ///< something hides the rest of the edge
};

/// Part of a line of the drawing that may hide others, as facets have it and as it is drawn.
struct Occluder {
  Line facets;
  PageCurve drawn;
  bool is_moved;  ///< it is drawn elsewhere
  bool is_arc;
  bool visible;
  int chain = -1;  ///< its number; -1 for a contour
};

/// The occluders at a place.
class Occluders {
 public:
  /// Those at a place are within `distance` of it, mm.
  Occluders(std::vector<Occluder> all, double distance)
      : all_(std::move(all)), distance_(distance), cells_(all_.size(), distance, [&](std::size_t i) {
          return std::array{all_[i].facets.from, all_[i].facets.to};
        }) {}

  [[nodiscard]] bool has_arc_at(const Vec2& place) const {
    const auto here = cells_.at(place);
    return std::any_of(here.begin(), here.end(),
                       [&](std::size_t i) { return all_[i].is_arc && is_at(all_[i], place); });
  }

  /// Where a line ends that facets end at `end`, at an occluder. What is drawn elsewhere hides before
  /// what is not. A straight line that is not drawn elsewhere itself ends where facets have it, unless such a line
  /// hides it.
  [[nodiscard]] std::optional<Vec2> end_of(const Occluder& line, const Vec2& end) const {
    std::optional<Vec2> nearest;
    bool found = false;
    for (const bool moved : {true, false}) {
      // What is drawn elsewhere is not where facets have it, even if the line only touches it.
      if (nearest || found || (!moved && !line.is_moved)) return nearest;
      for (const std::size_t i : cells_.at(end)) {
        const Occluder& one = all_[i];
        const bool is_own = one.chain >= 0 && one.chain == line.chain;
        if (!one.visible || one.is_moved != moved || is_own || !is_at(one, end)) continue;
        found = line.chain >= 0;  // a contour is beside its own hidden part, which is such a line, too
        const auto place = crossing_near(line.drawn, one.drawn, end);
        const double off = line.drawn.distance(end) + one.drawn.distance(end);
        if (!place || glm::distance(*place, end) > std::min(length_of(one.facets), most_slant * off)) continue;
        if (!nearest || glm::distance(*place, end) < glm::distance(*nearest, end)) nearest = place;
      }
    }
    return nearest;
  }

 private:
  static double length_of(const Line& line) { return glm::distance(line.from, line.to); }
  [[nodiscard]] bool is_at(const Occluder& one, const Vec2& place) const {
    return distance_to_segment(place, one.facets.from, one.facets.to) <= distance_;
  }

  std::vector<Occluder> all_;
  double distance_;
  search::LinesByCell cells_;
};

Ellipse ellipse_of(const CurvePart& curve) { return {curve.centre, curve.u, curve.v}; }

// Moves one end of an arc along it. Returns false if nothing would be left of the arc.
bool move_end(double& moved, double other, double turn) {
  if (!((moved + turn - other) * (moved - other) > 0)) return false;
  moved += turn;
  return true;
}

class Mover {
 public:
  Mover(const PartEdges& edges, const ExactCrossings& crossings, const std::vector<EndsOnFacets>& ends,
        ViewDrawing& drawing)
      : edges_(edges),
        crossings_(crossings),
        ends_(ends),
        drawing_(drawing),
        towards_viewer_(glm::normalize(drawing.projection.projector)),
        moved_(drawing.coincident) {}

  void move() {
    std::vector<Moved> contours;
    for (const Segment& segment : drawing_.segments)
      if (segment.kind == EdgeKind::contour && !is_link(segment))
        if (const auto moved = moved_contour(segment)) contours.push_back(*moved);
    const Occluders occluders(all_occluders(contours), drawing_.coincident);
    for (const Moved& contour : contours) {
      if (!can_move(occluders, contour.facets.from, contour.ends_in_edge[0])) continue;
      if (!can_move(occluders, contour.facets.to, contour.ends_in_edge[1])) continue;
      add_end(occluders, contour, 0);
      add_end(occluders, contour, 1);
    }
    for (Chain& chain : drawing_.chains) move(chain);
    // Visible lines first: their hidden parts end at the same places.
    for (const bool visible : {true, false})
      for (std::size_t i = 0; i < drawing_.chains.size(); ++i)
        if (drawing_.chains[i].visible == visible && !drawing_.chains[i].closed) move_ends(occluders, i);
  }

 private:
  [[nodiscard]] Vec2 on_page(const Vec3& point) const { return Vec2(drawing_.world_to_page * Vec4(point, 1)); }

  // The surface of the cylinder or cone inside which an edge lies along a generator.
  [[nodiscard]] const PartSurface* surface_of(const Segment& segment) const {
    const features::PartFace* face = edges_.face_around(segment);
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
    if (!(glm::distance(begin + first_t * along, segment.from) <= same_place)) return std::nullopt;
    if (!(glm::distance(begin + last_t * along, segment.to) <= same_place)) return std::nullopt;
    const Vec3 from = edges_.place_on(segment, first_t), to = edges_.place_on(segment, last_t);
    const auto moved = [&](const Vec3& point) { return on_page(on_surface(*surface, point, away)); };
    const auto is_inside = [](double t) { return t != 0 && t != 1; };
    return Moved{
        {segment.from, segment.to}, {moved(from), moved(to)}, {is_inside(segment.t[0]), is_inside(segment.t[1])}};
  }

  [[nodiscard]] static Occluder occluder_of(const Moved& contour) {
    return {contour.facets, PageCurve(contour.surface.from, contour.surface.to), true, false, true};
  }

  // Lines as they are before any of them moves.
  [[nodiscard]] std::vector<Occluder> all_occluders(const std::vector<Moved>& contours) const {
    std::vector<Occluder> all;
    for (const Moved& contour : contours) all.push_back(occluder_of(contour));
    for (std::size_t number = 0; number < drawing_.chains.size(); ++number) {
      const Chain& chain = drawing_.chains[number];
      const std::size_t count = chain.points.size(), first = all.size();
      for (std::size_t i = 0; i + (chain.closed ? 0 : 1) < count; ++i) {
        const Line line{chain.points[i], chain.points[(i + 1) % count]};
        all.push_back({line, PageCurve(line.from, line.to), false, false, chain.visible, static_cast<int>(number)});
      }
      if (!chain.closed) {
        all[first].facets.from = ends_[number][0];
        all.back().facets.to = ends_[number][1];
      }
      for (const CurvePart& curve : chain.curves) {
        check(curve.first >= 0 && curve.last - curve.first <= static_cast<int>(count), "an arc is a part of its line");
        for (int i = curve.first; i < curve.last; ++i) {
          Occluder& one = all[first + static_cast<std::size_t>(i) % count];
          one.drawn = PageCurve(ellipse_of(curve));
          one.is_moved = one.is_arc = true;
        }
      }
    }
    return all;
  }

  // Whether a contour still meets what it ends at: the arc of a rim, the crossing with another surface, or what hides
  // the rest of it.
  [[nodiscard]] bool can_move(const Occluders& occluders, const Vec2& end, bool ends_in_edge) const {
    if (!ends_in_edge) return occluders.has_arc_at(end);
    return !crossings_.is_node(end) || crossings_.moved(end);
  }

  void add_end(const Occluders& occluders, const Moved& contour, std::size_t number) {
    const Vec2& end = number == 0 ? contour.facets.from : contour.facets.to;
    Vec2 place = number == 0 ? contour.surface.from : contour.surface.to;
    if (const auto met = crossings_.moved(end))
      place = *met;
    else if (contour.ends_in_edge[number])
      place = occluders.end_of(occluder_of(contour), end).value_or(place);
    moved_.add(end, place);
  }

  // Arcs through a place go on as they are; those that end there end where the contour touches them.
  void move(Chain& chain) const {
    const int count = static_cast<int>(chain.points.size());
    for (int i = 0; i < count; ++i) {
      const Vec2* moved = moved_.find(chain.points[static_cast<std::size_t>(i)]);
      if (moved == nullptr) continue;
      bool inside = false;
      for (const CurvePart& curve : chain.curves)
        inside = inside || (curve.first < i && i < curve.last) || (curve.first < i + count && i + count < curve.last);
      if (!inside) move_point(chain, i, *moved);
    }
  }

  static void move_point(Chain& chain, int i, const Vec2& place) {
    const int count = static_cast<int>(chain.points.size());
    Vec2& point = chain.points[static_cast<std::size_t>(i)];
    for (CurvePart& curve : chain.curves) {
      const Ellipse ellipse = ellipse_of(curve);
      const double turn = std::remainder(ellipse.angle_of(place) - ellipse.angle_of(point), 2 * std::numbers::pi);
      if (curve.first == i && !move_end(curve.from, curve.to, turn)) return;
      if ((curve.last == i || curve.last == i + count) && !move_end(curve.to, curve.from, turn)) return;
    }
    point = place;
  }

  // Whether something hides the rest of the edge at the end of a line.
  [[nodiscard]] bool ends_in_edge(const Segment& segment, const Vec2& end) const {
    if (is_link(segment)) return false;
    const bool is_first = glm::distance(segment.from, end) < glm::distance(segment.to, end);
    const double t = segment.t[is_first ? 0 : 1];
    return glm::distance(is_first ? segment.from : segment.to, end) <= drawing_.coincident && t != 0 && t != 1;
  }

  void move_ends(const Occluders& occluders, std::size_t number) {
    Chain& chain = drawing_.chains[number];
    for (const bool front : {true, false}) {
      const Vec2& end = ends_[number][front ? 0 : 1];
      const int segment = front ? chain.segments.front() : chain.segments.back();
      auto place = end_on_page(occluders, number, front, drawing_.segments[static_cast<std::size_t>(segment)]);
      while (place && is_before_last_line(chain, front, *place)) {
        drop_end(chain, front);
        place = end_on_page(occluders, number, front, drawing_.segments[static_cast<std::size_t>(segment)]);
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
  [[nodiscard]] std::optional<Vec2> end_on_page(const Occluders& occluders, std::size_t number, bool front,
                                                const Segment& segment) const {
    const Chain& chain = drawing_.chains[number];
    const Vec2& end = ends_[number][front ? 0 : 1];
    if (const Vec2* moved = moved_.find(end)) return *moved;
    if (const auto crossed = crossings_.moved(end)) return crossed;
    if (!ends_in_edge(segment, end)) return std::nullopt;
    const std::size_t last = chain.points.size() - 1;
    const Line line = front ? Line{chain.points[1], chain.points[0]} : Line{chain.points[last - 1], chain.points[last]};
    Occluder own{line, PageCurve(line.from, line.to), false, false, chain.visible, static_cast<int>(number)};
    for (const CurvePart& curve : chain.curves)
      if (front ? curve.first == 0 : curve.last == static_cast<int>(last)) {
        own.drawn = PageCurve(ellipse_of(curve));
        own.is_moved = true;
      }
    own.is_moved = own.is_moved || segment.crossing >= 0;
    return occluders.end_of(own, end);
  }

  const PartEdges& edges_;
  const ExactCrossings& crossings_;
  const std::vector<EndsOnFacets>& ends_;
  ViewDrawing& drawing_;
  Vec3 towards_viewer_;
  Places<Vec2> moved_;  ///< by the place of the end on facets
};

}  // namespace

void move_contours(const PartEdges& edges, const ExactCrossings& crossings, const std::vector<EndsOnFacets>& ends,
                   ViewDrawing& drawing) {
  if (!drawing.projection.central) Mover(edges, crossings, ends, drawing).move();
}

}  // namespace epura::drawing
