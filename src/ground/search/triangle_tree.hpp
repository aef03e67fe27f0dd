// SPDX-License-Identifier: Apache-2.0
// A tree of boxes around triangles in space, for finding pairs that may meet.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <vector>

#include "base/unset_vector.hpp"
#include "base/vec.hpp"

namespace epura::search {

/// Leaves have sixteen triangles each, in the order of a space-filling curve, and boxes are rounded outwards to 32
/// bits: many boxes are tested at once, and the tree takes about 32 bytes per triangle.
class TriangleTree {
 public:
  /// Calls `box_of(triangle)` for triangles 0 to count - 1, from several threads. Triangles of one group do not meet
  /// each other; `groups` has one entry for each triangle, numbered from 0, -1 for none, or is empty.
  TriangleTree(std::size_t count, const std::function<Box(int)>& box_of, const std::vector<int>& groups = {});

  /// A task of the search for pairs: the triangles below one node against those below another or the same node.
  using NodePair = std::array<int, 2>;

  /// Returns the whole search, divided into about `count` independent tasks.
  [[nodiscard]] std::vector<NodePair> tasks(std::size_t count) const;

  /// Calls `meet(a, b)` once for any two triangles of a task whose boxes overlap or touch, and for a few more, since
  /// the boxes are rounded.
  template <class Meet>
  void search(const NodePair& task, Meet meet) const {
    std::vector<NodePair> open{task};
    while (!open.empty()) {
      const auto [a, b] = open.back();
      open.pop_back();
      if (nodes_[a].leaves > 1 || nodes_[b].leaves > 1)
        split({a, b}, open);
      else
        meet_leaves(nodes_[a], nodes_[b], meet);
    }
  }

 private:
  static constexpr std::size_t width = 16;  ///< triangles of a leaf
  static constexpr float infinity = std::numeric_limits<float>::infinity();

  struct Bounds {
    std::array<float, 3> min, max;

    [[nodiscard]] bool meets(const Bounds& other) const {
      int apart = 0;  // bitwise, to avoid branches
      for (std::size_t axis = 0; axis < 3; ++axis)
        apart |= int{min[axis] > other.max[axis]} | int{other.min[axis] > max[axis]};
      return apart == 0;
    }
  };
  struct Node {
    Bounds bounds;
    int leaf, leaves;  ///< the first leaf and the number of leaves; the left child follows its parent
    int group;         ///< the common group of all triangles, or -1
  };
  struct Leaf {
    std::array<std::array<float, width>, 3> min, max;
    std::array<int, width> triangle;  ///< -1 after the last one

    [[nodiscard]] Bounds bounds(std::size_t i) const {
      return {{min[0][i], min[1][i], min[2][i]}, {max[0][i], max[1][i], max[2][i]}};
    }
  };

  [[nodiscard]] int right_child(int node) const { return node + 2 * (nodes_[node].leaves / 2); }
  static Bounds rounded_outwards(const Box& box);
  static UnsetVector<int> order_along_curve(const UnsetVector<Bounds>& bounds);
  static UnsetVector<int> by_group(const UnsetVector<int>& order, const std::vector<int>& groups);
  void fill_leaves(const UnsetVector<int>& order, const UnsetVector<Bounds>& bounds);
  [[nodiscard]] int group_of_leaf(int leaf, const std::vector<int>& groups) const;
  Node build(int node, int leaf, int leaves, const std::vector<int>& groups);
  void split(const NodePair& pair, std::vector<NodePair>& parts) const;

  template <class Meet>
  void meet_leaves(const Node& first, const Node& second, Meet& meet) const {
    const Leaf& a = leaves_[first.leaf];
    const Leaf& b = leaves_[second.leaf];
    for (std::size_t i = 0; i < width && a.triangle[i] >= 0; ++i) {
      const Bounds bounds = a.bounds(i);
      if (!bounds.meets(second.bounds)) continue;
      std::array<std::int32_t, width> apart{};
      for (std::size_t axis = 0; axis < 3; ++axis)
        for (std::size_t j = 0; j < width; ++j)
          apart[j] |= static_cast<std::int32_t>(bounds.min[axis] > b.max[axis][j]) |
                      static_cast<std::int32_t>(b.min[axis][j] > bounds.max[axis]);
      for (std::size_t j = &first == &second ? i + 1 : 0; j < width; ++j)
        if (apart[j] == 0) meet(a.triangle[i], b.triangle[j]);
    }
  }

  UnsetVector<Leaf> leaves_;
  UnsetVector<Node> nodes_;
};

}  // namespace epura::search
