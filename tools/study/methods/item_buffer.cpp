// SPDX-License-Identifier: Apache-2.0
#include "study/methods/item_buffer.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <utility>

#include "base/error.hpp"
#include "base/parallel.hpp"
#include "base/text.hpp"
#include "oracle/span_sets.hpp"
#include "search/triangle_cells.hpp"
#include "study/methods/pixel_walk.hpp"
#include "study/methods/point_rule.hpp"

namespace epura::study {

namespace {

constexpr int tile_side = 256;  // pixels; depth and items of a tile fit into the cache of a core
constexpr double max_tiles = 1 << 22;
constexpr double max_pixels_of_edges = 1e9;
constexpr std::size_t items_at_once = 4096;

/// The nearest triangles at the pixel centres of a tile.
class Tile {
 public:
  Tile(const view::ProjectedScene& view, const Vec2& origin, double density)
      : view_(view),
        origin_(origin),
        density_(density),
        depth_(tile_side * tile_side, -HUGE_VAL),
        item_(depth_.size(), -1) {}

  void rasterise(int triangle) {
    const view::ViewTriangle& t = view_.triangles[triangle];
    const std::optional<Vec2> slope = visibility::slope_of(view_, t);
    if (!slope) return;
    std::array<Vec2, 3> corner;
    for (std::size_t i = 0; i < 3; ++i) corner[i] = (view_.vertices[t.vertex[i]].at() - origin_) * density_;
    const auto [min, max] = std::minmax({corner[0].y, corner[1].y, corner[2].y});
    const int last = std::min(tile_side - 1, whole(std::floor(max - 0.5)));
    for (int row = std::max(0, whole(std::ceil(min - 0.5))); row <= last; ++row) {
      const auto [from, to] = columns(corner, row + 0.5);
      const double first_depth =
          view_.vertices[t.vertex[0]].depth + glm::dot(*slope, Vec2(0.5, row + 0.5) - corner[0]) / density_;
      for (int column = from; column <= to; ++column) {
        const double depth = first_depth + column * slope->x / density_;
        const auto pixel = static_cast<std::size_t>(row * tile_side + column);
        if (!(depth > depth_[pixel])) continue;
        depth_[pixel] = depth;
        item_[pixel] = triangle;
      }
    }
  }

  /// The triangle in a pixel, or -1.
  [[nodiscard]] int item(int column, int row) const {
    return item_[static_cast<std::size_t>(row * tile_side + column)];
  }

 private:
  static int whole(double x) { return static_cast<int>(std::clamp(x, -1.0, double{tile_side})); }

  // The columns with centres inside the triangle at this height.
  static std::array<int, 2> columns(const std::array<Vec2, 3>& corner, double y) {
    double from = HUGE_VAL, to = -HUGE_VAL;
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec2& a = corner[i];
      const Vec2& b = corner[(i + 1) % 3];
      if ((a.y < y) == (b.y < y)) continue;
      const double x = a.x + (b.x - a.x) * ((y - a.y) / (b.y - a.y));
      from = std::min(from, x);
      to = std::max(to, x);
    }
    if (!(from <= to)) return {0, -1};
    return {std::max(0, whole(std::ceil(from - 0.5))), std::min(tile_side - 1, whole(std::floor(to - 0.5)))};
  }

