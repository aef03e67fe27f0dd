// SPDX-License-Identifier: Apache-2.0
#include "drawing/exact_crossings.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>

#include "base/error.hpp"
#include "drawing/limits.hpp"
#include "surfaces/least_squares.hpp"

namespace epura::drawing {

namespace {

using surfaces::PartFace;
using surfaces::PartSurface;
using surfaces::SurfaceKind;

/// A number that vanishes on a surface, or on its contour, near which it is a length.
struct Condition {
  const PartSurface* surface;
  bool is_contour;
};

class Conditions {
 public:
  Conditions(std::vector<Condition> all, const Vec3& towards_viewer, double size)
      : all_(std::move(all)), towards_viewer_(towards_viewer), size_(size) {}

  // Returns the point nearby at which all vanish, to `precise`.
  [[nodiscard]] std::optional<Vec3> solve(const Vec3& start, double precise) const {
    Vec3 at = start;
    for (int step = 0; step < newton_steps; ++step) {
      surfaces::NormalEquations<3> equations;
      double off = 0;
      for (const Condition& one : all_) {
        const double value = value_at(one, at);
        const Vec3 slopes = slopes_at(one, at);
        off = std::max(off, std::abs(value));
        equations.add({slopes.x, slopes.y, slopes.z}, -value);
      }
      check(glm::distance(at, start) <= size_, "a crossing is where facets have it");
      if (off <= precise) return at;
      const auto by = equations.solve(0);
      if (!by) return std::nullopt;
      at += Vec3((*by)[0], (*by)[1], (*by)[2]);
      if (!(glm::distance(at, start) <= size_)) return std::nullopt;
    }
    return std::nullopt;
  }

 private:
  [[nodiscard]] double value_at(const Condition& one, const Vec3& p) const {
    return one.is_contour ? size_ * glm::dot(normal_near(*one.surface, p), towards_viewer_)
                          : signed_distance(*one.surface, p);
  }

  [[nodiscard]] Vec3 slopes_at(const Condition& one, const Vec3& p) const {
    if (!one.is_contour) return normal_near(*one.surface, p);
    const double step = 1e-3 * size_;
    Vec3 slopes;
    for (int i = 0; i < 3; ++i) {
      Vec3 by(0);
      by[i] = step;
      slopes[i] = (value_at(one, p + by) - value_at(one, p - by)) / (2 * step);
    }
    return slopes;
  }

