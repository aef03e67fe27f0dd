// SPDX-License-Identifier: Apache-2.0
#include "composition/seen_items.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string>

#include "composition/page_triangle.hpp"
#include "drawing/closed_line.hpp"
#include "drawing/drawing.hpp"

namespace epura::pipeline {

namespace {

constexpr double finest = 0.4;      // mm between the points of the grid
constexpr double max_points = 500;  // along one side

/// Points of the page at equal distances.
struct Grid {
  Vec2 corner;
  double pitch;
  int columns, rows;

  [[nodiscard]] Vec2 at(int x, int y) const { return corner + pitch * Vec2(x + 0.5, y + 0.5); }
  [[nodiscard]] std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(columns) + static_cast<std::size_t>(x);
  }
  [[nodiscard]] int column_of(double x) const { return static_cast<int>(std::ceil((x - corner.x) / pitch - 0.5)); }
  [[nodiscard]] int row_of(double y) const { return static_cast<int>(std::ceil((y - corner.y) / pitch - 0.5)); }
};

Grid grid_on(const Vec2& min, const Vec2& max) {
  const Vec2 size = max - min;
  const double pitch = std::max(finest, std::max(size.x, size.y) / max_points);
  return {min, pitch, static_cast<int>(size.x / pitch) + 1, static_cast<int>(size.y / pitch) + 1};
}

using Corners = std::array<Vec3, 3>;

/// What is nearest to the viewer at the points of a grid.
class NearestItems {
 public:
  explicit NearestItems(const Grid& grid)
      : grid_(grid), item_(grid.index(0, grid.rows), -1), depth_(item_.size(), -HUGE_VAL) {}

  void add(const Corners& page, int item) {
    const auto [left, right] = std::minmax({page[0].x, page[1].x, page[2].x});
    const auto [low, high] = std::minmax({page[0].y, page[1].y, page[2].y});
    const PageTriangle seen(page);
    if (seen.is_edge_on()) return;
    const int last_row = std::min(grid_.row_of(high), grid_.rows - 1);
    const int last_column = std::min(grid_.column_of(right), grid_.columns - 1);
    for (int y = std::max(grid_.row_of(low), 0); y <= last_row; ++y)
      for (int x = std::max(grid_.column_of(left), 0); x <= last_column; ++x) {
        const auto depth = seen.depth_at(grid_.at(x, y));
        const std::size_t i = grid_.index(x, y);
        if (!depth || *depth <= depth_[i]) continue;
        depth_[i] = *depth;
        item_[i] = item;
      }
  }

  [[nodiscard]] int at(int x, int y) const { return item_[grid_.index(x, y)]; }

 private:
  const Grid& grid_;
  std::vector<int> item_;
  std::vector<double> depth_;
};

/// Distances on a grid, by two passes over it: too large by 8 % at most.
class Distances {
 public:
  explicit Distances(const Grid& grid) : grid_(grid), mm_(grid.index(0, grid.rows), HUGE_VAL) {}

  void set_zero(int x, int y) {
    if (x >= 0 && y >= 0 && x < grid_.columns && y < grid_.rows) mm_[grid_.index(x, y)] = 0;
  }

  void spread() {
    for (int y = 0; y < grid_.rows; ++y)
      for (int x = 0; x < grid_.columns; ++x) take_from(x, y, -1);
    for (int y = grid_.rows - 1; y >= 0; --y)
      for (int x = grid_.columns - 1; x >= 0; --x) take_from(x, y, 1);
  }

  [[nodiscard]] double at(int x, int y) const { return mm_[grid_.index(x, y)]; }

 private:
  void take_from(int x, int y, int way) {
    double& here = mm_[grid_.index(x, y)];
    const auto take = [&](int dx, int dy, double length) {
      const int i = x + dx, j = y + dy;
      const bool is_outside = i < 0 || j < 0 || i >= grid_.columns || j >= grid_.rows;
      const double there = is_outside ? 0 : mm_[grid_.index(i, j)];
      here = std::min(here, there + length * grid_.pitch);
    };
    take(way, 0, 1);
    take(0, way, 1);
    take(way, way, std::sqrt(2.0));
    take(-way, way, std::sqrt(2.0));
  }

  const Grid& grid_;
  std::vector<double> mm_;
};

/// The item of each body of the models; -1 for others.
class ItemOfBody {
 public:
  ItemOfBody(const world::World& world, const std::vector<world::Item>& items) : world_(world) {
    for (const world::Placed& model : world.models)
      items_.emplace_back(static_cast<std::size_t>(std::max(model.mesh->report.bodies, 1)), -1);
    for (std::size_t i = 0; i < items.size(); ++i)
      for (const auto& [model, body] : items[i].bodies) set(model, body, static_cast<int>(i));
  }

