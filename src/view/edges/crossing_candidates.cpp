// SPDX-License-Identifier: Apache-2.0
#include "edges/crossing_candidates.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <numeric>
#include <utility>

#include "base/error.hpp"
#include "base/parallel.hpp"
#include "base/same_key.hpp"
#include "edges/convex_bodies.hpp"
#include "edges/intersections.hpp"
#include "search/triangle_tree.hpp"

namespace epura::edges {

namespace {

std::array<double, 6> corners_of(const Box& box) {
  return {box.min.x, box.min.y, box.min.z, box.max.x, box.max.y, box.max.z};
}

// For each distinct box the first body that has it, in ascending order; bodies with equal boxes are not isolated. A cut
// may remove bodies, whose boxes are then empty.
std::vector<int> unlike_bodies(const std::vector<Box>& boxes, std::vector<char>& isolated) {
  std::vector<int> there;
  for (std::size_t b = 0; b < boxes.size(); ++b)
    if (!boxes[b].empty()) there.push_back(static_cast<int>(b));
  std::stable_sort(there.begin(), there.end(),
                   [&](int a, int b) { return corners_of(boxes[a]) < corners_of(boxes[b]); });
  std::vector<int> unlike;
  for (const int body : there) {
    if (unlike.empty() || corners_of(boxes[unlike.back()]) != corners_of(boxes[body]))
      unlike.push_back(body);
    else
      isolated[body] = isolated[unlike.back()] = 0;
  }
  std::sort(unlike.begin(), unlike.end());
  check(unlike.size() <= there.size() && unlike.empty() == there.empty(), "of equal boxes one is left");
  return unlike;
}

// Marks the bodies whose box does not overlap that of any other body.
std::vector<char> isolated_bodies(const std::vector<Box>& boxes, const Progress& progress) {
  std::vector<char> isolated(boxes.size(), 1);
  const std::vector<int> there = unlike_bodies(boxes, isolated);
  if (there.size() < 2) return isolated;
  const search::TriangleTree tree(there.size(), [&](int i) { return boxes[there[i]]; });
  const auto tasks = tree.tasks(256);
  const auto mark = [&](int body) { std::atomic_ref(isolated[body]).store(0, std::memory_order_relaxed); };
  parallel_for(tasks.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t task = begin; task < end; ++task)
      tree.search(tasks[task], [&](int i, int j) {
        progress.expect_time();
        if (!boxes_overlap(boxes[there[i]], boxes[there[j]])) return;
        mark(there[i]);
        mark(there[j]);
      });
  });
  return isolated;
}

using Corners = std::array<double, 9>;

Corners corners_of(const world::World& world, int triangle) {
  Corners corners{};
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3& p = world.points[world.triangles[triangle][i]];
    for (std::size_t k = 0; k < 3; ++k) corners[3 * i + k] = p[static_cast<int>(k)];
  }
  return corners;
}

// Coincident parts have the same crossings with other parts. Two copies are kept, since a face may cross a copy where
// it does not cross its own neighbour. Further copies would only add copies of lines that come before them, and so are
// not drawn.
void drop_third_copies(const world::World& world, const Progress& progress, std::vector<int>& triangles) {
  if (world.models.size() < 3) return;  // no mesh has a triangle twice
  const std::vector<char> is_third = mark_third_copies(
      static_cast<int>(triangles.size()), [&](int i) { return corners_of(world, triangles[i]); }, progress);
  check(is_third.size() == triangles.size(), "every triangle is a copy or not");
  std::size_t kept = 0;
  for (std::size_t i = 0; i < triangles.size(); ++i)
    if (is_third[i] == 0) triangles[kept++] = triangles[i];
  triangles.resize(kept);
}

}  // namespace

CrossingCandidates crossing_candidates(const world::World& world, double normalisation, double contact,
                                       const Progress& progress) {
  progress.expect_time();
  const UnsetVector<Vec3> points = normalised_points(world, normalisation);
  const BodyTable bodies = bodies_of(world, points);
  std::vector<char> apart = isolated_bodies(bodies.box, progress);
  progress.expect_time();
  keep_convex(world, points, bodies, contact, apart);
  std::vector<char> may_cross(world.triangles.size());
  parallel_for(may_cross.size(), grain::light, [&](std::size_t begin, std::size_t end) {
    for (std::size_t t = begin; t < end; ++t) {
      const auto& [a, b, c] = world.triangles[t];
      may_cross[t] = apart[bodies.of_triangle[t]] == 0 && !is_low(points[a], points[b], points[c], contact) ? 1 : 0;
    }
  });
  std::vector<int> candidates;
  for (std::size_t t = 0; t < may_cross.size(); ++t)
    if (may_cross[t] != 0) candidates.push_back(static_cast<int>(t));
  drop_third_copies(world, progress, candidates);
  check(candidates.empty() || candidates.back() < static_cast<int>(world.triangles.size()), "candidates are triangles");
  return {std::move(candidates), /*in_patches=*/true};
}

CrossingCandidates all_triangles(const world::World& world) {
  std::vector<int> all(world.triangles.size());
  std::iota(all.begin(), all.end(), 0);
  return {std::move(all)};
}

}  // namespace epura::edges
