// SPDX-License-Identifier: Apache-2.0
// Parts with slopes, notches, round ends and holes about an axis or in a slope, of known sizes, in families.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <string>
#include <vector>

#include "known_parts.hpp"

namespace epura::test {

inline std::string number(double value) { return format_number(std::round(value * 100) / 100); }

inline constexpr int variants = 20;  // of each family

/// A block of width w and height h with a notch, 2b wide and d deep, in the middle of its top at x = m.
inline std::vector<KnownPart> v_notches() {
  std::vector<KnownPart> parts;
  for (int i = 0; i < variants; ++i) {
    const double w = 80 + i, h = 40, m = 25 + i, b = 7, d = 9 + 0.5 * i;
    parts.push_back({"a notch " + std::to_string(i),
                     block({{0, 0}, {w, 0}, {w, h}, {m + b, h}, {m, h - d}, {m - b, h}, {0, h}}, 12),
                     {number(w), "40", "12", number(m - b), number(m), number(m + b), number(h - d)}});
  }
  return parts;
}

/// A house: a plane between two slopes.
inline std::vector<KnownPart> planes_between_slopes() {
  std::vector<KnownPart> parts;
  for (int i = 0; i < variants; ++i) {
    const double w = 90, a = 20.5 + 0.5 * i, b = 65 + i, low = 22, high = 45;
    parts.push_back({"a plane between slopes " + std::to_string(i),
                     block({{0, 0}, {w, 0}, {w, low}, {b, high}, {a, high}, {0, low + 3}}, 15),
                     {"90", "45", "15", number(a), number(b), "22", "25"}});
  }
  return parts;
}

/// The outline of a polygon whose corners are rounded; counterclockwise.
inline Loop rounded(const Loop& corners, const std::vector<double>& radii) {
  Loop outline;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vec2 p = corners[i], before = corners[(i + corners.size() - 1) % corners.size()],
               after = corners[(i + 1) % corners.size()];
    if (radii[i] == 0) {
      outline.push_back(p);
      continue;
    }
    const Vec2 u = glm::normalize(before - p), v = glm::normalize(after - p);
    const double half = std::acos(glm::dot(u, v)) / 2, to = radii[i] / std::tan(half);
    const Vec2 centre = p + radii[i] / std::sin(half) * glm::normalize(u + v);
    const double begin = std::atan2((p + to * u - centre).y, (p + to * u - centre).x);
    const double turn = std::numbers::pi - 2 * half;
    for (int step = 0; step <= k; ++step) {
      const double angle = begin + turn * step / k;
      outline.push_back(centre + radii[i] * Vec2(std::cos(angle), std::sin(angle)));
    }
  }
  return outline;
}

/// A side that leans between a sharp corner and a rounded one, whose theoretical corner is dimensioned.
inline std::vector<KnownPart> slopes_to_rounded_corners() {
  std::vector<KnownPart> parts;
  for (int i = 0; i < variants; ++i) {
    const double x = 40 + 0.5 * i, r = 3;
    parts.push_back({"a slope to a rounded corner " + std::to_string(i),
                     block(rounded({{0, 0}, {60, 0}, {60, 10}, {x, 30}, {0, 30}}, {0, 0, 0, r, 0}), 8),
                     {"60", "30", "8", "10", number(x), "R3"}});
  }
  return parts;
}

/// A trapezium with four rounded corners: what is beyond the roundings cannot be measured, so the sides have angles.
inline std::vector<KnownPart> rounded_trapezia() {
  std::vector<KnownPart> parts;
  for (int i = 0; i < variants; ++i) {
    const double left = 8 + 0.5 * i, right = 47 - 0.5 * i, width = 60, height = 30, r = 3 + 0.25 * i;
    const double a = std::atan2(height, left), b = std::atan2(height, width - right);
    // The ends of the models are on the arcs at the bottom.
    const double from = r / std::tan(a / 2) - r, to = width - r / std::tan(b / 2) + r;
    const auto degrees = [](double angle) { return number(angle * 180 / std::numbers::pi) + "°"; };
    parts.push_back({"a rounded trapezium " + std::to_string(i),
                     block(rounded({{0, 0}, {width, 0}, {right, height}, {left, height}}, {r, r, r, r}), 6),
                     {number(to - from), "30", "6", "4× R" + number(r), degrees(a), degrees(b)}});
  }
  return parts;
}