  const view::ProjectedScene& view_;
  Vec2 origin_;
  double density_;
  std::vector<double> depth_;
  std::vector<int> item_;
};

/// Consecutive pixels of an edge in one tile.
struct TilePiece {
  int edge;
  int first, last;  ///< steps of its walk
};

/// Items by tile: those of tile i are things[first[i]] to things[first[i + 1]].
template <class Thing>
struct ByTile {
  std::vector<std::size_t> first;
  std::vector<Thing> things;
};

// Sorts the results of chunks of work by tile, in the order of the chunks.
template <class Thing>
ByTile<Thing> by_tile(const std::vector<std::vector<std::pair<int, Thing>>>& parts, int tiles) {
  ByTile<Thing> sorted;
  sorted.first.assign(static_cast<std::size_t>(tiles) + 1, 0);
  for (const auto& part : parts)
    for (const auto& found : part) ++sorted.first[found.first + 1];
  std::partial_sum(sorted.first.begin(), sorted.first.end(), sorted.first.begin());
  sorted.things.resize(sorted.first.back());
  std::vector<std::size_t> next(sorted.first.begin(), sorted.first.end() - 1);
  for (const auto& part : parts)
    for (const auto& found : part) sorted.things[next[found.first]++] = found.second;
  return sorted;
}

// Calls `find(i, found)` for all items; `found` takes pairs of a tile and an item in it.
template <class Thing, class Find>
ByTile<Thing> sort_into_tiles(std::size_t count, int tiles, const Find& find) {
  std::vector<std::vector<std::pair<int, Thing>>> parts((count + items_at_once - 1) / items_at_once);
  parallel_for(parts.size(), 1, [&](std::size_t first, std::size_t last) {
    for (std::size_t part = first; part < last; ++part)
      for (std::size_t i = part * items_at_once; i < std::min((part + 1) * items_at_once, count); ++i)
        find(i, parts[part]);
  });
  return by_tile(parts, tiles);
}

class ItemBuffer {
 public:
  ItemBuffer(const world::World& world, const view::ProjectedScene& view, const edges::FeatureEdges& drawn,
             double density)
      : world_(world), view_(view), drawn_(drawn), density_(density) {
    Vec2 min(HUGE_VAL), max(-HUGE_VAL);
    for (const edges::FeatureEdge& edge : drawn.edges)
      for (const int v : edge.vertex) {
        min = glm::min(min, view.vertices[v].at());
        max = glm::max(max, view.vertices[v].at());
      }
    if (drawn.edges.empty()) min = max = Vec2(0);
    const Vec2 tiles = glm::floor((max - min) * density / static_cast<double>(tile_side)) + 1.0;
    if (tiles.x * tiles.y > max_tiles) refuse((max - min) * density);
    tiles_ = {min, Vec2(tile_side / density), static_cast<int>(tiles.x), static_cast<int>(tiles.y)};
    walk_edges();
  }

  std::vector<visibility::Spans> hidden_spans() {
    const ByTile<int> triangles = triangles_by_tile();
    const ByTile<TilePiece> pieces = pieces_by_tile();
    parallel_for(static_cast<std::size_t>(tiles_.count()), 1, [&](std::size_t begin, std::size_t end) {
      for (std::size_t tile = begin; tile < end; ++tile) {
        if (pieces.first[tile] == pieces.first[tile + 1]) continue;
        Tile buffer(view_, corner_of(static_cast<int>(tile)), density_);
        for (std::size_t i = triangles.first[tile]; i < triangles.first[tile + 1]; ++i)
          buffer.rasterise(triangles.things[i]);
        for (std::size_t i = pieces.first[tile]; i < pieces.first[tile + 1]; ++i) look(buffer, pieces.things[i]);
      }
    });
    return spans_of_pixels();
  }

 private:
  [[noreturn]] static void refuse(const Vec2& size) {
    throw Error(ErrorKind::input, "--visibility item-buffer",
                "a buffer of " + format_rounded(size.x, 2) + " x " + format_rounded(size.y, 2) + " pixels is too large",
                "give fewer dpi");
  }

  void walk_edges() {
    double pixels = 0;
    for (const edges::FeatureEdge& edge : drawn_.edges) {
      walks_.emplace_back((view_.vertices[edge.vertex[0]].at() - tiles_.origin) * density_,
                          (view_.vertices[edge.vertex[1]].at() - tiles_.origin) * density_);
      first_pixel_.push_back(static_cast<std::size_t>(pixels));
      pixels += walks_.back().steps();
    }
    if (pixels > max_pixels_of_edges) refuse(Vec2(pixels));
    hidden_.assign(static_cast<std::size_t>(pixels), 0);
  }

