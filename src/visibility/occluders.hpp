// The triangles that may hide something, found by place on the page.
#pragma once

#include <vector>

#include "view/view.hpp"
#include "visibility/hiding_rule.hpp"
#include "visibility/line_cells.hpp"

namespace epura {

/// Occluders by cell of the page.
class OccluderGrid {
 public:
  /// Triangles without area on the page hide nothing and are left out.
  explicit OccluderGrid(const View& view);

  [[nodiscard]] const std::vector<Occluder>& occluders() const { return occluders_; }
  /// Numbers of all occluders whose box meets a cell of the edge's, ascending, each once.
  void near(const View& view, const Sightline& edge, std::vector<int>& numbers) const;

 private:
  void fill();

  std::vector<Occluder> occluders_;
  std::vector<Window> boxes_;
  CellGrid grid_;
  std::vector<int> first_;  ///< by cell, into members_
  std::vector<int> members_;
};

}  // namespace epura
