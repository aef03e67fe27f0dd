// SPDX-License-Identifier: Apache-2.0
// A sweep moves upwards in slabs between the heights of all ends and crossings. No two segments cross within a slab, so
// those that span it are sorted from left to right, and the inside lies between the first and second, the third and
// fourth of them, and so on. Trapezoids between the same two segments in consecutive slabs are merged.
// [Zalik, Clapworthy. A universal trapezoidation algorithm for planar polygons. Computers & Graphics 1999]
#include "mesh/even_odd.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace epura::mesh {

namespace {

constexpr double crossing_part = 1e-12;  // as a fraction of the whole size: closer lines touch instead of crossing

using Pair = std::array<int, 2>;

struct Slab {
  double bottom, top;
};

class Sweep {
 public:
  explicit Sweep(Outlines& outlines) : places_(outlines.places), segments_(outlines.segments) {
    std::erase_if(segments_, [&](const Pair& s) { return places_[s[0]].y == places_[s[1]].y; });
    double size = 0;
    for (Pair& s : segments_) {
      if (places_[s[0]].y > places_[s[1]].y) std::swap(s[0], s[1]);
      for (const int end : s) {
        heights_.push_back(places_[end].y);
        size = std::max({size, std::abs(places_[end].x), std::abs(places_[end].y)});
      }
    }
    slack_ = crossing_part * size;
    std::sort(segments_.begin(), segments_.end(), [&](const Pair& a, const Pair& b) {
      return std::pair(places_[a[0]].y, a) < std::pair(places_[b[0]].y, b);
    });
    std::sort(heights_.begin(), heights_.end());
    heights_.erase(std::unique(heights_.begin(), heights_.end()), heights_.end());
  }

  std::vector<std::array<int, 3>> run() {
    for (std::size_t i = 1; i < heights_.size(); ++i) sweep({heights_[i - 1], heights_[i]});
    for (const auto& [pair, bottom] : open_) emit(pair, bottom, heights_.back());
    return std::move(triangles_);
  }

 private:
  [[nodiscard]] double x_at(int segment, double y) const {
    const Vec2& a = places_[segments_[segment][0]];
    const Vec2& b = places_[segments_[segment][1]];
    if (y == a.y) return a.x;
    if (y == b.y) return b.x;
    return a.x + (y - a.y) / (b.y - a.y) * (b.x - a.x);
  }

  void sweep(const Slab& slab) {
    std::erase_if(active_, [&](int s) { return !(places_[segments_[s][1]].y > slab.bottom); });
    while (next_ < segments_.size() && places_[segments_[next_][0]].y <= slab.bottom)
      active_.push_back(static_cast<int>(next_++));
    divide(slab);
  }

  // Sorts from left to right along the middle of a slab.
  void sort_active(const Slab& slab) {
    const double middle = slab.bottom + (slab.top - slab.bottom) / 2;
    order_.clear();
    for (const int s : active_) order_.emplace_back(x_at(s, middle), s);
    std::sort(order_.begin(), order_.end());
    for (std::size_t i = 0; i < order_.size(); ++i) active_[i] = order_[i].second;
  }

  // Divides slabs at the heights at which segments cross.
  void divide(const Slab& whole) {
    std::vector<Slab> slabs{whole};
    while (!slabs.empty()) {
      const Slab slab = slabs.back();
      slabs.pop_back();
      sort_active(slab);
      const double crossing = crossing_in(slab);
      if (slab.bottom < crossing && crossing < slab.top) {
        slabs.push_back({crossing, slab.top});
        slabs.push_back({slab.bottom, crossing});
      } else {
        fill(slab.bottom);
      }
    }
  }

  // A height at which neighbours change their order; NaN if there is none.
  [[nodiscard]] double crossing_in(const Slab& slab) const {
    for (std::size_t i = 1; i < active_.size(); ++i) {
      const double below = x_at(active_[i], slab.bottom) - x_at(active_[i - 1], slab.bottom);
      const double above = x_at(active_[i], slab.top) - x_at(active_[i - 1], slab.top);
      if (std::min(below, above) < -slack_ && std::max(below, above) > slack_)
        return slab.bottom + below / (below - above) * (slab.top - slab.bottom);
    }
    return NAN;
  }

  // Trapezoids that do not continue in the slab end at its bottom.
  void fill(double bottom) {
    std::map<Pair, double> going_on;
    for (std::size_t i = 1; i < active_.size(); i += 2) {
      const Pair pair{active_[i - 1], active_[i]};
      const auto found = open_.find(pair);
      going_on[pair] = found == open_.end() ? bottom : found->second;
      if (found != open_.end()) open_.erase(found);
    }
    for (const auto& [pair, begin] : open_) emit(pair, begin, bottom);
    open_ = std::move(going_on);
  }

  // The number of the point on a segment at this height.
  int place_on(int segment, double y) {
    for (const int end : segments_[segment])
      if (places_[end].y == y) return end;
    const auto [found, made] = made_.try_emplace({segment, y}, static_cast<int>(places_.size()));
    if (made) places_.emplace_back(x_at(segment, y), y);
    return found->second;
  }

  void emit(const Pair& sides, double bottom, double top) {
    const auto [left, right] = sides;
    const double below = x_at(right, bottom) - x_at(left, bottom);
    const double above = x_at(right, top) - x_at(left, top);
    if (!(std::max(below, above) > 0)) return;
    const int a = place_on(left, bottom), b = place_on(right, bottom);
    const int c = place_on(right, top), d = place_on(left, top);
    if (a != b) triangles_.push_back({a, b, c});
    if (c != d) triangles_.push_back({a, c, d});
  }

  std::vector<Vec2>& places_;
  std::vector<Pair> segments_;  ///< each from its lower end, sorted by its height
  std::vector<double> heights_;
  double slack_ = 0;
  std::size_t next_ = 0;     ///< first segment that has not begun yet
  std::vector<int> active_;  ///< segments that span the slab
  std::vector<std::pair<double, int>> order_;
  std::map<Pair, double> open_;  ///< bottom of unfinished trapezoids, by their sides
  std::map<std::pair<int, double>, int> made_;
  std::vector<std::array<int, 3>> triangles_;
};

}  // namespace

std::vector<std::array<int, 3>> fill_even_odd(Outlines& outlines) { return Sweep(outlines).run(); }

bool is_inside(const Outlines& outlines, const Vec2& point) {
  bool inside = false;
  for (const auto& [i, j] : outlines.segments) {
    const Vec2& a = outlines.places[i];
    const Vec2& b = outlines.places[j];
    if ((a.y <= point.y) == (b.y <= point.y)) continue;
    if (a.x + (point.y - a.y) / (b.y - a.y) * (b.x - a.x) > point.x) inside = !inside;
  }
  return inside;
}

}  // namespace epura::mesh