/// Slopes that were drawn by their angle: an end whose place would have to be rounded has none.
inline std::vector<KnownPart> slopes_of_plain_angles() {
  std::vector<KnownPart> parts;
  for (int i = 0; i < variants; ++i) {
    const double w = 80 + i, h = 40, turn = 20 + i + 0.5 * (i % 2), tangent = sine(turn) / cosine(turn), top = 20 + i;
    const std::string degrees = number(turn) + "°";
    parts.push_back({"a cut corner of " + degrees,
                     block({{0, 0}, {w, 0}, {w, h}, {14 * tangent, h}, {0, h - 14}}, 12),
                     {number(w), "40", "12", "26", degrees}});
    parts.push_back(
        {"a dovetail of " + degrees,
         block(
             {{0, 0}, {w, 0}, {w, h}, {60, h}, {60 + 8 * tangent, h - 8}, {top - 8 * tangent, h - 8}, {top, h}, {0, h}},
             12),
         {number(w), "40", "12", number(top), "60", "32", "2× " + number(90 - turn) + "°"}});
    parts.push_back({"a wedge of " + degrees,
                     block({{0, 0}, {w, 0}, {w, 10}, {0, 10 + w * tangent}}, 12),
                     {number(w), "(" + number(10 + w * tangent) + ")", "12", "10", number(90 - turn) + "°"}});
  }
  return parts;
}

/// A block of 45 degrees at one corner: a chamfer if it is smaller than what it leaves of the faces there, a slope with
/// two places if it is larger, and if it fills a corner of the material.
inline std::vector<KnownPart> slopes_of_45_degrees() {
  std::vector<KnownPart> parts;
  for (int i = 0; i < variants; ++i) {
    const double w = 60 + i, h = 40, small = 3 + 0.45 * i, large = 22 + 0.5 * i, fill = 6 + 0.5 * i;
    const auto cut = [&](double leg) { return block({{0, 0}, {w, 0}, {w, h - leg}, {w - leg, h}, {0, h}}, 12); };
    parts.push_back({"a chamfer " + std::to_string(i), cut(small), {number(w), "40", "12", number(small) + "×45°"}});
    parts.push_back({"a cut corner " + std::to_string(i),
                     cut(large),
                     {number(w), "40", "12", number(w - large), number(h - large)}});
    parts.push_back({"a filled corner " + std::to_string(i),
                     block({{0, 0}, {w, 0}, {w, 15}, {20 + fill, 15}, {20, 15 + fill}, {20, h}, {0, h}}, 12),
                     {number(w), "40", "12", "20", number(20 + fill), "15", number(15 + fill)}});
  }
  return parts;
}

/// A bar with round ends: the distance of their axes, one radius, and sizes over all in brackets.
inline std::vector<KnownPart> round_ends() {
  std::vector<KnownPart> parts;
  for (int i = 0; i < variants; ++i) {
    const double length = 30 + i, r = 7.5 + 0.25 * i;
    Loop outline;
    for (int step = 0; step <= 2 * k; ++step)
      outline.push_back(Vec2(length, 0) + r * Vec2(sine(90.0 * step / k), -cosine(90.0 * step / k)));
    for (int step = 0; step <= 2 * k; ++step)
      outline.push_back(r * Vec2(-sine(90.0 * step / k), cosine(90.0 * step / k)));
    parts.push_back(
        {"round ends " + std::to_string(i),
         block(outline, 6),
         {"(" + number(length + 2 * r) + ")", "(" + number(2 * r) + ")", "6", number(length), "2× R" + number(r)}});
  }
  return parts;
}

/// An arc of half a turn beside straight sides, at one end only.
inline std::vector<KnownPart> tongues() {
  std::vector<KnownPart> parts;
  for (int i = 0; i < variants; ++i) {
    const double length = 40 + i, r = 9 + 0.5 * i;
    Loop outline{{0, 0}};
    for (int step = 0; step <= 2 * k; ++step)
      outline.push_back(Vec2(length, r) + r * Vec2(sine(90.0 * step / k), -cosine(90.0 * step / k)));
    outline.emplace_back(0, 2 * r);
    parts.push_back(
        {"a tongue " + std::to_string(i),
         block(outline, 6),
         {"(" + number(length + r) + ")", "(" + number(2 * r) + ")", "6", number(length), "R" + number(r)}});
    Loop turned;
    for (const Vec2& p : outline) turned.emplace_back(length - p.x, 2 * r - p.y);
    parts.push_back({"a turned tongue " + std::to_string(i), block(turned, 6), parts.back().texts});
  }
  return parts;
}

