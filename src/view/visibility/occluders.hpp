// SPDX-License-Identifier: Apache-2.0
// The triangles that may hide something, by position on the page, nearest first.
#pragma once

#include <bit>
#include <cstdint>
#include <span>
#include <vector>

#include "base/groups.hpp"
#include "edges/find_edges.hpp"
#include "search/choose_grid.hpp"
#include "search/line_cells.hpp"
#include "view/projected_scene.hpp"
#include "visibility/candidate_tree.hpp"
#include "visibility/hiding_rule.hpp"
#include "visibility/third_copies.hpp"

namespace epura::visibility {

/// A triangle of the view that may hide something in a cell. Candidates are ordered by distance.
class Candidate {
 public:
  Candidate() = default;
  /// `distance` behind the nearest place of the scene must not be negative; it is rounded down to 32 bits.
  Candidate(double distance, int triangle)
      : key_(std::uint64_t{std::bit_cast<std::uint32_t>(rounded_down(distance))} << 32 |
             static_cast<std::uint32_t>(triangle)) {}

  [[nodiscard]] float distance() const { return std::bit_cast<float>(static_cast<std::uint32_t>(key_ >> 32)); }
  [[nodiscard]] int triangle() const { return static_cast<int>(key_ & 0xffffffff); }
  bool operator<(const Candidate& other) const { return key_ < other.key_; }

 private:
  // The bits of non-negative floats are ordered like the floats, so one comparison of integers sorts candidates.
  std::uint64_t key_ = 0;
};

/// The part of an edge in one cell of the page, and what may hide it there.
struct CellSegment {
  double from, to;                        ///< page parameters
  double cover;                           ///< everything in the cell with less depth is hidden
  std::span<const Candidate> candidates;  ///< nearest first
  const CandidateTree* tree;              ///< the same triangles as a tree, where they are many; null otherwise
};

/// Which triangles hide what lies behind them in cells that they cover, without a test.
enum class Covers { any, none };

/// A uniform grid of cells over the drawn edges. A cell has no candidates if no edge runs through it, and none that lie
/// behind all its edges or behind a triangle that covers it entirely. Cells with too many edges and candidates get a
/// tree or are divided further.
class OccluderGrid {
 public:
  /// Throws OutOfTime.
  OccluderGrid(const world::World& world, const view::ProjectedScene& view,
               const std::vector<edges::FeatureEdge>& edges, Covers covers = Covers::any,
               const Progress& progress = {});

  /// Calls `visit(CellSegment)` for the cells along an edge; together, the segments cover the whole edge.
  template <class Visit>
  void along(const PageEdge& edge, Visit visit) const {
    along(top_, edge, 0, 1, visit);
  }

  /// Triangles that are not candidates anywhere, but may hide an edge that begins or ends at this vertex.
  [[nodiscard]] std::span<const int> copies_around(int vertex) const { return copies_.around(vertex); }

  /// Least and greatest depth of an edge between two page parameters.
  [[nodiscard]] std::array<double, 2> depths(const PageEdge& edge, double from, double to) const {
    const double p = view_.vertices[edge.p].depth;
    const double along = view_.vertices[edge.q].depth - p;
    const auto [min, max] = std::minmax({p + from * along, p + to * along});
    return {min, max};
  }

  /// Where an edge is at a page parameter: x, y and depth.
  [[nodiscard]] Vec3 point(const PageEdge& edge, double t) const { return {position(edge, t), depths(edge, t, t)[0]}; }

  /// Candidates at greater distances lie behind this depth.
  [[nodiscard]] double distance(double depth) const { return front_ - depth; }

 private:
  struct Level {
    search::CellGrid grid;
    std::vector<double> cover;     ///< by cell
    Groups<Candidate> candidates;  ///< by cell
    double pairs = 0;              ///< number of pairs of edge and triangle to be tested
    std::vector<int> full;         ///< by cell: its index in `children` and `trees`, or -1; empty if no cell is full
    std::vector<Level> children;   ///< without cells where there is a tree instead
    std::vector<CandidateTree> trees;
  };
  /// Part of a drawn edge.
  struct Piece {
    int edge;
    double from, to;
  };
  /// Everything that may meet in the part of the page that a level covers.
  struct Content {
    std::vector<Piece> pieces;
    std::vector<int> triangles;  ///< of the view
    double pairs;                ///< number of pairs of edge and triangle to be tested without further division
    int idle;                    ///< number of divisions in succession that left nearly as many pairs
    double spare;                ///< pieces and triangles that they may yet hand on to their parts

    [[nodiscard]] double size() const { return static_cast<double>(pieces.size() + triangles.size()); }
  };
  struct CellLoad {
    std::vector<double> deepest;  ///< by cell: least depth of the pieces that the cover does not hide
    std::vector<int> pieces;      ///< by cell: number of pieces
  };

  template <class Visit>
  void along(const Level& level, const PageEdge& edge, double from, double to, Visit& visit) const {
    search::visit_cells(
        level.grid, position(edge, from), position(edge, to), margin(), [&](int cell, double s, double t) {
          const double begin = from + s * (to - from);
          const double end = from + t * (to - from);
          const int full = level.full.empty() ? -1 : level.full[cell];
          const bool divided = full >= 0 && level.trees[full].empty();
          if (divided && !(depths(edge, begin, end)[1] < level.cover[cell]))
            along(level.children[full], edge, begin, end, visit);
          else
            visit(CellSegment{begin, end, level.cover[cell], level.candidates[static_cast<std::size_t>(cell)],
                              full < 0 || divided ? nullptr : &level.trees[full]});
        });
  }

  // Rounding moves vertices by less than a cell of the page grid.
  [[nodiscard]] double margin() const { return 2 * view_.cell; }
  [[nodiscard]] Vec2 cover_slack(const search::CellGrid& grid) const;
  [[nodiscard]] Vec2 position(const PageEdge& edge, double t) const;
  [[nodiscard]] std::array<Vec2, 3> corners(const view::ViewTriangle& triangle) const;
  [[nodiscard]] double nearest(const view::ViewTriangle& triangle) const;
  [[nodiscard]] PageEdge sightline(const Piece& piece) const;

  [[nodiscard]] Content whole_page() const;
  [[nodiscard]] search::PageBox box_of(const std::vector<Piece>& pieces) const;
  [[nodiscard]] Level make_level(const Content& content, int depth) const;
  [[nodiscard]] search::CellGrid grid_for(const Content& content, int depth) const;
  [[nodiscard]] static double pairs_in(const Level& level, const CellLoad& load, int cell);
  void find_covers(const Content& content, Level& level) const;
  [[nodiscard]] CellLoad find_load(const Content& content, const Level& level) const;
  void find_candidates(const Content& content, const CellLoad& load, Level& level) const;
  bool cover_by_sheets(const CellLoad& load, Level& level) const;
  void drop_covered(Level& level) const;
  [[nodiscard]] std::vector<Content> contents_of_full_cells(const Content& content, const CellLoad& load, int idle,
                                                            Level& level) const;
  static double share_out(const Content& content, int idle, std::vector<Content>& parts);
  [[nodiscard]] bool leaves_few_tries(const CandidateTree& tree, const std::vector<Piece>& pieces) const;
  void relieve_full_cells(const Content& content, const CellLoad& load, int idle, int depth, Level& level) const;

  const view::ProjectedScene& view_;
  const std::vector<edges::FeatureEdge>& edges_;
  Covers covers_;
  Progress progress_;
  double front_;  ///< greatest depth of the scene
  ThirdCopies copies_;
  Level top_;
};

}  // namespace epura::visibility
