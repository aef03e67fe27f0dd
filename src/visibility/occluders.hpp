// The triangles that may hide something, found by place on the page, the nearest first.
#pragma once

#include <vector>

#include "edges/drawn_edges.hpp"
#include "view/view.hpp"
#include "visibility/hiding_rule.hpp"
#include "visibility/line_cells.hpp"

namespace epura {

/// Occluders by cell of the page. A cell through which no edge runs has none, nor has a cell those that lie behind all
/// edges in it. Triangles without area on the page hide nothing.
class OccluderGrid {
 public:
  OccluderGrid(const View& view, const std::vector<DrawnEdge>& edges);

  /// Calls `visit(cell, from, to)` for the cells along an edge, with page parameters of the part in the cell.
  template <class Visit>
  void along(const Sightline& edge, Visit visit) const {
    const PageVertex& p = view_.vertices[edge.p];
    const PageVertex& q = view_.vertices[edge.q];
    visit_cells(grid_, {p.x, p.y}, {q.x, q.y}, margin(), visit);
  }

  /// Calls `visit(occluder)` for those of a cell, in order of falling `nearest`, until it returns false.
  template <class Visit>
  void in_cell(int cell, Visit visit) const {
    for (std::size_t i = first_[cell]; i < first_[cell + 1]; ++i)
      if (!visit(occluders_[members_[i]])) return;
  }

 private:
  // Vertices lie within a cell of the page grid of their place.
  [[nodiscard]] double margin() const { return 2 * view_.cell; }
  void choose_cells(const std::vector<DrawnEdge>& edges);
  void find_depths(const std::vector<DrawnEdge>& edges);
  /// Occluders and, one after the other, the cells of each: `ends` says where those of an occluder end.
  struct Found {
    std::vector<Occluder> occluders;
    std::vector<std::size_t> ends;
    std::vector<int> cells;
  };
  [[nodiscard]] Found collect() const;
  void collect(const ViewTriangle& triangle, Found& found) const;
  void add_cells(const std::array<int, 3>& corners, double nearest, std::vector<int>& cells) const;
  void fill(const Found& found);

  const View& view_;
  CellGrid grid_;
  std::vector<double> deepest_;      ///< by cell: least depth of the edges in it
  std::vector<Occluder> occluders_;  ///< nearest first
  std::vector<std::size_t> first_;   ///< by cell, into members_
  std::vector<int> members_;
};

}  // namespace epura
