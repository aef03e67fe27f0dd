// SPDX-License-Identifier: Apache-2.0
#include "sheet/view_table.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/error.hpp"

namespace epura::sheet {

ViewTable::ViewTable(std::vector<ViewCell> cells, double gap) : cells_(std::move(cells)), gap_(gap) {
  int rows = 0;
  for (const ViewCell& cell : cells_) rows = std::max(rows, cell.row + 1);
  for (ViewCell& cell : cells_) {
    cell.row = rows - 1 - cell.row;
    extend(columns_, cell.column, cell, 0);
    extend(rows_, cell.row, cell, 1);
  }
  sum_up(columns_, gap_);
  sum_up(rows_, gap_);
}

void ViewTable::extend(Lines& lines, int band, const ViewCell& cell, int axis) {
  const auto place = static_cast<std::size_t>(band);
  if (place >= lines.bands.size()) lines.bands.resize(place + 1);
  Band& here = lines.bands[place];
  const Band seen = here.used ? here : Band{true, cell.min[axis], cell.max[axis], 0, 0};
  here = {true, std::min(seen.min, cell.min[axis]), std::max(seen.max, cell.max[axis]),
          std::max(seen.before, cell.before[axis]), std::max(seen.after, cell.after[axis])};
}

void ViewTable::sum_up(Lines& lines, double gap) {
  int used = 0;
  for (const Band& band : lines.bands) {
    if (!band.used) continue;
    check(band.max >= band.min, "a row contains its views");
    lines.scaled += band.max - band.min;
    lines.fixed += band.before + band.after + (used++ > 0 ? gap : 0);
  }
}

Vec2 ViewTable::size(double scale) const {
  return {scale * columns_.scaled + columns_.fixed, scale * rows_.scaled + rows_.fixed};
}

double ViewTable::largest_scale(const Vec2& room) const {
  const auto along = [](const Lines& lines, double length) {
    const double left = length - lines.fixed;
    if (left < 0) return 0.0;
    return lines.scaled > 0 ? left / lines.scaled : HUGE_VAL;
  };
  return std::min(along(columns_, room.x), along(rows_, room.y));
}

std::vector<double> ViewTable::anchors(const Lines& lines, double scale) const {
  std::vector<double> anchors;
  double at = 0;
  for (const Band& band : lines.bands) {
    anchors.push_back(at + band.before - scale * band.min);
    if (band.used) at += band.before + scale * (band.max - band.min) + band.after + gap_;
  }
  return anchors;
}

std::vector<ViewSpot> ViewTable::spots(double scale, const Vec2& corner) const {
  const std::vector<double> x = anchors(columns_, scale), y = anchors(rows_, scale);
  std::vector<ViewSpot> spots;
  for (const ViewCell& cell : cells_) {
    const Vec2 anchor = corner + Vec2(x[std::size_t(cell.column)], y[std::size_t(cell.row)]);
    const double own = cell.scale.value_or(scale);
    check(own > 0, "a view has a scale");
    spots.push_back({cell.view,
                     own,
                     anchor - own * cell.anchor,
                     {anchor + scale * cell.min - cell.before, anchor + scale * cell.max + cell.after}});
  }
  return spots;
}

}  // namespace epura::sheet
