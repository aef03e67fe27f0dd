// SPDX-License-Identifier: Apache-2.0
#include "sheet/gravity_symbol.hpp"

#include <numbers>

#include "sheet/dimensions/marks.hpp"

namespace epura::sheet {

void add_gravity_symbol(Layer& layer, const Vec2& centre, double radius) {
  constexpr int parts = 16;
  constexpr double quarter = std::numbers::pi / 2;
  layer.strokes.push_back(circle_at(centre, radius));
  for (const double begin : {quarter, -quarter}) {
    Fill& fill = layer.fills.emplace_back();
    std::vector<Vec2>& ring = fill.rings.emplace_back();
    ring.push_back(centre);
    for (int i = 0; i <= parts; ++i) ring.push_back(centre + radius * turned_to(begin + quarter * i / parts));
  }
}

}  // namespace epura::sheet
