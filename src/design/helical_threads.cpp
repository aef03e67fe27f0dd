// SPDX-License-Identifier: Apache-2.0
#include "design/helical_threads.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <optional>

#include "base/portable_math.hpp"
#include "base/range.hpp"
#include "design/tolerances.hpp"
#include "scene/standard_threads.hpp"

namespace epura::design {

namespace {

using features::PartFace;
using features::SurfaceKind;

constexpr double same_place = 1e-3;       // relative to a radius
constexpr double flattest = 0.6;          // least ratio of the radii at roots and crests
constexpr double most_to_one_side = 0.8;  // mean of the directions of vertices from the axis
constexpr double least_depth = 0.005;     // relative to the radius
constexpr double smallest_thread = 0.8;   // mm, as the next, with room for play
constexpr double largest_thread = 110;    // mm, with room for play
constexpr double least_turns = 2;
constexpr double crest_part = 0.1;    // of the depth of a thread, whose vertices tell the helix
constexpr double least_order = 0.85;  // of crests along a helix: 1 for a line, 0 for vertices at random
constexpr std::size_t most_directions = 8, least_vertices = 48;
constexpr double widest_gap = 60;      // degrees
constexpr double least_facing = 0.05;  // of the area of a thread, seen from its axis

/// Positions around an axis.
struct AroundAxis {
  Vec3 origin, axis, u, v;

  explicit AroundAxis(const features::PartSurface& surface) : origin(surface.origin), axis(surface.axis) {
    const Vec3 aside = std::abs(axis.x) < 0.5 ? Vec3(1, 0, 0) : Vec3(0, 1, 0);
    u = glm::normalize(glm::cross(axis, aside));
    v = glm::cross(axis, u);
  }
  [[nodiscard]] double height(const Vec3& p) const { return glm::dot(p - origin, axis); }
  [[nodiscard]] double radius(const Vec3& p) const { return glm::length(glm::cross(p - origin, axis)); }
  /// In turns.
  [[nodiscard]] double turn(const Vec3& p) const {
    return portable_atan2(glm::dot(p - origin, v), glm::dot(p - origin, u)) / (2 * std::numbers::pi);
  }
};

/// The ends of a face, seen from an axis.
struct FaceReach {
  Range radius, height;
};

/// A ball around a free form.
struct FaceExtent {
  std::size_t face;
  Vec3 centre;
  double radius;
};

class ThreadFinder {
 public:
  ThreadFinder(const mesh::Mesh& mesh, const features::PartFaces& part, double unit)
      : mesh_(mesh), part_(part), unit_(unit), taken_(part.face_of_triangle.size(), 0), of_face_(part.faces.size()) {
    for (std::size_t t = 0; t < taken_.size(); ++t)
      if (const int face = part.face_of_triangle[t]; face >= 0)
        of_face_[static_cast<std::size_t>(face)].push_back(static_cast<int>(t));
  }

  HelicalForms find() {
    for (std::size_t f = 0; f < part_.faces.size(); ++f)
      if (is_free_form(part_.faces[f])) free_forms_.push_back(extent_of(f));
    if (free_forms_.empty()) return {};
    for (const PartFace& face : part_.faces)
      if (features::has_axis(face.surface.kind) && face.sweep >= 180 && !is_known(face.surface))
        find_around(face.surface);
    for (const FaceExtent& form : free_forms_) find_in(form.face);
    return {std::move(found_), std::move(others_)};
  }

 private:
  static bool is_free_form(const PartFace& face) { return face.surface.kind == SurfaceKind::free_form; }

  // Whether the threads around an axis have been looked for.
  bool is_known(const features::PartSurface& surface) {
    for (const features::PartSurface& other : axes_)
      if (are_parallel(other.axis, surface.axis) &&
          glm::length(glm::cross(surface.origin - other.origin, other.axis)) <= same_place * surface.radius)
        return true;
    axes_.push_back(surface);
    return false;
  }

