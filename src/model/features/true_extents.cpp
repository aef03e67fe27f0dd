// SPDX-License-Identifier: Apache-2.0
#include "features/true_extents.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

#include "features/interrupted_faces.hpp"
#include "features/limits.hpp"
#include "surfaces/limits.hpp"
#include "world/placed_part.hpp"

namespace epura::features {

namespace {

using surfaces::PartFace;
using surfaces::PartSurface;
using surfaces::SurfaceKind;

using Triangle = std::array<Vec3, 3>;

/// By how much facets deviate from the surface of their face.
double deviation_of(const PartFace& face) { return surfaces::max_sagittas * face.sagitta + face.residual; }

/// A surface and a direction. The half-plane through the axis that extends farthest in that direction has coordinates
/// (x, h, s): outwards in it, along the axis, and perpendicular to it.
class Outward {
 public:
  Outward(const PartFace& face, const Vec3& direction) : face_(face), direction_(direction) {
    axis_ = face.surface.axis;
    if (face.surface.kind == SurfaceKind::sphere) {
      const Vec3 aside = std::abs(direction.x) < 0.5 ? Vec3(1, 0, 0) : Vec3(0, 1, 0);
      axis_ = glm::normalize(glm::cross(direction, aside));
    }
    const Vec3 out = direction - glm::dot(direction, axis_) * axis_;
    steepness_ = glm::length(out);
    along_axis_ = !(steepness_ > parallel);
    if (!along_axis_) out_ = out / steepness_;
    side_ = glm::cross(axis_, out_);
    base_ = glm::dot(face.surface.origin, direction);
  }

  /// The greatest extent of the surface above a triangle; nothing if the surface has its farthest point elsewhere.
  [[nodiscard]] std::optional<double> reach_over(const Triangle& triangle) const {
    const SurfaceKind kind = face_.surface.kind;
    if (kind == SurfaceKind::cylinder || kind == SurfaceKind::cone) return along_axis_ ? std::nullopt : ridge(triangle);
    return along_axis_ ? crown(triangle) : meridian(triangle);
  }

 private:
  struct Cut {
    std::array<Vec2, 3> points;
    int count = 0;
  };

  // The points at which the half-plane meets the sides of a triangle, as (x, h).
  [[nodiscard]] Cut cut(const Triangle& triangle) const {
    Cut cut;
    std::array<Vec3, 3> q;
    for (int k = 0; k < 3; ++k) {
      const Vec3 p = triangle[k] - face_.surface.origin;
      q[k] = {glm::dot(p, out_), glm::dot(p, axis_), glm::dot(p, side_)};
    }
    for (int k = 0; k < 3; ++k) {
      const Vec3 &a = q[k], &b = q[(k + 1) % 3];
      if (!((a.z <= 0 && b.z >= 0) || (a.z >= 0 && b.z <= 0)) || a.z == b.z) continue;
      const Vec3 p = a + (b - a) * (a.z / (a.z - b.z));
      if (p.x > 0) cut.points[cut.count++] = {p.x, p.y};
    }
    return cut;
  }

  // Whether the surface is no farther from a facet than facets deviate from their surface.
  [[nodiscard]] bool is_above(double rise) const { return std::abs(rise) <= deviation_of(face_); }

  [[nodiscard]] std::optional<double> ridge(const Triangle& triangle) const {
    std::optional<double> reach;
    const Cut meets = cut(triangle);
    for (int i = 0; i < meets.count; ++i) {
      const Vec2& p = meets.points[i];
      const double radius =
          face_.surface.radius + (face_.surface.kind == SurfaceKind::cone ? face_.surface.slope * p.y : 0);
      if (!is_above(radius - p.x)) continue;
      const double value = base_ + steepness_ * radius + glm::dot(axis_, direction_) * p.y;
      reach = std::max(reach.value_or(value), value);
    }
    return reach;
  }

  // The extent of the circle in which the half-plane meets a sphere or the tube of a torus.
  [[nodiscard]] std::optional<double> meridian(const Triangle& triangle) const {
    const bool ball = face_.surface.kind == SurfaceKind::sphere;
    const double ring = ball ? 0 : face_.surface.radius, radius = ball ? face_.surface.radius : face_.surface.minor;
    const Vec2 up(steepness_, glm::dot(axis_, direction_));
    const double base = base_ + ring * steepness_;
    std::optional<double> reach;
    const Cut meets = cut(triangle);
    const auto take = [&](double value) { reach = std::max(reach.value_or(value), value); };
    for (int i = 0; i < meets.count; ++i) {
      const Vec2 a = meets.points[i] - Vec2(ring, 0), b = meets.points[(i + 1) % meets.count] - Vec2(ring, 0);
      const double length = glm::length(a);
      if (!(length > 0) || !is_above(radius - length)) continue;
      take(base + radius * glm::dot(a, up) / length);
      if (cross(a, up) * cross(up, b) >= 0 && glm::dot(a + b, up) > 0 && glm::dot(a, b) > 0) take(base + radius);
    }
    return reach;
  }

