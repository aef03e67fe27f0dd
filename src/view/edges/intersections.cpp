// SPDX-License-Identifier: Apache-2.0
#include "edges/intersections.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <iterator>
#include <optional>
#include <utility>

#include "base/angle.hpp"
#include "base/error.hpp"
#include "base/nearest.hpp"
#include "base/parallel.hpp"
#include "edges/dihedral.hpp"
#include "edges/flat_faces.hpp"
#include "edges/graph_patches.hpp"
#include "edges/limits.hpp"
#include "search/triangle_tree.hpp"

namespace epura::edges {

namespace {

// n . p = offset with a unit normal; a zero normal for a low triangle.
struct Plane {
  Vec3 normal;
  double offset;

  [[nodiscard]] double distance(const Vec3& p) const { return glm::dot(normal, p) - offset; }
};

struct Piece {
  std::array<Vec3, 2> ends;
};

Vec3 middle_of(const world::World& world, double normalisation) { return world.box.centre() * normalisation; }

/// Whatever the numbers and the orientation of the two triangles are, a crossing runs in one way along its line: where
/// it lies on the outline of a face, its direction decides on which side it counts (hiding_rule.hpp). No line of a
/// usual part is perpendicular to this.
constexpr Vec3 usual_way{0.7548776662466927, 0.5698402909980532, 0.3247179572447460};

class Crossings {
 public:
  Crossings(const world::World& world, double normalisation, double contact)
      : world_(world),
        normalisation_(normalisation),
        contact_(contact),
        middle_(middle_of(world, normalisation)),
        points_(normalised_points(world, normalisation)) {}

  /// Computes the planes of the triangles for which `cross` will be called. Not done in the constructor: the tree is
  /// built first, and needs the memory.
  void find_planes(const std::vector<int>& triangles) {
    planes_.resize(world_.triangles.size());
    parallel_for(triangles.size(), grain::light, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) planes_[triangles[i]] = plane(triangles[i]);
    });
  }

  // Of triangles in one group, no crossings are searched: none are left between those that are settled.
  [[nodiscard]] std::vector<int> groups_of(const CrossingCandidates& candidates) const {
    const std::vector<char>& is_settled = candidates.known.is_settled;
    if (is_settled.empty()) return apart(candidates.triangles, candidates.in_patches);
    const auto settled = [&](int t) { return is_settled[static_cast<std::size_t>(t)] != 0; };
    std::vector<int> open;
    std::ranges::remove_copy_if(candidates.triangles, std::back_inserter(open), settled);
    std::vector<int> of_open = apart(open, candidates.in_patches);
    of_open.resize(open.size(), -1);
    for (int& group : of_open)
      if (group >= 0) ++group;  // group 0 has the settled ones
    std::vector<int> groups(candidates.triangles.size(), 0);
    auto next = of_open.begin();
    for (std::size_t i = 0; i < groups.size(); ++i)
      if (!settled(candidates.triangles[i])) groups[i] = *next++;
    return groups;
  }

  // The groups of triangles that do not cross each other.
  [[nodiscard]] std::vector<int> apart(const std::vector<int>& triangles, bool in_patches) const {
    std::vector<int> groups = flat_faces(world_, points_, contact_, triangles);
    if (!in_patches) return groups;
    const std::vector<int> patches = graph_patches(world_, points_, contact_, triangles, groups);
    if (patches.empty()) return groups;
    if (groups.empty()) return patches;
    const int first = *std::max_element(groups.begin(), groups.end()) + 1;
    for (std::size_t i = 0; i < groups.size(); ++i)
      if (patches[i] >= 0) groups[i] = first + patches[i];
    return groups;
  }

  [[nodiscard]] Box box(int triangle) const {
    Box box;
    for (const int v : world_.triangles[triangle]) box.add(point(v));
    return box;
  }

  [[nodiscard]] std::optional<FaceCrossing> cross(int a, int b) const {
    const int first = std::min(a, b);
    const int second = std::max(a, b);
    // Nearly all pairs are neighbours or are rejected here: all corners of one are on one side of the other.
    if (common_vertices(first, second) >= 2) return std::nullopt;
    if (stays_apart(second, planes_[first]) || stays_apart(first, planes_[second])) return std::nullopt;
    if (!boxes_overlap(box(first), box(second))) return std::nullopt;
    Vec3 along = glm::cross(planes_[first].normal, planes_[second].normal);
    if (glm::dot(along, usual_way) < 0) along = -along;
    const auto one = cut(first, planes_[second]);
    if (!one) return std::nullopt;
    const auto two = cut(second, planes_[first]);
    if (!two) return std::nullopt;
    const auto common = overlap(*one, *two, glm::normalize(along));
    if (!common || !has(first, *common) || !has(second, *common)) return std::nullopt;
    const double angle = std::asin(std::min(glm::length(along), 1.0)) * degrees;
    return FaceCrossing{{denormalised(common->ends[0]), denormalised(common->ends[1])}, {first, second}, angle};
  }

 private:
  [[nodiscard]] const Vec3& point(int vertex) const { return points_[vertex]; }
  [[nodiscard]] Vec3 denormalised(const Vec3& p) const { return (p + middle_) / normalisation_; }