  // Threads in plates have no round face beside them: their axis is perpendicular to a plane.
  void find_in(std::size_t face) {
    if (taken_[static_cast<std::size_t>(of_face_[face].front())] != 0) return;
    const std::vector<int> vertices = vertices_of(of_face_[face]);
    std::vector<Vec3> directions;
    for (const PartFace& plane : part_.faces) {
      const Vec3& axis = plane.surface.axis;
      if (plane.surface.kind != SurfaceKind::plane || directions.size() >= most_directions) continue;
      if (std::none_of(directions.begin(), directions.end(),
                       [&](const Vec3& known) { return are_parallel(known, axis); }))
        directions.push_back(axis);
    }
    for (const Vec3& direction : directions)
      if (const auto axis = axis_along(direction, vertices); axis && may_be_around(AroundAxis(*axis), of_face_[face]))
        find_around(*axis);
  }

  // The cylinder around vertices: those farthest from its axis are on a circle.
  [[nodiscard]] std::optional<features::PartSurface> axis_along(const Vec3& direction,
                                                                const std::vector<int>& vertices) const {
    if (vertices.size() < least_vertices) return std::nullopt;
    features::PartSurface cylinder{SurfaceKind::cylinder, Vec3(0), direction};
    for (const int v : vertices) cylinder.origin += mesh_.point(v) / static_cast<double>(vertices.size());
    for (const double share : {0.3, 0.1, 0.03, 0.01, 0.01}) {
      const AroundAxis around(cylinder);
      Range radius;
      for (const int v : vertices) radius.add(around.radius(mesh_.point(v)));
      const double least = radius.to - share * (radius.to - radius.from);
      // Least squares of x² + y² = 2 a x + 2 b y + c.
      Mat3 sums(0);
      Vec3 right(0);
      for (const int v : vertices) {
        const Vec3 d = mesh_.point(v) - around.origin;
        const Vec3 row(2 * glm::dot(d, around.u), 2 * glm::dot(d, around.v), 1);
        if (around.radius(mesh_.point(v)) < least) continue;
        sums += glm::outerProduct(row, row);
        right += (row.x * row.x + row.y * row.y) / 4 * row;
      }
      const double size = radius.to * radius.to;
      if (!(glm::determinant(sums) > 1e-9 * size * size)) return std::nullopt;
      const Vec3 centre = glm::inverse(sums) * right;
      cylinder.origin += centre.x * around.u + centre.y * around.v;
      cylinder.radius = radius.to;
    }
    return cylinder;
  }

  void find_around(const features::PartSurface& surface) {
    const AroundAxis around(surface);
    std::vector<std::size_t> seeds;
    for (const FaceExtent& form : free_forms_)
      if (around.radius(form.centre) <= form.radius && may_be_around(around, of_face_[form.face]))
        seeds.push_back(form.face);
    if (seeds.empty()) return;
    std::vector<char> known(part_.faces.size(), 0);
    const auto may_belong = [&](int face) {
      char& answer = known[static_cast<std::size_t>(face)];
      if (answer == 0) answer = lies_in_band(around, face) ? 1 : -1;
      return answer > 0;
    };
    std::vector<char> visited = taken_;
    for (const std::size_t seed : seeds) {
      const int t = of_face_[seed].front();
      if (visited[static_cast<std::size_t>(t)] != 0 || !may_belong(static_cast<int>(seed))) continue;
      const std::vector<int> triangles = connected(t, may_belong, visited);
      const std::size_t others = others_.size();
      auto thread = thread_of(around, triangles);
      if (!thread && others_.size() == others) continue;
      for (const int triangle : triangles) taken_[static_cast<std::size_t>(triangle)] = 1;
      if (!thread) continue;
      add_strips(around, *thread);
      found_.push_back(std::move(*thread));
    }
  }

