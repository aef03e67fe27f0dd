// SPDX-License-Identifier: Apache-2.0
// Lists, one after the other.
#pragma once

#include <iterator>
#include <utility>
#include <vector>

namespace epura {

/// Returns a list with all elements of another one at its end.
template <class T>
std::vector<T> joined(std::vector<T> all, std::vector<T> more) {
  all.insert(all.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
  return all;
}

}  // namespace epura
