#include "edges/triangle_tree.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/parallel.hpp"

namespace epura {

namespace {

constexpr std::size_t grain = 8192;

// The lower 21 bits, two zeros behind each.
std::uint64_t spread(std::uint64_t x) {
  x &= 0x1fffff;
  x = (x | x << 32) & 0x1f00000000ffff;
  x = (x | x << 16) & 0x1f0000ff0000ff;
  x = (x | x << 8) & 0x100f00f00f00f00f;
  x = (x | x << 4) & 0x10c30c30c30c30c3;
  return (x | x << 2) & 0x1249249249249249;
}

// A place on a Morton curve, 63 bits.
using Code = std::uint64_t;

std::vector<Code> codes_of(std::size_t count, const std::function<Box(int)>& box_of) {
  std::vector<Vec3> centres(count);
  parallel_for(count, grain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) centres[i] = box_of(static_cast<int>(i)).centre();
  });
  Box all;
  for (const Vec3& centre : centres) all.add(centre);
  const Vec3 size = all.size();
  const double cells = 0x1fffff / std::max({size.x, size.y, size.z, 1e-300});
  std::vector<Code> codes(count);
  parallel_for(count, grain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const Vec3 at = (centres[i] - all.least) * cells;
      codes[i] = spread(static_cast<std::uint64_t>(at.x)) | spread(static_cast<std::uint64_t>(at.y)) << 1 |
                 spread(static_cast<std::uint64_t>(at.z)) << 2;
    }
  });
  return codes;
}

// By the places of the boxes' middles on the curve: neighbours there are neighbours in space. One pass puts them into
// buckets by the codes' upper bits; the buckets are sorted side by side.
std::vector<int> order_along_curve(const std::vector<Code>& codes) {
  constexpr int lower_bits = 63 - 15;
  std::vector<std::size_t> ends((1 << 15) + 1, 0);
  for (const Code code : codes) ++ends[(code >> lower_bits) + 1];
  for (std::size_t b = 1; b < ends.size(); ++b) ends[b] += ends[b - 1];
  std::vector<int> order(codes.size());
  for (std::size_t i = 0; i < codes.size(); ++i) order[ends[codes[i] >> lower_bits]++] = static_cast<int>(i);
  parallel_for(ends.size() - 1, 64, [&](std::size_t first, std::size_t last) {
    std::vector<std::pair<Code, int>> bucket;
    for (std::size_t b = first; b < last; ++b) {
      const auto begin = order.begin() + static_cast<std::ptrdiff_t>(b == 0 ? 0 : ends[b - 1]);
      const auto end = order.begin() + static_cast<std::ptrdiff_t>(ends[b]);
      bucket.clear();
      for (auto it = begin; it != end; ++it) bucket.emplace_back(codes[*it], *it);
      std::sort(bucket.begin(), bucket.end());
      std::transform(bucket.begin(), bucket.end(), begin, [](const auto& place) { return place.second; });
    }
  });
  return order;
}

float rounded_down(double x) {
  const auto rounded = static_cast<float>(x);
  return rounded > x ? std::nextafter(rounded, -std::numeric_limits<float>::infinity()) : rounded;
}

}  // namespace

TriangleTree::TriangleTree(std::size_t count, const std::function<Box(int)>& box_of) {
  if (count == 0) return;
  leaves_.resize((count + width - 1) / width);
  fill_leaves(order_along_curve(codes_of(count, box_of)), box_of);
  nodes_.resize(2 * leaves_.size() - 1);
  build(0, 0, static_cast<int>(leaves_.size()));
}

TriangleTree::Bounds TriangleTree::rounded_outwards(const Box& box) {
  Bounds bounds;
  for (int axis = 0; axis < 3; ++axis) {
    bounds.least[axis] = rounded_down(box.least[axis]);
    bounds.most[axis] = -rounded_down(-box.most[axis]);
  }
  return bounds;
}

bool TriangleTree::overlap(const Bounds& a, const Bounds& b) {
  bool apart = false;
  for (std::size_t axis = 0; axis < 3; ++axis)
    apart |= a.least[axis] > b.most[axis] || b.least[axis] > a.most[axis];
  return !apart;
}

void TriangleTree::fill_leaves(const std::vector<int>& order, const std::function<Box(int)>& box_of) {
  parallel_for(leaves_.size(), grain / width, [&](std::size_t begin, std::size_t end) {
    for (std::size_t l = begin; l < end; ++l)
      for (std::size_t i = 0; i < width; ++i) {
        const std::size_t at = l * width + i;
        leaves_[l].triangle[i] = at < order.size() ? order[at] : -1;
        const Bounds bounds = at < order.size() ? rounded_outwards(box_of(order[at])) : Bounds{};
        for (std::size_t axis = 0; axis < 3; ++axis) {
          leaves_[l].least[axis][i] = bounds.least[axis];
          leaves_[l].most[axis][i] = bounds.most[axis];
        }
      }
  });
}

TriangleTree::Bounds TriangleTree::build(int node, int leaf, int leaves) {
  Bounds bounds;
  nodes_[node] = {bounds, leaf, leaves};
  if (leaves == 1) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      bounds.least[axis] = *std::min_element(leaves_[leaf].least[axis].begin(), leaves_[leaf].least[axis].end());
      bounds.most[axis] = *std::max_element(leaves_[leaf].most[axis].begin(), leaves_[leaf].most[axis].end());
    }
  } else {
    Bounds left, right;
    const int half = leaves / 2;
    const auto build_left = [&] { left = build(node + 1, leaf, half); };
    const auto build_right = [&] { right = build(right_child(node), leaf + half, leaves - half); };
    if (static_cast<std::size_t>(leaves) * width > grain) {
      parallel_both(build_left, build_right);
    } else {
      build_left();
      build_right();
    }
    for (std::size_t axis = 0; axis < 3; ++axis) {
      bounds.least[axis] = std::min(left.least[axis], right.least[axis]);
      bounds.most[axis] = std::max(left.most[axis], right.most[axis]);
    }
  }
  nodes_[node].bounds = bounds;
  return bounds;
}

// A node against itself: its children against themselves and each other. Two nodes: the larger one is opened.
void TriangleTree::split(const NodePair& pair, std::vector<NodePair>& parts) const {
  const auto [a, b] = pair;
  const auto add = [&](int i, int j) {
    if (overlap(nodes_[i].bounds, nodes_[j].bounds)) parts.push_back({i, j});
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

}  // namespace epura