  // Along its axis, a torus has its greatest extent in a circle.
  [[nodiscard]] std::optional<double> crown(const Triangle& triangle) const {
    if (face_.surface.kind != SurfaceKind::torus) return std::nullopt;
    double least = HUGE_VAL, most = -HUGE_VAL;
    for (const Vec3& corner : triangle) {
      const Vec3 p = corner - face_.surface.origin;
      const double height = glm::dot(p, direction_);
      if (!(height > 0)) return std::nullopt;
      const double x = glm::length(p - height * direction_) - face_.surface.radius;
      least = std::min(least, x);
      most = std::max(most, x);
    }
    return least <= 0 && most >= 0 ? std::optional(base_ + face_.surface.minor) : std::nullopt;
  }

  const PartFace& face_;
  Vec3 direction_, axis_, out_{0}, side_{0};
  double steepness_ = 0, base_ = 0;
  bool along_axis_ = false;
};

Triangle corners_of(const world::World& world, int triangle) {
  const auto& [a, b, c] = world.triangles[triangle];
  return {world.points[a], world.points[b], world.points[c]};
}

/// The extent of a face in one direction.
struct Reach {
  double value;
  const PartFace* face;  ///< null for vertices of other faces
  bool turned = false;   ///< it goes all around an axis, or is part of what is interrupted
};

/// A cylinder of a model, or a torus with its greatest circle, that is interrupted.
struct Interrupted {
  const PartFace* face;             ///< its first part
  std::array<double, 6> farthest;   ///< extents of its vertices
  std::array<char, 6> ends_flat{};  ///< whether it ends there in a plane across the direction, as beside a flat
};

class ExtentFinder {
  // Marks of vertices; those of interrupted faces have numbers from `first_interrupted` on.
  static constexpr int whole = 1, first_interrupted = 2;

 public:
  explicit ExtentFinder(const world::World& world)
      : world_(world),
        size_(glm::length(world.box.size())),
        of_round_(world.points.size(), 0),
        of_flat_(world.points.size()) {
    for (const world::Placed& placed : world.models) parts_.push_back(world::place_part(placed));
    const Box box = box_of_faces(world);
    for (int end = 0; end < 6; ++end) farthest_[end] = towards(end, end < 3 ? box.min : box.max);
    for (int model = 0; model < static_cast<int>(parts_.size()); ++model) add_model(model);
    for (const Interrupted& one : interrupted_) add_interrupted(one);
  }

  [[nodiscard]] std::array<Extent, 3> extents() const {
    std::array<Extent, 3> found;
    for (int axis = 0; axis < 3; ++axis) {
      found[axis] = {-farthest_[axis], farthest_[axis + 3]};
      found[axis].interrupted = is_interrupted_[axis] || is_interrupted_[axis + 3];
      set_form(found[axis], axis);
      found[axis].at_ends = {points_at(axis), points_at(axis + 3)};
    }
    return found;
  }

 private:
  // Ends 0 to 2 are backwards, 3 to 5 forwards.
  static Vec3 direction_of(int end) {
    Vec3 direction(0);
    direction[end % 3] = end < 3 ? -1 : 1;
    return direction;
  }

  /// How far a point lies in the direction of an end.
  static double towards(int end, const Vec3& point) { return end < 3 ? -point[end] : point[end - 3]; }

  [[nodiscard]] std::vector<Vec3> points_at(int end) const {
    std::vector<char> taken(world_.points.size(), 0);
    for (int model = 0; model < static_cast<int>(parts_.size()); ++model)
      for (int t = world_.first_triangle[model]; t < world_.first_triangle[model + 1]; ++t) {
        const int face = parts_[model] ? parts_[model]->face_of_triangle[t - world_.first_triangle[model]] : -1;
        const double below = same_point * size_ + (face >= 0 ? deviation_of(parts_[model]->faces[face]) : 0);
        for (const int v : world_.triangles[t])
          if (towards(end, world_.points[v]) >= farthest_[end] - below) taken[v] = 1;
      }
    std::vector<Vec3> points;
    for (std::size_t v = 0; v < taken.size(); ++v)
      if (taken[v] != 0) points.push_back(world_.points[v]);
    return points;
  }

  static bool is_whole(const PartFace& face) {
    return world::is_round(face.surface.kind) &&
           (face.surface.kind == SurfaceKind::sphere || face.sweep >= surfaces::whole_turn);
  }

  static bool is_across(const Vec3& axis, const Vec3& direction) {
    return std::abs(glm::dot(axis, direction)) <= parallel;
  }