  [[nodiscard]] Vec2 corner_of(int tile) const { return tiles_.middle(tile) - 0.5 * tiles_.side; }

  [[nodiscard]] ByTile<int> triangles_by_tile() const {
    const Vec2 slack(0x1p-20 / density_);
    return sort_into_tiles<int>(view_.triangles.size(), tiles_.count(), [&](std::size_t t, auto& found) {
      std::array<Vec2, 3> corners;
      for (std::size_t i = 0; i < 3; ++i) corners[i] = view_.vertices[view_.triangles[t].vertex[i]].at();
      search::TriangleOnGrid(tiles_, corners, slack).visit_rows([&](const search::RowOfCells& row) {
        for (int column = row.from; column <= row.to; ++column)
          found.emplace_back(tiles_.cell(column, row.row), static_cast<int>(t));
      });
    });
  }

  [[nodiscard]] int tile_of(const std::array<int, 2>& pixel) const {
    return tiles_.cell(std::clamp(pixel[0] / tile_side, 0, tiles_.columns - 1),
                       std::clamp(pixel[1] / tile_side, 0, tiles_.rows - 1));
  }

  [[nodiscard]] ByTile<TilePiece> pieces_by_tile() const {
    return sort_into_tiles<TilePiece>(walks_.size(), tiles_.count(), [&](std::size_t e, auto& found) {
      int tile = -1;
      for (int step = 0; step < walks_[e].steps(); ++step) {
        const int here = tile_of(walks_[e].pixel(step));
        if (std::exchange(tile, here) == here)
          found.back().second.last = step;
        else
          found.push_back({here, {static_cast<int>(e), step, step}});
      }
    });
  }

  void look(const Tile& buffer, const TilePiece& piece) {
    const PixelWalk& walk = walks_[piece.edge];
    const edges::FeatureEdge& edge = drawn_.edges[piece.edge];
    const PointRule rule(view_, {edge.vertex[0], edge.vertex[1]});
    const visibility::OwnTriangles own(world_, drawn_, edge);
    for (int step = piece.first; step <= piece.last; ++step) {
      const auto [column, row] = walk.pixel(step);
      const int item = buffer.item(column % tile_side, row % tile_side);
      if (item < 0) continue;
      const view::ViewTriangle& triangle = view_.triangles[item];
      hidden_[first_pixel_[piece.edge] + step] =
          static_cast<char>(rule.lies_before(triangle, walk.position(step)) && !own.contain(triangle.source));
    }
  }

  [[nodiscard]] std::vector<visibility::Spans> spans_of_pixels() const {
    std::vector<visibility::Spans> spans(walks_.size());
    parallel_for(walks_.size(), items_at_once, [&](std::size_t begin, std::size_t end) {
      for (std::size_t e = begin; e < end; ++e)
        for (int step = 0; step < walks_[e].steps(); ++step)
          if (hidden_[first_pixel_[e] + step] != 0) visibility::add_span(spans[e], walks_[e].part(step));
    });
    return spans;
  }

  const world::World& world_;
  const view::ProjectedScene& view_;
  const edges::FeatureEdges& drawn_;
  double density_;
  search::CellGrid tiles_{};
  std::vector<PixelWalk> walks_;
  std::vector<std::size_t> first_pixel_;  ///< by edge, of its first step
  std::vector<char> hidden_;              ///< by step of all walks
};

}  // namespace

visibility::HiddenSpans find_hidden_by_item_buffer(const world::World& world, const view::ProjectedScene& view,
                                                   const edges::FeatureEdges& drawn, double density,
                                                   Progress progress) {
  progress.begin("hiding lines");
  return gather(ItemBuffer(world, view, drawn, density).hidden_spans());
}

}  // namespace epura::study
