// SPDX-License-Identifier: Apache-2.0
// Several bodies in one file: cylinders through each other, a bearing whose parts touch.
#include "parts.hpp"

namespace samples {

namespace {

constexpr int segments = 72;

/// A body of revolution about the axis of a frame, which stands on the frame's plane. The profile lists radius and
/// height, upwards on the outside; `closed` leads it back down inside a bore, otherwise both ends are capped.
Solid turned(const std::string& name, const Frame& frame, const std::vector<Point2>& profile, bool closed) {
  const Point axis = cross(frame.u, frame.v);
  std::vector<Loop> loops;
  for (const auto& [radius, height] : profile) {
    loops.push_back(ring({frame.origin + height * axis, frame.u, frame.v}, radius, segments));
  }
  Solid solid(name);
  solid.rings(loops, closed);
  return solid;
}

}  // namespace

Model cylinders() {
  const Frame upright = seen_from_top({0, 0, -45});
  const Frame slanted = {-70.0 * Point{sin_deg(60), 0, cos_deg(60)}, {cos_deg(60), 0, -sin_deg(60)}, {0, 1, 0}};
  return {turned("upright", upright, {{25, 0}, {25, 90}}, false),
          turned("slanted", slanted, {{17, 0}, {17, 140}}, false)};
}

namespace {

constexpr double axis_height = 55;  // of the shaft above the ground
constexpr double plate_height = 14;

Solid base_plate() {
  Solid plate("base_plate");
  std::vector<Loop> holes;
  for (const double x : {-85.0, 85.0}) {
    for (const double y : {-38.0, 38.0}) {
      holes.push_back(place(circle(5.5, 48, {x, y}), seen_from_top({0, 0, 0})));
    }
  }
  plate.prism(place(rectangle(-100, -50, 100, 50), seen_from_top({0, 0, 0})), {0, 0, plate_height}, holes);
  return plate;
}

/// A pillow block with its bore about the axis of the shaft.
Solid block(const std::string& name, double from, double to) {
  const Frame frame = seen_from_right({from, 0, axis_height});
  Outline outline = {{-28, plate_height - axis_height}, {28, plate_height - axis_height}};
  const Outline top = arc({0, 0}, 28, 0, 180, 36);
  outline.insert(outline.end(), top.begin(), top.end());
  Solid solid(name);
  solid.prism(place(outline, frame), {to - from, 0, 0}, {ring(frame, 12, segments)});
  return solid;
}

/// A hexagon nut with its bore on the thread of the shaft.
Solid nut(const std::string& name, double from, double to) {
  const Frame frame = seen_from_right({from, 0, axis_height});
  Solid solid(name);
  solid.prism(place(circle(10.4, 6), frame), {to - from, 0, 0}, {ring(frame, 6, segments)});
  return solid;
}

}  // namespace

Model bearing() {
  const auto at = [](double x) { return seen_from_right({x, 0, axis_height}); };
  const Solid shaft =
      turned("shaft", at(0), {{5, -84}, {6, -83}, {6, -65}, {12, -65}, {12, 65}, {6, 65}, {6, 83}, {5, 84}}, false);
  const Solid roller = turned(
      "roller", at(0), {{12, -34}, {38, -34}, {38, -28}, {30, -20}, {30, 20}, {38, 28}, {38, 34}, {12, 34}}, true);
  const auto washer = [&at](const std::string& name, double from, double to) {
    return turned(name, at(0), {{6, from}, {18, from}, {18, to}, {6, to}}, true);
  };
  return {base_plate(),
          block("left_block", -65, -40),
          block("right_block", 40, 65),
          shaft,
          roller,
          washer("left_washer", -68, -65),
          washer("right_washer", 65, 68),
          nut("left_nut", -78, -68),
          nut("right_nut", 68, 78)};
}

}  // namespace samples