  // Marks the vertices of faces that go all around, and of interrupted ones. A torus counts if its greatest circle is
  // there.
  void mark_round(int model, std::vector<char>& turned) {
    const world::PlacedPart& part = *parts_[model];
    const std::vector<RoundFace> round = find_round_faces(world_, model, part);
    for (const RoundFace& one : round) {
      if (!is_whole(one.face)) continue;
      turned[one.number] = 1;
      for (const int v : one.vertices) of_round_[v] = whole;
    }
    for (const SurfaceKind kind : {SurfaceKind::cylinder, SurfaceKind::torus})
      for (const InterruptedFace& face : find_interrupted(round, kind))
        if (kind == SurfaceKind::cylinder || (face.from <= same_point * size_ && face.to >= -same_point * size_))
          mark_interrupted(part, round, face, turned);
  }

  void mark_interrupted(const world::PlacedPart& part, const std::vector<RoundFace>& round, const InterruptedFace& face,
                        std::vector<char>& turned) {
    Interrupted found{&part.faces[round[face.parts.front()].number], {}};
    if (found.face->inwards) return;
    found.farthest.fill(-HUGE_VAL);
    for (const int p : face.parts) {
      turned[round[p].number] = 1;
      for (const int v : round[p].vertices) {
        if (of_round_[v] == 0) of_round_[v] = first_interrupted + static_cast<int>(interrupted_.size());
        for (int end = 0; end < 6; ++end)
          found.farthest[end] = std::max(found.farthest[end], towards(end, world_.points[v]));
      }
    }
    interrupted_.push_back(found);
  }

  void add_model(int model) {
    const int first = world_.first_triangle[model], last = world_.first_triangle[model + 1];
    std::vector<int> faces(static_cast<std::size_t>(last - first), -1);
    std::vector<char> turned;
    if (parts_[model]) {
      turned.resize(parts_[model]->faces.size(), 0);
      mark_round(model, turned);
      for (int t = first; t < last; ++t) {
        const int number = parts_[model]->face_of_triangle[t - first];
        if (number >= 0 && world::is_round(parts_[model]->faces[number].surface.kind)) faces[t - first] = number;
      }
    }
    for (int t = first; t < last; ++t) add_vertices(t, faces[t - first] < 0);
    for (int t = first; t < last; ++t)
      if (const int face = faces[t - first]; face >= 0) add_facet(parts_[model]->faces[face], turned[face] != 0, t);
  }

  // The corners of a triangle that count themselves. On the rims of round faces, those of planes across the direction
  // do: of flats.
  void add_vertices(int triangle, bool is_plane) {
    const Triangle corners = corners_of(world_, triangle);
    const Vec3 normal = glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
    const double slope = parallel * glm::length(normal);
    std::array<bool, 3> is_flat{};
    for (int axis = 0; axis < 3 && is_plane; ++axis)
      is_flat[axis] = glm::length(Vec2(normal[(axis + 1) % 3], normal[(axis + 2) % 3])) <= slope;
    for (const int vertex : world_.triangles[triangle])
      for (int end = 0; end < 6; ++end) add_vertex(vertex, is_flat[end % 3], end);
  }

  void add_vertex(int vertex, bool is_flat, int end) {
    const int mark = of_round_[vertex];
    if (is_flat) of_flat_[vertex][end % 3] = true;
    if (mark == whole && !is_flat) return;
    const double value = towards(end, world_.points[vertex]);
    if (mark >= first_interrupted) {
      Interrupted& face = interrupted_[mark - first_interrupted];
      if (is_across(face.face->surface.axis, direction_of(end)) && !is_flat) return;
      if (value >= face.farthest[end] - same_point * size_) face.ends_flat[end] = 1;
    }
    add(end, {value, nullptr});
  }

  // Where a slot or a gap between teeth is, an interrupted face reaches as far as elsewhere.
  void add_interrupted(const Interrupted& interrupted) {
    const PartSurface& surface = interrupted.face->surface;
    for (int end = 0; end < 6; ++end) {
      const Vec3 direction = direction_of(end);
      if (interrupted.ends_flat[end] != 0 || !is_across(surface.axis, direction)) continue;
      const double reach = glm::dot(direction, surface.origin) + surface.radius + surface.minor;
      if (reach > farthest_[end] + same_point * size_) is_interrupted_[end] = true;
      add(end, {reach, interrupted.face, true});
    }
  }

  // Whether a facet ends, with a side, in the flat that lies farthest in the direction of its corners: above a chord of
  // a hyperbola, its cone lies beyond the flat of the hexagon.
  [[nodiscard]] bool ends_in_flat(int triangle, int end, double top) const {
    return std::ranges::count_if(world_.triangles[triangle], [&](int v) {
             return of_flat_[v][end % 3] && towards(end, world_.points[v]) >= top - same_point * size_;
           }) >= 2;
  }