  [[nodiscard]] FaceReach reach_of(const AroundAxis& around, int face) const {
    FaceReach reach;
    for (const int t : of_face_[static_cast<std::size_t>(face)])
      for (const int v : mesh_.triangle(t)) {
        reach.radius.add(around.radius(mesh_.point(v)));
        reach.height.add(around.height(mesh_.point(v)));
      }
    return reach;
  }

  // Flanks and crests, and planes in which a thread ends.
  [[nodiscard]] bool lies_in_band(const AroundAxis& around, int face) const {
    const features::PartSurface& surface = part_.faces[static_cast<std::size_t>(face)].surface;
    const bool across = are_parallel(surface.axis, around.axis);
    if (surface.kind != SurfaceKind::free_form && (surface.kind != SurfaceKind::plane || across)) return false;
    const Range radius = reach_of(around, face).radius;
    return radius.from >= flattest * radius.to;
  }

  [[nodiscard]] FaceExtent extent_of(std::size_t face) const {
    Box box;
    for (const int t : of_face_[face])
      for (const int v : mesh_.triangle(t)) box.add(mesh_.point(v));
    return {face, box.centre(), glm::length(box.size()) / 2};
  }

  // Numbers below `count`. Even steps might meet the same column of a mesh again and again.
  static std::size_t scattered(std::size_t i, std::size_t count) {
    constexpr double golden = std::numbers::phi - 1;
    const double turns = golden * static_cast<double>(i), place = turns - std::floor(turns);
    return static_cast<std::size_t>(place * static_cast<double>(count));
  }

  // Whether a few vertices of a face are where those of a thread around an axis may be.
  [[nodiscard]] bool may_be_around(const AroundAxis& around, const std::vector<int>& triangles) const {
    constexpr std::size_t samples = 16;
    Range radius;
    Vec3 directions(0);
    for (std::size_t i = 0; i < samples && !triangles.empty(); ++i) {
      const int triangle = triangles[scattered(i, triangles.size())];
      const Vec3 p = mesh_.point(mesh_.triangle(triangle)[0]) - around.origin;
      const Vec3 out = p - glm::dot(p, around.axis) * around.axis;
      radius.add(glm::length(out));
      if (glm::length(out) > 0) directions += glm::normalize(out) / static_cast<double>(samples);
    }
    const double diameter = 2 * radius.to * unit_;
    return radius.from >= flattest * radius.to && diameter >= smallest_thread && diameter <= largest_thread &&
           radius.to - radius.from >= least_depth * radius.to && glm::length(directions) <= most_to_one_side;
  }

  template <class Visit>
  void for_each_neighbour(int triangle, Visit&& visit) const {
    const std::array<int, 3> corners = mesh_.triangle(triangle);
    for (std::size_t i = 0; i < 3; ++i) {
      const auto [a, b] = std::minmax(corners[i], corners[(i + 1) % 3]);
      for (const int other : mesh_.triangles_of(*mesh_.edge_between({a, b}))) visit(other);
    }
  }

  // The triangles of certain faces that are joined to one, which are marked as visited.
  template <class Belongs>
  [[nodiscard]] std::vector<int> connected(int first, const Belongs& may_belong, std::vector<char>& visited) const {
    std::vector<int> triangles{first};
    visited[static_cast<std::size_t>(first)] = 1;
    for (std::size_t i = 0; i < triangles.size(); ++i)
      for_each_neighbour(triangles[i], [&](int other) {
        const int face = part_.face_of_triangle[static_cast<std::size_t>(other)];
        if (visited[static_cast<std::size_t>(other)] != 0 || face < 0 || !may_belong(face)) return;
        visited[static_cast<std::size_t>(other)] = 1;
        triangles.push_back(other);
      });
    return triangles;
  }

  [[nodiscard]] std::vector<int> vertices_of(const std::vector<int>& triangles) const {
    std::vector<int> vertices;
    for (const int t : triangles)
      for (const int v : mesh_.triangle(t)) vertices.push_back(v);
    std::sort(vertices.begin(), vertices.end());
    vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
    return vertices;
  }

