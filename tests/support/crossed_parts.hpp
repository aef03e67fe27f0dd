// SPDX-License-Identifier: Apache-2.0
// Shafts with cross holes, blocks with holes from three sides, plates with domes, beads and turned bosses on them,
// bases with two lugs and bent bars, of known sizes, in families.
#pragma once

#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "grooved_parts.hpp"
#include "turned_parts.hpp"

namespace epura::test {

/// A shaft about z with a hole through its axis.
inline std::string shaft_with_cross_hole(double angle, double height, double radius, int rings = 8) {
  constexpr double outer = RadialHole::outer;
  Model model;
  const std::vector<RadialHole> holes = radial_holes({angle, angle + 180}, height, radius, rings);
  const std::size_t count = holes[0].border.size();
  for (const RadialHole& hole : holes)
    for (std::size_t i = 0; i < count; ++i) {
      hole.add_cylinder(model, outer, i, false);
      if (hole.is_on_end(i))
        model.face({hole.at(outer, rings, hole.next(i)), hole.at(outer, rings, i), Vec3(0, 0, hole.border[i].y)});
    }
  // Seen from the other side, the rim runs the other way round.
  const auto opposite = [count](std::size_t i) { return (count + k - i) % count; };
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t j = holes[0].next(i);
    model.face({holes[0].at(outer, 0, i), holes[0].at(outer, 0, j), holes[1].at(outer, 0, opposite(j)),
                holes[1].at(outer, 0, opposite(i))});
  }
  return model.obj();
}

/// Along an axis of the views, a cross hole has no angle.
inline std::vector<KnownPart> shafts_with_cross_holes() {
  std::vector<KnownPart> parts;
  for (int i = 0; i < variants; ++i) {
    const double angle = i % 4 == 0 ? 0 : i % 4 == 2 ? 90 : 5 + 2 * i, height = 12 + 0.5 * i, r = 2 + 0.25 * i;
    KnownPart part{"a cross hole at " + number(angle),
                   shaft_with_cross_hole(angle, height, r),
                   {"40", "⌀40", "⌀" + number(2 * r), number(height)}};
    if (i % 2 == 1) part.texts.push_back(number(angle) + "°");
    parts.push_back(part);
  }
  return parts;
}

/// A block with a blind hole in its front, one in its top and one in its left side: all places from one corner.
inline std::vector<KnownPart> blocks_with_holes_from_three_sides() {
  struct Side {
    Vec3 corner, u, v;  ///< u x v points out
    Vec2 size, hole;
    double radius = 0, depth = 0;  ///< no hole without a radius
  };
  std::vector<KnownPart> parts;
  for (int i = 0; i < variants; ++i) {
    const double w = 80 + i, d = 50, h = 40, front_depth = 8 + 0.25 * i, top_depth = 7 + 0.25 * i, left_depth = 9;
    const Vec2 front(31 + i, 13 + 0.5 * i), top(54 + 0.5 * i, 17 + 0.5 * i),
        left(29 + 0.25 * i, 24 + 0.25 * i);  // (x, z), (x, y), (y, z)
    const Vec3 x(1, 0, 0), y(0, 1, 0), z(0, 0, 1);
    const std::array sides{Side{Vec3(0), x, z, {w, h}, front, 3, front_depth},
                           Side{h * z, x, y, {w, d}, top, 4, top_depth},
                           Side{d * y, -y, z, {d, h}, {d - left.x, left.y}, 5, left_depth},
                           Side{w * x, y, z, {d, h}, {}},
                           Side{w * x + d * y, -x, z, {w, h}, {}},
                           Side{d * y, x, -y, {w, d}, {}}};
    Model model;
    for (const Side& side : sides) {
      const auto at = [&](const Vec2& p, double below) {
        return side.corner + p.x * side.u + p.y * side.v - below * glm::cross(side.u, side.v);
      };
      const Loop border = square({0, 0}, side.size), rim = circle(side.hole, side.radius, -135);
      std::vector<Vec3> floor;
      for (std::size_t p = 0; p < border.size(); ++p) {
        const std::size_t q = (p + 1) % border.size();
        floor.push_back(side.radius > 0 ? at(rim[p], side.depth) : at(border[p], 0));
        if (side.radius == 0) continue;
        model.face({at(border[p], 0), at(border[q], 0), at(rim[q], 0), at(rim[p], 0)});
        model.face({at(rim[p], 0), at(rim[q], 0), at(rim[q], side.depth), at(rim[p], side.depth)});
      }
      model.face(floor);
    }
    parts.push_back({"holes from three sides " + std::to_string(i),
                     model.obj(),
                     {number(w), "50", "40", "⌀6 ↧" + number(front_depth), "⌀8 ↧" + number(top_depth), "⌀10 ↧9",
                      number(front.x), number(front.y), number(top.x), number(top.y), number(left.x), number(left.y)}});
  }
  return parts;
}

