// SPDX-License-Identifier: Apache-2.0
#include "visibility/occluders.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <numbers>
#include <utility>

#include "base/error.hpp"
#include "base/parallel.hpp"
#include "search/triangle_cells.hpp"
#include "visibility/limits.hpp"
#include "visibility/occluder_patch.hpp"
#include "visibility/occlusion_query.hpp"

namespace epura::visibility {

namespace {

constexpr std::size_t chunk = 4096;
constexpr search::GridLimits page_limits{0x1p24, 0, 8, 128};
constexpr search::GridLimits cell_limits{1024, 0, 8, 32};
constexpr int deepest_level = 8;
// Number of triangles that are examined to choose a grid.
constexpr std::size_t sample = 65536;

// A tree is good enough if most edges of a sample need at most this number of tests.
constexpr int few_tries = 16;
constexpr int sampled_edges = 24;

void raise(double& value, double other) {
  std::atomic_ref<double> shared(value);
  double old = shared.load(std::memory_order_relaxed);
  while (other > old && !shared.compare_exchange_weak(old, other, std::memory_order_relaxed)) {
  }
}

void lower(double& value, double other) {
  std::atomic_ref<double> shared(value);
  double old = shared.load(std::memory_order_relaxed);
  while (other < old && !shared.compare_exchange_weak(old, other, std::memory_order_relaxed)) {
  }
}

template <class Number>
Number count_up(Number& value) {
  return std::atomic_ref<Number>(value).fetch_add(1, std::memory_order_relaxed);
}

double greatest_depth(const view::ProjectedScene& view) {
  double greatest = -HUGE_VAL;
  for (const view::PageVertex& vertex : view.vertices) greatest = std::max(greatest, vertex.depth);
  return greatest;
}

}  // namespace

OccluderGrid::OccluderGrid(const world::World& world, const view::ProjectedScene& view,
                           const std::vector<edges::FeatureEdge>& edges, Covers covers, const Progress& progress)
    : view_(view),
      edges_(edges),
      covers_(covers),
      progress_(progress),
      front_(greatest_depth(view)),
      copies_(world, view, progress),
      top_(make_level(whole_page(), 0)) {}

Vec2 OccluderGrid::cover_slack(const search::CellGrid& grid) const { return 2 * margin() + cell_slack * grid.side; }

Vec2 OccluderGrid::position(const PageEdge& edge, double t) const {
  const view::PageVertex& p = view_.vertices[edge.p];
  const view::PageVertex& q = view_.vertices[edge.q];
  if (t >= 1) return {q.x, q.y};
  return {p.x + t * (q.x - p.x), p.y + t * (q.y - p.y)};
}

std::array<Vec2, 3> OccluderGrid::corners(const view::ViewTriangle& triangle) const {
  std::array<Vec2, 3> places;
  for (std::size_t i = 0; i < 3; ++i) {
    const view::PageVertex& v = view_.vertices[triangle.vertex[i]];
    places[i] = {v.x, v.y};
  }
  return places;
}

double OccluderGrid::nearest(const view::ViewTriangle& triangle) const {
  const auto& [a, b, c] = triangle.vertex;
  return std::max({view_.vertices[a].depth, view_.vertices[b].depth, view_.vertices[c].depth});
}

PageEdge OccluderGrid::sightline(const Piece& piece) const {
  const edges::FeatureEdge& edge = edges_[piece.edge];
  return {edge.vertex[0], edge.vertex[1]};
}

OccluderGrid::Content OccluderGrid::whole_page() const {
  Content content{{}, copies_.others(), HUGE_VAL, 0, 0};
  for (const int e : copies_.other_edges(view_, edges_, progress_)) content.pieces.push_back({e, 0, 1});
  return content;
}

search::PageBox OccluderGrid::box_of(const std::vector<Piece>& pieces) const {
  search::PageBox box{Vec2(HUGE_VAL), Vec2(-HUGE_VAL)};
  for (const Piece& piece : pieces)
    for (const double t : {piece.from, piece.to}) {
      const Vec2 at = position(sightline(piece), t);
      box = {glm::min(box.min, at), glm::max(box.max, at)};
    }
  if (pieces.empty()) return {Vec2(0), Vec2(0)};
  check(box.min.x <= box.max.x && box.min.y <= box.max.y, "a box contains its edges");
  return box;
}

OccluderGrid::Level OccluderGrid::make_level(const Content& content, int depth) const {
  Level level;
  progress_.expect_time();
  level.grid = grid_for(content, depth);
  find_covers(content, level);
  CellLoad load = find_load(content, level);
  find_candidates(content, load, level);
  if (cover_by_sheets(load, level)) load = find_load(content, level);
  check(level.candidates.size() == load.pieces.size() && level.cover.size() == load.pieces.size(),
        "every cell has a cover and candidates");
  for (int cell = 0; cell < level.grid.count(); ++cell) level.pairs += pairs_in(level, load, cell);
  const int idle = level.pairs > worthwhile * content.pairs ? content.idle + 1 : 0;
  relieve_full_cells(content, load, idle, depth, level);
  return level;
}

double OccluderGrid::pairs_in(const Level& level, const CellLoad& load, int cell) {
  return static_cast<double>(load.pieces[cell]) *
         static_cast<double>(level.candidates[static_cast<std::size_t>(cell)].size());
}

search::CellGrid OccluderGrid::grid_for(const Content& content, int depth) const {
  const search::PageBox page = box_of(content.pieces);
  const Vec2 size = glm::max(page.max - page.min, Vec2(margin()));
  search::Cuts lines, areas;
  for (const Piece& piece : content.pieces)
    lines.add(glm::abs(position(sightline(piece), piece.to) - position(sightline(piece), piece.from)), size);
  const std::size_t step = 1 + content.triangles.size() / sample;
  for (std::size_t i = 0; i < content.triangles.size(); i += step) {
    const auto [a, b, c] = corners(view_.triangles[content.triangles[i]]);
    const Vec2 min = glm::max(glm::min(glm::min(a, b), c), page.min);
    areas.add(glm::min(glm::max(glm::max(a, b), c), page.max) - min, size);
  }
  search::GridLimits limits = depth == 0 ? page_limits : cell_limits;
  limits.cells = std::min(limits.cells, static_cast<double>(content.triangles.size()) / triangles_of_cell);
  limits.side = 8 * margin();
  check(limits.side > 0, "cells have a size");
  return search::choose_grid(page, lines, areas, limits);
}

void OccluderGrid::find_covers(const Content& content, Level& level) const {
  const search::CellGrid& grid = level.grid;
  level.cover.assign(static_cast<std::size_t>(grid.count()), -HUGE_VAL);
  if (covers_ == Covers::none) return;
  const Vec2 slack = cover_slack(grid);
  parallel_for(content.triangles.size(), chunk, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      progress_.expect_time();  // a large triangle lies over very many cells
      const view::ViewTriangle& triangle = view_.triangles[content.triangles[i]];
      const search::TriangleOnGrid on_grid(grid, corners(triangle), slack);
      if (!on_grid.may_hold_cells()) continue;
      const CoverPlane plane(view_, triangle, grid.side / 2.0 + slack);
      on_grid.visit_rows([&](const search::RowOfCells& row) {
        for (int column = row.inner_from; column <= row.inner_to; ++column) {
          const int cell = grid.cell(column, row.row);
          raise(level.cover[cell], plane.depth(grid.middle(cell)));
        }
      });
    }
  });
}

