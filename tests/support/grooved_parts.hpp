// SPDX-License-Identifier: Apache-2.0
// Parts with grooves, ribs, pockets, bosses over bores and round tops that a groove parts, of known sizes, in families.
#pragma once

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "sloped_parts.hpp"

namespace epura::test {

/// A block with a groove in its top: a place and a width.
inline std::vector<KnownPart> blocks_with_grooves() {
  std::vector<KnownPart> parts;
  for (int i = 0; i < variants; ++i) {
    const double w = 90 + i, a = 20.5 + i, g = 5 + 0.75 * i, floor = 22 - 0.5 * i;
    parts.push_back({"a groove " + std::to_string(i),
                     block({{0, 0}, {w, 0}, {w, 30}, {a + g, 30}, {a + g, floor}, {a, floor}, {a, 30}, {0, 30}}, 12),
                     {number(w), "30", "12", number(a), number(g), number(floor)}});
  }
  return parts;
}

/// A base with one rib, or with two: each has a place and a width.
inline std::vector<KnownPart> bases_with_ribs() {
  std::vector<KnownPart> parts;
  for (int i = 0; i < variants; ++i) {
    const double w = 100 + i, a = 12.5 + 0.5 * i, t = 4 + 0.25 * i, b = a + t + 30, u = 6 + 0.25 * i;
    Loop outline{{0, 0}, {w, 0}, {w, 8}};
    KnownPart part{"ribs " + std::to_string(i), {}, {number(w), "32", "14", "8", number(a), number(t)}};
    if (i % 2 == 1) {
      outline.insert(outline.end(), {{b + u, 8}, {b + u, 32}, {b, 32}, {b, 8}});
      part.texts.insert(part.texts.end(), {number(b), number(u)});
    }
    outline.insert(outline.end(), {{a + t, 8}, {a + t, 32}, {a, 32}, {a, 8}, {0, 8}});
    part.obj = block(outline, 14);
    parts.push_back(part);
  }
  return parts;
}

/// A plate with a rectangular pocket.
inline std::vector<KnownPart> plates_with_pockets() {
  std::vector<KnownPart> parts;
  for (int i = 0; i < variants; ++i) {
    const Vec2 size(80 + i, 50), low(11 + i, 9 + 0.5 * i), pocket(24 + 0.5 * i, 14 + 0.25 * i);
    const double floor = 12 + 0.25 * i;
    Plate plate(20);
    plate.cell(square({0, 0}, size), {{square(low, pocket), 20}, {square(low, pocket), floor}});
    parts.push_back({"a pocket " + std::to_string(i),
                     plate.obj(),
                     {number(size.x), "50", "20", number(low.x), number(pocket.x), number(low.y), number(pocket.y),
                      number(floor)}});
  }
  return parts;
}

/// A plate with a rectangular pocket, and a hole in line with one of its walls: the place of the hole is that of the
/// wall, from which the pocket has its width.
inline std::vector<KnownPart> pockets_beside_holes() {
  std::vector<KnownPart> parts;
  for (int i = 0; i < variants; ++i) {
    const Vec2 size(80 + i, 40), low(21 + i, 9 + 0.5 * i), pocket(24 + 0.5 * i, 14 + 0.25 * i);
    const Vec2 hole(low.x + (i % 2 == 0 ? 0 : pocket.x), 63 + 0.25 * i);
    const double floor = 12 + 0.25 * i;
    Plate plate(20);
    plate.cell(square({0, 0}, size), {{square(low, pocket), 20}, {square(low, pocket), floor}});
    plate.cell(square({0, 40}, size), stepped_hole({{4, 20}, {4, 0}})(hole));
    parts.push_back({"a pocket beside a hole " + std::to_string(i),
                     plate.obj(),
                     {number(size.x), "80", "20", "⌀8", number(hole.x), number(hole.y), number(pocket.x), number(low.y),
                      number(pocket.y), number(floor)}});
  }
  return parts;
}

/// A plate with a rectangular boss above a wider blind bore, whose walls are inside the circle of the bore.
inline std::vector<KnownPart> bosses_over_bores() {
  std::vector<KnownPart> parts;
  for (int i = 0; i < variants; ++i) {
    const Vec2 size(90 + i, 60), middle(38 + 0.5 * i, 27), boss(24 + 0.5 * i, 16 + 0.5 * i), low = middle - boss / 2.0;
    const double top = 32 + i, radius = 20, depth = 9 + 0.25 * i;
    const Loop outline = square({0, 0}, size), walls = square(low, boss), rim = circle(middle, radius, -135);
    Model model;
    for (std::size_t p = 0; p < outline.size(); ++p) {
      const std::size_t q = (p + 1) % outline.size();
      model.face({Vec3(outline[p], 20), Vec3(outline[q], 20), Vec3(walls[q], 20), Vec3(walls[p], 20)});
      model.face({Vec3(walls[p], 20), Vec3(walls[q], 20), Vec3(walls[q], top), Vec3(walls[p], top)});
      model.face({Vec3(outline[p], 0), Vec3(outline[q], 0), Vec3(outline[q], 20), Vec3(outline[p], 20)});
      model.face({Vec3(outline[q], 0), Vec3(outline[p], 0), Vec3(rim[p], 0), Vec3(rim[q], 0)});
      model.face({Vec3(rim[q], 0), Vec3(rim[p], 0), Vec3(rim[p], depth), Vec3(rim[q], depth)});
    }
    model.fan(walls, top, true);
    model.fan(rim, depth, false);
    parts.push_back({"a boss over a bore " + std::to_string(i),
                     model.obj(),
                     {number(size.x), "60", number(top), "20", "⌀40 ↧" + number(depth), number(middle.x), "27",
                      number(low.x), number(boss.x), number(low.y), number(boss.y)}});
  }
  return parts;
}

/// A block with a round top, of one cylinder that a groove parts: one radius.
inline std::vector<KnownPart> parted_round_tops() {
  std::vector<KnownPart> parts;
  for (int i = 0; i < variants; ++i) {
    const double w = 60 + i, r = 50 + 2 * i, side = 20, g = 6 + 0.5 * i, floor = 15;
    const double centre = side - std::sqrt(r * r - w * w / 4);
    const auto arc = [&](double from, double to) {
      Loop points;
      for (int step = 0; step <= k; ++step) {
        const double x = from + (to - from) * step / k;
        points.emplace_back(w / 2 + x, centre + std::sqrt(r * r - x * x));
      }
      return points;
    };
    Loop outline{{0, 0}, {w, 0}};
    for (const Vec2& p : arc(w / 2, g / 2)) outline.push_back(p);
    outline.insert(outline.end(), {{w / 2 + g / 2, floor}, {w / 2 - g / 2, floor}});
    for (const Vec2& p : arc(-g / 2, -w / 2)) outline.push_back(p);
    parts.push_back({"a round top with a groove " + std::to_string(i),
                     block(outline, 16),
                     {number(w), number(centre + std::sqrt(r * r - g * g / 4)), "16", "R" + number(r), "15",
                      number(w / 2 - g / 2), number(g)}});
  }
  return parts;
}

/// A flange with a boss that a groove parts: the boss has one diameter, the groove a place and a width.
inline std::vector<KnownPart> bosses_with_ring_grooves() {
  std::vector<KnownPart> parts;
  for (int i = 0; i < variants; ++i) {
    const double a = 18 + 0.5 * i, g = 2 + 0.25 * i, length = 40 + i, r = 15 + 0.25 * i;
    parts.push_back({"a boss with a groove " + std::to_string(i),
                     shaft({{0, 1e-9},
                            {0, 30},
                            {8, 30},
                            {8, r},
                            {a, r},
                            {a, r - 2},
                            {a + g, r - 2},
                            {a + g, r},
                            {length, r},
                            {length, 1e-9}}),
                     {number(length), "⌀60", "8", "⌀" + number(2 * r), "⌀" + number(2 * r - 4), number(a), number(g)}});
  }
  return parts;
}

/// Half a turn about a point, from one direction, in degrees.
inline Loop half_turn(const Vec2& centre, double r, double from, double turn) {
  Loop arc;
  for (int i = 0; i <= 2 * k; ++i)
    arc.push_back(centre + r * Vec2(cosine(from + turn * i / (2 * k)), sine(from + turn * i / (2 * k))));
  return arc;
}

/// A block with a slot that is open above and round below: the place of its axis and a radius.
inline std::vector<KnownPart> blocks_with_open_slots() {
  std::vector<KnownPart> parts;
  for (int i = 0; i < variants; ++i) {
    const double w = 80 + i, m = 31 + 0.5 * i, r = 6 + 0.25 * i, at = 18 + 0.25 * i;
    Loop outline{{0, 0}, {w, 0}, {w, 40}};
    outline.emplace_back(m + r, 40);
    for (const Vec2& p : half_turn({m, at}, r, 0, -180)) outline.push_back(p);
    outline.insert(outline.end(), {{m - r, 40}, {0, 40}});
    parts.push_back({"an open slot " + std::to_string(i),
                     block(outline, 14),
                     {number(w), "40", "14", number(m), number(at), "R" + number(r)}});
  }
  return parts;
}

/// A base with an upright lug that ends in half a turn; its sides may be in the ends of the base.
inline std::vector<KnownPart> bases_with_lugs() {
  std::vector<KnownPart> parts;
  for (int i = 0; i < variants; ++i) {
    const double w = 70 + i, r = 9 + 0.25 * i, up = 38 + i;
    const double m = i % 3 == 0 ? r : i % 3 == 1 ? w - r : 30 + 0.5 * i;
    Loop outline{{0, 0}, {w, 0}};
    if (i % 3 != 1) outline.insert(outline.end(), {{w, 10}, {m + r, 10}});
    for (const Vec2& p : half_turn({m, up}, r, 0, 180)) outline.push_back(p);
    if (i % 3 != 0) outline.insert(outline.end(), {{m - r, 10}, {0, 10}});
    KnownPart part{"a lug " + std::to_string(i),
                   block(outline, 16),
                   {number(w), "(" + number(up + r) + ")", "16", number(up), "10", "R" + number(r)}};
    if (i % 3 == 2) part.texts.push_back(number(m));
    parts.push_back(part);
  }
  return parts;
}

/// Arcs about the x axis, in y and z: all but `key` degrees to either side of the top, or only these.
inline Loop keyed_arc(double r, double key, bool is_top) {
  const double from = is_top ? 90 - key : 90 + key, to = is_top ? 90 + key : 450 - key;
  const int steps = is_top ? 4 : 4 * k;
  Loop points;
  for (int i = 0; i <= steps; ++i) {
    const double angle = from + (to - from) * i / steps;
    points.push_back(r * Vec2(cosine(angle), sine(angle)));
  }
  return points;
}

/// A shaft of 20 and 16 whose keyway runs out at its chamfered end: the floor is measured from the thinner one.
inline std::vector<KnownPart> shafts_with_open_keyways() {
  std::vector<KnownPart> parts;
  for (int i = 0; i < variants; ++i) {
    const double step = 30, begin = 34 + 0.5 * i, length = 60 + i, floor = 3 + 0.1 * i, half = 2 + 0.05 * i;
    const auto key = [half](double r) { return std::asin(half / r) * 180 / std::numbers::pi; };
    const auto full = [&](double r) {
      Loop loop = keyed_arc(r, key(r), false);
      const Loop top = keyed_arc(r, key(r), true);
      loop.insert(loop.end(), top.begin() + 1, top.end() - 1);
      return loop;
    };
    const auto keyed = [&](double r) {
      Loop loop = keyed_arc(r, key(r), false);
      loop.insert(loop.end(), {{half, floor}, {-half, floor}});
      return loop;
    };
    Model model;
    const auto wall = [&](const Loop& a, double from, const Loop& b, double to) {
      for (std::size_t p = 0; p < a.size(); ++p) {
        const std::size_t q = (p + 1) % a.size();
        model.face({Vec3(from, a[p]), Vec3(from, a[q]), Vec3(to, b[q]), Vec3(to, b[p])});
      }
    };
    const auto end = [&](const Loop& loop, double x, bool is_high) {
      std::vector<Vec3> face;
      for (const Vec2& p : loop) face.emplace_back(x, p);
      model.face(is_high ? face : std::vector<Vec3>(face.rbegin(), face.rend()));
    };
    end(full(10), 0, false);
    wall(full(10), 0, full(10), step);
    wall(full(10), step, full(8), step);
    wall(full(8), step, full(8), begin);
    Loop key_end{{-half, floor}, {half, floor}};
    for (const Vec2& p : keyed_arc(8, key(8), true)) key_end.push_back(p);
    end(key_end, begin, true);
    wall(keyed(8), begin, keyed(8), length - 1);
    wall(keyed(8), length - 1, keyed(7), length);
    end(keyed(7), length, true);
    parts.push_back(
        {"an open keyway " + std::to_string(i),
         model.obj(),
         {number(length), "⌀20", "⌀16", "30", number(begin), number(2 * half), number(8 + floor), "1×45°"}});
  }
  return parts;
}

/// A plate with a round groove about an axis that is not that of the plate: half of a torus below its top.
inline std::vector<KnownPart> plates_with_ring_grooves() {
  std::vector<KnownPart> parts;
  for (int i = 0; i < variants; ++i) {
    const Vec2 size(90 + i, 70), centre(40 + 0.5 * i, 31);
    const double ring = 16 + 0.5 * i, r = 3 + 0.1 * i, height = 15;
    const auto at = [&](int step) { return circle(centre, ring + r * cosine(15.0 * step), -135); };
    const auto depth = [&](int step) { return height - r * sine(15.0 * step); };
    Model model;
    const Loop border = square({0, 0}, size);
    const auto strip = [&](const Loop& outer, double high, const Loop& inner, double low) {
      for (std::size_t p = 0; p < outer.size(); ++p) {
        const std::size_t q = (p + 1) % outer.size();
        model.face({Vec3(outer[p], high), Vec3(outer[q], high), Vec3(inner[q], low), Vec3(inner[p], low)});
      }
    };
    strip(border, height, at(0), height);
    for (int step = 0; step < 12; ++step) strip(at(step), depth(step), at(step + 1), depth(step + 1));
    model.fan(at(12), height, true);
    strip(border, 0, border, height);
    std::vector<Vec3> bottom;
    for (const Vec2& p : border) bottom.emplace_back(p, 0);
    model.face({bottom.rbegin(), bottom.rend()});
    parts.push_back({"a ring groove " + std::to_string(i),
                     model.obj(),
                     {number(size.x), "70", "15", "⌀" + number(2 * ring), "R" + number(r), number(centre.x), "31"}});
  }
  return parts;
}

}  // namespace epura::test
