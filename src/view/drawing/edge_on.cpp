// SPDX-License-Identifier: Apache-2.0
#include "drawing/edge_on.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <numbers>
#include <numeric>
#include <optional>
#include <set>
#include <span>
#include <tuple>
#include <utility>
#include <vector>

#include "base/angle.hpp"
#include "base/error.hpp"
#include "base/nearest.hpp"
#include "base/portable_math.hpp"
#include "drawing/limits.hpp"
#include "drawing/polylines.hpp"
#include "visibility/spans.hpp"
#include "world/placed_part.hpp"

namespace epura::drawing {

namespace {

std::vector<char> faces_edge_on(const world::World& world, std::size_t model, const Vec3& viewer) {
  const world::Placed& placed = world.models[model];
  if (placed.part == nullptr) return {};
  std::vector<double> seen(placed.part->faces.size(), 0), all(seen);
  const std::vector<int> faces = world::faces_of_triangles(placed);
  for (std::size_t t = 0; t < faces.size(); ++t) {
    if (faces[t] < 0) continue;
    const auto& [a, b, c] = world.triangles[static_cast<std::size_t>(world.first_triangle[model]) + t];
    const Vec3 area = glm::cross(world.points[b] - world.points[a], world.points[c] - world.points[a]);
    seen[faces[t]] += std::abs(glm::dot(area, viewer));
    all[faces[t]] += glm::length(area);
  }
  std::vector<char> edge_on(seen.size());
  for (std::size_t f = 0; f < seen.size(); ++f) edge_on[f] = seen[f] < seen_edge_on * all[f] ? 1 : 0;
  return edge_on;
}

const visibility::Spans whole{{0, 1}};

Vec2 on_page(const Mat4& map, const Vec3& point) {
  const Vec4 image = map * Vec4(point, 1);
  return Vec2(image) / image.w;
}

/// The image of a cylinder that is seen along its axis: an ellipse in an oblique projection.
struct CircleEdgeOn {
  Vec2 centre, u, v;  ///< images of two radii at right angles

  /// A point in units of the radius, in the plane of the circle.
  [[nodiscard]] Vec2 local(const Vec2& p) const {
    const double area = cross(u, v);
    return Vec2(cross(p - centre, v), cross(u, p - centre)) / area;
  }
  [[nodiscard]] double size() const { return std::max(glm::length(u), glm::length(v)); }
  [[nodiscard]] bool is_one_with(const CircleEdgeOn& other) const {
    const double most = on_line_part * size();
    return glm::distance(centre, other.centre) <= most && std::abs(glm::length(u) - glm::length(other.u)) <= most &&
           std::abs(glm::length(v) - glm::length(other.v)) <= most;
  }
};

/// Where an edge of the mesh lies on a circle.
struct OnCircle {
  int circle;
  bool inside;  ///< no rim, but an edge between two facets of the cylinder
};

/// The circles of one model.
class Circles {
 public:
  Circles(const world::Placed& placed, const Vec3& viewer, const Mat4& map) : placed_(&placed) {
    const auto part = world::place_part(placed);
    if (!part) return;
    for (const surfaces::PartFace& face : part->faces) {
      const auto circle = circle_of(face.surface, viewer, map);
      const auto same = std::find_if(circles_.begin(), circles_.end(),
                                     [&](const CircleEdgeOn& other) { return circle && circle->is_one_with(other); });
      circle_of_face_.push_back(circle ? static_cast<int>(same - circles_.begin()) : -1);
      if (circle && same == circles_.end()) circles_.push_back(*circle);
    }
    if (!circles_.empty()) face_of_triangle_ = world::faces_of_triangles(placed);
  }

  [[nodiscard]] const CircleEdgeOn& operator[](int circle) const { return circles_[static_cast<std::size_t>(circle)]; }

  [[nodiscard]] std::optional<OnCircle> find(int mesh_edge) const {
    if (circles_.empty()) return std::nullopt;
    std::array<int, 2> faces{-1, -1};  // that with a circle, and another one
    for (const int t : placed_->mesh->triangles_of(placed_->mesh->edges[static_cast<std::size_t>(mesh_edge)])) {
      const int face = face_of_triangle_[static_cast<std::size_t>(t)];
      if (faces[0] < 0 && face >= 0 && circle_of_face_[static_cast<std::size_t>(face)] >= 0)
        faces[0] = face;
      else
        faces[1] = face;
    }
    if (faces[0] < 0) return std::nullopt;
    return OnCircle{circle_of_face_[static_cast<std::size_t>(faces[0])], faces[0] == faces[1]};
  }

 private:
  static std::optional<CircleEdgeOn> circle_of(const surfaces::PartSurface& surface, const Vec3& viewer,
                                               const Mat4& map) {
    if (surface.kind != surfaces::SurfaceKind::cylinder) return std::nullopt;
    if (glm::length(glm::cross(surface.axis, viewer)) > parallel_sine) return std::nullopt;
    const Vec3 any = std::abs(surface.axis.x) < 0.5 ? Vec3(1, 0, 0) : Vec3(0, 1, 0);
    const Vec3 u = glm::normalize(glm::cross(surface.axis, any)), v = glm::cross(surface.axis, u);
    const Vec2 centre = on_page(map, surface.origin);
    const CircleEdgeOn circle{centre, on_page(map, surface.origin + surface.radius * u) - centre,
                              on_page(map, surface.origin + surface.radius * v) - centre};
    return cross(circle.u, circle.v) != 0 ? std::optional(circle) : std::nullopt;
  }

