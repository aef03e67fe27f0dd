#include "visibility/line_cells.hpp"

namespace epura {

namespace {

int clamped(double place, int count) {
  if (!(place > 0)) return 0;
  return place >= count - 1 ? count - 1 : static_cast<int>(place);
}

}  // namespace

int CellGrid::column(double x) const { return clamped((x - origin.x) / side.x, columns); }

int CellGrid::row(double y) const { return clamped((y - origin.y) / side.y, rows); }

}  // namespace epura