/// Two round bosses that a lower web joins: the distance of their axes, and the size over them in brackets.
inline std::vector<KnownPart> bosses_on_a_web() {
  std::vector<KnownPart> parts;
  for (int i = 0; i < variants; ++i) {
    const double length = 50 + i, web = 6, half = 4 + 0.25 * i;
    const std::array<double, 2> radii{14 + 0.5 * i, 9.0}, heights{20, 15};
    Model model;
    Loop outline, floor;
    for (const std::size_t end : {0U, 1U}) {
      const double r = radii[end], key = std::asin(half / r) * 180 / std::numbers::pi, way = end == 0 ? 0 : 180;
      const auto arc = [&](double from, double to) {
        Loop loop;
        for (int step = 0; step <= 2 * k; ++step) {
          const double angle = from + (to - from) * step / (2 * k);
          loop.push_back(Vec2(end == 0 ? 0 : length, 0) + r * Vec2(cosine(angle), sine(angle)));
        }
        return loop;
      };
      const auto wall = [&](const Loop& loop, double low, double high) {
        for (std::size_t p = 0; p + 1 < loop.size(); ++p)
          model.face({Vec3(loop[p], low), Vec3(loop[p + 1], low), Vec3(loop[p + 1], high), Vec3(loop[p], high)});
      };
      const Loop outer = arc(way + key, way + 360 - key), inner = arc(way - key, way + key);
      wall(outer, 0, web);
      wall(outer, web, heights[end]);
      wall(inner, web, heights[end]);
      std::vector<Vec3> top;
      for (const Vec2& p : outer) top.emplace_back(p, heights[end]);
      for (std::size_t p = 1; p + 1 < inner.size(); ++p) top.emplace_back(inner[p], heights[end]);
      model.face(top);
      outline.insert(outline.end(), outer.begin(), outer.end());
      floor.insert(floor.end(), inner.rbegin(), inner.rend());
    }
    std::vector<Vec3> bottom, above;
    for (const Vec2& p : outline) bottom.emplace_back(p, 0);
    for (const Vec2& p : floor) above.emplace_back(p, web);
    model.face({bottom.rbegin(), bottom.rend()});
    model.face(above);
    const std::size_t next = outline.size() / 2;
    for (const auto& [p, q] : {std::pair(outline[next - 1], outline[next]), std::pair(outline.back(), outline[0])})
      model.face({Vec3(p, 0), Vec3(q, 0), Vec3(q, web), Vec3(p, web)});
    parts.push_back({"bosses on a web " + std::to_string(i),
                     model.obj(),
                     {"(" + number(length + radii[0] + radii[1]) + ")", "⌀" + number(2 * radii[0]),
                      "⌀" + number(2 * radii[1]), "20", "15", number(web), number(2 * half), number(length)}});
  }
  return parts;
}

// Half of a bar with round ends, about its hole at the origin: 4k points, beginning in direction -135 degrees.
inline Loop half_bar(double half_length, double r) {
  Loop loop;
  for (int i = 0; i < k / 2; ++i) loop.push_back(r * Vec2(cosine(-135 + 90.0 * i / k), sine(-135 + 90.0 * i / k)));
  const std::array corners{Vec2(0, -r), Vec2(half_length, -r), Vec2(half_length, r), Vec2(0, r)};
  for (int side = 0; side < 3; ++side)
    for (int i = 0; i < 2 * k / 3; ++i)
      loop.push_back(corners[side] + (corners[side + 1] - corners[side]) * (1.5 * i / k));
  for (int i = 0; i < 3 * k / 2; ++i) loop.push_back(r * Vec2(cosine(90 + 90.0 * i / k), sine(90 + 90.0 * i / k)));
  return loop;
}