  const world::Placed* placed_;
  std::vector<CircleEdgeOn> circles_;
  std::vector<int> circle_of_face_;    ///< -1: none
  std::vector<int> face_of_triangle_;  ///< empty without circles
};

/// A piece on a circle.
struct Chord {
  std::size_t piece;
  bool inside;
  Vec2 from, to;
  double start, turn;          ///< radians; the turn may be negative
  std::array<Vec2, 2> edge{};  ///< ends of the edge that it is a piece of
};

std::optional<Chord> chord_of(const CircleEdgeOn& circle, const Piece& piece, std::size_t number, bool inside) {
  const Vec2 from = circle.local(piece.from), to = circle.local(piece.to);
  const double turn = portable_atan2(cross(from, to), glm::dot(from, to));
  if (std::abs(turn) <= rounding_part || std::abs(turn) > max_known_step) return std::nullopt;
  return Chord{number, inside, from, to, portable_atan2(from.y, from.x), turn};
}

// At which fraction of a chord it is seen from the centre in a direction.
double fraction_at(const Chord& chord, double angle) {
  const double turned = (angle - chord.start) / chord.turn;
  if (turned <= rounding_part) return 0;
  if (turned >= 1 - rounding_part) return 1;
  const Vec2 direction(portable_cos(angle), portable_sin(angle));
  const double from = cross(direction, chord.from), to = cross(direction, chord.to);
  return std::clamp(from / (from - to), 0.0, 1.0);
}

// Calls visit(from, to) for an interval of angles as one or two intervals between 0 and a full turn.
template <class Visit>
void visit_turns(double from, double to, const Visit& visit) {
  const double turns = std::floor(from / full_turn) * full_turn;
  from -= turns, to -= turns;
  if (to <= full_turn) return visit(from, to, turns);
  visit(from, full_turn, turns);
  visit(0, to - full_turn, turns + full_turn);
}

// Returns which parts of a chord, as fractions of it, are at angles that no chord before covers, and covers them.
visibility::Spans uncovered(const Chord& chord, visibility::Spans& covered) {
  visibility::Spans parts;
  const double low = std::min(chord.start, chord.start + chord.turn), high = low + std::abs(chord.turn);
  visit_turns(low, high, [&](double from, double to, double turns) {
    double at = from;
    const auto add = [&](double end) {
      if (!(end > at)) return;
      const double a = fraction_at(chord, at + turns), b = fraction_at(chord, end + turns);
      visibility::add_span(parts, {std::min(a, b), std::max(a, b)});
    };
    for (const auto& span : covered) {
      if (span[1] <= at) continue;
      if (span[0] >= to) break;
      add(span[0]);
      at = span[1];
    }
    add(to);
  });
  visit_turns(low, high, [&](double from, double to, double) { visibility::add_span(covered, {from, to}); });
  check(parts.empty() || (parts.front()[0] >= 0 && parts.back()[1] <= 1), "parts of a chord lie on it");
  return parts;
}

Piece part_of(const Piece& piece, const std::array<double, 2>& part) {
  const auto at = [&](double u) {
    if (u <= 0) return std::pair(piece.from, piece.s[0]);
    if (u >= 1) return std::pair(piece.to, piece.s[1]);
    return std::pair(piece.from + u * (piece.to - piece.from), piece.s[0] + u * (piece.s[1] - piece.s[0]));
  };
  Piece result = piece;
  std::tie(result.from, result.s[0]) = at(part[0]);
  std::tie(result.to, result.s[1]) = at(part[1]);
  return result;
}

// The angles of the ends of the edge, rounded, the smaller one first.
std::array<long, 2> place_of(const Chord& chord) {
  const auto rounded = [](const Vec2& end) {
    return std::lround(portable_atan2(end.y, end.x) / full_turn / rounding_part);
  };
  const long from = rounded(chord.edge[0]), to = rounded(chord.edge[1]);
  return {std::min(from, to), std::max(from, to)};
}

/// All chords of one circle.
class Chords {
 public:
  explicit Chords(const CircleEdgeOn& circle) : circle_(circle) {}

  /// `edge`: the ends of the edge that the piece is of.
  void add(const Piece& piece, std::size_t number, bool inside, const std::array<Vec2, 2>& edge) {
    auto chord = chord_of(circle_, piece, number, inside);
    if (!chord) return;
    chord->edge = {circle_.local(edge[0]), circle_.local(edge[1])};
    chords_.push_back(*chord);
  }