  // The resultant of the places of points along a right- or left-handed helix.
  static double order_along(const std::vector<Vec2>& turns_and_heights, double pitch, bool left) {
    Vec2 sum(0);
    for (const Vec2& at : turns_and_heights) {
      const double angle = 2 * std::numbers::pi * (at.y / pitch + (left ? at.x : -at.x));
      sum += Vec2(portable_cos(angle), portable_sin(angle));
    }
    return glm::length(sum) / static_cast<double>(turns_and_heights.size());
  }

  static bool goes_around(std::vector<Vec2> turns_and_heights) {
    std::sort(turns_and_heights.begin(), turns_and_heights.end(),
              [](const Vec2& a, const Vec2& b) { return a.x < b.x; });
    double gap = turns_and_heights.front().x + 1 - turns_and_heights.back().x;
    for (std::size_t i = 1; i < turns_and_heights.size(); ++i)
      gap = std::max(gap, turns_and_heights[i].x - turns_and_heights[i - 1].x);
    return gap <= widest_gap / 360;
  }

  // How much of the area of triangles faces away from the axis: negative in holes.
  [[nodiscard]] double facing(const AroundAxis& around, const std::vector<int>& triangles) const {
    double outwards = 0, all = 0;
    for (const int t : triangles) {
      const auto [a, b, c] = mesh_.triangle(t);
      const Vec3 area = glm::cross(mesh_.point(b) - mesh_.point(a), mesh_.point(c) - mesh_.point(a));
      const Vec3 middle = (mesh_.point(a) + mesh_.point(b) + mesh_.point(c)) / 3.0 - around.origin;
      outwards += glm::dot(area, glm::normalize(middle - glm::dot(middle, around.axis) * around.axis));
      all += glm::length(area);
    }
    return outwards / all * (is_inside_out() ? -1 : 1);
  }

  [[nodiscard]] bool is_inside_out() const {
    if (inside_out_) return *inside_out_;
    double volume = 0;
    for (int t = 0; t < mesh_.triangle_count(); ++t) {
      const auto [a, b, c] = mesh_.triangle(t);
      volume += glm::dot(mesh_.point(a), glm::cross(mesh_.point(b), mesh_.point(c)));
    }
    inside_out_ = volume < 0;
    return *inside_out_;
  }

  std::optional<HelicalThread> thread_of(const AroundAxis& around, const std::vector<int>& triangles) {
    FaceReach reach;
    const std::vector<int> vertices = vertices_of(triangles);
    for (const int v : vertices) {
      reach.radius.add(around.radius(mesh_.point(v)));
      reach.height.add(around.height(mesh_.point(v)));
    }
    if (!(reach.radius.from >= flattest * reach.radius.to)) return std::nullopt;
    const double faces = facing(around, triangles);
    if (std::abs(faces) < least_facing) return std::nullopt;
    const bool internal = faces < 0;
    const double crest = internal ? reach.radius.from : reach.radius.to;
    const double near = crest_part * (reach.radius.to - reach.radius.from);
    std::vector<Vec2> crests;
    for (const int v : vertices)
      if (const Vec3 p = mesh_.point(v); std::abs(around.radius(p) - crest) <= near)
        crests.emplace_back(around.turn(p), around.height(p));
    if (!goes_around(crests)) return std::nullopt;
    const double length = reach.height.to - reach.height.from;
    const auto thread = best_size(crests, crest, internal, reach.height);
    if (!thread) {
      if (const auto pitch = pitch_of(crests, length)) others_.push_back({2 * crest * unit_, *pitch * unit_});
      return std::nullopt;
    }
    return HelicalThread{around.origin,
                         around.axis,
                         internal,
                         crest,
                         reach.height.from,
                         reach.height.to,
                         full_depth(around, vertices, internal, near),
                         *thread,
                         triangles};
  }