/// A plate with a surface of revolution on it, away from its middle: a profile of (radius, height) from outside
/// inwards.
inline std::string plate_with_round(const Vec2& size, double height, const Vec2& centre, const Loop& profile) {
  Model model;
  const Loop border = square({0, 0}, size);
  const auto strip = [&](const Loop& outer, double high, const Loop& inner, double low) {
    for (std::size_t p = 0; p < outer.size(); ++p) {
      const std::size_t q = (p + 1) % outer.size();
      model.face({Vec3(outer[p], high), Vec3(outer[q], high), Vec3(inner[q], low), Vec3(inner[p], low)});
    }
  };
  const auto ring = [&](const Vec2& p) { return circle(centre, p.x, -135); };
  strip(border, height, ring(profile.front()), profile.front().y);
  for (std::size_t step = 1; step < profile.size(); ++step)
    strip(ring(profile[step - 1]), profile[step - 1].y, ring(profile[step]), profile[step].y);
  if (profile.back().x > 0) model.fan(ring(profile.back()), profile.back().y, true);
  strip(border, 0, border, height);
  std::vector<Vec3> bottom;
  for (const Vec2& p : border) bottom.emplace_back(p, 0);
  model.face({bottom.rbegin(), bottom.rend()});
  return model.obj();
}

/// Half a ball on a plate.
inline std::vector<KnownPart> plates_with_domes() {
  std::vector<KnownPart> parts;
  for (int i = 0; i < variants; ++i) {
    const Vec2 size(70 + i, 46), centre(28 + 0.5 * i, 20);
    const double r = 8 + 0.5 * i, height = 9;
    Loop profile;
    for (int step = 0; step <= k; ++step)
      profile.emplace_back(step == k ? 0 : r * cosine(90.0 * step / k), height + r * sine(90.0 * step / k));
    parts.push_back({"a dome " + std::to_string(i),
                     plate_with_round(size, height, centre, profile),
                     {number(size.x), "46", number(height + r), "9", "SR" + number(r), number(centre.x), "20"}});
  }
  return parts;
}

/// Half a torus on a plate.
inline std::vector<KnownPart> plates_with_beads() {
  std::vector<KnownPart> parts;
  for (int i = 0; i < variants; ++i) {
    const Vec2 size(90 + i, 70), centre(40 + 0.5 * i, 31);
    const double ring = 16 + 0.5 * i, r = 3 + 0.1 * i, height = 12;
    Loop profile;
    for (int step = 0; step <= k; ++step)
      profile.emplace_back(ring + r * cosine(180.0 * step / k), height + r * sine(180.0 * step / k));
    parts.push_back({"a bead " + std::to_string(i),
                     plate_with_round(size, height, centre, profile),
                     {number(size.x), "70", number(height + r), "12", "⌀" + number(2 * ring), "R" + number(r),
                      number(centre.x), "31"}});
  }
  return parts;
}

/// A plate with a rectangular boss that is turned, or with such a pocket.
inline std::vector<KnownPart> plates_with_turned_bosses() {
  std::vector<KnownPart> parts;
  for (int i = 0; i < variants; ++i) {
    const double degrees = 10 + 1.5 * i, w = 20 + 0.25 * i, h = 11 + 0.25 * i, end = i % 2 == 0 ? 26 + i : 9 - 0.25 * i;
    const Vec2 size(80 + i, 54), middle(33 + 0.5 * i, 24);
    const Loop outline = turned(square(middle - Vec2(w, h) / 2.0, {w, h}), middle, degrees);
    Plate plate(15);
    plate.cell(square({0, 0}, size), {{outline, 15}, {outline, end}});
    parts.push_back({(i % 2 == 0 ? "a boss turned by " : "a pocket turned by ") + number(degrees),
                     plate.obj(),
                     {number(size.x), "54", number(end), "15", number(w), number(h), number(degrees) + "°",
                      number(middle.x), "24"}});
  }
  return parts;
}

