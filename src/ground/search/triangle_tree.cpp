// SPDX-License-Identifier: Apache-2.0
#include "search/triangle_tree.hpp"

#include <algorithm>
#include <numeric>
#include <tuple>

#include "base/parallel.hpp"

namespace epura::search {

namespace {

/// A triangle and its position on the curve.
struct Place {
  std::uint64_t code;
  int triangle;
};

// Spreads the lower 21 bits, with two zeros above each.
std::uint64_t spread(std::uint64_t x) {
  x &= 0x1fffff;
  x = (x | x << 32) & 0x1f00000000ffff;
  x = (x | x << 16) & 0x1f0000ff0000ff;
  x = (x | x << 8) & 0x100f00f00f00f00f;
  x = (x | x << 4) & 0x10c30c30c30c30c3;
  return (x | x << 2) & 0x1249249249249249;
}

}  // namespace

TriangleTree::TriangleTree(std::size_t count, const std::function<Box(int)>& box_of, const std::vector<int>& groups) {
  if (count == 0) return;
  UnsetVector<Bounds> bounds(count);
  parallel_for(count, grain::light, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) bounds[i] = rounded_outwards(box_of(static_cast<int>(i)));
  });
  UnsetVector<int> order = order_along_curve(bounds);
  if (!groups.empty()) order = by_group(order, groups);
  leaves_.resize((count + width - 1) / width);  // not earlier, because ordering takes as much memory
  fill_leaves(order, bounds);
  nodes_.resize(2 * leaves_.size() - 1);
  build(0, 0, static_cast<int>(leaves_.size()), groups);
}

UnsetVector<int> TriangleTree::by_group(const UnsetVector<int>& order, const std::vector<int>& groups) {
  const int last = *std::max_element(groups.begin(), groups.end());
  std::vector<std::size_t> next(static_cast<std::size_t>(last) + 3, 0);  // by group, from -1
  for (const int triangle : order) ++next[groups[triangle] + 2];
  std::partial_sum(next.begin(), next.end(), next.begin());
  UnsetVector<int> sorted(order.size());
  for (const int triangle : order) sorted[next[groups[triangle] + 1]++] = triangle;
  return sorted;
}

// Orders triangles by the positions of the middles of their boxes on a Morton curve: neighbours on it are neighbours in
// space. One pass puts them into buckets by the upper bits of their positions; the buckets are then sorted in parallel.
UnsetVector<int> TriangleTree::order_along_curve(const UnsetVector<Bounds>& bounds) {
  const auto middle = [&](std::size_t i) {
    return (Vec3(bounds[i].min[0], bounds[i].min[1], bounds[i].min[2]) +
            Vec3(bounds[i].max[0], bounds[i].max[1], bounds[i].max[2])) *
           0.5;
  };
  Box all;
  for (std::size_t i = 0; i < bounds.size(); ++i) all.add(middle(i));
  const double cells = 0x1fffff / std::max({all.size().x, all.size().y, all.size().z, 1e-300});
  UnsetVector<std::uint64_t> codes(bounds.size());  // 63 bits
  parallel_for(bounds.size(), grain::light, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const Vec3 at = (middle(i) - all.min) * cells;
      codes[i] = spread(static_cast<std::uint64_t>(at.x)) | spread(static_cast<std::uint64_t>(at.y)) << 1 |
                 spread(static_cast<std::uint64_t>(at.z)) << 2;
    }
  });

  constexpr int lower_bits = 63 - 15;
  std::vector<std::size_t> ends((1 << 15) + 1, 0);
  for (const std::uint64_t code : codes) ++ends[(code >> lower_bits) + 1];
  std::partial_sum(ends.begin(), ends.end(), ends.begin());
  UnsetVector<Place> places(codes.size());
  for (std::size_t i = 0; i < codes.size(); ++i)
    places[ends[codes[i] >> lower_bits]++] = {codes[i], static_cast<int>(i)};
  const auto by_place = [](const Place& a, const Place& b) {
    return std::tie(a.code, a.triangle) < std::tie(b.code, b.triangle);
  };
  UnsetVector<int> order(codes.size());
  parallel_for(ends.size() - 1, grain::heavy, [&](std::size_t first, std::size_t last) {
    for (std::size_t b = first; b < last; ++b) {
      const std::size_t begin = b == 0 ? 0 : ends[b - 1];
      std::sort(places.begin() + begin, places.begin() + ends[b], by_place);
      for (std::size_t i = begin; i < ends[b]; ++i) order[i] = places[i].triangle;
    }
  });
  return order;
}

