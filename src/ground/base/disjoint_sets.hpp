// SPDX-License-Identifier: Apache-2.0
// Disjoint sets with union (union-find).
#pragma once

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

namespace epura {

/// Numbers from 0, each in a separate set until sets are joined. A set is identified by its smallest number.
class DisjointSets {
 public:
  explicit DisjointSets(std::size_t count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), 0); }

  /// Returns the set that contains a number.
  int root(int i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }

  void join(int i, int j) {
    i = root(i);
    j = root(j);
    parent_[std::max(i, j)] = std::min(i, j);
  }

  /// Returns the root of each number.
  [[nodiscard]] std::vector<int> roots() && {
    for (int i = 0; i < static_cast<int>(parent_.size()); ++i) parent_[i] = root(i);
    return std::move(parent_);
  }

 private:
  std::vector<int> parent_;
};

}  // namespace epura
