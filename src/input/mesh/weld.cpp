// SPDX-License-Identifier: Apache-2.0
#include "mesh/weld.hpp"

#include <bit>
#include <cmath>
#include <cstdint>
#include <numeric>

namespace epura::mesh {

namespace {

using Place = std::array<double, 3>;

bool is_finite(const Place& p) { return std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2]); }

std::uint64_t hash(const Place& p) {
  std::uint64_t h = 0;
  // Adding zero makes -0 equal to 0.
  for (const double x : p) h = std::rotl((h ^ std::bit_cast<std::uint64_t>(x + 0.0)) * 0x9E3779B97F4A7C15u, 32);
  return h * 0x9E3779B97F4A7C15u;
}

// A hash table of points with open addressing, which grows when half full.
class PlaceTable {
 public:
  explicit PlaceTable(const Points& points) : points_(points), slots_(std::bit_ceil(points.size() / 2 + 2), -1) {}

  /// Returns the first point entered at the position of `point`, which is entered if there is none.
  int first_at_place_of(int point) {
    int& slot = slot_of(point);
    if (slot >= 0) return slot;
    slot = point;
    if (2 * ++used_ > slots_.size()) grow();
    return point;
  }

 private:
  int& slot_of(int point) {
    const Place& place = points_[point];
    const std::size_t mask = slots_.size() - 1;
    std::size_t at = hash(place) >> 20 & mask;
    while (slots_[at] >= 0 && points_[slots_[at]] != place) at = (at + 1) & mask;
    return slots_[at];
  }

  void grow() {
    std::vector<int> old(4 * slots_.size(), -1);
    old.swap(slots_);
    for (const int point : old)
      if (point >= 0) slot_of(point) = point;
  }

  const Points& points_;
  std::vector<int> slots_;
  std::size_t used_ = 0;
};

}  // namespace

std::vector<int> same_places(const Points& points) {
  std::vector<int> first(points.size());
  std::iota(first.begin(), first.end(), 0);
  PlaceTable table(points);
  for (int& point : first)
    if (is_finite(points[point])) point = table.first_at_place_of(point);
  return first;
}

void renumber(Points& points, std::vector<int>& corners, std::vector<int> representative) {
  int kept = 0;
  for (std::size_t point = 0; point < points.size(); ++point) {
    // A representative precedes the points that it represents, so its new number is known.
    int& number = representative[point];
    if (number != static_cast<int>(point)) {
      number = representative[number];
      continue;
    }
    points[kept] = points[point];
    number = kept++;
  }
  points.resize(kept);
  points.shrink_to_fit();
  for (int& corner : corners) corner = representative[corner];
}

}  // namespace epura::mesh