  [[nodiscard]] Plane plane(int triangle) const {
    const auto& c = world_.triangles[triangle];
    const Vec3 a = point(c[0]);
    if (is_low(a, point(c[1]), point(c[2]), contact_)) return {Vec3(0), 0};
    const Vec3 normal = glm::cross(point(c[1]) - a, point(c[2]) - a);
    const double area = glm::length(normal);
    return {normal / area, glm::dot(normal / area, a)};
  }

  [[nodiscard]] int sign(double distance) const { return distance > contact_ ? 1 : distance < -contact_ ? -1 : 0; }

  // Whether no corner is in front of the plane, or none is behind it and no edge lies in it.
  [[nodiscard]] bool stays_apart(int triangle, const Plane& plane) const {
    int in_front = 0;
    int behind = 0;
    for (const int v : world_.triangles[triangle]) {
      const double distance = plane.distance(point(v));
      in_front += static_cast<int>(distance > contact_);
      behind += static_cast<int>(distance < -contact_);
    }
    return in_front == 0 || (behind == 0 && in_front > 1);
  }

  [[nodiscard]] int common_vertices(int first, int second) const {
    int common = 0;
    for (const int a : world_.triangles[first])
      for (const int b : world_.triangles[second]) common += static_cast<int>(a == b);
    return common;
  }

  // The point at which the edge between two vertices meets the plane, computed identically for both triangles at the
  // edge.
  [[nodiscard]] Vec3 meet(const Plane& plane, int a, int b) const {
    const Vec3 p = point(std::min(a, b));
    const Vec3 q = point(std::max(a, b));
    const double from = plane.distance(p);
    return p + (from / (from - plane.distance(q))) * (q - p);
  }

  // The segment in which a triangle cuts a plane that it crosses.
  [[nodiscard]] std::optional<Piece> cut(int triangle, const Plane& plane) const {
    const auto& c = world_.triangles[triangle];
    std::array<int, 3> signs{};
    for (int i = 0; i < 3; ++i) signs[i] = sign(plane.distance(point(c[i])));
    if (std::count(signs.begin(), signs.end(), -1) == 0) return edge_in_plane(triangle, signs, plane);

    std::array<Vec3, 4> met{};
    std::size_t count = 0;
    for (int i = 0; i < 3; ++i) {
      const int j = (i + 1) % 3;
      if (signs[i] == 0) met[count++] = point(c[i]);
      if (signs[i] * signs[j] < 0) met[count++] = meet(plane, c[i], c[j]);
    }
    check(count == 2, "the outline of a triangle crosses a plane twice");
    return Piece{{met[0], met[1]}};
  }

  // Two corners are in the plane and the third one is in front: a crossing only if the surface continues behind the
  // plane. It is found only from the triangle in front, hence once.
  [[nodiscard]] std::optional<Piece> edge_in_plane(int triangle, const std::array<int, 3>& signs,
                                                   const Plane& plane) const {
    const auto& c = world_.triangles[triangle];
    const auto third = std::distance(signs.begin(), std::find(signs.begin(), signs.end(), 1));
    const int a = c[(third + 1) % 3];
    const int b = c[(third + 2) % 3];
    return goes_on_behind(triangle, a, b, plane) ? std::optional(Piece{{point(a), point(b)}}) : std::nullopt;
  }

  [[nodiscard]] bool goes_on_behind(int triangle, int a, int b, const Plane& plane) const {
    const int model = world_.model_of_triangle(triangle);
    const mesh::MeshEdge* edge = find_edge({world_, model, normalisation_}, {std::min(a, b), std::max(a, b)});
    check(edge != nullptr, "the sides of a triangle are edges of its mesh");
    for (const int other : world_.models[model].mesh->triangles_of(*edge))
      for (const int v : world_.triangles[world_.first_triangle[model] + other])
        if (sign(plane.distance(point(v))) < 0) return true;
    return false;
  }

  // The common part of two segments of one line, if it is longer than the contact distance.
  [[nodiscard]] std::optional<Piece> overlap(Piece one, Piece two, const Vec3& along) const {
    for (Piece* piece : {&one, &two})
      if (glm::dot(piece->ends[0], along) > glm::dot(piece->ends[1], along)) std::swap(piece->ends[0], piece->ends[1]);
    const auto at = [&](const Vec3& p) { return glm::dot(p, along); };
    const Vec3 from = at(one.ends[0]) >= at(two.ends[0]) ? one.ends[0] : two.ends[0];
    const Vec3 to = at(one.ends[1]) <= at(two.ends[1]) ? one.ends[1] : two.ends[1];
    if (!(at(to) - at(from) > contact_)) return std::nullopt;
    return Piece{{from, to}};
  }