  /// Finds what stays of each piece. Returns how far apart chords are at one angle, mm, if some chord that does not
  /// stay has another place than those that do: they rise over each other, and their ends may lie beside the circle.
  double decide(const std::vector<Piece>& pieces, std::vector<std::optional<visibility::Spans>>& left,
                const Progress& progress) const {
    std::vector<Piece> own;
    std::vector<signed char> strength;
    for (const Chord& chord : chords_) {
      own.push_back(pieces[chord.piece]);
      strength.push_back(static_cast<signed char>((own.back().visible ? 2 : 0) + (chord.inside ? 0 : 1)));
    }
    const Polylines lines(own, strength, progress);
    visibility::Spans covered;
    std::set<std::array<long, 2>> places;
    double nearest = 1, farthest = 1;  // from the centre
    bool is_apart = false;
    std::size_t decided = 0;
    for (const std::size_t line : lines.by_rank())
      for (const End end : lines[line]) {
        const Chord& chord = chords_[static_cast<std::size_t>(line_of(end))];
        left[chord.piece] = uncovered(chord, covered);
        ++decided;
        const bool is_new = places.insert(place_of(chord)).second, stays = *left[chord.piece] == whole;
        is_apart = is_apart || (is_new && !stays);
        nearest = std::min(nearest, distance_to_segment(Vec2(0), chord.from, chord.to));
        farthest = std::max({farthest, glm::length(chord.from), glm::length(chord.to)});
      }
    check(decided == chords_.size(), "every chord is decided about once");
    return is_apart ? (farthest - nearest) * circle_.size() : 0;
  }

 private:
  CircleEdgeOn circle_;
  std::vector<Chord> chords_{};
};

}  // namespace

FacesEdgeOn::FacesEdgeOn(const visibility::ResolvedView& lines) : world_(lines.world) {
  const projection::Projection& projection = lines.view.projection;
  edge_on_.resize(world_.models.size());
  if (projection.central) return;
  const Vec3 viewer = glm::normalize(projection.projector);
  for (std::size_t model = 0; model < edge_on_.size(); ++model) edge_on_[model] = faces_edge_on(world_, model, viewer);
}

bool FacesEdgeOn::has_step(const edges::FeatureEdge& edge) const {
  const std::vector<char>& edge_on = edge_on_[edge.model];
  if (edge.kind != EdgeKind::contour || edge.mesh_edge < 0 || edge_on.empty()) return false;
  const world::Placed& placed = world_.models[edge.model];
  const mesh::Mesh& whole = placed.mesh->whole();
  const mesh::MeshEdge* found = &placed.mesh->edges[edge.mesh_edge];
  if (&whole != placed.mesh.get()) found = whole.edge_between(placed.mesh->origin_of(*found).vertex);
  if (found == nullptr || found->count == 0) return false;
  if (placed.part->border_at(found - whole.edges.data()) != nullptr) return false;
  const int face = placed.part->face_of_triangle[whole.triangles_of(*found).front()];
  return face >= 0 && edge_on[face] != 0;
}

LeftInk draw_circles_once(const visibility::ResolvedView& lines, const view::PaperMap& paper, double least,
                          std::vector<Piece> pieces, const Progress& progress) {
  const projection::Projection& projection = lines.view.projection;
  if (projection.central) return {std::move(pieces)};
  const Mat4 map = view::world_to_page(lines.view, paper);
  std::vector<Circles> circles;
  for (const world::Placed& placed : lines.world.models)
    circles.emplace_back(placed, glm::normalize(projection.projector), map);
  std::map<std::array<int, 2>, Chords> chords;  // by model and circle
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const edges::FeatureEdge& edge = lines.drawn.edges[pieces[i].edge];
    if (!pieces[i].drawn || edge.mesh_edge < 0 || pieces[i].kind == EdgeKind::section) continue;
    const auto on = circles[edge.model].find(edge.mesh_edge);
    if (!on) continue;
    const CircleEdgeOn& circle = circles[edge.model][on->circle];
    const std::array<Vec2, 2> edge_on_paper{paper(lines.view.vertices[edge.vertex[0]]),
                                            paper(lines.view.vertices[edge.vertex[1]])};
    chords.try_emplace({edge.model, on->circle}, circle).first->second.add(pieces[i], i, on->inside, edge_on_paper);
  }
  if (chords.empty()) return {std::move(pieces)};
  std::vector<std::optional<visibility::Spans>> left(pieces.size());
  double rise = 0;
  for (const auto& [place, all] : chords) rise = std::max(rise, all.decide(pieces, left, progress));
  std::vector<Piece> kept;
  kept.reserve(pieces.size());
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    if (!left[i] || *left[i] == whole) {
      kept.push_back(pieces[i]);
      continue;
    }
    for (const auto& part : *left[i])
      if ((part[1] - part[0]) * length_of(pieces[i]) >= least) kept.push_back(part_of(pieces[i], part));
  }
  const auto ink = [](const std::vector<Piece>& all) {
    return std::accumulate(all.begin(), all.end(), 0.0, [](double sum, const Piece& p) { return sum + length_of(p); });
  };
  check(!(ink(kept) > ink(pieces) * (1 + rounding_part)), "drawing circles once adds no ink");
  return {std::move(kept), rise};
}

}  // namespace epura::drawing
