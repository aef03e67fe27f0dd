#include "visibility/occluders.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "base/parallel.hpp"

namespace epura {

namespace {

constexpr std::size_t chunk = 8192;

// Whether the line through two corners keeps the third corner and the whole square on different sides.
bool separates(const PageVertex& a, const PageVertex& b, const PageVertex& c, const Vec2& middle, double half) {
  const Vec2 normal(a.y - b.y, b.x - a.x);
  const double inner = normal.x * (c.x - a.x) + normal.y * (c.y - a.y);
  const double square = normal.x * (middle.x - a.x) + normal.y * (middle.y - a.y);
  const double reach = half * (std::abs(normal.x) + std::abs(normal.y));
  return inner > 0 ? square + reach < 0 : square - reach > 0;
}

}  // namespace

OccluderGrid::OccluderGrid(const View& view, const std::vector<DrawnEdge>& edges) : view_(view), grid_{} {
  choose_cells(edges);
  find_depths(edges);
  fill(collect());
}

void OccluderGrid::choose_cells(const std::vector<DrawnEdge>& edges) {
  Vec2 least(HUGE_VAL), most(-HUGE_VAL);
  for (const DrawnEdge& edge : edges)
    for (const int v : edge.vertex) {
      const Vec2 place(view_.vertices[v].x, view_.vertices[v].y);
      least = glm::min(least, place);
      most = glm::max(most, place);
    }
  if (edges.empty()) least = most = Vec2(0);
  grid_ = make_cell_grid(least, most, static_cast<double>(view_.triangles.size()) / 2);
}

void OccluderGrid::find_depths(const std::vector<DrawnEdge>& edges) {
  deepest_.assign(static_cast<std::size_t>(grid_.count()), HUGE_VAL);
  for (const DrawnEdge& edge : edges) {
    const double p = view_.vertices[edge.vertex[0]].depth;
    const double q = view_.vertices[edge.vertex[1]].depth;
    along({edge.vertex[0], edge.vertex[1]}, [&](int cell, double from, double to) {
      deepest_[cell] = std::min({deepest_[cell], p + from * (q - p), p + to * (q - p)});
    });
  }
}

// The cells that a triangle may touch and in which something lies behind its nearest corner.
void OccluderGrid::add_cells(const std::array<int, 3>& corners, double nearest, std::vector<int>& cells) const {
  const PageVertex& a = view_.vertices[corners[0]];
  const PageVertex& b = view_.vertices[corners[1]];
  const PageVertex& c = view_.vertices[corners[2]];
  const int left = grid_.column(std::min({a.x, b.x, c.x}) - margin());
  const int right = grid_.column(std::max({a.x, b.x, c.x}) + margin());
  const int bottom = grid_.row(std::min({a.y, b.y, c.y}) - margin());
  const int top = grid_.row(std::max({a.y, b.y, c.y}) + margin());
  const bool large = right - left > 1 && top - bottom > 1;
  const double half = grid_.side / 2 + 2 * margin();
  for (int row = bottom; row <= top; ++row)
    for (int column = left; column <= right; ++column) {
      const int cell = grid_.cell(column, row);
      if (!(nearest > deepest_[cell])) continue;
      // The outermost cells reach beyond their square.
      const bool inner = column > 0 && row > 0 && column < grid_.columns - 1 && row < grid_.rows - 1;
      const Vec2 middle = grid_.origin + grid_.side * Vec2(column + 0.5, row + 0.5);
      if (large && inner &&
          (separates(a, b, c, middle, half) || separates(b, c, a, middle, half) || separates(c, a, b, middle, half)))
        continue;
      cells.push_back(cell);
    }
}

void OccluderGrid::collect(const ViewTriangle& triangle, Found& found) const {
  const auto& [i, j, k] = triangle.vertex;
  if (cross(view_.grid[i], view_.grid[j], view_.grid[k]) == 0) return;
  const Occluder occluder = make_occluder(view_, triangle);
  const std::size_t before = found.cells.size();
  add_cells(triangle.vertex, occluder.nearest, found.cells);
  if (found.cells.size() == before) return;
  found.occluders.push_back(occluder);
  found.ends.push_back(found.cells.size());
}

OccluderGrid::Found OccluderGrid::collect() const {
  const std::size_t count = view_.triangles.size();
  std::vector<Found> parts((count + chunk - 1) / chunk);
  parallel_for(parts.size(), 1, [&](std::size_t first, std::size_t last) {
    for (std::size_t part = first; part < last; ++part)
      for (std::size_t t = part * chunk; t < std::min((part + 1) * chunk, count); ++t)
        collect(view_.triangles[t], parts[part]);
  });
  Found all;
  for (const Found& part : parts) {
    for (const std::size_t end : part.ends) all.ends.push_back(all.cells.size() + end);
    all.occluders.insert(all.occluders.end(), part.occluders.begin(), part.occluders.end());
    all.cells.insert(all.cells.end(), part.cells.begin(), part.cells.end());
  }
  return all;
}

void OccluderGrid::fill(const Found& found) {
  std::vector<int> order(found.occluders.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(), [&](int a, int b) {
    return std::pair(-found.occluders[a].nearest, a) < std::pair(-found.occluders[b].nearest, b);
  });
  first_.assign(static_cast<std::size_t>(grid_.count()) + 1, 0);
  for (const int cell : found.cells) ++first_[cell + 1];
  std::partial_sum(first_.begin(), first_.end(), first_.begin());
  members_.resize(found.cells.size());
  std::vector<std::size_t> next(first_.begin(), first_.end() - 1);
  occluders_.reserve(order.size());
  for (const int o : order) {
    for (std::size_t i = o == 0 ? 0 : found.ends[o - 1]; i < found.ends[o]; ++i)
      members_[next[found.cells[i]]++] = static_cast<int>(occluders_.size());
    occluders_.push_back(found.occluders[o]);
  }
}

}  // namespace epura