  // Whether the middle of a piece in the plane of a triangle lies in the triangle. A corner within contact of the other
  // plane may be far from the line in which nearly parallel planes meet: then two segments are not of one line.
  [[nodiscard]] bool has(int triangle, const Piece& piece) const {
    const auto& c = world_.triangles[triangle];
    const Vec3 middle = (piece.ends[0] + piece.ends[1]) / 2.0;
    bool is_inside = true;
    for (int i = 0; i < 3; ++i) {
      const Vec3 &from = point(c[i]), &to = point(c[(i + 1) % 3]);
      if (distance_to_segment(middle, from, to) <= contact_) return true;
      is_inside &= glm::dot(glm::cross(planes_[triangle].normal, to - from), middle - from) >= 0;
    }
    return is_inside;
  }

  const world::World& world_;
  double normalisation_, contact_;
  Vec3 middle_;
  UnsetVector<Vec3> points_;  ///< normalised and centred
  UnsetVector<Plane> planes_;
};

}  // namespace

KnownCrossings renumbered(const KnownCrossings& known, std::span<const int> numbers, std::size_t count) {
  KnownCrossings now{{}, std::vector<char>(count, 0)};
  for (std::size_t t = 0; t < numbers.size(); ++t)
    if (numbers[t] >= 0) now.is_settled[static_cast<std::size_t>(numbers[t])] = known.is_settled[t];
  for (FaceCrossing crossing : known.found) {
    for (int& t : crossing.triangles) t = numbers[static_cast<std::size_t>(t)];
    if (std::ranges::min(crossing.triangles) < 0) continue;
    std::ranges::sort(crossing.triangles);
    now.found.push_back(crossing);
  }
  return now;
}

bool is_low(const Vec3& a, const Vec3& b, const Vec3& c, double contact) {
  const Vec3 ab = b - a, ac = c - a;
  const double area = glm::length(glm::cross(ab, ac));
  const double longest = std::max({glm::length(ab), glm::length(ac), glm::length(ac - ab)});
  return !(area > contact * longest);
}

bool boxes_overlap(const Box& a, const Box& b) {
  return a.min.x <= b.max.x && b.min.x <= a.max.x && a.min.y <= b.max.y && b.min.y <= a.max.y && a.min.z <= b.max.z &&
         b.min.z <= a.max.z;
}

UnsetVector<Vec3> normalised_points(const world::World& world, double normalisation) {
  const Vec3 middle = middle_of(world, normalisation);
  UnsetVector<Vec3> points(world.points.size());
  parallel_for(points.size(), grain::light, [&](std::size_t begin, std::size_t end) {
    for (std::size_t v = begin; v < end; ++v) points[v] = world.points[v] * normalisation - middle;
  });
  return points;
}

FaceCrossings find_intersections(const world::World& world, double normalisation, double contact,
                                 const CrossingCandidates& candidates, Progress progress) {
  const std::vector<int>& triangles = candidates.triangles;
  if (triangles.empty()) return {candidates.known.found, 1};
  if (progress.is_out_of_time()) return {{}, 0};
  Crossings crossings(world, normalisation, contact);
  const search::TriangleTree tree(
      triangles.size(), [&](int i) { return crossings.box(triangles[i]); }, crossings.groups_of(candidates));
  crossings.find_planes(triangles);

  const std::vector<search::TriangleTree::NodePair> tasks = tree.tasks(1024);
  progress.begin("finding intersections", tasks.size());
  std::vector<std::vector<FaceCrossing>> found(tasks.size());
  std::atomic<std::size_t> finished = 0, work = 0;
  const std::vector<char>& settled = candidates.known.is_settled;
  const auto is_settled = [&](int t) { return !settled.empty() && settled[static_cast<std::size_t>(t)] != 0; };
  const auto search = [&](std::size_t task) {
    std::size_t pairs = 0;
    tree.search(tasks[task], [&](int a, int b) {
      progress.expect_time();
      if (is_settled(triangles[a]) && is_settled(triangles[b])) return;
      ++pairs;
      if (const auto crossing = crossings.cross(triangles[a], triangles[b])) found[task].push_back(*crossing);
    });
    work += found[task].size() + pairs / pairs_a_crossing;
    ++finished;
    progress.advance(1);
  };
  const auto is_too_much = [&] { return work > most_crossings + triangles.size(); };
  try {
    // Part by part, each of which is searched to its end: where the search ends does not depend on threads.
    constexpr std::size_t part = 32;
    for (std::size_t first = 0; first < tasks.size() && !is_too_much(); first += part)
      parallel_for(std::min(part, tasks.size() - first), 1, progress, [&](std::size_t begin, std::size_t end) {
        for (std::size_t task = first + begin; task < first + end; ++task) search(task);
      });
  } catch (const OutOfTime&) {  // what was found so far is valid
  }
  FaceCrossings all{candidates.known.found, static_cast<double>(finished) / static_cast<double>(tasks.size())};
  all.too_many = all.searched < 1 && is_too_much();
  for (const auto& part : found) all.found.insert(all.found.end(), part.begin(), part.end());
  parallel_sort(all.found.begin(), all.found.end());
  for (const FaceCrossing& crossing : all.found) {
    check(crossing.triangles[0] < crossing.triangles[1], "two triangles cross");
    check(crossing.angle >= 0 && crossing.angle <= 90, "planes cross at an angle from 0 to 90 degrees");
  }
  return all;
}

}  // namespace epura::edges
