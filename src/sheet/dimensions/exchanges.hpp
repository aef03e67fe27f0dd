// SPDX-License-Identifier: Apache-2.0
// Leaders that cross are untangled by exchanging places: by the triangle inequality, straight ones become shorter.
#pragma once

#include <cstddef>
#include <span>

#include "dimensions/item_arrangement.hpp"
#include "dimensions/place_items.hpp"

namespace epura::sheet {

/// Exchanges the places of items with crossing leaders, beginning with one of them, while the sum of their costs falls.
/// Whether none of those that moved crosses anything then.
bool untangle(ItemArrangement& placed, std::span<const PlacementItem> items, std::size_t first);

}  // namespace epura::sheet
