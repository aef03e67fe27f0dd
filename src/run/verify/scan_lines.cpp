// SPDX-License-Identifier: Apache-2.0
#include "verify/scan_lines.hpp"

#include <cmath>
#include <random>

#include "base/portable_math.hpp"

namespace epura::verify {

LineBundle::LineBundle(const ScanWindow& box, double direction, double distance, unsigned seed) : distance_(distance) {
  const Vec2 along(portable_cos(direction), portable_sin(direction));
  across_ = {-along.y, along.x};
  const Vec2 middle = 0.5 * (box.min + box.max);
  const double radius = 0.5 * glm::distance(box.min, box.max);
  first_ = glm::dot(across_, middle) - radius;
  std::mt19937 random(seed);
  for (double strip = 0; strip * distance < 2 * radius; ++strip) {
    const double part = std::ldexp(static_cast<double>(random()), -32);
    offset_.push_back(first_ + (strip + part) * distance);
    lines_.push_back({middle + (offset_.back() - first_ - radius) * across_, along, radius});
  }
}

ItemsOfLines::ItemsOfLines(std::size_t lines, const std::vector<std::vector<std::pair<int, int>>>& pairs)
    : first(lines + 1, 0) {
  for (const auto& part : pairs)
    for (const auto& [line, item] : part) ++first[line + 1];
  for (std::size_t i = 0; i < lines; ++i) first[i + 1] += first[i];
  items.resize(first.back());
  std::vector<int> next = first;
  for (const auto& part : pairs)
    for (const auto& [line, item] : part) items[next[line]++] = item;
}

}  // namespace epura::verify
