// SPDX-License-Identifier: Apache-2.0
// Parts that one machine makes: bracket, flange, shaft, gear, elbow.
#include <cmath>
#include <numbers>

#include "parts.hpp"

namespace samples {

namespace {

std::vector<Loop> place_all(const std::vector<Outline>& outlines, const Frame& frame) {
  std::vector<Loop> loops;
  for (const Outline& outline : outlines) {
    loops.push_back(place(outline, frame));
  }
  return loops;
}

/// A hole as long as its centre line plus its width, along the first axis.
Outline slot(const Point2& centre, double length, double radius) {
  Outline outline = arc({centre[0] + length / 2, centre[1]}, radius, -90, 90, 24);
  const Outline left = arc({centre[0] - length / 2, centre[1]}, radius, 90, 270, 24);
  outline.insert(outline.end(), left.begin(), left.end());
  return outline;
}

}  // namespace

Model bracket() {
  constexpr double width = 80, depth = 70, height = 75, thickness = 10, fillet = 12;
  Outline profile = {{0, 0}, {depth, 0}, {depth, height}, {depth - thickness, height}};
  const Outline inside = arc({depth - thickness - fillet, thickness + fillet}, fillet, 0, -90, 18);
  profile.insert(profile.end(), inside.begin(), inside.end());
  profile.push_back({0, thickness});

  const std::vector<Outline> slots = {slot({20, 22}, 10, 5.5), slot({60, 22}, 10, 5.5)};
  const std::vector<Outline> rounds = {circle(13, 72, {40, 48}), circle(3.5, 48, {14, 62}), circle(3.5, 48, {66, 62})};
  const std::vector<Loop> top_holes = place_all(slots, seen_from_top({0, 0, thickness}));
  const std::vector<Loop> front_holes = place_all(rounds, seen_from_front({0, depth - thickness, 0}));

  Solid solid("bracket");
  const Loop left = place(profile, seen_from_right({0, 0, 0}));
  const Loop right = shifted(left, {width, 0, 0});
  const auto wall = [&](std::size_t i, const std::vector<Loop>& holes = {}) {
    const std::size_t j = (i + 1) % left.size();
    solid.face({left[i], left[j], right[j], right[i]}, holes);
  };
  solid.face(reversed(left));
  solid.face(right);
  wall(0, place_all(slots, seen_from_top({0, 0, 0})));
  wall(1, place_all(rounds, seen_from_front({0, depth, 0})));
  wall(2);
  wall(3, front_holes);
  for (std::size_t i = 4; i + 2 < left.size(); ++i) {
    wall(i);
  }
  wall(left.size() - 2, top_holes);
  wall(left.size() - 1);
  for (const Loop& hole : top_holes) {
    solid.bore(hole, {0, 0, -thickness});
  }
  for (const Loop& hole : front_holes) {
    solid.bore(hole, {0, thickness, 0});
  }
  return {solid};
}

Model flange() {
  constexpr int segments = 96;
  constexpr double bore = 41.25, bottom = 3, top = 23;
  const auto at = [](double r, double z) { return ring(seen_from_top({0, 0, z}), r, segments); };
  const std::vector<Outline> bolts = bolt_circle(8, 80, 9, 48, 22.5);

  Solid solid("flange");
  solid.strip(at(bore, 0), at(69, 0));
  solid.strip(at(69, 0), at(69, bottom));
  std::vector<Loop> under = place_all(bolts, seen_from_top({0, 0, bottom}));
  std::vector<Loop> above = place_all(bolts, seen_from_top({0, 0, top}));
  for (const Loop& hole : above) {
    solid.bore(hole, {0, 0, bottom - top});
  }
  under.push_back(at(69, bottom));
  above.push_back(at(55, top));
  solid.face(reversed(at(100, bottom)), under);
  solid.strip(at(100, bottom), at(100, top));
  solid.face(at(100, top), above);
  const std::vector<Loop> neck = {at(55, top), at(44.45, 45), at(44.45, 53), at(bore, 53), at(bore, 0)};
  for (std::size_t i = 0; i + 1 < neck.size(); ++i) {
    solid.strip(neck[i], neck[i + 1]);
  }
  return {solid};
}

namespace {

constexpr double key_width = 8, key_floor = 11, key_radius = 15;

/// A circle about the x axis with corners where the keyway meets it. 90 degrees is up.
Loop shaft_ring(double x, double radius) {
  const double half = std::asin(key_width / 2 / key_radius) * 180 / std::numbers::pi;
  Outline outline;
  for (int angle = 0; angle < 360; angle += 5) {
    const double at = angle == 75 ? 90 - half : angle == 105 ? 90 + half : angle;
    outline.push_back({radius * cos_deg(at), radius * sin_deg(at)});
  }
  return place(outline, seen_from_right({x, 0, 0}));
}

/// The stretch of the shaft that the keyway was milled into.
void keyway(Solid& solid, double from, double to) {
  constexpr std::size_t first = 75 / 5, last = 105 / 5;
  const Loop a = shaft_ring(from, key_radius), b = shaft_ring(to, key_radius);
  for (std::size_t i = 0; i < a.size(); ++i) {
    const std::size_t j = (i + 1) % a.size();
    if (i < first || i >= last) {
      solid.face({a[i], a[j], b[j], b[i]});
    }
  }
  constexpr double y = key_width / 2;
  Loop end(a.begin() + first, a.begin() + last + 1);
  end.push_back({from, -y, key_floor});
  end.push_back({from, y, key_floor});
  solid.face(end);
  solid.face(reversed(shifted(end, {to - from, 0, 0})));
  solid.face({{from, -y, key_floor}, {to, -y, key_floor}, {to, y, key_floor}, {from, y, key_floor}});
  solid.face({{from, y, key_floor}, {to, y, key_floor}, b[first], a[first]});
  solid.face({{to, -y, key_floor}, {from, -y, key_floor}, a[last], b[last]});
}

}  // namespace

Model shaft() {
  const std::vector<Point2> left = {{0, 10.5}, {1.5, 12}, {25, 12},  {25, 17.5}, {60, 17.5}, {60, 25},
                                    {68, 25},  {68, 20},  {120, 20}, {120, 15},  {130, 15}};
  const std::vector<Point2> right = {{158, 15}, {163.5, 15}, {165, 13.5}};
  Solid solid("shaft");
  const auto section = [&solid](const std::vector<Point2>& profile) {
    for (std::size_t i = 0; i + 1 < profile.size(); ++i) {
      solid.strip(shaft_ring(profile[i][0], profile[i][1]), shaft_ring(profile[i + 1][0], profile[i + 1][1]));
    }
  };
  solid.face(reversed(shaft_ring(left.front()[0], left.front()[1])));
  section(left);
  keyway(solid, left.back()[0], right.front()[0]);
  section(right);
  solid.face(shaft_ring(right.back()[0], right.back()[1]));
  return {solid};
}

namespace {

/// Spur gear with involute flanks; ISO 53 rack: addendum 1, dedendum 1.25 modules, pressure angle 20 degrees.
Outline gear_outline(int teeth, double module) {
  constexpr int flank_points = 7;
  const double pitch = module * teeth / 2, tip = pitch + module, root = pitch - 1.25 * module;
  const double base = pitch * cos_deg(20);
  const auto involute = [](double r_over_base) {  // polar angle of the involute at a radius, in degrees
    const double t = std::sqrt(r_over_base * r_over_base - 1);
    return (t - std::atan(t)) * 180 / std::numbers::pi;
  };
  // Half the angle that a tooth takes at radius r: 90/teeth on the pitch circle.
  const auto half_tooth = [&](double r) {
    return 90.0 / teeth + involute(pitch / base) - involute(std::max(r, base) / base);
  };
  Outline outline;
  const auto add = [&](double r, double angle) { outline.push_back({r * cos_deg(angle), r * sin_deg(angle)}); };
  for (int tooth = 0; tooth < teeth; ++tooth) {
    const double middle = 360.0 * tooth / teeth;
    add(root, middle - half_tooth(root));
    for (int i = 0; i < flank_points; ++i) {
      const double r = base + (tip - base) * i / (flank_points - 1);
      add(r, middle - half_tooth(r));
    }
    add(tip, middle);
    for (int i = flank_points - 1; i >= 0; --i) {
      const double r = base + (tip - base) * i / (flank_points - 1);
      add(r, middle + half_tooth(r));
    }
    add(root, middle + half_tooth(root));
    add(root, middle + 180.0 / teeth);
  }
  return outline;
}

/// A round bore with a keyway at its top.
Outline keyed_bore(double radius, double width, double top) {
  const double half = std::asin(width / 2 / radius) * 180 / std::numbers::pi;
  Outline outline = arc({0, 0}, radius, 90 + half, 450 - half, 60);
  outline.push_back({width / 2, top});
  outline.push_back({-width / 2, top});
  return outline;
}

}  // namespace

Model gear() {
  constexpr double face_width = 20, hub_height = 32, hub_radius = 20;
  const Loop teeth = place(gear_outline(24, 4), seen_from_top({0, 0, 0}));
  const Loop bore = place(keyed_bore(12, 8, 15.3), seen_from_top({0, 0, 0}));
  const std::vector<Outline> lightening = bolt_circle(6, 31, 7, 48, 30);
  std::vector<Loop> under = place_all(lightening, seen_from_top({0, 0, 0}));
  std::vector<Loop> above = place_all(lightening, seen_from_top({0, 0, face_width}));

  Solid solid("gear");
  for (const Loop& hole : above) {
    solid.bore(hole, {0, 0, -face_width});
  }
  under.push_back(bore);
  above.push_back(ring(seen_from_top({0, 0, face_width}), hub_radius, 72));
  solid.face(reversed(teeth), under);
  solid.strip(teeth, shifted(teeth, {0, 0, face_width}));
  solid.face(shifted(teeth, {0, 0, face_width}), above);
  const Loop hub_top = ring(seen_from_top({0, 0, hub_height}), hub_radius, 72);
  solid.strip(above.back(), hub_top);
  solid.face(hub_top, {shifted(bore, {0, 0, hub_height})});
  solid.bore(shifted(bore, {0, 0, hub_height}), {0, 0, -hub_height});
  return {solid};
}

namespace {

constexpr double stub = 45, bend = 100;  // length of the straight ends, radius of the centre line

/// Cross-sections of the pipe: straight up from the origin, through the bend, and straight on to the right.
std::vector<Frame> elbow_sections(double flange_thickness) {
  constexpr int steps = 24;
  std::vector<Frame> sections = {seen_from_top({0, 0, 0}), seen_from_top({0, 0, flange_thickness})};
  for (int i = 0; i <= steps; ++i) {
    const double c = cos_deg(90.0 * i / steps), s = sin_deg(90.0 * i / steps);
    sections.push_back({{bend - bend * c, 0, stub + bend * s}, {c, 0, -s}, {0, 1, 0}});
  }
  const Frame& last = sections.back();
  const Point step = {stub - flange_thickness, 0, 0};
  sections.push_back({last.origin + step, last.u, last.v});
  sections.push_back({last.origin + Point{stub, 0, 0}, last.u, last.v});
  return sections;
}

}  // namespace

Model elbow() {
  constexpr int segments = 64;
  constexpr double inside = 25, outside = 30, rim = 58, thickness = 14;
  const std::vector<Frame> sections = elbow_sections(thickness);
  const std::vector<Outline> bolts = bolt_circle(4, 45, 7, 48, 45);
  const std::size_t n = sections.size();

  Solid solid("elbow");
  const auto annulus = [&](const Frame& frame, double hole, bool forward) {
    std::vector<Loop> holes = place_all(bolts, frame);
    holes.push_back(ring(frame, hole, segments));
    const Loop outer = ring(frame, rim, segments);
    solid.face(forward ? outer : reversed(outer), holes);
  };
  const auto flange_rim = [&](const Frame& from, const Frame& to) {
    solid.strip(ring(from, rim, segments), ring(to, rim, segments));
    for (const Outline& bolt : bolts) {
      solid.strip(place(bolt, to), place(bolt, from));
    }
  };
  annulus(sections[0], inside, false);
  flange_rim(sections[0], sections[1]);
  annulus(sections[1], outside, true);
  for (std::size_t i = 1; i + 2 < n; ++i) {
    solid.strip(ring(sections[i], outside, segments), ring(sections[i + 1], outside, segments));
  }
  annulus(sections[n - 2], outside, false);
  flange_rim(sections[n - 2], sections[n - 1]);
  annulus(sections[n - 1], inside, true);
  for (std::size_t i = n - 1; i > 0; --i) {
    solid.strip(ring(sections[i], inside, segments), ring(sections[i - 1], inside, segments));
  }
  return {solid};
}

}  // namespace samples
