// SPDX-License-Identifier: Apache-2.0
#include "annotations/target_areas.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "base/error.hpp"
#include "sheet/dash.hpp"
#include "sheet/furniture.hpp"
#include "sheet/marks.hpp"

namespace epura::sheet {

namespace {

constexpr double spacing = 2, cross_arm = 1.5;  // mm: between the lines of a hatching, and half a cross
constexpr double no_size = 1e-6;                // mm; targets that are smaller are points or lines

Vec2 on_page(const drawing::ViewDrawing& view, const Vec3& at) {
  const Vec4 p = view.world_to_page * Vec4(at, 1);
  check(p.w > 0, "targets are shown in parallel views");
  return view.shown.breaks.moved(Vec2(p) / p.w);
}

void add_cross(Layer& layer, const Vec2& at) {
  for (const Vec2& arm : {Vec2(cross_arm, cross_arm), Vec2(cross_arm, -cross_arm)})
    layer.strokes.push_back(line(at - arm, at + arm));
}

Stroke dashed_outline(std::vector<Vec2> corners, double width) {
  Stroke stroke{std::move(corners)};
  stroke.closed = true;
  stroke.dashes = fit_closed(length_of(stroke.points, true), width, scene::long_dash_double_dot);
  return stroke;
}

// Lines at 45 degrees across what `reach` limits: for the distance of a line from the middle, how far it goes back and
// forth from there.
template <class Reach>
void add_hatching(Layer& layer, const Vec2& middle, double radius, const Reach& reach) {
  const double half = std::sqrt(0.5);
  const Vec2 along(half, half), across(-half, half);
  const int count = static_cast<int>(radius / spacing);
  for (int i = -count; i <= count; ++i) {
    const auto [from, to] = reach(i * spacing);
    if (to - from > no_size)
      layer.strokes.push_back(
          line(middle + i * spacing * across + from * along, middle + i * spacing * across + to * along));
  }
}

void add_circle(Layer& layer, const Vec2& middle, double radius, double width) {
  Stroke outline = circle_at(middle, radius);
  outline.dashes = fit_closed(length_of(outline.points, true, outline.curves), width, scene::long_dash_double_dot);
  layer.strokes.push_back(std::move(outline));
  add_hatching(layer, middle, radius, [radius](double aside) {
    const double reach = std::sqrt(std::max(0.0, radius * radius - aside * aside));
    return std::pair(-reach, reach);
  });
}

void add_rectangle(Layer& layer, const Vec2& middle, const Vec2& length, const Vec2& width_of, double width) {
  check(glm::length(length) > no_size && glm::length(width_of) > no_size, "an area has sides");
  layer.strokes.push_back(dashed_outline(
      {middle - length - width_of, middle + length - width_of, middle + length + width_of, middle - length + width_of},
      width));
  const double half = std::sqrt(0.5), longest = glm::length(length) + glm::length(width_of);
  const Vec2 along(half, half), across(-half, half);
  // Within both pairs of sides.
  add_hatching(layer, middle, longest, [&](double aside) {
    double from = -longest, to = longest;
    for (const Vec2& side : {length, width_of}) {
      const double size = glm::dot(side, side), rate = glm::dot(along, side), offset = aside * glm::dot(across, side);
      if (std::abs(rate) <= no_size) {
        if (std::abs(offset) > size) to = from;
        continue;
      }
      const double one = (-size - offset) / rate, other = (size - offset) / rate;
      from = std::max(from, std::min(one, other));
      to = std::min(to, std::max(one, other));
    }
    return std::pair(from, to);
  });
}

}  // namespace

std::optional<Layer> target_areas(const drawing::ViewDrawing& view, std::span<const Callout> callouts,
                                  const CalloutFaults& placed, const LineWidths& widths) {
  Layer layer = empty_layer(view.name, scene::SheetLine::target, widths);
  for (const auto& [number, box] : placed.places) {
    check(number < callouts.size(), "a place is that of a callout");
    if (!callouts[number].area) continue;
    const scene::DatumTarget& target = *callouts[number].area;
    const Vec2 middle = on_page(view, target.middle);
    const Vec2 length = on_page(view, target.middle + target.half_length) - middle;
    const Vec2 width = on_page(view, target.middle + target.half_width) - middle;
    if (glm::length(length) <= no_size) {
      add_cross(layer, middle);
    } else if (target.is_round) {
      add_circle(layer, middle, glm::length(length), widths.narrow);
    } else if (glm::length(width) <= no_size) {
      Stroke stroke{{middle - length, middle + length}};
      stroke.dashes = fit_open(2 * glm::length(length), widths.narrow, scene::long_dash_double_dot);
      layer.strokes.push_back(std::move(stroke));
      for (const Vec2& end : {middle - length, middle + length}) add_cross(layer, end);
    } else {
      add_rectangle(layer, middle, length, width, widths.narrow);
    }
  }
  return layer.strokes.empty() ? std::nullopt : std::optional(std::move(layer));
}

}  // namespace epura::sheet