/// The same with holes at the axes of both ends.
inline std::vector<KnownPart> links() {
  std::vector<KnownPart> parts;
  for (int i = 0; i < variants; ++i) {
    const double length = 36 + i, r = 8 + 0.5 * i, bore = 3;
    Plate plate(5);
    const Loop half = half_bar(length / 2, r);
    Loop turned;
    for (const Vec2& p : half) turned.push_back(Vec2(length, 0) - p);
    const Loop low = circle({0, 0}, bore, -135), high = circle({length, 0}, bore, 45);
    plate.cell(half, {{low, 5}, {low, 0}});
    plate.cell(turned, {{high, 5}, {high, 0}});
    parts.push_back({"a link " + std::to_string(i),
                     plate.obj(),
                     {"(" + number(length + 2 * r) + ")", "(" + number(2 * r) + ")", "5", number(length),
                      "2× R" + number(r), "2× ⌀6"}});
  }
  return parts;
}

/// A sector of cylinders about z with a hole towards their axis. Rings of vertices lead from the rim of the hole to the
/// border of the sector.
struct RadialHole {
  static constexpr double outer = 20, length = 40;

  double middle, height;  ///< of the hole: degrees about z, and along it
  Loop border, rim;       ///< the sector as (degrees, height), and the hole about its axis; points of equal number
  int rings = 8;

  /// Where a bore about the radial direction meets a cylinder, in ring 0, and beyond.
  [[nodiscard]] Vec3 at(double r, int ring, std::size_t i) const {
    const Vec2 mouth(middle + std::asin(rim[i].x / r) * 180 / std::numbers::pi, height + rim[i].y);
    const Vec2 p = mouth + (border[i] - mouth) * (double(ring) / rings);
    return Vec3(r * cosine(p.x), r * sine(p.x), p.y);
  }
  /// Where the bore meets a plane across its axis.
  [[nodiscard]] Vec3 at_floor(double from_axis, std::size_t i) const {
    return Vec3(from_axis * cosine(middle) - rim[i].x * sine(middle),
                from_axis * sine(middle) + rim[i].x * cosine(middle), height + rim[i].y);
  }
  [[nodiscard]] std::size_t next(std::size_t i) const { return (i + 1) % border.size(); }
  [[nodiscard]] bool is_on_end(std::size_t i) const { return border[i].y == border[next(i)].y; }

  /// The cylinder around the hole between two lines of vertices, seen from outside or from within.
  void add_cylinder(Model& model, double r, std::size_t i, bool from_within) const {
    const std::size_t a = from_within ? next(i) : i, b = from_within ? i : next(i);
    for (int ring = 0; ring < rings; ++ring) {
      model.face({at(r, ring + 1, a), at(r, ring + 1, b), at(r, ring, next(i))});
      if (from_within)
        model.face({at(r, ring + 1, i), at(r, ring, i), at(r, ring, next(i))});
      else
        model.face({at(r, ring + 1, i), at(r, ring, next(i)), at(r, ring, i)});
    }
  }
};

inline std::vector<RadialHole> radial_holes(const std::vector<double>& angles, double height, double radius,
                                            int rings = 8) {
  std::vector<RadialHole> holes;
  const std::size_t count = angles.size();
  for (std::size_t s = 0; s < count; ++s) {
    const double middle = angles[s], before = angles[(s + count - 1) % count] - (s == 0 ? 360 : 0),
                 after = angles[(s + 1) % count] + (s + 1 == count ? 360 : 0);
    const double from = (middle + before) / 2, to = (middle + after) / 2;
    holes.push_back(
        {middle, height, square({from, 0}, {to - from, RadialHole::length}), circle({0, 0}, radius, -135), rings});
  }
  return holes;
}

/// A tube about z with holes towards its axis, each in a sector of its own.
inline std::string tube_with_holes(const std::vector<double>& angles, double height, double radius) {
  constexpr double inner = 14, outer = RadialHole::outer;
  Model model;
  for (const RadialHole& hole : radial_holes(angles, height, radius))
    for (std::size_t i = 0; i < hole.border.size(); ++i) {
      const std::size_t j = hole.next(i);
      hole.add_cylinder(model, outer, i, false);
      hole.add_cylinder(model, inner, i, true);
      model.face({hole.at(outer, 0, i), hole.at(outer, 0, j), hole.at(inner, 0, j), hole.at(inner, 0, i)});
      if (hole.is_on_end(i))
        model.face({hole.at(outer, hole.rings, j), hole.at(outer, hole.rings, i), hole.at(inner, hole.rings, i),
                    hole.at(inner, hole.rings, j)});
    }
  return model.obj();
}

