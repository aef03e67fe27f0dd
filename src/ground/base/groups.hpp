// SPDX-License-Identifier: Apache-2.0
// Items by group, with the items of all groups in one array, group after group.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <numeric>
#include <span>
#include <utility>
#include <vector>

#include "base/unset_vector.hpp"

namespace epura {

/// Items have no particular order within a group: it changes from run to run.
template <class Item>
class Groups {
 public:
  Groups() = default;

  /// `each(visit)` must call visit(group, item) for every item, on any number of threads. It is called twice and must
  /// make the same calls both times.
  template <class Each>
  Groups(std::size_t groups, const Each& each) : first_(groups + 1, 0) {
    const auto count_up = [](std::size_t& n) { return std::atomic_ref(n).fetch_add(1, std::memory_order_relaxed); };
    each([&](std::size_t group, const auto&...) { count_up(first_[group + 1]); });
    std::partial_sum(first_.begin(), first_.end(), first_.begin());
    items_.resize(first_.back());
    std::vector<std::size_t> next(first_.begin(), first_.end() - 1);
    each([&](std::size_t group, const Item& item) { items_[count_up(next[group])] = item; });
  }

  /// The number of groups.
  [[nodiscard]] std::size_t size() const { return first_.empty() ? 0 : first_.size() - 1; }
  [[nodiscard]] std::span<const Item> operator[](std::size_t group) const {
    return {items_.data() + first_[group], first_[group + 1] - first_[group]};
  }
  [[nodiscard]] std::span<Item> operator[](std::size_t group) {
    return {items_.data() + first_[group], first_[group + 1] - first_[group]};
  }

  /// Keeps the first count(group, items) items of each group.
  template <class Count>
  void shorten(const Count& count) {
    std::size_t kept = 0;
    for (std::size_t group = 0; group < size(); ++group) {
      const auto items = std::as_const(*this)[group];
      const auto rest = items.first(static_cast<std::size_t>(count(group, items)));
      first_[group] = kept;
      if (rest.data() != items_.data() + kept) std::copy(rest.begin(), rest.end(), items_.begin() + kept);
      kept += rest.size();
    }
    if (!first_.empty()) first_.back() = kept;
    items_.resize(kept);
  }

 private:
  std::vector<std::size_t> first_;  ///< by group, into items_
  UnsetVector<Item> items_;
};

}  // namespace epura
