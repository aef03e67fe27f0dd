// SPDX-License-Identifier: Apache-2.0
#include "mesh/simple_rings.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <unordered_map>
#include <utility>

#include "base/vec.hpp"

namespace epura::mesh {

namespace {

// Positions relative to the first corner of a ring, scaled to about unit size.
class Places {
 public:
  Places(std::span<const int> ring, const Points& points) : points_(points), origin_(ring.front()) {
    double largest = 0;
    for (const int corner : ring)
      for (const double x : points[corner]) largest = std::max(largest, std::abs(x));
    scale_ = largest > 0 ? std::ldexp(1.0, -std::clamp(std::ilogb(largest), -1000, 1000)) : 1;
  }

  // Twice the vector area of a closed ring.
  [[nodiscard]] Vec3 area(std::span<const int> ring) const {
    Vec3 sum(0);
    for (std::size_t i = 0; i < ring.size(); ++i) sum += glm::cross(at(ring[i]), at(ring[(i + 1) % ring.size()]));
    return sum;
  }

 private:
  [[nodiscard]] Vec3 place(int corner) const {
    return Vec3(points_[corner][0], points_[corner][1], points_[corner][2]) * scale_;
  }
  [[nodiscard]] Vec3 at(int corner) const { return place(corner) - place(origin_); }

  const Points& points_;
  int origin_;
  double scale_ = 1;
};

// Removes spikes, which lead to a corner and back, including those across the end of the ring.
void drop_spikes(std::vector<int>& ring) {
  std::vector<int> kept;
  for (const int corner : ring) {
    kept.push_back(corner);
    while (kept.size() > 2 && kept.back() == kept[kept.size() - 3]) kept.resize(kept.size() - 2);
    if (kept.size() > 1 && kept.back() == kept[kept.size() - 2]) kept.pop_back();
  }
  std::size_t first = 0, last = kept.size();
  while (last - first > 2) {
    if (kept[first] == kept[last - 1]) {
      --last;
    } else if (kept[first] == kept[last - 2]) {
      last -= 2;
    } else if (kept[first + 1] == kept[last - 1]) {
      ++first;
      --last;
    } else {
      break;
    }
  }
  ring.assign(kept.begin() + static_cast<std::ptrdiff_t>(first), kept.begin() + static_cast<std::ptrdiff_t>(last));
}

// A loop that is gone round again bounds nothing more.
void drop_repeated(std::vector<std::vector<int>>& rings) {
  if (rings.size() < 2) return;
  std::set<std::vector<int>> known;
  std::erase_if(rings, [&](std::vector<int> ring) {
    std::rotate(ring.begin(), std::min_element(ring.begin(), ring.end()), ring.end());
    return !known.insert(std::move(ring)).second;
  });
}

}  // namespace

bool repeats_corner(std::span<const int> ring) {
  // Nearly all polygons are small: no memory is allocated.
  if (ring.size() <= 16) {
    for (std::size_t i = 1; i < ring.size(); ++i)
      if (std::find(ring.begin(), ring.begin() + static_cast<std::ptrdiff_t>(i), ring[i]) !=
          ring.begin() + static_cast<std::ptrdiff_t>(i))
        return true;
    return false;
  }
  std::vector<int> sorted(ring.begin(), ring.end());
  std::sort(sorted.begin(), sorted.end());
  return std::adjacent_find(sorted.begin(), sorted.end()) != sorted.end();
}

std::vector<std::vector<int>> simple_rings(std::span<const int> ring, const Points& points) {
  std::vector<int> rest(ring.begin(), ring.end());
  drop_spikes(rest);
  std::vector<std::vector<int>> rings;
  const Places places(ring, points);
  Vec3 area = places.area(rest);
  std::vector<int> open;
  std::unordered_map<int, std::size_t> place_in_open;
  for (const int corner : rest) {
    const auto before = place_in_open.find(corner);
    if (before != place_in_open.end()) {
      const std::span<const int> loop(open.begin() + static_cast<std::ptrdiff_t>(before->second), open.end());
      const Vec3 of_loop = places.area(loop);
      if (glm::dot(of_loop, area) > 0 && glm::dot(area - of_loop, area) > 0) {
        rings.emplace_back(loop.begin(), loop.end());
        area -= of_loop;
        const std::size_t length = before->second;
        for (const int gone : rings.back()) place_in_open.erase(gone);
        open.resize(length);
      }
    }
    place_in_open[corner] = open.size();
    open.push_back(corner);
  }
  rings.push_back(std::move(open));
  for (auto& found : rings) drop_spikes(found);
  std::erase_if(rings, [](const auto& found) { return found.size() < 3; });
  drop_repeated(rings);
  return rings;
}

}  // namespace epura::mesh
