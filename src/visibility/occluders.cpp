#include "visibility/occluders.hpp"

#include <algorithm>
#include <cmath>

namespace epura {

namespace {

// Triangles lower than this part of their length on the page are lines there.
constexpr double thinnest = 0x1p-40;

// 1 + length of the gradient of depth over the page. A line has no gradient: what it covers is decided by depth alone.
double steepness_of(const PageVertex& a, const PageVertex& b, const PageVertex& c) {
  const double bx = b.x - a.x, by = b.y - a.y, bz = b.depth - a.depth;
  const double cx = c.x - a.x, cy = c.y - a.y, cz = c.depth - a.depth;
  const double area = bx * cy - by * cx;
  if (std::abs(area) <= thinnest * std::max(bx * bx + by * by, cx * cx + cy * cy)) return 1;
  return 1 + std::hypot((bz * cy - by * cz) / area, (bx * cz - bz * cx) / area);
}

}  // namespace

OccluderGrid::OccluderGrid(const View& view) : grid_{} {
  Window all{Vec2(HUGE_VAL), Vec2(-HUGE_VAL)};
  for (const ViewTriangle& triangle : view.triangles) {
    const auto& [i, j, k] = triangle.vertex;
    if (cross(view.grid[i], view.grid[j], view.grid[k]) == 0) continue;
    const PageVertex& a = view.vertices[i];
    const PageVertex& b = view.vertices[j];
    const PageVertex& c = view.vertices[k];
    occluders_.push_back(
        {triangle.vertex, triangle.source, std::max({a.depth, b.depth, c.depth}), steepness_of(a, b, c)});
    const Vec2 margin(2 * view.cell);
    const Window box{glm::min(glm::min(Vec2(a.x, a.y), Vec2(b.x, b.y)), Vec2(c.x, c.y)) - margin,
                     glm::max(glm::max(Vec2(a.x, a.y), Vec2(b.x, b.y)), Vec2(c.x, c.y)) + margin};
    boxes_.push_back(box);
    all = {glm::min(all.least, box.least), glm::max(all.most, box.most)};
  }
  if (occluders_.empty()) all = {Vec2(0), Vec2(1)};
  grid_ = make_cell_grid(all.least, all.most, static_cast<double>(occluders_.size()) / 2);
  fill();
}

void OccluderGrid::fill() {
  const auto each_cell = [&](const Window& box, auto visit) {
    const int right = grid_.column(box.most.x);
    const int top = grid_.row(box.most.y);
    for (int row = grid_.row(box.least.y); row <= top; ++row)
      for (int column = grid_.column(box.least.x); column <= right; ++column) visit(grid_.cell(column, row));
  };
  // Large triangles over small cells would fill memory: cells grow until each triangle is in a few on average.
  const auto references = [&] {
    double sum = 0;
    for (const Window& box : boxes_)
      sum += (grid_.column(box.most.x) - grid_.column(box.least.x) + 1.0) *
             (grid_.row(box.most.y) - grid_.row(box.least.y) + 1.0);
    return sum;
  };
  while (references() > 8.0 * static_cast<double>(boxes_.size()) + 65536 && grid_.columns * grid_.rows > 1) {
    grid_.side *= 2;
    grid_.columns = grid_.columns / 2 + 1;
    grid_.rows = grid_.rows / 2 + 1;
    if (grid_.columns <= 2 && grid_.rows <= 2) break;
  }
  first_.assign(static_cast<std::size_t>(grid_.columns) * grid_.rows + 1, 0);
  for (const Window& box : boxes_) each_cell(box, [&](int cell) { ++first_[cell + 1]; });
  for (std::size_t c = 1; c < first_.size(); ++c) first_[c] += first_[c - 1];
  members_.resize(first_.back());
  std::vector<int> next(first_.begin(), first_.end() - 1);
  for (std::size_t o = 0; o < boxes_.size(); ++o)
    each_cell(boxes_[o], [&](int cell) { members_[next[cell]++] = static_cast<int>(o); });
}

void OccluderGrid::near(const View& view, const Sightline& edge, std::vector<int>& numbers) const {
  numbers.clear();
  const PageVertex& p = view.vertices[edge.p];
  const PageVertex& q = view.vertices[edge.q];
  visit_cells(grid_, {p.x, p.y}, {q.x, q.y}, 2 * view.cell, [&](int cell) {
    for (int i = first_[cell]; i < first_[cell + 1]; ++i)
      if (occluders_[members_[i]].nearest > edge.farthest) numbers.push_back(members_[i]);
  });
  std::sort(numbers.begin(), numbers.end());
  numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
}

}  // namespace epura