  // The heights at which vertices are as far from the crests as most roots are: a chamfer may reach below these.
  [[nodiscard]] Range full_depth(const AroundAxis& around, const std::vector<int>& vertices, bool internal,
                                 double near) const {
    constexpr std::size_t share = 10;  // of the vertices, one of so many is beyond
    std::vector<double> radii;
    for (const int v : vertices) radii.push_back((internal ? -1 : 1) * around.radius(mesh_.point(v)));
    std::vector<double> sorted = radii;
    const auto root = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / share);
    std::nth_element(sorted.begin(), root, sorted.end());
    Range heights;
    for (std::size_t i = 0; i < vertices.size(); ++i)
      if (std::abs(radii[i] - *root) <= near) heights.add(around.height(mesh_.point(vertices[i])));
    return heights;
  }

  // Whether crests are a left-handed helix; nothing if they are none. Where a thread runs out into a shaft at one end
  // or both, within two turns, all is as far from the axis as the crests.
  [[nodiscard]] static std::optional<bool> hand_of(const std::vector<Vec2>& crests, const Range& heights,
                                                   double pitch) {
    constexpr double off = 0.15;  // turns
    for (const double cut : {0, 1, 2}) {
      const double from = heights.from + cut * pitch, to = heights.to - cut * pitch;
      if (to - from < least_turns * pitch) break;
      std::vector<Vec2> some;
      for (const Vec2& at : crests)
        if (at.y >= from && at.y <= to) some.push_back(at);
      if (some.empty() || !goes_around(some)) break;
      const double turns = (to - from) / pitch;
      for (const bool left : {false, true}) {
        const double order = order_along(some, pitch, left);
        // A few turns suit a pitch about as large, too, but less than their own.
        const auto suits_better = [&](double more) {
          return cut > 0 && order_along(some, (to - from) / (turns + more), left) > order;
        };
        if (order >= least_order && !suits_better(off) && !suits_better(-off)) return left;
      }
    }
    return std::nullopt;
  }

  // The size whose diameter is nearest, of those whose pitch is that of the crests.
  [[nodiscard]] std::optional<scene::Thread> best_size(const std::vector<Vec2>& crests, double crest, bool internal,
                                                       const Range& reach) const {
    const double diameter = 2 * crest * unit_;
    std::optional<scene::Thread> best;
    double least = HUGE_VAL;
    for (const scene::Thread& thread : scene::threads_between(diameter / scene::largest_shaft, 1.5 * diameter + 1)) {
      if (!scene::suits(thread, diameter, internal) || (reach.to - reach.from) * unit_ < least_turns * thread.pitch)
        continue;
      const auto left = hand_of(crests, reach, thread.pitch / unit_);
      if (!left) continue;
      const double off = std::abs((internal ? thread.minor() : thread.diameter) - diameter);
      if (off >= least) continue;
      best = thread;
      if (*left) best->text += "-LH";
      least = off;
    }
    return best;
  }

  // The largest pitch of which the crests are a helix, in units of the file, if they have enough turns of it: smaller
  // ones may suit rows of vertices as well. Many more vertices than turns prevent that some pitch suits by chance.
  [[nodiscard]] static std::optional<double> pitch_of(const std::vector<Vec2>& crests, double length) {
    constexpr double step = 0.1, vertices_of_turn = 8;
    constexpr std::size_t most_samples = 512;
    if (crests.size() < least_vertices) return std::nullopt;
    std::vector<Vec2> some;
    for (std::size_t i = 0; i < std::min(most_samples, crests.size()); ++i)
      some.push_back(crests[scattered(i, crests.size())]);
    const auto order = [length](const std::vector<Vec2>& points, double turns) {
      return std::max(order_along(points, length / turns, true), order_along(points, length / turns, false));
    };
    const double most = static_cast<double>(some.size()) / vertices_of_turn;
    for (double turns = step; turns <= most; turns += step) {
      if (order(some, turns) < least_order) continue;
      while (order(some, turns + step) > order(some, turns)) turns += step;
      double from = turns - step, to = turns + step;
      while (to - from > 1e-6 * turns) {
        const double low = from + (to - from) / 3, high = to - (to - from) / 3;
        const bool is_above = order(crests, low) < order(crests, high);
        (is_above ? from : to) = is_above ? low : high;
      }
      const double found = (from + to) / 2;
      return found < least_turns ? std::nullopt : std::optional(length / found);
    }
    return std::nullopt;
  }