  void add_facet(const PartFace& face, bool turned, int triangle) {
    const Triangle corners = corners_of(world_, triangle);
    const double rise = deviation_of(face) + same_point * size_;
    for (int end = 0; end < 6; ++end) {
      double top = -HUGE_VAL;
      for (const Vec3& corner : corners) top = std::max(top, towards(end, corner));
      if (top + rise < farthest_[end]) continue;
      if (const auto reach = Outward(face, direction_of(end)).reach_over(corners))
        add(end, {ends_in_flat(triangle, end, top) ? std::min(*reach, top) : *reach, &face, turned});
    }
  }

  void add(int end, const Reach& reach) {
    if (reach.value < farthest_[end] - same_point * size_) return;
    farthest_[end] = std::max(farthest_[end], reach.value);
    std::vector<Reach>& list = reaches_[end];
    const auto known = std::find_if(list.begin(), list.end(), [&](const Reach& r) { return r.face == reach.face; });
    if (known == list.end())
      list.push_back(reach);
    else
      known->value = std::max(known->value, reach.value);
  }

  // The size is a diameter if only round faces about one axis reach this far, equally on both sides.
  void set_form(Extent& extent, int axis) const {
    const double slack = same_point * size_;
    const PartFace* turned = nullptr;
    bool balls = true;
    std::vector<const PartFace*> all;
    for (const int end : {axis, axis + 3}) {
      const std::size_t before = all.size();
      for (const Reach& reach : reaches_[end]) {
        if (reach.value < farthest_[end] - slack) continue;
        if (!reach.turned) return;
        all.push_back(reach.face);
        if (reach.face->surface.kind == SurfaceKind::sphere) continue;
        balls = false;
        turned = reach.face;
      }
      if (all.size() == before) return;
    }
    const PartSurface& first = (balls ? all.front() : turned)->surface;
    if (!balls && std::abs(first.axis[axis]) > parallel) return;
    for (const PartFace* face : all)
      if (!is_about(face->surface, first, slack)) return;
    if (std::abs(0.5 * (extent.from + extent.to) - first.origin[axis]) > slack) return;
    // Where a hole leaves out its pole, a sphere reaches as far as elsewhere.
    if (balls) {
      const double radius = first.radius;
      extent.interrupted = extent.interrupted || extent.size() < 2 * (radius - slack);
      extent.from = first.origin[axis] - radius;
      extent.to = first.origin[axis] + radius;
    }
    extent.form = balls ? ExtentForm::sphere : ExtentForm::diameter;
    extent.centre = first.origin;
    extent.axis = balls ? Vec3(0) : first.axis;
  }

  static bool is_about(const PartSurface& surface, const PartSurface& first, double slack) {
    const Vec3 d = surface.origin - first.origin;
    if (first.kind == SurfaceKind::sphere) return glm::length(d) <= slack;
    const bool ball = surface.kind == SurfaceKind::sphere;
    return (ball || glm::length(glm::cross(surface.axis, first.axis)) <= parallel) &&
           glm::length(glm::cross(d, first.axis)) <= slack;
  }

  const world::World& world_;
  double size_;
  std::vector<int> of_round_;  ///< by vertex: whether it is on a round face, and so does not count itself
  std::vector<std::array<bool, 3>> of_flat_;  ///< by vertex and axis: whether it is on a plane across the axis
  std::vector<Interrupted> interrupted_;
  std::vector<std::optional<world::PlacedPart>> parts_;
  std::array<double, 6> farthest_{};
  std::array<bool, 6> is_interrupted_{};
  std::array<std::vector<Reach>, 6> reaches_;
};

}  // namespace

bool Extent::is_same_as(const Extent& other) const {
  if (form == ExtentForm::length || form != other.form) return false;
  const double slack = same_point * std::max(size(), other.size());
  return std::abs(size() - other.size()) <= slack && glm::length(centre - other.centre) <= slack &&
         glm::length(glm::cross(axis, other.axis)) <= parallel;
}

std::vector<Vec3> points_of_faces(const world::World& world) {
  if (world.triangles.empty()) return {world.points.begin(), world.points.end()};
  std::vector<char> used(world.points.size(), 0);
  for (const auto& corners : world.triangles)
    for (const int v : corners) used[v] = 1;
  std::vector<Vec3> points;
  for (std::size_t v = 0; v < used.size(); ++v)
    if (used[v] != 0) points.push_back(world.points[v]);
  return points;
}

Box box_of_faces(const world::World& world) {
  if (world.wires.empty() || world.triangles.empty()) return world.box;
  Box box;
  for (const Vec3& point : points_of_faces(world)) box.add(point);
  return box;
}

std::array<Extent, 3> true_extents(const world::World& world) { return ExtentFinder(world).extents(); }

}  // namespace epura::features