TriangleTree::Bounds TriangleTree::rounded_outwards(const Box& box) {
  Bounds bounds{};
  for (int axis = 0; axis < 3; ++axis) {
    bounds.min[axis] = rounded_down(box.min[axis]);
    bounds.max[axis] = -rounded_down(-box.max[axis]);
  }
  return bounds;
}

// The bounds of unused entries after the last triangle meet nothing.
void TriangleTree::fill_leaves(const UnsetVector<int>& order, const UnsetVector<Bounds>& bounds) {
  constexpr Bounds nothing{{infinity, infinity, infinity}, {-infinity, -infinity, -infinity}};
  parallel_for(leaves_.size(), grain::light / width, [&](std::size_t begin, std::size_t end) {
    for (std::size_t l = begin; l < end; ++l)
      for (std::size_t i = 0; i < width; ++i) {
        const std::size_t at = l * width + i;
        leaves_[l].triangle[i] = at < order.size() ? order[at] : -1;
        const Bounds box = at < order.size() ? bounds[order[at]] : nothing;
        for (std::size_t axis = 0; axis < 3; ++axis) {
          leaves_[l].min[axis][i] = box.min[axis];
          leaves_[l].max[axis][i] = box.max[axis];
        }
      }
  });
}

int TriangleTree::group_of_leaf(int leaf, const std::vector<int>& groups) const {
  const auto& triangles = leaves_[leaf].triangle;
  if (groups.empty()) return -1;
  const int group = groups[triangles[0]];
  const auto is_of_group = [&](int triangle) { return triangle < 0 || groups[triangle] == group; };
  return std::all_of(triangles.begin(), triangles.end(), is_of_group) ? group : -1;
}

TriangleTree::Node TriangleTree::build(int node, int leaf, int leaves, const std::vector<int>& groups) {
  Node built{{}, leaf, leaves, -1};
  nodes_[node] = built;
  Bounds& bounds = built.bounds;
  if (leaves == 1) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      bounds.min[axis] = *std::min_element(leaves_[leaf].min[axis].begin(), leaves_[leaf].min[axis].end());
      bounds.max[axis] = *std::max_element(leaves_[leaf].max[axis].begin(), leaves_[leaf].max[axis].end());
    }
    built.group = group_of_leaf(leaf, groups);
  } else {
    Node left{}, right{};
    const int half = leaves / 2;
    const auto build_left = [&] { left = build(node + 1, leaf, half, groups); };
    const auto build_right = [&] { right = build(right_child(node), leaf + half, leaves - half, groups); };
    if (static_cast<std::size_t>(leaves) * width > grain::light) {
      parallel_both(build_left, build_right);
    } else {
      build_left();
      build_right();
    }
    for (std::size_t axis = 0; axis < 3; ++axis) {
      bounds.min[axis] = std::min(left.bounds.min[axis], right.bounds.min[axis]);
      bounds.max[axis] = std::max(left.bounds.max[axis], right.bounds.max[axis]);
    }
    if (left.group == right.group) built.group = left.group;
  }
  return nodes_[node] = built;
}

// A pair of a node with itself becomes pairs of its children with themselves and each other; of two different nodes,
// the larger one is replaced by its children.
void TriangleTree::split(const NodePair& pair, std::vector<NodePair>& parts) const {
  const auto [a, b] = pair;
  const auto add = [&](int i, int j) {
    const bool one_group = nodes_[i].group >= 0 && nodes_[i].group == nodes_[j].group;
    if (!one_group && nodes_[i].bounds.meets(nodes_[j].bounds)) parts.push_back({i, j});
  };
  if (a == b) {
    add(a + 1, a + 1);
    add(right_child(a), right_child(a));
    add(a + 1, right_child(a));
    return;
  }
  const bool open_a = nodes_[a].leaves >= nodes_[b].leaves;
  const int opened = open_a ? a : b;
  const int kept = open_a ? b : a;
  add(opened + 1, kept);
  add(right_child(opened), kept);
}

std::vector<TriangleTree::NodePair> TriangleTree::tasks(std::size_t count) const {
  if (nodes_.empty()) return {};
  std::vector<NodePair> parts{{0, 0}};
  while (parts.size() < count) {
    std::vector<NodePair> finer;
    for (const NodePair& pair : parts) {
      if (nodes_[pair[0]].leaves == 1 && nodes_[pair[1]].leaves == 1)
        finer.push_back(pair);
      else
        split(pair, finer);
    }
    if (finer.size() <= parts.size()) break;
    parts = std::move(finer);
  }
  return parts;
}

}  // namespace epura::search