/// A shaft about z with flat-bottomed holes towards its axis, which end `floor` from it, each in a sector of its own.
inline std::string shaft_with_blind_holes(const std::vector<double>& angles, double height, double radius,
                                          double floor) {
  constexpr double outer = RadialHole::outer;
  Model model;
  for (const RadialHole& hole : radial_holes(angles, height, radius)) {
    std::vector<Vec3> bottom;
    for (std::size_t i = 0; i < hole.border.size(); ++i) {
      const std::size_t j = hole.next(i);
      hole.add_cylinder(model, outer, i, false);
      model.face({hole.at(outer, 0, i), hole.at(outer, 0, j), hole.at_floor(floor, j), hole.at_floor(floor, i)});
      bottom.push_back(hole.at_floor(floor, i));
      if (hole.is_on_end(i))
        model.face({hole.at(outer, hole.rings, j), hole.at(outer, hole.rings, i), Vec3(0, 0, hole.border[i].y)});
    }
    model.face(bottom);
  }
  return model.obj();
}

/// Depths are those below the shaft, where the axis of the hole meets it.
inline std::vector<KnownPart> shafts_with_blind_holes() {
  std::vector<KnownPart> parts;
  for (int i = 0; i < variants; ++i) {
    const double first = 5 + 0.5 * i, height = 12 + 0.5 * i, floor = 8 + 0.25 * i;
    parts.push_back({"radial blind holes " + number(floor) + " from the axis",
                     shaft_with_blind_holes({first, first + 120, first + 240}, height, 2.5, floor),
                     {"40", "⌀40", "3× ⌀5 ↧" + number(20 - floor), number(height), number(first) + "°", "3× 120°"}});
  }
  return parts;
}

inline std::vector<KnownPart> tubes_with_radial_holes() {
  std::vector<KnownPart> parts;
  for (int i = 0; i < variants; ++i) {
    const double first = 5 + 0.5 * i, height = 12 + 0.5 * i;
    parts.push_back({"radial holes from " + number(first),
                     tube_with_holes({first, first + 120, first + 240}, height, 2.5),
                     {"40", "⌀40", "⌀28", "3× ⌀5", number(height), number(first) + "°", "3× 120°"}});
  }
  return parts;
}

/// The mouth of a hole about a point, with as many points as a square.
using Mouth = std::function<Loop(const Vec2&)>;

/// A wedge with blind holes in rows along its slope, perpendicular to it; one row for each mouth, whose coordinates are
/// along the slope and across it.
inline std::string wedge_with(double length, double degrees, int count, double depth,
                              const std::vector<Mouth>& mouths) {
  constexpr double row = 24, low = 18;
  const double width = row * static_cast<double>(mouths.size());
  const int across = k * static_cast<int>(mouths.size());
  Model model;
  const Vec3 along(cosine(degrees), 0, sine(degrees)), up(-along.z, 0, along.x);
  const auto at = [&](const Vec2& p, double below) {
    return Vec3(0, 0, low) + p.x * along + Vec3(0, p.y, 0) - below * up;
  };
  for (int c = 0; c < count; ++c)
    for (std::size_t r = 0; r < mouths.size(); ++r) {
      const Vec2 size(length / count, row), corner(c * size.x, row * static_cast<double>(r));
      const Loop border = square(corner, size), rim = mouths[r](corner + size / 2.0);
      std::vector<Vec3> floor;
      for (std::size_t i = 0; i < border.size(); ++i) {
        const std::size_t j = (i + 1) % border.size();
        model.face({at(border[i], 0), at(border[j], 0), at(rim[j], 0), at(rim[i], 0)});
        model.face({at(rim[i], 0), at(rim[j], 0), at(rim[j], depth), at(rim[i], depth)});
        floor.push_back(at(rim[i], depth));
      }
      model.face(floor);
    }
  const double end = length * along.x;
  std::vector<Vec3> front{{0, 0, 0}, {end, 0, 0}}, back{{end, width, 0}, {0, width, 0}};
  for (int i = 0; i <= count * k; ++i) {
    front.push_back(at({length * (1 - double(i) / (count * k)), 0}, 0));
    back.push_back(at({length * double(i) / (count * k), width}, 0));
  }
  std::vector<Vec3> left{{0, width, 0}, {0, 0, 0}}, right{{end, 0, 0}, {end, width, 0}};
  for (int i = 0; i <= across; ++i) {
    left.push_back(at({0, width * i / across}, 0));
    right.push_back(at({length, width * (1 - double(i) / across)}, 0));
  }
  for (const auto& face : {front, back, left, right}) model.face(face);
  model.face({{0, 0, 0}, {0, width, 0}, {end, width, 0}, {end, 0, 0}});
  return model.obj();
}