  [[nodiscard]] int of_triangle(int model, int triangle) const {
    const auto body = static_cast<std::size_t>(world_.models[model].mesh->body[triangle]);
    const std::vector<int>& items = items_[static_cast<std::size_t>(world_.number_in_scene(model))];
    return body < items.size() ? items[body] : -1;
  }

  // Of the body to which a line belongs.
  [[nodiscard]] int of_line(const drawing::Segment& segment) const {
    if (segment.edge[0] < 0) return -1;
    const mesh::Mesh& mesh = *world_.models[segment.model].mesh;
    const mesh::MeshEdge* edge = mesh.edge_between(segment.edge);
    return edge == nullptr || edge->count == 0 ? -1 : of_triangle(segment.model, mesh.triangles_of(*edge).front());
  }

 private:
  // One named group may have several parts, which are numbered as bodies.
  void set(int model, int body, int item) {
    const mesh::MeshReport& report = world_.models[model].mesh->report;
    std::vector<int>& own = items_[model];
    if (report.body_names.empty() && !report.only_body.empty())
      std::fill(own.begin(), own.end(), item);
    else
      own[static_cast<std::size_t>(body)] = item;
  }

  const world::World& world_;
  std::vector<std::vector<int>> items_;
};

// Corners of triangles on the page with their depths, as if nothing were left out.
std::optional<Corners> on_page(const world::World& world, const Mat4& to_page, int triangle) {
  Corners corners;
  for (int i = 0; i < 3; ++i) {
    const Vec4 p = to_page * Vec4(world.points[world.triangles[triangle][i]], 1);
    if (!(p.w > 0)) return std::nullopt;
    corners[i] = Vec3(p) / p.w;
  }
  return corners;
}

void fill(NearestItems& nearest, const world::World& world, const drawing::ViewDrawing& drawing,
          const ItemOfBody& items) {
  for (std::size_t m = 0; m < world.models.size(); ++m)
    for (int t = world.first_triangle[m]; t < world.first_triangle[m + 1]; ++t)
      if (const auto page = on_page(world, drawing.world_to_page, t))
        nearest.add(*page, items.of_triangle(static_cast<int>(m), t - world.first_triangle[m]));
}

void mark_lines(Distances& distances, const Grid& grid, const drawing::ViewDrawing& drawing) {
  for (const drawing::Segment& segment : drawing.segments) {
    const Vec2 from = drawing.shown.breaks.restored(segment.from), to = drawing.shown.breaks.restored(segment.to);
    const int steps = static_cast<int>(glm::length(to - from) / grid.pitch) + 1;
    for (int i = 0; i <= steps; ++i) {
      const Vec2 p = from + (to - from) * (static_cast<double>(i) / steps) - grid.corner;
      if (std::isfinite(p.x) && std::isfinite(p.y))
        distances.set_zero(static_cast<int>(p.x / grid.pitch), static_cast<int>(p.y / grid.pitch));
    }
  }
}

void mark_borders(Distances& distances, const Grid& grid, const NearestItems& nearest) {
  for (int y = 0; y + 1 < grid.rows; ++y)
    for (int x = 0; x + 1 < grid.columns; ++x)
      if (nearest.at(x, y) != nearest.at(x + 1, y) || nearest.at(x, y) != nearest.at(x, y + 1))
        distances.set_zero(x, y);
}

void find_on_lines(std::vector<std::optional<SeenPoint>>& seen, const drawing::ViewDrawing& drawing,
                   const ItemOfBody& items) {
  std::vector<double> longest(seen.size(), 0);
  for (const drawing::Segment& segment : drawing.segments) {
    const int item = segment.visible ? items.of_line(segment) : -1;
    const double length = glm::length(segment.to - segment.from);
    if (item < 0 || length <= longest[item] * (1 + 1e-9)) continue;
    if (seen[item] && !seen[item]->on_line) continue;
    longest[item] = length;
    seen[item] = SeenPoint{(segment.from + segment.to) / 2.0, 0, true};
  }
}

// Inside these lines, the faces of the whole models are not seen.
std::vector<drawing::ClosedLine> cut_out(const drawing::ViewDrawing& drawing) {
  std::vector<drawing::ClosedLine> lines;
  for (const drawing::BrokenOut& one : drawing.cuts.broken_out) lines.emplace_back(one.ring);
  return lines;
}

}  // namespace