  // Whether a face is a cylinder around the axis.
  [[nodiscard]] bool is_around(const AroundAxis& around, int face) const {
    const features::PartSurface& surface = part_.faces[static_cast<std::size_t>(face)].surface;
    return surface.kind == SurfaceKind::cylinder && are_parallel(surface.axis, around.axis) &&
           around.radius(surface.origin) <= same_place * surface.radius;
  }

  // Whether a face is part of a ring between roots and crests, across the axis.
  [[nodiscard]] bool is_ring(const AroundAxis& around, int face, const Range& band) const {
    const PartFace& plane = part_.faces[static_cast<std::size_t>(face)];
    const double ring = std::numbers::pi * (band.to * band.to - band.from * band.from);
    if (plane.surface.kind != SurfaceKind::plane || plane.area > ring || !are_parallel(plane.surface.axis, around.axis))
      return false;
    const FaceReach reach = reach_of(around, face);
    return reach.radius.from >= band.from * (1 - same_place) && reach.radius.to <= band.to * (1 + same_place);
  }

  // Strips of cylinders between the flanks and rings at their ends belong to a thread, and what is left of them beyond
  // its ends within a pitch.
  void add_strips(const AroundAxis& around, HelicalThread& thread) {
    const double pitch = thread.thread.pitch / unit_;
    Range band;
    for (const int v : vertices_of(thread.triangles)) band.add(around.radius(mesh_.point(v)));
    const auto is_strip = [&](int triangle) {
      const int face = part_.face_of_triangle[static_cast<std::size_t>(triangle)];
      if (face < 0 || taken_[static_cast<std::size_t>(triangle)] != 0) return false;
      if (!is_around(around, face) && !is_ring(around, face, band)) return false;
      const std::array<int, 3> corners = mesh_.triangle(triangle);
      return std::all_of(corners.begin(), corners.end(), [&](int v) {
        const double height = around.height(mesh_.point(v));
        return height >= thread.low - pitch && height <= thread.high + pitch;
      });
    };
    for (std::size_t i = 0; i < thread.triangles.size(); ++i)
      for_each_neighbour(thread.triangles[i], [&](int other) {
        if (!is_strip(other)) return;
        taken_[static_cast<std::size_t>(other)] = 1;
        thread.triangles.push_back(other);
      });
    for (const int v : vertices_of(thread.triangles)) {
      thread.low = std::min(thread.low, around.height(mesh_.point(v)));
      thread.high = std::max(thread.high, around.height(mesh_.point(v)));
    }
    std::sort(thread.triangles.begin(), thread.triangles.end());
  }

  const mesh::Mesh& mesh_;
  const features::PartFaces& part_;
  double unit_;
  std::vector<char> taken_;                // by triangle: belongs to a thread
  std::vector<std::vector<int>> of_face_;  // triangles
  std::vector<FaceExtent> free_forms_;
  mutable std::optional<bool> inside_out_;
  std::vector<features::PartSurface> axes_;
  std::vector<HelicalThread> found_;
  std::vector<OtherHelix> others_;
};

}  // namespace

HelicalForms find_helical_threads(const mesh::Mesh& mesh, const features::PartFaces& part, double unit) {
  return ThreadFinder(mesh, part, unit).find();
}

}  // namespace epura::design
