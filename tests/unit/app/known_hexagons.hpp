// SPDX-License-Identifier: Apache-2.0
// Nuts, bolts and sockets whose dimensions are known.
#pragma once

#include "known_parts.hpp"

namespace epura::test {

// Counterclockwise, `4 * k` points, beginning in a corner in direction `begin`.
inline Loop hexagon(double across_flats, double begin = 0) {
  const double reach = across_flats / std::numbers::sqrt3;
  const auto corner = [&](int i) { return reach * Vec2(cosine(begin + 60 * i), sine(begin + 60 * i)); };
  Loop loop;
  constexpr int side = 4 * k / 6;
  for (int i = 0; i < 6; ++i)
    for (int j = 0; j < side; ++j) loop.push_back(corner(i) + (corner(i + 1) - corner(i)) * (double(j) / side));
  return loop;
}

inline std::string nut(double begin) {
  Plate plate(8);
  const Loop bore = circle({0, 0}, 5, begin);
  plate.cell(hexagon(18, begin), {{bore, 8}, {bore, 0}});
  return plate.obj();
}

// The corners of its upper end are cut off by a cone of 30 degrees.
inline std::string chamfered_nut() {
  Model model;
  const Loop outline = hexagon(18), rim = circle({0, 0}, 8.5, 0), bore = circle({0, 0}, 5, 0);
  const auto top = [](const Vec2& p) { return Vec3(p, 8 - (glm::length(p) - 8.5) * std::tan(std::numbers::pi / 6)); };
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const std::size_t j = (i + 1) % outline.size();
    // On the cone, straight lines run towards its tip.
    const Vec2 a = 8.5 * glm::normalize(outline[i]), b = 8.5 * glm::normalize(outline[j]);
    model.face({Vec3(a, 8), top(outline[i]), top(outline[j])});
    model.face({Vec3(a, 8), top(outline[j]), Vec3(b, 8)});
    model.face({top(outline[i]), Vec3(outline[i], 0), Vec3(outline[j], 0), top(outline[j])});
    model.face({Vec3(bore[i], 8), Vec3(a, 8), Vec3(b, 8), Vec3(bore[j], 8)});
    model.face({Vec3(bore[j], 0), Vec3(outline[j], 0), Vec3(outline[i], 0), Vec3(bore[i], 0)});
    model.face({Vec3(bore[j], 8), Vec3(bore[j], 0), Vec3(bore[i], 0), Vec3(bore[i], 8)});
  }
  return model.obj();
}

// A head on a shank of diameter 10 and length 30, with a socket of width 8 and depth 5 or without.
inline std::string bolt(const Loop& head, double height, bool has_socket) {
  Model model;
  const Loop shank = circle({0, 0}, 5, 0);
  model.fan(shank, 0, false);
  model.strip(shank, 30, shank, 0);
  model.strip(head, 30, shank, 30);
  model.strip(head, 30 + height, head, 30);
  if (!has_socket) {
    model.fan(head, 30 + height, true);
    return model.obj();
  }
  const Loop socket = hexagon(8);
  model.strip(socket, 30 + height, head, 30 + height);
  model.strip({socket.rbegin(), socket.rend()}, 30 + height, {socket.rbegin(), socket.rend()}, 25 + height);
  model.fan(socket, 25 + height, true);
  return model.obj();
}

inline std::string two_bosses() {
  Model model;
  for (const double x : {0.0, 40.0}) {
    Loop boss = hexagon(18), cell = square({x - 20, -20}, {40, 40});
    for (Vec2& p : boss) p.x += x;
    // A square begins in direction -135 degrees, between two corners of the hexagon.
    std::rotate(boss.begin(), boss.begin() + 30, boss.end());
    model.strip(boss, 12, cell, 12);
    model.strip(boss, 20, boss, 12);
    model.fan(boss, 20, true);
    model.fan(cell, 0, false);
  }
  const auto wall = [&](const Vec2& a, const Vec2& b) {
    for (int i = 0; i < k; ++i) {
      const Vec2 from = a + (b - a) * (double(i) / k), to = a + (b - a) * (double(i + 1) / k);
      model.face({Vec3(from, 12), Vec3(from, 0), Vec3(to, 0), Vec3(to, 12)});
    }
  };
  wall({-20, -20}, {20, -20}), wall({20, -20}, {60, -20}), wall({60, -20}, {60, 20});
  wall({60, 20}, {20, 20}), wall({20, 20}, {-20, 20}), wall({-20, 20}, {-20, -20});
  return model.obj();
}

// 18 / cos 30° = 20.78. With a corner 10 degrees from the x axis, the largest cosines are those of 10 and 20 degrees.
inline std::vector<KnownPart> hexagons() {
  return {{"a nut", nut(0), {"(20.78)", "18", "8", "⌀10"}},
          {"a nut turned by 30 degrees", nut(30), {"18", "(20.78)", "8", "⌀10"}},
          {"a nut turned by 10 degrees", nut(10), {"(20.47)", "(19.53)", "18", "8", "⌀10", "10°"}},
          {"a chamfered nut", chamfered_nut(), {"(20.78)", "18", "8", "⌀10", "⌀17", "6.91"}},
          {"a bolt", bolt(hexagon(18), 7, false), {"(20.78)", "18", "37", "⌀10", "30"}},
          {"a socket screw", bolt(circle({0, 0}, 8, 0), 10, true), {"40", "⌀16", "⌀10", "30", "35", "8"}},
          {"two bosses", two_bosses(), {"80", "40", "20", "2× 18", "20", "60", "20", "12"}}};
}

}  // namespace epura::test
