// SPDX-License-Identifier: Apache-2.0
#include "visibility/pile.hpp"

#include <algorithm>

#include "base/error.hpp"

namespace epura::visibility {

namespace {

std::array<int, 3> sorted_corners(const view::ProjectedScene& view, int triangle) {
  std::array<int, 3> corners = view.triangles[triangle].vertex;
  std::sort(corners.begin(), corners.end());
  return corners;
}

bool lie_alike(const view::ProjectedScene& view, const std::array<int, 3>& a, const std::array<int, 3>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), [&](int u, int v) {
    return view.vertices[u].x == view.vertices[v].x && view.vertices[u].y == view.vertices[v].y;
  });
}

}  // namespace

Pile::Footprint Pile::footprint(const view::ProjectedScene& view, int triangle) {
  const auto [a, b, c] = sorted_corners(view, triangle);
  return {view.grid[a].x, view.grid[a].y, view.grid[b].x, view.grid[b].y, view.grid[c].x, view.grid[c].y};
}

Pile::Pile(const view::ProjectedScene& view, std::vector<int> triangles) : triangles_(std::move(triangles)) {
  const auto nearest = [&](int triangle) {
    const auto& [a, b, c] = view.triangles[triangle].vertex;
    return std::max({view.vertices[a].depth, view.vertices[b].depth, view.vertices[c].depth});
  };
  std::sort(triangles_.begin(), triangles_.end(),
            [&](int a, int b) { return std::pair(-nearest(a), a) < std::pair(-nearest(b), b); });
  check(!triangles_.empty(), "a pile has triangles");
  corners_ = sorted_corners(view, triangles_.front());
  for (const int triangle : triangles_)
    for (const int corner : sorted_corners(view, triangle)) around_.emplace_back(corner, triangle);
  std::sort(around_.begin(), around_.end());
  const auto lies_as_first = [&](int triangle) { return lie_alike(view, sorted_corners(view, triangle), corners_); };
  if (!std::all_of(triangles_.begin(), triangles_.end(), lies_as_first)) return;
  tree_ = {triangles_.size(), [&](std::size_t i) {
             const std::array<int, 3> corners = sorted_corners(view, triangles_[i]);
             Depths depths;
             for (std::size_t k = 0; k < 3; ++k) depths[k].fill(view.vertices[corners[k]].depth);
             return depths;
           }};
}

std::vector<int> Pile::around(int vertex) const {
  std::vector<int> found;
  auto next = std::lower_bound(around_.begin(), around_.end(), std::pair(vertex, -1));
  for (; next != around_.end() && next->first == vertex; ++next) found.push_back(next->second);
  return found;
}

}  // namespace epura::visibility
