// SPDX-License-Identifier: Apache-2.0
// A tree over items in a given order, searched by the bounds of several measures.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace epura::search {

/// Minimum and maximum of each of several measures.
template <std::size_t measures>
using Bounds = std::array<std::array<double, 2>, measures>;

/// Whether both have a value of each measure in common.
template <std::size_t measures>
bool meet(const Bounds<measures>& a, const Bounds<measures>& b) {
  for (std::size_t i = 0; i < measures; ++i)
    if (a[i][0] > b[i][1] || a[i][1] < b[i][0]) return false;
  return true;
}

/// Halves the items repeatedly in their given order, which is therefore the order of visiting.
template <std::size_t measures>
class BoundsTree {
 public:
  BoundsTree() = default;

  /// `bounds_of(i)` returns the bounds of item i.
  template <class BoundsOf>
  BoundsTree(std::size_t count, const BoundsOf& bounds_of) : count_(count) {
    if (count > 0) bound(0, 0, count, bounds_of);
  }

  [[nodiscard]] bool empty() const { return count_ == 0; }

  /// Calls `visit(i)`, ascending, for all items that meet the wanted bounds, and for some others near them, until it
  /// returns false. `visit` may narrow the wanted bounds.
  template <class Visit>
  void visit(const Bounds<measures>& wanted, Visit visit) const {
    visit_where([&](const Bounds<measures>& bounds) { return meet<measures>(bounds, wanted); }, visit);
  }

  /// The same for items with bounds for which `may_hold(bounds)` is true. It must also be true for all bounds that
  /// contain these.
  template <class MayHold, class Visit>
  void visit_where(const MayHold& may_hold, Visit visit) const {
    if (count_ > 0) visit_below(0, 0, count_, may_hold, visit);
  }

 private:
  static constexpr std::size_t leaf = 8;  // maximum number of items that are not divided

  // Nodes are in heap order.
  template <class BoundsOf>
  const Bounds<measures>& bound(std::size_t node, std::size_t begin, std::size_t end, const BoundsOf& bounds_of) {
    Bounds<measures> all;
    all.fill({HUGE_VAL, -HUGE_VAL});
    const auto add = [&](const Bounds<measures>& other) {
      for (std::size_t i = 0; i < measures; ++i)
        all[i] = {std::min(all[i][0], other[i][0]), std::max(all[i][1], other[i][1])};
    };
    if (end - begin <= leaf) {
      for (std::size_t i = begin; i < end; ++i) add(bounds_of(i));
    } else {
      const std::size_t middle = begin + (end - begin) / 2;
      add(bound(2 * node + 1, begin, middle, bounds_of));
      add(bound(2 * node + 2, middle, end, bounds_of));
    }
    if (nodes_.size() <= node) nodes_.resize(node + 1);
    return nodes_[node] = all;
  }

  template <class MayHold, class Visit>
  bool visit_below(std::size_t node, std::size_t begin, std::size_t end, const MayHold& may_hold, Visit& visit) const {
    if (!may_hold(nodes_[node])) return true;
    if (end - begin <= leaf) {
      while (begin < end && visit(begin)) ++begin;
      return begin == end;
    }
    const std::size_t middle = begin + (end - begin) / 2;
    return visit_below(2 * node + 1, begin, middle, may_hold, visit) &&
           visit_below(2 * node + 2, middle, end, may_hold, visit);
  }

  std::size_t count_ = 0;
  std::vector<Bounds<measures>> nodes_;
};

}  // namespace epura::search
