#include "edges/triangle_tree.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

namespace epura {

namespace {

constexpr int leaf_size = 4;

bool overlap(const Box& a, const Box& b) {
  return a.least.x <= b.most.x && b.least.x <= a.most.x && a.least.y <= b.most.y && b.least.y <= a.most.y &&
         a.least.z <= b.most.z && b.least.z <= a.most.z;
}

int longest_axis(const Box& box) {
  const Vec3 size = box.size();
  if (size.x >= size.y && size.x >= size.z) return 0;
  return size.y >= size.z ? 1 : 2;
}

}  // namespace

TriangleTree::TriangleTree(std::vector<Box> boxes) : boxes_(std::move(boxes)), order_(boxes_.size()) {
  std::iota(order_.begin(), order_.end(), 0);
  nodes_.reserve(boxes_.size());
  if (!boxes_.empty()) build(0, static_cast<int>(boxes_.size()));
}

int TriangleTree::build(int begin, int end) {
  const int number = static_cast<int>(nodes_.size());
  nodes_.push_back({{}, begin, end, -1});
  Box box;
  Box centres;
  for (int i = begin; i < end; ++i) {
    box.add(boxes_[order_[i]].least);
    box.add(boxes_[order_[i]].most);
    centres.add(boxes_[order_[i]].centre());
  }
  nodes_[number].box = box;
  if (end - begin <= leaf_size) return number;

  const int axis = longest_axis(centres);
  const int middle = begin + (end - begin) / 2;
  std::nth_element(order_.begin() + begin, order_.begin() + middle, order_.begin() + end, [&](int a, int b) {
    const double ca = boxes_[a].least[axis] + boxes_[a].most[axis];
    const double cb = boxes_[b].least[axis] + boxes_[b].most[axis];
    return std::pair(ca, a) < std::pair(cb, b);
  });
  build(begin, middle);
  const int right = build(middle, end);
  nodes_[number].right = right;
  return number;
}

void TriangleTree::overlapping(const Box& box, const std::function<void(int)>& meet) const {
  if (nodes_.empty()) return;
  std::vector<int> open{0};
  while (!open.empty()) {
    const int number = open.back();
    open.pop_back();
    const Node& node = nodes_[number];
    if (!overlap(node.box, box)) continue;
    if (node.right >= 0) {
      open.push_back(node.right);
      open.push_back(number + 1);
      continue;
    }
    for (int i = node.begin; i < node.end; ++i)
      if (overlap(boxes_[order_[i]], box)) meet(order_[i]);
  }
}

}  // namespace epura
