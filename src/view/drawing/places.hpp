// SPDX-License-Identifier: Apache-2.0
// Values at places on paper, found again within a distance: ends of lines that meet differ by rounding.
#pragma once

#include <map>
#include <utility>

#include "base/vec.hpp"

namespace epura::drawing {

template <class Value>
class Places {
 public:
  explicit Places(double distance) : distance_(distance) {}

  void add(const Vec2& place, const Value& value) { by_x_.emplace(place.x, std::pair(place, value)); }

  /// One that is near, the first from the left; null if there is none.
  [[nodiscard]] const Value* find(const Vec2& place) const {
    for (auto at = by_x_.lower_bound(place.x - distance_); at != by_x_.end() && at->first <= place.x + distance_; ++at)
      if (glm::distance(at->second.first, place) <= distance_) return &at->second.second;
    return nullptr;
  }

  [[nodiscard]] bool empty() const { return by_x_.empty(); }

 private:
  double distance_;
  std::multimap<double, std::pair<Vec2, Value>> by_x_{};
};

}  // namespace epura::drawing
