// SPDX-License-Identifier: Apache-2.0
#include "visibility/occluder_patch.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "base/error.hpp"
#include "visibility/limits.hpp"

namespace epura::visibility {

CoverPlane::CoverPlane(const view::ProjectedScene& view, const view::ViewTriangle& triangle, const Vec2& half)
    : corner_(view.vertices[triangle.vertex[0]].at()) {
  const std::optional<Vec2> slope = slope_of(view, triangle);
  if (!slope) return;
  slope_ = *slope;
  const double depth = view.vertices[triangle.vertex[0]].depth;
  const double steepness = std::abs(slope->x) + std::abs(slope->y);
  const double rounding = depth_rounding * (view.extent + std::abs(depth));
  depth_ = depth - glm::dot(half, glm::abs(*slope)) - view.contact.touching * (1 + steepness) - rounding;
}

bool OccluderPatch::add(const view::ViewTriangle& triangle) {
  const double depth = CoverPlane(view_, triangle, cell_.half).depth(cell_.middle);
  if (depth == -HUGE_VAL) return false;
  const auto& v = triangle.vertex;
  const bool turns_left = view::cross(view_.grid[v[0]], view_.grid[v[1]], view_.grid[v[2]]) > 0;
  const int sheet = static_cast<int>(sheets_.size());
  sheets_.push_back({sheet, 0, depth});
  bool alone = true;
  for (int side = 0; side < 3; ++side) {
    if (!reaches_in(v[side], v[(side + 1) % 3])) continue;
    close(sheet, triangle, side, turns_left);
    alone = false;
  }
  const Sheet& whole = sheets_[root(sheet)];
  check(whole.depth <= depth, "a sheet lies no nearer than any of its triangles");
  if (whole.open > 0 || (alone && !holds_middle(triangle))) return false;
  depth_ = whole.depth;
  return true;
}

// A triangle on the other side closes an open side; any other opens one.
void OccluderPatch::close(int sheet, const view::ViewTriangle& triangle, int side, bool turns_left) {
  const int u = triangle.vertex[side], v = triangle.vertex[(side + 1) % 3];
  const bool left = turns_left == (u < v);
  const std::uint64_t key =
      std::uint64_t{static_cast<std::uint32_t>(std::min(u, v))} << 32 | static_cast<std::uint32_t>(std::max(u, v));
  const auto [found, is_new] = open_.try_emplace(key, OpenSide{sheet, left});
  Sheet& own = sheets_[root(sheet)];
  if (is_new || found->second.left == left) {
    ++own.open;
    return;
  }
  Sheet& other = sheets_[root(found->second.sheet)];
  open_.erase(found);
  --other.open;
  if (&own == &other) return;
  other.open += own.open;
  check(other.open >= 0, "a side that is closed was open");
  other.depth = std::min(other.depth, own.depth);
  own.parent = other.parent;
}

int OccluderPatch::root(int sheet) {
  while (sheets_[sheet].parent != sheet) sheet = sheets_[sheet].parent = sheets_[sheets_[sheet].parent].parent;
  return sheet;
}

bool OccluderPatch::reaches_in(int u, int v) const {
  const Vec2 a = view_.vertices[u].at() - cell_.middle, b = view_.vertices[v].at() - cell_.middle;
  const Vec2 along = b - a;
  if (std::min(a.x, b.x) > cell_.half.x || std::max(a.x, b.x) < -cell_.half.x) return false;
  if (std::min(a.y, b.y) > cell_.half.y || std::max(a.y, b.y) < -cell_.half.y) return false;
  return std::abs(cross(along, a)) <= std::abs(along.x) * cell_.half.y + std::abs(along.y) * cell_.half.x;
}

bool OccluderPatch::holds_middle(const view::ViewTriangle& triangle) const {
  int left = 0;
  for (int i = 0; i < 3; ++i) {
    const Vec2 a = view_.vertices[triangle.vertex[i]].at() - cell_.middle;
    const Vec2 b = view_.vertices[triangle.vertex[(i + 1) % 3]].at() - cell_.middle;
    left += static_cast<int>(cross(a, b) > 0);
  }
  return left == 0 || left == 3;
}

}  // namespace epura::visibility
