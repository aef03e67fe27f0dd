// SPDX-License-Identifier: Apache-2.0
// Vectors that leave new items uninitialised until they are written.
#pragma once

#include <memory>
#include <vector>

namespace epura {

/// Leaves new items as they are in memory if their type permits it.
template <class Item>
struct UnsetAllocator : std::allocator<Item> {
  template <class Other>
  struct rebind {
    using other = UnsetAllocator<Other>;
  };
  template <class Other>
  void construct(Other* place) {
    ::new (static_cast<void*>(place)) Other;
  }
};

/// For large vectors that a parallel loop fills: their memory is first touched by that loop, on several threads,
/// instead of by one thread that writes zeros.
template <class Item>
using UnsetVector = std::vector<Item, UnsetAllocator<Item>>;

}  // namespace epura
