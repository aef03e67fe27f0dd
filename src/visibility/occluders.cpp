#include "visibility/occluders.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/parallel.hpp"

namespace epura {

namespace {

// Triangles lower than this part of their length on the page are lines there.
constexpr double thinnest = 0x1p-40;
constexpr std::size_t chunk = 8192;

// 1 + length of the gradient of depth over the page. A line has no gradient: what it covers is decided by depth alone.
double steepness_of(const PageVertex& a, const PageVertex& b, const PageVertex& c) {
  const double bx = b.x - a.x, by = b.y - a.y, bz = b.depth - a.depth;
  const double cx = c.x - a.x, cy = c.y - a.y, cz = c.depth - a.depth;
  const double area = bx * cy - by * cx;
  if (std::abs(area) <= thinnest * std::max(bx * bx + by * by, cx * cx + cy * cy)) return 1;
  return 1 + std::hypot((bz * cy - by * cz) / area, (bx * cz - bz * cx) / area);
}

double nearest_of(const View& view, const std::array<int, 3>& corners) {
  return std::max({view.vertices[corners[0]].depth, view.vertices[corners[1]].depth, view.vertices[corners[2]].depth});
}

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
  collect();
  fill();
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
template <class Visit>
void OccluderGrid::each_cell(const std::array<int, 3>& corners, double nearest, Visit visit) const {
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
      if (!visit(cell)) return;
    }
}

void OccluderGrid::collect() {
  const std::size_t count = view_.triangles.size();
  std::vector<std::vector<Occluder>> found((count + chunk - 1) / chunk);
  parallel_for(found.size(), 1, [&](std::size_t first, std::size_t last) {
    for (std::size_t part = first; part < last; ++part)
      for (std::size_t t = part * chunk; t < std::min((part + 1) * chunk, count); ++t) {
        const auto& [corners, source] = view_.triangles[t];
        const auto& [i, j, k] = corners;
        if (cross(view_.grid[i], view_.grid[j], view_.grid[k]) == 0) continue;
        const double nearest = nearest_of(view_, corners);
        bool useful = false;
        each_cell(corners, nearest, [&](int) {
          useful = true;
          return false;
        });
        const auto& v = view_.vertices;
        if (useful) found[part].push_back({corners, source, nearest, steepness_of(v[i], v[j], v[k])});
      }
  });
  for (const auto& part : found) occluders_.insert(occluders_.end(), part.begin(), part.end());
  std::stable_sort(occluders_.begin(), occluders_.end(),
                   [](const Occluder& a, const Occluder& b) { return a.nearest > b.nearest; });
}

void OccluderGrid::fill() {
  first_.assign(static_cast<std::size_t>(grid_.count()) + 1, 0);
  const auto each = [&](const Occluder& o, auto visit) {
    each_cell(o.vertex, o.nearest, [&](int cell) {
      visit(cell);
      return true;
    });
  };
  for (const Occluder& o : occluders_) each(o, [&](int cell) { ++first_[cell + 1]; });
  for (std::size_t c = 1; c < first_.size(); ++c) first_[c] += first_[c - 1];
  members_.resize(first_.back());
  std::vector<std::size_t> next(first_.begin(), first_.end() - 1);
  for (std::size_t o = 0; o < occluders_.size(); ++o)
    each(occluders_[o], [&](int cell) { members_[next[cell]++] = static_cast<int>(o); });
}

}  // namespace epura
