// SPDX-License-Identifier: Apache-2.0
#include "visibility/candidate_tree.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <numeric>
#include <tuple>
#include <utility>

#include "base/error.hpp"
#include "visibility/limits.hpp"

namespace epura::visibility {

namespace {

constexpr std::size_t min_pile = 8;
constexpr std::size_t min_at_hub = 16;  // and every second triangle

Vec3 point(const view::ProjectedScene& view, int vertex) {
  const view::PageVertex& v = view.vertices[vertex];
  return {v.x, v.y, v.depth};
}

// Returns the direction over the flattest plane through the longest side on the page.
Vec3 over_longest_side(const view::ProjectedScene& view, const std::vector<int>& triangles) {
  Vec3 longest(0);
  const auto length2 = [](const Vec3& side) { return side.x * side.x + side.y * side.y; };
  for (const int triangle : triangles) {
    const auto& corners = view.triangles[triangle].vertex;
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec3 side = point(view, corners[(i + 1) % 3]) - point(view, corners[i]);
      if (length2(side) > length2(longest)) longest = side;
    }
  }
  return length2(longest) > 0 ? Vec3(Vec2(longest) * (-longest.z / length2(longest)), 1) : Vec3(0, 0, 1);
}

std::int64_t area(const view::ProjectedScene& view, int triangle) {
  const auto& [a, b, c] = view.triangles[triangle].vertex;
  return std::abs(view::cross(view.grid[a], view.grid[b], view.grid[c]));
}

}  // namespace

CandidateTree::CandidateTree(const view::ProjectedScene& view, std::vector<int> triangles)
    : touching_(view.contact.touching) {
  if (triangles.empty()) return;
  choose_directions(view, triangles);
  note_corners(view, triangles);
  make_piles(view, std::move(triangles));
  make_tree(view);
}

// The vertex with the most triangles becomes the hub if it has enough.
void CandidateTree::note_corners(const view::ProjectedScene& view, const std::vector<int>& triangles) {
  joined_.reserve(3 * triangles.size());
  for (const int triangle : triangles)
    for (const int vertex : view.triangles[triangle].vertex) joined_.emplace_back(vertex, triangle);
  std::sort(joined_.begin(), joined_.end());
  std::size_t max = 0;
  int hub = -1;
  for (auto begin = joined_.begin(); begin != joined_.end();) {
    const auto end =
        std::find_if(begin, joined_.end(), [&](const auto& corner) { return corner.first != begin->first; });
    if (const auto count = static_cast<std::size_t>(end - begin); count > max) {
      max = count;
      hub = begin->first;
    }
    begin = end;
  }
  check(max <= triangles.size(), "a triangle has a vertex at one of its corners");
  if (max < min_at_hub || 2 * max < triangles.size()) return;
  hub_ = SeenFrom(view, view.grid[hub]);
  std::erase_if(joined_, [&](const auto& corner) { return hub_->is_at(view.grid[corner.first]); });
}

std::span<const std::pair<int, int>> CandidateTree::joined_at(int vertex) const {
  const auto begin = std::lower_bound(joined_.begin(), joined_.end(), std::pair(vertex, -1));
  return {begin, std::find_if(begin, joined_.end(), [&](const auto& corner) { return corner.first != vertex; })};
}

// Small groups of triangles with one footprint are not worth a pile; their triangles are tested one by one.
void CandidateTree::make_piles(const view::ProjectedScene& view, std::vector<int> triangles) {
  std::vector<std::pair<Pile::Footprint, int>> keys;
  keys.reserve(triangles.size());
  for (const int triangle : triangles) keys.emplace_back(Pile::footprint(view, triangle), triangle);
  std::sort(keys.begin(), keys.end());
  for (auto begin = keys.begin(); begin != keys.end();) {
    const auto end = std::find_if(begin, keys.end(), [&](const auto& key) { return key.first != begin->first; });
    std::vector<int> alike;
    for (; begin != end; ++begin) alike.push_back(begin->second);
    if (alike.size() < min_pile) {
      things_.insert(things_.end(), alike.begin(), alike.end());
      continue;
    }
    things_.push_back(~static_cast<int>(piles_.size()));
    piles_.emplace_back(view, std::move(alike));
  }
  std::size_t entered = things_.size() - piles_.size();
  for (const Pile& pile : piles_) entered += pile.triangles().size();
  check(entered == triangles.size(), "every triangle is in the tree once");
}

