// SPDX-License-Identifier: Apache-2.0
// Parts with rectangles turned against the world, conical bosses, open channels, and holes at angles, of known sizes,
// in families.
#pragma once

#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "sloped_parts.hpp"

namespace epura::test {

inline Loop turned(Loop loop, const Vec2& about, double degrees) {
  for (Vec2& p : loop) {
    const Vec2 off = p - about;
    p = about + Vec2(cosine(degrees) * off.x - sine(degrees) * off.y, sine(degrees) * off.x + cosine(degrees) * off.y);
  }
  return loop;
}

/// A plate of 6 with a frustum of a cone on it, away from its middle.
inline std::vector<KnownPart> plates_with_conical_bosses() {
  std::vector<KnownPart> parts;
  for (int i = 0; i < variants; ++i) {
    const double low = 8 + 0.5 * i, high = 4 + 0.25 * i, top = 16 + i;
    const Vec2 size(70 + i, 50), place(25 + i, 19);
    Plate plate(6);
    plate.cell(square({0, 0}, size), {{circle(place, low, -135), 6}, {circle(place, high, -135), top}});
    parts.push_back({"a cone of " + number(2 * low) + " on a plate",
                     plate.obj(),
                     {number(size.x), "50", number(top), "6", "⌀" + number(2 * low), "⌀" + number(2 * high),
                      number(place.x), "19"}});
  }
  return parts;
}

/// Conical tubes; none of their corners lies where they are widest.
inline std::vector<KnownPart> conical_tubes() {
  std::vector<KnownPart> parts;
  for (int i = 0; i < variants; ++i) {
    const double height = 40 + i, outer = 30 + 0.5 * i, wall = 6 + 0.25 * i;
    const auto ring = [](double radius) { return circle({0, 0}, radius, 45.0 / k); };
    const Loop low = ring(outer), high = ring(outer - 14), low_bore = ring(outer - wall), high_bore = ring(outer - 21);
    Model model;
    for (std::size_t p = 0; p < low.size(); ++p) {
      const std::size_t q = (p + 1) % low.size();
      model.face({Vec3(low[p], 0), Vec3(low[q], 0), Vec3(high[q], height), Vec3(high[p], height)});
      model.face({Vec3(low_bore[q], 0), Vec3(low_bore[p], 0), Vec3(high_bore[p], height), Vec3(high_bore[q], height)});
      model.face({Vec3(low[q], 0), Vec3(low[p], 0), Vec3(low_bore[p], 0), Vec3(low_bore[q], 0)});
      model.face(
          {Vec3(high[p], height), Vec3(high[q], height), Vec3(high_bore[q], height), Vec3(high_bore[p], height)});
    }
    parts.push_back({"a conical tube " + std::to_string(i),
                     model.obj(),
                     {number(height), "⌀" + number(2 * outer), "⌀" + number(2 * (outer - 14)),
                      "⌀" + number(2 * (outer - wall)), "⌀" + number(2 * (outer - 21))}});
  }
  return parts;
}

/// A plate with a rectangular hole in its middle that is turned.
inline std::vector<KnownPart> plates_with_turned_holes() {
  std::vector<KnownPart> parts;
  for (int i = 0; i < variants; ++i) {
    const double degrees = i == 0 ? 45 : 10 + 1.5 * i, w = 12, h = 7 + 0.5 * i;
    const Vec2 size(60 + 2 * i, 44), middle = size / 2.0;
    const Loop hole = turned(square(middle - Vec2(w, h) / 2.0, {w, h}), middle, degrees);
    Plate plate(10);
    plate.cell(square({0, 0}, size), {{hole, 10}, {hole, 0}});
    parts.push_back({"a hole turned by " + number(degrees),
                     plate.obj(),
                     {number(size.x), "44", "10", "12", number(h), number(degrees) + "°", number(middle.x), "22"}});
  }
  return parts;
}

/// Two equal ones: one note for each width, and one angle.
inline KnownPart plate_with_two_turned_holes() {
  Plate plate(10);
  for (const double x : {0.0, 50.0}) {
    const Loop hole = turned(square({x + 20, 18}, {10, 8}), {x + 25, 22}, 30);
    plate.cell(square({x, 0}, {50, 44}), {{hole, 10}, {hole, 0}});
  }
  return {"two turned holes", plate.obj(), {"100", "44", "10", "2× 10", "2× 8", "2× 30°", "25", "75", "22"}};
}

/// A block that is turned as a whole: its sides and their angle; the sizes over all follow.
inline std::vector<KnownPart> turned_blocks() {
  std::vector<KnownPart> parts;
  for (int i = 0; i < variants; ++i) {
    const double degrees = 8 + 1.5 * i, w = 50 + i, h = 30;
    parts.push_back(
        {"a block turned by " + number(degrees),
         block(turned({{0, 0}, {w, 0}, {w, h}, {0, h}}, {0, 0}, degrees), 20),
         {"(" + number(w * cosine(degrees) + h * sine(degrees)) + ")",
          "(" + number(w * sine(degrees) + h * cosine(degrees)) + ")", "20", number(w), "30", number(degrees) + "°"}});
  }
  return parts;
}

/// The sizes over all of a rectangle that is turned, in brackets; its corners rounded.
inline std::vector<std::string> sizes_over_turned(const Vec2& size, double degrees, double round = 0) {
  const Vec2 flat = size - Vec2(2 * round);
  return {"(" + number(flat.x * cosine(degrees) + flat.y * sine(degrees) + 2 * round) + ")",
          "(" + number(flat.x * sine(degrees) + flat.y * cosine(degrees) + 2 * round) + ")"};
}

/// A plate that is turned as a whole, with a round hole and a rectangular one: places along its own axes, one angle.
/// Where both are at one height, that is one place.
inline std::vector<KnownPart> turned_plates(bool in_line) {
  std::vector<KnownPart> parts;
  for (int i = 0; i < variants; ++i) {
    const double degrees = 6 + 1.75 * i, r = 3 + 0.25 * i;
    const Vec2 size(30, 36 + 0.5 * i), place(13, in_line ? 20 : 14 + 0.45 * i), window(46 + 0.25 * i, 20),
        opening(12, 9 + 0.25 * i);
    const auto turn = [&](const Loop& loop) { return turned(loop, {0, 0}, degrees); };
    const Loop hole = turn(circle(place, r, -135)), corners = turn(square(window - opening / 2.0, opening));
    Plate plate(10);
    plate.cell(turn(square({0, 0}, size)), {{hole, 10}, {hole, 0}});
    plate.cell(turn(square({30, 0}, size)), {{corners, 10}, {corners, 0}});
    KnownPart part{"a plate turned by " + number(degrees), plate.obj(), sizes_over_turned({60, size.y}, degrees)};
    for (const std::string& text :
         {std::string("10"), std::string("60"), number(size.y), number(degrees) + "°", "⌀" + number(2 * r),
          number(place.x), number(opening.x), number(opening.y), number(window.x), std::string("20")})
      part.texts.push_back(text);
    if (!in_line) part.texts.push_back(number(place.y));
    parts.push_back(part);
  }
  return parts;
}

inline std::vector<KnownPart> turned_plates_with_two_heights() { return turned_plates(false); }
inline std::vector<KnownPart> turned_plates_with_one_height() { return turned_plates(true); }

/// The same with rounded corners and without holes.
inline std::vector<KnownPart> turned_rounded_plates() {
  std::vector<KnownPart> parts;
  for (int i = 0; i < variants; ++i) {
    const double degrees = 7 + 1.75 * i, r = 4 + 0.2 * i, w = 60 + i, h = 34;
    KnownPart part{"a rounded plate turned by " + number(degrees),
                   block(turned(rounded({{0, 0}, {w, 0}, {w, h}, {0, h}}, {r, r, r, r}), {0, 0}, degrees), 9),
                   sizes_over_turned({w, h}, degrees, r)};
    for (const std::string& text : {std::string("9"), number(w), number(h), number(degrees) + "°", "4× R" + number(r)})
      part.texts.push_back(text);
    parts.push_back(part);
  }
  return parts;
}

/// A plate with one or two hexagonal holes that are turned: their angle to the nearest axis.
inline std::vector<KnownPart> turned_hexagons() {
  std::vector<KnownPart> parts;
  for (int i = 0; i < variants; ++i) {
    const double degrees = i < 9 ? 3 + 1.25 * i : 16 + i - 9, flats = 12 + 0.25 * i;
    const int count = 1 + i % 2;
    Plate plate(8);
    for (int one = 0; one < count; ++one) {
      const Vec2 centre(40.0 * one + 20, 18);
      const auto corner = [&](int at) {
        const double angle = degrees - 120 + 60 * at;
        return centre + flats / std::sqrt(3) * Vec2(cosine(angle), sine(angle));
      };
      Loop hole;
      constexpr int side = 4 * k / 6;
      for (int j = 0; j < 4 * k; ++j)
        hole.push_back(corner(j / side) + double(j % side) / side * (corner(j / side + 1) - corner(j / side)));
      plate.cell(square({40.0 * one, 0}, {40, 40}), {{hole, 8}, {hole, 0}});
    }
    const std::string times = count > 1 ? "2× " : "";
    KnownPart part{"a hexagon turned by " + number(degrees),
                   plate.obj(),
                   {number(40 * count), "40", "8", times + number(flats),
                    times + number(std::min(degrees, 30 - degrees)) + "°", "20", "18"}};
    if (count > 1) part.texts.push_back("60");
    parts.push_back(part);
  }
  return parts;
}

/// A block with an open round channel in its top, whose axis is in the top or above it.
inline std::vector<KnownPart> channels() {
  std::vector<KnownPart> parts;
  for (int i = 0; i < variants; ++i) {
    const double m = 25 + i, r = 7 + 0.5 * i, above = i % 2 == 0 ? 0 : 0.4 * r;
    Loop outline{{0, 0}, {70, 0}, {70, 20}};
    const double end = std::asin(above / r) * 180 / std::numbers::pi;
    for (int step = 0; step <= 2 * k; ++step) {
      const double angle = -end - (180 - 2 * end) * step / (2 * k);
      outline.push_back(Vec2(m, 20 + above) + r * Vec2(cosine(angle), sine(angle)));
    }
    outline.emplace_back(0, 20);
    KnownPart part{
        "a channel " + std::to_string(i), block(outline, 30), {"70", "20", "30", number(m), "R" + number(r)}};
    if (above > 0) part.texts.push_back(number(20 + above));
    parts.push_back(part);
  }
  return parts;
}

/// A ring about z with a hole at each angle.
inline std::string ring_with_holes(const std::vector<double>& angles, double pitch, double radius) {
  constexpr double inner = 15, outer = 50, thickness = 8;
  Plate plate(thickness);
  const std::size_t count = angles.size();
  const auto at = [](double r, double angle) { return r * Vec2(cosine(angle), sine(angle)); };
  for (std::size_t s = 0; s < count; ++s) {
    const double middle = angles[s];
    const double from = (middle + angles[(s + count - 1) % count] - (s == 0 ? 360 : 0)) / 2,
                 to = (middle + angles[(s + 1) % count] + (s + 1 == count ? 360 : 0)) / 2;
    Loop outline;
    for (int i = 0; i < k; ++i) outline.push_back(at(outer, from + (to - from) * i / k));
    for (int i = 0; i < k; ++i) outline.push_back(at(outer + (inner - outer) * i / k, to));
    for (int i = 0; i < k; ++i) outline.push_back(at(inner, to + (from - to) * i / k));
    for (int i = 0; i < k; ++i) outline.push_back(at(inner + (outer - inner) * i / k, from));
    const Loop hole = circle(at(pitch, middle), radius, middle - 45);
    plate.cell(outline, {{hole, thickness}, {hole, 0}});
  }
  return plate.obj();
}

/// Unevenly spaced holes on a pitch circle: those at one angle from the axes have one dimension.
inline std::vector<KnownPart> uneven_pitch_circles() {
  std::vector<KnownPart> parts;
  const auto add = [&](const std::vector<double>& angles, const std::vector<std::string>& texts) {
    std::vector<std::string> all{"⌀100", "⌀30", "8", std::to_string(angles.size()) + "× ⌀8", "⌀70"};
    all.insert(all.end(), texts.begin(), texts.end());
    parts.push_back({"holes at " + number(angles.front()), ring_with_holes(angles, 35, 4), all});
  };
  for (int i = 0; i < variants - 2; ++i) {
    const double a = 18.5 + i;
    add({a, 180 - a, 270}, {"2× " + number(a) + "°"});
  }
  add({30, 60, 120, 150, 210, 240, 300, 330}, {"8× 30°"});
  add({10, 90, 200}, {"10°", "20°"});
  return parts;
}

/// A plate with half a sphere cut into its top.
inline std::vector<KnownPart> plates_with_dimples() {
  std::vector<KnownPart> parts;
  constexpr int rings = 12;
  for (int i = 0; i < variants; ++i) {
    const Vec2 size(60 + 2 * i, 40), centre(22 + i, 18);
    const double height = 15, radius = 5 + 0.5 * i;
    const Loop border = square({0, 0}, size), round = circle({0, 0}, radius, -135);
    const auto at = [&](int ring, std::size_t point) {
      const double angle = 90.0 * ring / rings;
      return Vec3(centre + cosine(angle) * round[point], height - radius * sine(angle));
    };
    Model model;
    std::vector<Vec3> bottom;
    for (std::size_t p = 0; p < border.size(); ++p) {
      const std::size_t q = (p + 1) % border.size();
      model.face({Vec3(border[p], height), Vec3(border[q], height), at(0, q), at(0, p)});
      for (int ring = 0; ring < rings; ++ring) model.face({at(ring, p), at(ring, q), at(ring + 1, q), at(ring + 1, p)});
      model.face({Vec3(border[q], height), Vec3(border[p], height), Vec3(border[p], 0), Vec3(border[q], 0)});
      bottom.insert(bottom.begin(), Vec3(border[p], 0));
    }
    model.face(bottom);
    parts.push_back({"a dimple " + std::to_string(i),
                     model.obj(),
                     {number(size.x), "40", "15", "SR" + number(radius), number(centre.x), "18"}});
  }
  return parts;
}

/// Hexagonal bars with a chamfer at all six edges of one end.
inline std::vector<KnownPart> chamfered_hexagons() {
  std::vector<KnownPart> parts;
  for (int i = 0; i < variants; ++i) {
    const double flats = 30 + i, height = 25, leg = 2 + 0.25 * i;
    const auto outline = [](double across) {
      Loop loop;
      for (int corner = 0; corner < 6; ++corner)
        loop.push_back(across / std::sqrt(3) * Vec2(cosine(60 * corner), sine(60 * corner)));
      return loop;
    };
    Model model;
    const Loop outer = outline(flats), inner = outline(flats - 2 * leg);
    const auto wall = [&](const Loop& above, double z, const Loop& below, double low) {
      model.strip({above.rbegin(), above.rend()}, z, {below.rbegin(), below.rend()}, low);
    };
    wall(inner, height, outer, height - leg);
    wall(outer, height - leg, outer, 0);
    std::vector<Vec3> top, bottom;
    for (const Vec2& p : inner) top.emplace_back(p, height);
    for (const Vec2& p : outer) bottom.insert(bottom.begin(), Vec3(p, 0));
    model.face(top);
    model.face(bottom);
    parts.push_back(
        {"a chamfered hexagon " + std::to_string(i),
         model.obj(),
         {"(" + number(2 * flats / std::sqrt(3)) + ")", number(flats), "25", "6× " + number(leg) + "×45°"}});
  }
  return parts;
}

/// A wedge with holes of two sizes side by side: their places along the slope once.
inline std::vector<KnownPart> wedges_with_pairs() {
  std::vector<KnownPart> parts;
  for (int i = 0; i < variants; ++i) {
    const double length = 60 + 3 * i, degrees = 12 + 0.5 * i;
    const int count = 1 + i % 2;
    KnownPart part{"pairs in a slope of " + number(degrees), wedge_with_holes(length, degrees, count, 8, {3, 2.5}), {}};
    const std::string many = count > 1 ? number(count) + "× " : "";
    part.texts = {number(length * cosine(degrees)),
                  "48",
                  "(" + number(18 + length * sine(degrees)) + ")",
                  number(90 - degrees) + "°",
                  "18",
                  "12",
                  "36",
                  many + "⌀6 ↧8",
                  many + "⌀5 ↧8",
                  number(length / count / 2)};
    if (count == 2) part.texts.push_back(number(length * 0.75));
    parts.push_back(part);
  }
  return parts;
}

/// A hollow pyramid of `n` sides on a round foot, from each of which a hole goes to the axis: its wall `t` thick, its
/// outer sides at a distance from the origin, their normals up by so many degrees.
inline std::string pyramid_with_holes(int n, double up, double distance, double t, double hole) {
  const double height = 14, foot = 6, outside = 60, bore = 5;
  Model model;
  const auto at = [](double r, double degrees, double z) { return Vec3(r * cosine(degrees), r * sine(degrees), z); };
  const auto round = [&](double r, double z, int j) { return at(r, 360.0 * j / (n * k) - 180.0 / n, z); };
  const auto corner = [&](double off, double z, int side) {
    return at((off - z * sine(up)) / cosine(up) / cosine(180.0 / n), 360.0 * side / n - 180.0 / n, z);
  };
  const auto edge = [&](double off, double z, int j) {
    const Vec3 from = corner(off, z, j / k), to = corner(off, z, j / k + 1);
    return from + double(j % k) / k * (to - from);
  };
  const auto ring = [&](const auto& a, const auto& b) {
    for (int j = 0; j < n * k; ++j) model.face({a(j), a(j + 1), b(j + 1), b(j)});
  };
  const auto circle_of = [&](double r, double z) { return [&round, r, z](int j) { return round(r, z, j); }; };
  const auto polygon = [&](double off, double z) { return [&edge, off, z](int j) { return edge(off, z, j); }; };
  const double inner = distance - t;
  ring(circle_of(outside, -foot), circle_of(outside, 0));
  ring(circle_of(outside, 0), polygon(distance, 0));
  ring(polygon(inner, 0), circle_of(bore, 0));
  ring(circle_of(bore, 0), circle_of(bore, -foot));
  ring(circle_of(bore, -foot), circle_of(outside, -foot));
  ring(polygon(distance, height), polygon(inner, height));
  for (int side = 0; side < n; ++side) {
    const double turn = 360.0 * side / n, middle = height / 2;
    const Vec3 normal = at(cosine(up), turn, sine(up)), aside = at(1, turn + 90, 0), along = glm::cross(normal, aside),
               centre = at((distance - middle * sine(up)) / cosine(up), turn, middle);
    const auto outline = [&](double off) {
      const std::array corners{corner(off, 0, side), corner(off, 0, side + 1), corner(off, height, side + 1),
                               corner(off, height, side)};
      std::vector<Vec3> points;
      for (int i = 0; i < 4 * k; ++i)
        points.push_back(corners[i / k] + double(i % k) / k * (corners[(i / k + 1) % 4] - corners[i / k]));
      return points;
    };
    const auto rim = [&](double down) {
      std::vector<Vec3> points;
      for (const Vec2& p : circle({0, 0}, hole / 2, -135))
        points.push_back(centre - down * normal + p.x * aside + p.y * along);
      return points;
    };
    const std::vector<Vec3> out = outline(distance), in = outline(inner), mouth = rim(0), end = rim(t);
    for (std::size_t i = 0; i < out.size(); ++i) {
      const std::size_t j = (i + 1) % out.size();
      model.face({out[i], out[j], mouth[j], mouth[i]});
      model.face({mouth[i], mouth[j], end[j], end[i]});
      model.face({end[i], end[j], in[j], in[i]});
    }
  }
  return model.obj();
}

}  // namespace epura::test