OccluderGrid::CellLoad OccluderGrid::find_load(const Content& content, const Level& level) const {
  const auto count = static_cast<std::size_t>(level.grid.count());
  CellLoad load{std::vector<double>(count, HUGE_VAL), std::vector<int>(count, 0)};
  parallel_for(content.pieces.size(), chunk, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      progress_.expect_time();
      const Piece& piece = content.pieces[i];
      const PageEdge line = sightline(piece);
      search::visit_cells(level.grid, position(line, piece.from), position(line, piece.to), margin(),
                          [&](int cell, double s, double t) {
                            const double length = piece.to - piece.from;
                            const auto [min, max] = depths(line, piece.from + s * length, piece.from + t * length);
                            check(cell >= 0 && cell < static_cast<int>(count), "a piece lies in cells of its grid");
                            if (max < level.cover[cell]) return;
                            lower(load.deepest[cell], min);
                            count_up(load.pieces[cell]);
                          });
    }
  });
  return load;
}

void OccluderGrid::find_candidates(const Content& content, const CellLoad& load, Level& level) const {
  const search::CellGrid& grid = level.grid;
  const Vec2 slack = margin() + cell_slack * grid.side;
  const auto add_cells = [&](int number, const auto& add) {
    const auto& [a, b, c] = view_.triangles[number].vertex;
    if (view::cross(view_.grid[a], view_.grid[b], view_.grid[c]) == 0) return false;  // without area it hides nothing
    const double closest = nearest(view_.triangles[number]);
    const Candidate candidate(front_ - closest, number);
    bool any = false;
    search::TriangleOnGrid(grid, corners(view_.triangles[number]), slack)
        .visit_rows([&](const search::RowOfCells& row) {
          for (int column = row.from; column <= row.to; ++column) {
            const int cell = grid.cell(column, row.row);
            if (!(closest > load.deepest[cell]) || closest < level.cover[cell]) continue;
            add(static_cast<std::size_t>(cell), candidate);
            any = true;
          }
        });
    return any;
  };
  // In smooth models, most triangles are not candidates anywhere; the second pass skips them.
  std::vector<char> may_hide(content.triangles.size(), 1);
  level.candidates = Groups<Candidate>(static_cast<std::size_t>(grid.count()), [&](const auto& add) {
    parallel_for(content.triangles.size(), chunk, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) {
        progress_.expect_time();
        if (may_hide[i] != 0) may_hide[i] = add_cells(content.triangles[i], add) ? 1 : 0;
      }
    });
  });
  check(level.candidates.size() == load.deepest.size(), "every cell has its candidates");
  parallel_for(level.candidates.size(), chunk, [&](std::size_t begin, std::size_t end) {
    for (std::size_t cell = begin; cell < end; ++cell) {
      progress_.expect_time();
      std::sort(level.candidates[cell].begin(), level.candidates[cell].end());
    }
  });
}