std::vector<std::optional<SeenPoint>> seen_items(const world::World& world, const drawing::ViewDrawing& drawing,
                                                 const std::vector<world::Item>& items) {
  constexpr double least = 0.7;  // mm between the end of a leader and lines
  const ItemOfBody of_body(world, items);
  const Grid grid =
      grid_on(drawing.shown.breaks.restored(drawing.box.min), drawing.shown.breaks.restored(drawing.box.max));
  NearestItems nearest(grid);
  fill(nearest, world, drawing, of_body);
  Distances distances(grid);
  mark_lines(distances, grid, drawing);
  mark_borders(distances, grid, nearest);
  distances.spread();
  std::vector<std::optional<SeenPoint>> seen(items.size());
  const std::vector<drawing::ClosedLine> cut = cut_out(drawing);
  const auto is_cut = [&](const Vec2& p) {
    return std::any_of(cut.begin(), cut.end(), [&](const drawing::ClosedLine& line) { return line.contains(p); });
  };
  for (int y = grid.rows - 1; y >= 0; --y)
    for (int x = 0; x < grid.columns; ++x) {
      const int item = nearest.at(x, y);
      const double free = distances.at(x, y);
      if (item < 0 || free < least || !drawing.shown.breaks.keeps(grid.at(x, y)) || is_cut(grid.at(x, y))) continue;
      if (!seen[item] || free > seen[item]->free * (1 + 1e-9))
        seen[item] = SeenPoint{drawing.shown.breaks.moved(grid.at(x, y)), free};
    }
  find_on_lines(seen, drawing, of_body);
  return seen;
}

namespace {

// The numbers of items that no view shows are added to `missing`.
std::vector<std::vector<sheet::BalloonTarget>> balloons_by_view(
    const std::vector<std::vector<std::optional<SeenPoint>>>& seen, std::optional<std::size_t> main,
    std::vector<std::size_t>& missing) {
  constexpr double enough = 2.5;  // mm; where an item has more room does not matter
  std::vector<std::vector<sheet::BalloonTarget>> balloons(seen.size());
  std::size_t items = 0;
  for (const auto& view : seen) items = std::max(items, view.size());
  for (std::size_t item = 0; item < items; ++item) {
    std::optional<std::size_t> best;
    for (std::size_t view = 0; view < seen.size(); ++view) {
      if (seen[view].empty() || !seen[view][item]) continue;
      const auto worth = [&](std::size_t v) { return v == main ? HUGE_VAL : std::min(seen[v][item]->free, enough); };
      if (!best || worth(view) > worth(*best)) best = view;
    }
    if (best)
      balloons[*best].push_back({std::to_string(item + 1), seen[*best][item]->at, seen[*best][item]->on_line});
    else
      missing.push_back(item + 1);
  }
  return balloons;
}

}  // namespace

std::vector<world::Item> listed_items(const world::World& world, const scene::SceneDescription& scene,
                                      const std::vector<std::vector<importer::BodyPart>>& parts, int sheet,
                                      const Messages& messages) {
  if (!scene.parts_list || scene.parts_list->sheet.value_or(1) != sheet + 1) return {};
  world::ItemList list = world::find_items(world, scene.models, parts);
  for (const std::string& name : list.surfaces)
    messages.warn("a surface of '" + name +
                  "' is not in the parts list: it is open, beside solids of the same part\n"
                  "  hint: remove it from the file if it is no part of the model");
  return std::move(list.items);
}

std::vector<std::vector<sheet::BalloonTarget>> balloons_of(
    const scene::SceneDescription& scene, const SheetOfViews& views,
    const std::vector<std::vector<std::optional<SeenPoint>>>& seen, const Messages& messages) {
  if (!scene.parts_list || !scene.parts_list->balloons.value_or(true)) return {};
  std::optional<std::size_t> main;
  for (std::size_t i = 0; i < views.descriptions.size(); ++i)
    if (views.descriptions[i].name.value == scene.parts_list->view.value) main = i;
  std::vector<std::size_t> missing;
  auto balloons = balloons_by_view(seen, main, missing);
  for (const std::size_t item : views.items.empty() ? std::vector<std::size_t>() : missing)
    messages.warn("no view shows item " + std::to_string(item) + ", '" + views.items[item - 1].name +
                  "', and it has no balloon\n  hint: add a view that shows it, such as a section");
  return balloons;
}

}  // namespace epura::pipeline
