// A tree of boxes over triangles in space, to find those that may meet.
#pragma once

#include <functional>
#include <vector>

#include "base/vec.hpp"

namespace epura {

class TriangleTree {
 public:
  /// One box a triangle; the boxes' order numbers are what the tree reports.
  explicit TriangleTree(std::vector<Box> boxes);

  /// Calls `meet(other)` for every box that overlaps `box`, touching included. Safe to call from several threads.
  void overlapping(const Box& box, const std::function<void(int)>& meet) const;

 private:
  struct Node {
    Box box;
    int begin, end;  ///< of order_
    int right;       ///< the left child follows its parent; -1 for a leaf
  };

  int build(int begin, int end);

  std::vector<Box> boxes_;
  std::vector<int> order_;
  std::vector<Node> nodes_;
};

}  // namespace epura