// Cells with many pairs are worth a search for sheets. Returns whether one was found, and drops what lies behind it.
bool OccluderGrid::cover_by_sheets(const CellLoad& load, Level& level) const {
  if (covers_ == Covers::none) return false;
  const search::CellGrid& grid = level.grid;
  std::atomic<bool> any = false;
  parallel_for(static_cast<std::size_t>(grid.count()), grain::heavy, [&](std::size_t begin, std::size_t end) {
    for (std::size_t cell = begin; cell < end; ++cell) {
      const int number = static_cast<int>(cell);
      if (pairs_in(level, load, number) <= max_pairs) continue;
      progress_.expect_time();
      OccluderPatch sheets(view_, {grid.middle(number), grid.side / 2.0 + cover_slack(grid)});
      for (const Candidate& candidate : level.candidates[cell])
        if (sheets.add(view_.triangles[candidate.triangle()])) break;
      if (!(sheets.depth() > level.cover[cell])) continue;
      check(sheets.depth() <= front_, "a cover is no nearer than what is nearest");
      level.cover[cell] = sheets.depth();
      any = true;
    }
  });
  if (any) drop_covered(level);
  return any;
}

void OccluderGrid::drop_covered(Level& level) const {
  level.candidates.shorten([&](std::size_t cell, std::span<const Candidate> candidates) {
    const double reach = distance(level.cover[cell]);
    const auto lies_behind = [&](const Candidate& candidate) { return candidate.distance() > reach; };
    return std::find_if(candidates.begin(), candidates.end(), lies_behind) - candidates.begin();
  });
}

