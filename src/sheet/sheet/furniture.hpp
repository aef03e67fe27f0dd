// SPDX-License-Identifier: Apache-2.0
// Everything on a sheet except its views, grouped by line width.
#pragma once

#include <iterator>
#include <utility>
#include <vector>

#include "sheet/rectangle.hpp"
#include "sheet/sheet.hpp"

namespace epura::sheet {

/// Line widths, mm. ISO 5457: frame 0.7, grid 0.35.
inline constexpr double wide_line = 0.7, medium_line = 0.35, narrow_line = 0.18;
/// Height of the letters of sections, details and arrows, in narrow lines of the view: 5 mm for 0.25 mm.
inline constexpr double letter_widths = 20;

struct Furniture {
  std::vector<Stroke> wide{}, medium{}, narrow{};
  std::vector<Stroke> block{};  ///< of the title block: medium, too
  std::vector<Fill> fills{};
  std::vector<Text> texts{};
};

inline Stroke line(const Vec2& from, const Vec2& to) { return {{from, to}}; }

inline Stroke outline(const Rectangle& r) { return {{r.min, {r.max.x, r.min.y}, r.max, {r.min.x, r.max.y}}, true}; }

template <class Thing>
void append(std::vector<Thing>& all, std::vector<Thing> more) {
  std::move(more.begin(), more.end(), std::back_inserter(all));
}

}  // namespace epura::sheet
