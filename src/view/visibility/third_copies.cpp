// SPDX-License-Identifier: Apache-2.0
#include "visibility/third_copies.hpp"

#include <algorithm>
#include <array>
#include <cstddef>

#include "base/error.hpp"
#include "base/same_key.hpp"

namespace epura::visibility {

namespace {

// Everything in a triangle that affects hiding. The ends of sides are used in ascending order of their numbers.
std::array<double, 10> key_of(const view::ProjectedScene& view, int triangle) {
  const auto& [a, b, c] = view.triangles[triangle].vertex;
  const view::PageVertex &u = view.vertices[a], &v = view.vertices[b], &w = view.vertices[c];
  const int order = (a < b ? 1 : 0) + (b < c ? 2 : 0) + (c < a ? 4 : 0);
  return {u.x, u.y, u.depth, v.x, v.y, v.depth, w.x, w.y, w.depth, static_cast<double>(order)};
}

std::vector<int> unmarked(const std::vector<char>& marks) {
  std::vector<int> numbers;
  numbers.reserve(marks.size());
  for (std::size_t i = 0; i < marks.size(); ++i)
    if (marks[i] == 0) numbers.push_back(static_cast<int>(i));
  return numbers;
}

}  // namespace

ThirdCopies::ThirdCopies(const world::World& world, const view::ProjectedScene& view, const Progress& progress)
    : is_third_(view.triangles.size(), 0) {
  if (world.models.size() < 3) return;  // no mesh has a triangle twice
  is_third_ = mark_third_copies(
      static_cast<int>(view.triangles.size()), [&](int t) { return key_of(view, t); }, progress);
  check(is_third_.size() == view.triangles.size(), "every triangle is a copy or not");
  if (std::find(is_third_.begin(), is_third_.end(), 1) == is_third_.end()) return;
  at_ = Groups<int>(view.vertices.size(), [&](const auto& add) {
    for (std::size_t t = 0; t < is_third_.size(); ++t)
      if (is_third_[t] != 0)
        for (const int v : view.triangles[t].vertex) add(static_cast<std::size_t>(v), static_cast<int>(t));
  });
}

std::vector<int> ThirdCopies::others() const { return unmarked(is_third_); }

std::vector<int> ThirdCopies::other_edges(const view::ProjectedScene& view,
                                          const std::vector<edges::FeatureEdge>& edges,
                                          const Progress& progress) const {
  if (at_.size() == 0) return unmarked(std::vector<char>(edges.size(), 0));
  const auto key = [&](int e) {
    const view::PageVertex &p = view.vertices[edges[e].vertex[0]], &q = view.vertices[edges[e].vertex[1]];
    return std::array{p.x, p.y, p.depth, q.x, q.y, q.depth};
  };
  return unmarked(mark_third_copies(static_cast<int>(edges.size()), key, progress));
}

}  // namespace epura::visibility