/// A base with two lugs of one height, the front one with a round end: the size over all is that of the other one.
inline std::vector<KnownPart> bases_with_two_lugs() {
  std::vector<KnownPart> parts;
  for (int i = 0; i < variants; ++i) {
    const double w = 80 + i, base = 11, r = 12 + 0.25 * i, m = 30 + 0.5 * i, up = 36 + 0.5 * i, top = up + r;
    const std::array<double, 4> y{0, 9 + 0.25 * i, 50, 60 + 0.5 * i};
    const Loop round = half_turn({m, up}, r, 0, 180), square_end{{m + r, top}, {m - r, top}};
    Model model;
    const auto at = [](const Vec2& p, double along) { return Vec3(p.x, along, p.y); };
    const auto face = [&](const Loop& loop, double along, bool to_front) {
      std::vector<Vec3> corners;
      for (const Vec2& p : loop) corners.push_back(at(p, along));
      model.face(to_front ? corners : std::vector<Vec3>(corners.rbegin(), corners.rend()));
    };
    const auto lug = [&](const Loop& end) {
      Loop loop{{m + r, base}};
      loop.insert(loop.end(), end.begin(), end.end());
      loop.emplace_back(m - r, base);
      return loop;
    };
    const auto outline = [&](const Loop& end) {
      Loop loop{{0, 0}, {w, 0}, {w, base}};
      const Loop above = lug(end);
      loop.insert(loop.end(), above.begin(), above.end());
      loop.emplace_back(0, base);
      return loop;
    };
    const std::array<Loop, 3> slices{outline(round), outline({}), outline(square_end)};
    for (std::size_t s = 0; s < slices.size(); ++s)
      for (std::size_t p = 0; p < slices[s].size(); ++p) {
        const Vec2 &a = slices[s][p], &b = slices[s][(p + 1) % slices[s].size()];
        model.face({at(b, y[s]), at(a, y[s]), at(a, y[s + 1]), at(b, y[s + 1])});
      }
    face(slices[0], y[0], true);
    face(lug(round), y[1], false);
    face(lug(square_end), y[2], true);
    face(slices[2], y[3], false);
    parts.push_back({"two lugs " + std::to_string(i),
                     model.obj(),
                     {number(w), number(y[3]), number(top), "11", "R" + number(r), number(m), number(up), number(y[1]),
                      number(y[2] - y[1])}});
  }
  return parts;
}

/// A quarter of a turn of a round bar about y, from plane to plane: the sizes over all give its radii.
inline std::vector<KnownPart> bent_bars() {
  std::vector<KnownPart> parts;
  for (int i = 0; i < variants; ++i) {
    const double ring = 30 + i, r = 6 + 0.25 * i;
    const Loop section = circle({ring, 0}, r, 0);
    const auto at = [&](const Vec2& p, int step) {
      const double angle = 90.0 * step / (2 * k);
      return Vec3(p.x * cosine(angle), p.y, p.x * sine(angle));
    };
    Model model;
    for (int step = 0; step < 2 * k; ++step)
      for (std::size_t p = 0; p < section.size(); ++p) {
        const Vec2 &a = section[p], &b = section[(p + 1) % section.size()];
        model.face({at(a, step), at(b, step), at(b, step + 1), at(a, step + 1)});
      }
    std::vector<Vec3> first, last;
    for (const Vec2& p : section) {
      first.insert(first.begin(), at(p, 0));
      last.push_back(at(p, 2 * k));
    }
    model.face(last);
    model.face(first);
    parts.push_back(
        {"a bent bar " + std::to_string(i), model.obj(), {number(ring + r), number(ring + r), number(2 * r)}});
  }
  return parts;
}

}  // namespace epura::test
