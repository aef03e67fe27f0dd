#include "edges/triangle_tree.hpp"

#include <algorithm>
#include <cstdint>
#include <utility>

#include "base/parallel.hpp"

namespace epura {

namespace {

constexpr int leaf_size = 6;
constexpr int alone = 8192;  // triangles that one thread handles without help

// Nodes of a tree over so many triangles: halves are equal, so the tree's shape follows from the number alone.
int node_count(int triangles) {
  return triangles <= leaf_size ? 1 : 1 + node_count(triangles / 2) + node_count(triangles - triangles / 2);
}

// The lower 21 bits, two zeros behind each.
std::uint64_t spread(std::uint64_t x) {
  x &= 0x1fffff;
  x = (x | x << 32) & 0x1f00000000ffff;
  x = (x | x << 16) & 0x1f0000ff0000ff;
  x = (x | x << 8) & 0x100f00f00f00f00f;
  x = (x | x << 4) & 0x10c30c30c30c30c3;
  return (x | x << 2) & 0x1249249249249249;
}

}  // namespace

TriangleTree::TriangleTree(std::vector<Box> boxes) : boxes_(std::move(boxes)) {
  sort_along_curve();
  const int count = static_cast<int>(boxes_.size());
  nodes_.resize(static_cast<std::size_t>(node_count(count)));
  build(0, 0, count);
}

// By the places of the boxes' middles on a Morton curve: neighbours there are neighbours in space.
void TriangleTree::sort_along_curve() {
  Box all;
  for (const Box& box : boxes_) all.add(box.centre());
  const Vec3 size = all.size();
  const double cells = 0x1fffff / std::max({size.x, size.y, size.z, 1e-300});
  std::vector<std::pair<std::uint64_t, int>> places(boxes_.size());
  parallel_for(places.size(), alone, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const Vec3 at = (boxes_[i].centre() - all.least) * cells;
      const std::uint64_t code = spread(static_cast<std::uint64_t>(at.x)) |
                                 spread(static_cast<std::uint64_t>(at.y)) << 1 |
                                 spread(static_cast<std::uint64_t>(at.z)) << 2;
      places[i] = {code, static_cast<int>(i)};
    }
  });
  parallel_sort(places.begin(), places.end());
  std::vector<Box> sorted;
  sorted.reserve(boxes_.size());
  for (const auto& [code, triangle] : places) {
    order_.push_back(triangle);
    sorted.push_back(boxes_[triangle]);
  }
  boxes_ = std::move(sorted);
}

void TriangleTree::build(int number, int begin, int end) {
  Node& node = nodes_[number];
  node = {{}, begin, end, -1};
  if (end - begin <= leaf_size) {
    for (int i = begin; i < end; ++i) {
      node.box.add(boxes_[i].least);
      node.box.add(boxes_[i].most);
    }
    return;
  }
  const int middle = begin + (end - begin) / 2;
  const int left = number + 1;
  const int right = left + node_count(middle - begin);
  node.right = right;
  const auto build_left = [&] { build(left, begin, middle); };
  const auto build_right = [&] { build(right, middle, end); };
  if (end - begin > alone) {
    parallel_both(build_left, build_right);
  } else {
    build_left();
    build_right();
  }
  for (const int child : {left, right}) {
    node.box.add(nodes_[child].box.least);
    node.box.add(nodes_[child].box.most);
  }
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