// Returns the contents of cells that have too many pairs, and numbers them in `level.full`.
std::vector<OccluderGrid::Content> OccluderGrid::contents_of_full_cells(const Content& content, const CellLoad& load,
                                                                        int idle, Level& level) const {
  const search::CellGrid& grid = level.grid;
  std::vector<Content> parts;
  for (int cell = 0; cell < grid.count(); ++cell) {
    if (pairs_in(level, load, cell) <= max_pairs) continue;
    level.full.resize(static_cast<std::size_t>(grid.count()), -1);
    level.full[cell] = static_cast<int>(parts.size());
    Content part{{}, {}, pairs_in(level, load, cell), idle, 0};
    for (const Candidate& candidate : level.candidates[static_cast<std::size_t>(cell)])
      part.triangles.push_back(candidate.triangle());
    parts.push_back(std::move(part));
  }
  if (parts.empty()) return parts;
  check(level.full.size() == static_cast<std::size_t>(grid.count()), "every cell is full or not");
  for (const Piece& piece : content.pieces) {
    progress_.expect_time();
    const PageEdge line = sightline(piece);
    search::visit_cells(grid, position(line, piece.from), position(line, piece.to), margin(),
                        [&](int cell, double s, double t) {
                          const double from = piece.from + s * (piece.to - piece.from);
                          const double to = piece.from + t * (piece.to - piece.from);
                          if (level.full[cell] >= 0 && !(depths(line, from, to)[1] < level.cover[cell]))
                            parts[level.full[cell]].pieces.push_back({piece.edge, from, to});
                        });
  }
  return parts;
}

// Whether most of a sample of edges need few tests. Only parts of the edges are tested, and against their own
// triangles, too: this is an estimate.
bool OccluderGrid::leaves_few_tries(const CandidateTree& tree, const std::vector<Piece>& pieces) const {
  int good = 0;
  for (int k = 0; k < sampled_edges; ++k) {
    const double part = std::fmod(k * std::numbers::phi, 1);  // out of step with the order of the edges
    const Piece& piece = pieces[static_cast<std::size_t>(part * static_cast<double>(pieces.size()))];
    OcclusionQuery hider(view_, *this, sightline(piece), OwnTriangles(), few_tries + 1);
    hider.hide({piece.from, piece.to, -HUGE_VAL, {}, &tree});
    good += hider.tries() <= few_tries ? 1 : 0;
  }
  return 2 * good > sampled_edges;
}

// Returns what is left for idle divisions, and shares it out among the parts.
double OccluderGrid::share_out(const Content& content, int idle, std::vector<Content>& parts) {
  double handed_on = 0;
  for (const Content& part : parts) handed_on += part.size();
  const double left = idle > 0 ? content.spare - handed_on : deepest_level * handed_on;
  for (Content& part : parts) part.spare = left * (part.size() / handed_on);
  return left;
}

// Full cells get a tree if that leaves few tests; otherwise they are divided if that saves work.
void OccluderGrid::relieve_full_cells(const Content& content, const CellLoad& load, int idle, int depth,
                                      Level& level) const {
  // One idle division is tolerated (the arms of an L are separated only by the second). Where very many pairs are left,
  // any number is, until the cells are as small as the L is wide, unless every part has nearly all edges and triangles
  // again, as where very many coincide.
  std::vector<Content> parts = contents_of_full_cells(content, load, idle, level);
  const double left = share_out(content, idle, parts);
  const bool may_divide = depth < deepest_level && (idle <= 1 || (content.pairs >= many_pairs && left > 0));
  std::vector<double> saved(parts.size(), 0);
  level.children.resize(parts.size());
  level.trees.resize(parts.size());
  parallel_for(parts.size(), 1, progress_, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const Content part = std::exchange(parts[i], {});
      level.trees[i] = CandidateTree(view_, part.triangles);
      if (leaves_few_tries(level.trees[i], part.pieces)) {
        saved[i] = std::max(0.0, part.pairs - few_tries * static_cast<double>(part.pieces.size()));
        continue;
      }
      if (!may_divide) continue;
      Level child = make_level(part, depth + 1);
      if (!(child.pairs < part.pairs)) continue;
      saved[i] = part.pairs - child.pairs;
      level.children[i] = std::move(child);
      level.trees[i] = {};
    }
  });
  for (const double pairs : saved) {
    check(pairs >= 0, "a full cell that is relieved has no more to test than before");
    level.pairs -= pairs;
  }
}

}  // namespace epura::visibility
