// SPDX-License-Identifier: Apache-2.0
#include "annotations/revision_clouds.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <tuple>

#include "base/error.hpp"
#include "base/portable_math.hpp"
#include "sheet/marks.hpp"

namespace epura::sheet {

namespace {

constexpr double room_around = 3;                       // mm, from ink to the cloud
constexpr double cloud_chord = 6;                       // mm; of an arc, about
constexpr double cloud_bulge = std::numbers::pi / 3;    // half the angle of an arc
constexpr double triangle_side = 8, mark_height = 2.5;  // mm; of the triangle, and height of its letters

// Arcs along a side of the cloud, which bulge to the right of the way.
void add_side(Layer& layer, const Vec2& from, const Vec2& to) {
  const double length = glm::distance(from, to);
  const int count = std::max(1, static_cast<int>(std::lround(length / cloud_chord)));
  const Vec2 along = (to - from) / length, out(along.y, -along.x);
  const double half = length / count / 2, radius = half / portable_sin(cloud_bulge);
  const double middle = portable_atan2(out.y, out.x);
  for (int i = 0; i < count; ++i) {
    const Vec2 centre = from + (2 * i + 1) * half * along - radius * portable_cos(cloud_bulge) * out;
    layer.strokes.push_back(arc_at(centre, radius, middle - cloud_bulge, middle + cloud_bulge));
  }
}

double triangle_rise() { return std::sqrt(3.0) / 2 * triangle_side; }

// The left corner of the triangle beside a cloud.
Vec2 triangle_of(const Rectangle& cloud) { return cloud.max + Vec2(cloud_chord / 2, cloud_chord / 2); }

// What the cloud round a box takes, with its triangle. Arcs bulge by less than half their chord.
Rectangle room_of(const Rectangle& box) {
  const Rectangle cloud = box.grown(room_around);
  return {cloud.min - cloud_chord / 2, triangle_of(cloud) + Vec2(triangle_side, triangle_rise())};
}

}  // namespace

std::vector<Rectangle> united_changes(std::vector<Rectangle> boxes) {
  const std::size_t count = boxes.size();
  // Each round unites at least two.
  for (bool any = true; any;) {
    any = false;
    std::vector<Rectangle> united;
    for (const Rectangle& box : boxes) {
      const auto near = std::find_if(united.begin(), united.end(),
                                     [&](const Rectangle& other) { return room_of(other).overlaps(room_of(box)); });
      if (near == united.end()) {
        united.push_back(box);
        continue;
      }
      *near = sheet::united(*near, box);
      any = true;
    }
    boxes = std::move(united);
  }
  std::sort(boxes.begin(), boxes.end(), [](const Rectangle& a, const Rectangle& b) {
    return std::tie(a.min.x, a.min.y, a.max.x, a.max.y) < std::tie(b.min.x, b.min.y, b.max.x, b.max.y);
  });
  check(boxes.size() <= count && boxes.empty() == (count == 0), "boxes only become fewer, not none");
  return boxes;
}

Layer revision_clouds(std::span<const Rectangle> boxes, const std::string& revision, const LineWidths& widths) {
  Layer layer = empty_layer("sheet", scene::SheetLine::cloud, widths);
  for (const Rectangle& box : boxes) {
    const Rectangle cloud = box.grown(room_around);
    const auto& [low, high] = cloud;
    const std::array<Vec2, 4> corners{low, {high.x, low.y}, high, {low.x, high.y}};
    for (std::size_t i = 0; i < corners.size(); ++i) add_side(layer, corners[i], corners[(i + 1) % corners.size()]);
    const Vec2 left = triangle_of(cloud), top = left + Vec2(triangle_side / 2, triangle_rise());
    layer.strokes.push_back({{left, left + Vec2(triangle_side, 0), top}, true});
    layer.texts.push_back(
        {revision, left + Vec2(triangle_side / 2, mark_height / 2), mark_height, 0, Align::middle, "revision"});
  }
  return layer;
}

}  // namespace epura::sheet
