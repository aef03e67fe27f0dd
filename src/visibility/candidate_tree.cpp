// SPDX-License-Identifier: Apache-2.0
#include "visibility/candidate_tree.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <utility>

#include "visibility/hiding_rule.hpp"

namespace epura {

namespace {

// What a triangle hides lies within so many cells of the page grid of it.
constexpr double slack_cells = 8;
// Depths are computed to this part of their size.
constexpr double depth_rounding = 0x1p-40;

constexpr std::size_t first_of_depth = 3;
constexpr std::size_t least_pile = 8;

Vec3 point(const View& view, int vertex) {
  const PageVertex& v = view.vertices[vertex];
  return {v.x, v.y, v.depth};
}

std::int64_t area(const View& view, int triangle) {
  const auto& [a, b, c] = view.triangles[triangle].vertex;
  return std::abs(cross(view.grid[a], view.grid[b], view.grid[c]));
}

}  // namespace

CandidateTree::CandidateTree(const View& view, std::vector<int> triangles) {
  if (triangles.empty()) return;
  choose_directions(view, triangles);
  make_piles(view, std::move(triangles));
  sort(view);
  tree_ = {things_.size(), [&](std::size_t i) { return bounds_of_thing(view, things_[i]); }};
}

// Of few triangles with one footprint, each is tried alone.
void CandidateTree::make_piles(const View& view, std::vector<int> triangles) {
  std::vector<std::pair<Pile::Footprint, int>> keys;
  keys.reserve(triangles.size());
  for (const int triangle : triangles) keys.emplace_back(Pile::footprint(view, triangle), triangle);
  std::sort(keys.begin(), keys.end());
  for (auto begin = keys.begin(); begin != keys.end();) {
    const auto end = std::find_if(begin, keys.end(), [&](const auto& key) { return key.first != begin->first; });
    std::vector<int> alike;
    for (; begin != end; ++begin) alike.push_back(begin->second);
    if (alike.size() < least_pile) {
      things_.insert(things_.end(), alike.begin(), alike.end());
      continue;
    }
    things_.push_back(~static_cast<int>(piles_.size()));
    piles_.emplace_back(view, std::move(alike));
  }
}

void CandidateTree::choose_directions(const View& view, const std::vector<int>& triangles) {
  const auto by_area = [&](int a, int b) { return area(view, a) < area(view, b); };
  const ViewTriangle& largest = view.triangles[*std::max_element(triangles.begin(), triangles.end(), by_area)];
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3 side = point(view, largest.vertex[(i + 1) % 3]) - point(view, largest.vertex[i]);
    const double length = std::hypot(side.x, side.y);
    directions_[i] = length > 0 ? Vec3(-side.y, side.x, 0) / length : Vec3(0);
  }
  const Vec2 slope = slope_of(view, largest).value_or(Vec2(0));
  directions_[first_of_depth] = {-slope.x, -slope.y, 1};
  directions_[first_of_depth + 1] = {0, 0, 1};

  double deepest = 0;
  for (const int t : triangles)
    for (const int v : view.triangles[t].vertex) deepest = std::max(deepest, std::abs(view.vertices[v].depth));
  for (std::size_t i = 0; i < directions_.size(); ++i) {
    const Vec3& d = directions_[i];
    slack_[i] = slack_cells * view.cell * (std::hypot(d.x, d.y) + d.z) + depth_rounding * d.z * deepest;
  }
}

CandidateTree::Bounds CandidateTree::before(const Vec3& a, const Vec3& b) const {
  Bounds bounds;
  for (std::size_t i = 0; i < bounds.size(); ++i) {
    const auto [low, high] = std::minmax({glm::dot(directions_[i], a), glm::dot(directions_[i], b)});
    bounds[i] = {low - slack_[i], i < first_of_depth ? high + slack_[i] : HUGE_VAL};
  }
  return bounds;
}

CandidateTree::Bounds CandidateTree::bounds_of(const View& view, int triangle) const {
  const auto& [u, v, w] = view.triangles[triangle].vertex;
  const Vec3 a = point(view, u), b = point(view, v), c = point(view, w);
  Bounds bounds;
  for (std::size_t i = 0; i < bounds.size(); ++i) {
    const Vec3& d = directions_[i];
    const auto [low, high] = std::minmax({glm::dot(d, a), glm::dot(d, b), glm::dot(d, c)});
    bounds[i] = {low, high};
  }
  return bounds;
}

CandidateTree::Bounds CandidateTree::bounds_of_thing(const View& view, int thing) const {
  if (thing >= 0) return bounds_of(view, thing);
  const std::vector<int>& triangles = piles_[~thing].triangles();
  Bounds all = bounds_of(view, triangles.front());
  for (const int triangle : triangles) {
    const Bounds bounds = bounds_of(view, triangle);
    for (std::size_t i = 0; i < all.size(); ++i)
      all[i] = {std::min(all[i][0], bounds[i][0]), std::max(all[i][1], bounds[i][1])};
  }
  return all;
}

void CandidateTree::sort(const View& view) {
  std::vector<std::pair<double, int>> keys(things_.size());
  for (std::size_t i = 0; i < keys.size(); ++i)
    keys[i] = {bounds_of_thing(view, things_[i])[first_of_depth][1], things_[i]};
  std::sort(keys.begin(), keys.end());
  for (std::size_t i = 0; i < keys.size(); ++i) things_[i] = keys[i].second;
}

}  // namespace epura
