#include "edges/triangle_tree.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

#include "base/parallel.hpp"

namespace epura {

namespace {

constexpr int leaf_size = 6;
constexpr int alone = 8192;  // triangles that one thread sorts without help

// Nodes of a tree over so many triangles: halves are equal, so the tree's shape follows from the number alone.
int node_count(int triangles) {
  return triangles <= leaf_size ? 1 : 1 + node_count(triangles / 2) + node_count(triangles - triangles / 2);
}

int longest_axis(const Box& box) {
  const Vec3 size = box.size();
  if (size.x >= size.y && size.x >= size.z) return 0;
  return size.y >= size.z ? 1 : 2;
}

}  // namespace

TriangleTree::TriangleTree(std::vector<Box> boxes) : boxes_(std::move(boxes)), order_(boxes_.size()) {
  std::iota(order_.begin(), order_.end(), 0);
  const int count = static_cast<int>(boxes_.size());
  nodes_.resize(static_cast<std::size_t>(node_count(count)));
  build(0, 0, count);
}

void TriangleTree::build(int number, int begin, int end) {
  Box box;
  Box centres;
  for (int i = begin; i < end; ++i) {
    box.add(boxes_[order_[i]].least);
    box.add(boxes_[order_[i]].most);
    centres.add(boxes_[order_[i]].centre());
  }
  if (end - begin <= leaf_size) {
    nodes_[number] = {box, begin, end, -1};
    return;
  }
  const int axis = longest_axis(centres);
  const int middle = begin + (end - begin) / 2;
  std::nth_element(order_.begin() + begin, order_.begin() + middle, order_.begin() + end, [&](int a, int b) {
    const double ca = boxes_[a].least[axis] + boxes_[a].most[axis];
    const double cb = boxes_[b].least[axis] + boxes_[b].most[axis];
    return std::pair(ca, a) < std::pair(cb, b);
  });
  const int right = number + 1 + node_count(middle - begin);
  nodes_[number] = {box, begin, end, right};
  const auto build_left = [&] { build(number + 1, begin, middle); };
  const auto build_right = [&] { build(right, middle, end); };
  if (end - begin > alone) return parallel_both(build_left, build_right);
  build_left();
  build_right();
}

// A node against itself: its children against themselves and each other. Two nodes: the larger one is opened.
void TriangleTree::split(const NodePair& pair, std::vector<NodePair>& parts) const {
  const auto [a, b] = pair;
  const auto add = [&](int i, int j) {
    if (overlap(nodes_[i].box, nodes_[j].box)) parts.push_back({i, j});
  };
  if (a == b) {
    add(a + 1, a + 1);
    add(nodes_[a].right, nodes_[a].right);
    add(a + 1, nodes_[a].right);
    return;
  }
  const bool open_a = nodes_[a].end - nodes_[a].begin >= nodes_[b].end - nodes_[b].begin;
  const int opened = open_a ? a : b;
  const int kept = open_a ? b : a;
  add(opened + 1, kept);
  add(nodes_[opened].right, kept);
}

std::vector<TriangleTree::NodePair> TriangleTree::tasks(std::size_t count) const {
  std::vector<NodePair> parts{{0, 0}};
  while (parts.size() < count) {
    std::vector<NodePair> finer;
    for (const NodePair& pair : parts) {
      if (nodes_[pair[0]].right < 0 && nodes_[pair[1]].right < 0)
        finer.push_back(pair);
      else
        split(pair, finer);
    }
    if (finer.size() <= parts.size()) break;
    parts = std::move(finer);
  }
  return parts;
}

}  // namespace epura