void CandidateTree::choose_directions(const view::ProjectedScene& view, const std::vector<int>& triangles) {
  const auto by_area = [&](int a, int b) { return area(view, a) < area(view, b); };
  const view::ViewTriangle& largest = view.triangles[*std::max_element(triangles.begin(), triangles.end(), by_area)];
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3 side = point(view, largest.vertex[(i + 1) % 3]) - point(view, largest.vertex[i]);
    const double length = std::hypot(side.x, side.y);
    directions_[i] = length > 0 ? Vec3(-side.y, side.x, 0) / length : Vec3(0);
  }
  const Vec2 slope = slope_of(view, largest).value_or(Vec2(0));
  directions_[height] = {-slope.x, -slope.y, 1};
  directions_[depth] = over_longest_side(view, triangles);

  double deepest = 0;
  for (const int t : triangles)
    for (const int v : view.triangles[t].vertex) deepest = std::max(deepest, std::abs(view.vertices[v].depth));
  for (std::size_t i = 0; i < directions; ++i) {
    const Vec3& d = directions_[i];
    const double cells = i < height ? hidden_cells : depth_cells;
    slack_[i] = cells * view.cell * std::hypot(d.x, d.y) + depth_rounding * d.z * deepest;
    check(slack_[i] >= 0, "bounds are widened");
  }
}

CandidateTree::Bounds CandidateTree::before(const view::ProjectedScene& view, const PageEdge& edge,
                                            const std::array<Vec3, 2>& places) const {
  Bounds bounds;
  for (std::size_t i = 0; i < directions; ++i) {
    const auto [low, high] = std::minmax({glm::dot(directions_[i], places[0]), glm::dot(directions_[i], places[1])});
    bounds[i] = {low - slack_[i], i < height ? high + slack_[i] : HUGE_VAL};
    check(bounds[i][0] <= bounds[i][1], "bounds contain a part of an edge");
  }
  if (!hub_)
    bounds[turn] = all_around;
  else if (hub_->is_at(view.grid[edge.p]) || hub_->is_at(view.grid[edge.q]))
    bounds[turn] = hub_->of_edge(view, edge);
  else
    bounds[turn] = hub_->of_line(Vec2(places[0]), Vec2(places[1]));
  return bounds;
}

// A triangle hides only what lies behind it by more than contact, so its far bounds are moved by that amount.
CandidateTree::Bounds CandidateTree::bounds_of(const view::ProjectedScene& view, int triangle) const {
  const auto& [u, v, w] = view.triangles[triangle].vertex;
  const Vec3 a = point(view, u), b = point(view, v), c = point(view, w);
  const double forgiven = touching_ * steepness_of(view, view.triangles[triangle]);
  Bounds bounds;
  for (std::size_t i = 0; i < directions; ++i) {
    const Vec3& d = directions_[i];
    const auto [low, high] = std::minmax({glm::dot(d, a), glm::dot(d, b), glm::dot(d, c)});
    bounds[i] = {low, i < height ? high : high - forgiven};
  }
  bounds[turn] = hub_ ? hub_->of_triangle(view, view.triangles[triangle]) : all_around;
  return bounds;
}

CandidateTree::Bounds CandidateTree::bounds_of_thing(const view::ProjectedScene& view, int thing) const {
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

void CandidateTree::make_tree(const view::ProjectedScene& view) {
  std::vector<Bounds> bounds;
  bounds.reserve(things_.size());
  for (const int thing : things_) bounds.push_back(bounds_of_thing(view, thing));
  std::vector<std::size_t> order(things_.size());
  std::iota(order.begin(), order.end(), 0);
  const auto key = [&](std::size_t i) { return std::tuple(bounds[i][turn][0], bounds[i][height][1], things_[i]); };
  std::sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) { return key(i) < key(j); });
  std::vector<int> sorted;
  sorted.reserve(order.size());
  for (const std::size_t i : order) sorted.push_back(things_[i]);
  things_ = std::move(sorted);
  tree_ = {things_.size(), [&](std::size_t i) { return bounds[order[i]]; }};
}

}  // namespace epura::visibility