  std::vector<Condition> all_;
  Vec3 towards_viewer_;
  double size_;  ///< what vanishes must do so within this distance
};

// The width of the facets of a face near a point, from the height of the surface over them.
double width_of_facets(const PartFace& face, const Vec3& point) {
  const PartSurface& surface = face.surface;
  const double radius = surface.kind == SurfaceKind::torus ? surface.minor
                        : surface.kind == SurfaceKind::cone
                            ? surface.radius + surface.slope * glm::dot(point - surface.origin, surface.axis)
                            : surface.radius;
  return std::sqrt(8 * std::abs(radius) * face.sagitta);
}

double sine_between(const PartSurface& one, const PartSurface& other, const Vec3& point) {
  return glm::length(glm::cross(normal_near(one, point), normal_near(other, point)));
}

bool is_surface(const PartFace* face) { return face != nullptr && face->surface.kind != SurfaceKind::free_form; }

}  // namespace

ExactCrossings::ExactCrossings(const PartEdges& edges, const ViewDrawing& drawing)
    : edges_(edges),
      drawing_(drawing),
      towards_viewer_(glm::normalize(drawing.projection.projector)),
      touching_(
          drawing.distances.coincident /
          glm::length(Vec3(drawing.world_to_page[0][0], drawing.world_to_page[1][0], drawing.world_to_page[2][0]))),
      number_of_(node_in_touching * drawing.distances.coincident) {
  // Faces of the file are told by models of the scene.
  if (drawing.projection.central || !drawing.cuts.numbers_in_scene.empty()) return;
  for (const Segment& segment : drawing.segments)
    if (segment.crossing >= 0 && segment.kind != EdgeKind::contour && !is_link(segment)) add_crossing(segment);
  if (nodes_.empty()) return;
  for (const Segment& segment : drawing.segments)
    if (segment.kind == EdgeKind::contour && !is_link(segment)) add_contour_ends(segment);
  for (Node& node : nodes_) node.exact = solved(node);
}

const ExactCrossings::Node* ExactCrossings::node_at(const Vec2& place) const {
  const int* number = number_of_.find(place);
  return number == nullptr ? nullptr : &nodes_[static_cast<std::size_t>(*number)];
}

ExactCrossings::Node& ExactCrossings::node_to_add(const Vec2& place, const Vec3& in_mesh) {
  if (const int* number = number_of_.find(place)) return nodes_[static_cast<std::size_t>(*number)];
  number_of_.add(place, static_cast<int>(nodes_.size()));
  return nodes_.emplace_back(Node{in_mesh});
}

void ExactCrossings::add_crossing(const Segment& segment) {
  const CrossingSegment& crossing = drawing_.crossings[static_cast<std::size_t>(segment.crossing)];
  const Pair pair{edges_.face_of(crossing.faces[0]), edges_.face_of(crossing.faces[1])};
  const std::array<Vec2, 2> ends{segment.from, segment.to};
  for (std::size_t end = 0; end < 2; ++end) {
    Node& node = node_to_add(ends[end], crossing.world[end]);
    node.is_cut = node.is_cut && segment.t[end] != 0 && segment.t[end] != 1;
    node.ways.push_back({ends[1 - end], pair});
    for (const PartFace* face : pair)
      if (std::find(node.faces.begin(), node.faces.end(), face) == node.faces.end()) node.faces.push_back(face);
  }
}

void ExactCrossings::add_contour_ends(const Segment& segment) {
  // Refinement made it, or it is an edge of the file.
  const CrossingSegment* made =
      segment.crossing >= 0 ? &drawing_.crossings[static_cast<std::size_t>(segment.crossing)] : nullptr;
  const PartFace* face = made != nullptr ? edges_.face_of(made->faces[0]) : edges_.face_around(segment);
  if (face == nullptr || !world::is_round(face->surface.kind)) return;
  const std::array<Vec2, 2> ends{segment.from, segment.to};
  for (std::size_t end = 0; end < 2; ++end) {
    if (segment.t[end] == 0 || segment.t[end] == 1) continue;
    const Vec3 in_mesh = made != nullptr ? made->world[end] : edges_.place_on(segment, segment.t[end]);
    const int* number = number_of_.find(on_page(in_mesh));
    if (number == nullptr) continue;
    Node& node = nodes_[static_cast<std::size_t>(*number)];
    if (std::ranges::find(node.faces, face) == node.faces.end()) continue;
    if (std::ranges::find(node.contours, face) == node.contours.end()) node.contours.push_back(face);
    node.is_cut = false;
    // Where the contour is drawn, which may be on the surface already.
    if (number_of_.find(ends[end]) == nullptr) number_of_.add(ends[end], *number);
  }
}

std::optional<Vec3> ExactCrossings::solved(const Node& node) const {
  if (node.faces.size() < 2 || !std::all_of(node.faces.begin(), node.faces.end(), is_surface)) return std::nullopt;
  std::vector<Condition> conditions;
  double heights = 0, sine = 1, width = 0;
  for (const PartFace* face : node.faces) {
    conditions.push_back({&face->surface, false});
    heights += face->sagitta;
  }
  for (const Way& way : node.ways)
    sine = std::min(sine, sine_between(way.pair[0]->surface, way.pair[1]->surface, node.in_mesh));
  for (const PartFace* face : node.contours) {
    conditions.push_back({&face->surface, true});
    width = std::max(width, width_of_facets(*face, node.in_mesh));
  }
  if (!(sine >= told_apart_sine)) return std::nullopt;
  const double size = max_heights * heights / sine + 2 * width + node_in_touching * touching_;
  check(size >= 0, "facets tell how far a crossing may be from them");
  return Conditions(std::move(conditions), towards_viewer_, size).solve(node.in_mesh, node_precision * touching_);
}

std::optional<Vec2> ExactCrossings::moved(const Vec2& place) const {
  const Node* node = node_at(place);
  return node != nullptr && node->exact && !node->is_cut ? std::optional(on_page(*node->exact)) : std::nullopt;
}

std::optional<Vec3> ExactCrossings::on_both(const Vec3& start, const Pair& pair) const {
  const double sine = sine_between(pair[0]->surface, pair[1]->surface, start);
  if (!(sine >= told_apart_sine)) return std::nullopt;
  const double size = max_heights * (pair[0]->sagitta + pair[1]->sagitta) / sine + node_in_touching * touching_;
  return Conditions({{&pair[0]->surface, false}, {&pair[1]->surface, false}}, towards_viewer_, size)
      .solve(start, node_precision * touching_);
}

// The surfaces whose crossing leads from a node to another place; null if none does.
const ExactCrossings::Pair* ExactCrossings::crossing_between(const Node* node, const Vec2& from, const Vec2& to) const {
  if (node == nullptr || !node->exact || from == to) return nullptr;
  const Vec2 along = glm::normalize(to - from);
  for (const Way& way : node->ways) {
    const Vec2 step = way.to - from;
    if (glm::dot(step, along) > 0 && std::abs(cross(along, step)) <= told_apart_sine * glm::length(step))
      return &way.pair;
  }
  return nullptr;
}

// Halves the curve until its chords are within the tolerance.
void ExactCrossings::add_between(const Node& from, const Node& to, const Pair& pair, double tolerance,
                                 std::vector<Vec2>& points) const {
  const auto add = [&](const auto& self, const Vec3& a, const Vec3& b, int halvings) -> void {
    const auto middle = halvings < max_halvings ? on_both((a + b) / 2.0, pair) : std::nullopt;
    if (!middle || glm::distance(on_page(*middle), on_page((a + b) / 2.0)) <= tolerance) return;
    self(self, a, *middle, halvings + 1);
    points.push_back(on_page(*middle));
    self(self, *middle, b, halvings + 1);
  };
  add(add, *from.exact, *to.exact, 0);
}

bool ExactCrossings::refine(Chain& chain, double tolerance) const {
  if (nodes_.empty()) return false;
  const std::vector<Vec2> old = chain.points;
  std::vector<const Node*> nodes;
  nodes.reserve(old.size());
  for (const Vec2& place : old) nodes.push_back(node_at(place));
  bool any = false;
  chain.points.clear();
  for (std::size_t i = 0; i < old.size(); ++i) {
    chain.points.push_back(nodes[i] != nullptr && nodes[i]->exact ? on_page(*nodes[i]->exact) : old[i]);
    const std::size_t next = (i + 1) % old.size();
    if (next == 0 && !chain.closed) break;
    const Pair* pair = crossing_between(nodes[i], old[i], old[next]);
    if (pair == nullptr || nodes[next] == nullptr || !nodes[next]->exact) continue;
    any = true;
    add_between(*nodes[i], *nodes[next], *pair, tolerance, chain.points);
  }
  check(chain.points.size() >= old.size(), "a refined line keeps its places");
  return any;
}

}  // namespace epura::drawing