inline std::string wedge_with_holes(double length, double degrees, int count, double depth,
                                    const std::vector<double>& radii = {3}) {
  std::vector<Mouth> mouths;
  for (const double radius : radii)
    mouths.emplace_back([radius](const Vec2& centre) { return circle(centre, radius, -135); });
  return wedge_with(length, degrees, count, depth, mouths);
}

inline std::vector<KnownPart> wedges_with_holes() {
  std::vector<KnownPart> parts;
  for (int i = 0; i < variants; ++i) {
    const double length = 60 + 3 * i, degrees = 12 + 0.5 * i;
    const int count = 1 + i % 3;
    KnownPart part{"holes in a slope of " + number(degrees), wedge_with_holes(length, degrees, count, 8), {}};
    part.texts = {number(length * cosine(degrees)), "24", "18", "12", number(90 - degrees) + "°"};
    part.texts.push_back("(" + number(18 + length * sine(degrees)) + ")");
    part.texts.push_back((count > 1 ? number(count) + "× " : "") + "⌀6 ↧8");
    part.texts.push_back(number(length / count / 2));
    if (count == 2) part.texts.push_back(number(length * 0.75));
    if (count == 3) part.texts.push_back("2× " + number(length / 3) + " (=" + number(length * 2 / 3) + ")");
    parts.push_back(part);
  }
  return parts;
}

/// A wedge with a rectangular pocket in its slope: places and widths along the slope and across it, and its depth.
inline std::vector<KnownPart> wedges_with_pockets() {
  std::vector<KnownPart> parts;
  for (int i = 0; i < variants; ++i) {
    const double length = 60 + 3 * i, degrees = 12 + 0.5 * i, depth = 5 + 0.2 * i;
    const Vec2 pocket(20 + 0.5 * i, 9 + 0.2 * i), low = Vec2(length, 24) / 2.0 - pocket / 2.0;
    const auto mouth = [&](const Vec2& centre) { return square(centre - pocket / 2.0, pocket); };
    parts.push_back({"a pocket in a slope of " + number(degrees),
                     wedge_with(length, degrees, 1, depth, {mouth}),
                     {number(length * cosine(degrees)), "24", "(" + number(18 + length * sine(degrees)) + ")", "18",
                      number(90 - degrees) + "°", number(low.x), number(pocket.x), number(low.y), number(pocket.y),
                      number(depth)}});
  }
  return parts;
}

/// A wedge with a slot that runs down its slope, seen along its axis.
inline std::vector<KnownPart> wedges_with_slots() {
  std::vector<KnownPart> parts;
  for (int i = 0; i < variants; ++i) {
    const double length = 60 + 3 * i, degrees = 12 + 0.5 * i, depth = 5 + 0.25 * i, r = 3 + 0.1 * i, way = 14 + i;
    const auto mouth = [&](const Vec2& centre) {
      Loop loop = slot(centre, r, way);
      std::rotate(loop.begin(), loop.end() - k / 2, loop.end());  // in direction -135 degrees from its end
      return loop;
    };
    parts.push_back({"a slot in a slope of " + number(degrees),
                     wedge_with(length, degrees, 1, depth, {mouth}),
                     {number(length * cosine(degrees)), "24", "(" + number(18 + length * sine(degrees)) + ")", "18",
                      number(90 - degrees) + "°", number(length / 2 - way / 2), number(length / 2 + way / 2), "12",
                      "2× R" + number(r), number(depth)}});
    parts.back().view = "auxiliary:direction=" + format_number(-sine(degrees)) + ",0," + format_number(cosine(degrees));
  }
  return parts;
}

}  // namespace epura::test
