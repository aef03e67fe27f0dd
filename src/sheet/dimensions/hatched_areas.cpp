// SPDX-License-Identifier: Apache-2.0
#include "dimensions/hatched_areas.hpp"

#include <algorithm>

#include "base/error.hpp"
#include "dimensions/obstacles.hpp"
#include "drawing/drawing.hpp"

namespace epura::sheet {

namespace {

// Calls `visit(from, to)` for the sides of a ring.
void visit_sides(const std::vector<Vec2>& ring, const auto& visit) {
  for (std::size_t i = 0; i < ring.size(); ++i) visit(ring[i], ring[(i + 1) % ring.size()]);
}

}  // namespace

HatchedAreas::HatchedAreas(const drawing::ViewDrawing& drawing) {
  for (const drawing::CutFace& face : drawing.cuts.faces)
    for (const std::vector<Vec2>& ring : face.rings) {
      Rectangle box{ring.front(), ring.front()};
      for (const Vec2& p : ring) box = united(box, {p, p});
      rings_.push_back({box, ring});
    }
}

bool HatchedAreas::contains(const Vec2& p) const {
  bool is_inside = false;
  for (const Ring& ring : rings_) {
    if (!ring.box.holds({p, p})) continue;
    visit_sides(ring.corners, [&](const Vec2& a, const Vec2& b) {
      if ((a.y > p.y) != (b.y > p.y) && a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x) > p.x) is_inside = !is_inside;
    });
  }
  return is_inside;
}

int HatchedAreas::on_way(const Vec2& from, const Vec2& to) const {
  const Vec2 way = to - from;
  const Rectangle box{glm::min(from, to), glm::max(from, to)};
  std::vector<double> at{0, 1};
  for (const Ring& ring : rings_) {
    if (!ring.box.grown(on_line).overlaps(box.grown(on_line))) continue;
    visit_sides(ring.corners, [&](const Vec2& a, const Vec2& b) {
      const double one = cross(way, a - from), other = cross(way, b - from);
      if ((one > 0) == (other > 0)) return;
      const double t = glm::dot(a + one / (one - other) * (b - a) - from, way) / glm::dot(way, way);
      if (t > 0 && t < 1) at.push_back(t);
    });
  }
  std::sort(at.begin(), at.end());
  int count = 0;
  for (std::size_t i = 1; i < at.size(); ++i)
    if ((at[i] - at[i - 1]) * glm::length(way) > on_line && contains(from + (at[i - 1] + at[i]) / 2 * way)) ++count;
  check(count >= 0, "parts are counted");
  return count;
}

}  // namespace epura::sheet
