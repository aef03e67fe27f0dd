// A tree of boxes over triangles in space, to find pairs that may meet.
#pragma once

#include <array>
#include <vector>

#include "base/vec.hpp"

namespace epura {

class TriangleTree {
 public:
  /// One box a triangle; the boxes' order numbers are what the tree reports.
  explicit TriangleTree(std::vector<Box> boxes);

  /// A task of the search for pairs: triangles below one node against those below another (or the same).
  using NodePair = std::array<int, 2>;

  /// The whole search, cut into about `count` independent tasks.
  [[nodiscard]] std::vector<NodePair> tasks(std::size_t count) const;

  /// Calls `meet(a, b)` once for each two triangles of a task whose boxes overlap, touching included.
  template <class Meet>
  void search(const NodePair& task, Meet meet) const {
    std::vector<NodePair> open{task};
    while (!open.empty()) {
      const auto [a, b] = open.back();
      open.pop_back();
      if (nodes_[a].right >= 0 || nodes_[b].right >= 0)
        split({a, b}, open);
      else
        meet_leaves(nodes_[a], nodes_[b], a == b, meet);
    }
  }

 private:
  struct Node {
    Box box;
    int begin, end;  ///< of order_
    int right;       ///< the left child follows its parent; -1 for a leaf
  };

  static bool overlap(const Box& a, const Box& b) {
    return a.least.x <= b.most.x && b.least.x <= a.most.x && a.least.y <= b.most.y && b.least.y <= a.most.y &&
           a.least.z <= b.most.z && b.least.z <= a.most.z;
  }

  void sort_along_curve();
  void build(int number, int begin, int end);
  void split(const NodePair& pair, std::vector<NodePair>& parts) const;

  template <class Meet>
  void meet_leaves(const Node& a, const Node& b, bool same, Meet& meet) const {
    for (int i = a.begin; i < a.end; ++i)
      for (int j = same ? i + 1 : b.begin; j < b.end; ++j)
        if (overlap(boxes_[i], boxes_[j])) meet(order_[i], order_[j]);
  }

  // Both in the order of the leaves.
  std::vector<Box> boxes_;
  std::vector<int> order_;  ///< the boxes' numbers
  std::vector<Node> nodes_;
};

}  // namespace epura
