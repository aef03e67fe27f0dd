// SPDX-License-Identifier: Apache-2.0
// Parts whose features, and therefore dimensions, are known: plates with holes, turned parts, prisms.
#pragma once

#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <numbers>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "base/text.hpp"
#include "base/vec.hpp"

namespace epura::test {

using Loop = std::vector<Vec2>;

inline constexpr int k = 12;  // points on a side of a cell; its hole has four times as many

inline double cosine(double degrees) { return std::cos(degrees * std::numbers::pi / 180); }
inline double sine(double degrees) { return std::sin(degrees * std::numbers::pi / 180); }

inline Loop circle(const Vec2& centre, double radius, double begin) {
  Loop loop;
  for (int i = 0; i < 4 * k; ++i) {
    const double angle = begin + 90.0 * i / k;
    loop.push_back(centre + radius * Vec2(cosine(angle), sine(angle)));
  }
  return loop;
}

// Along x, the distance of the centres of its ends is `length`.
inline Loop slot(const Vec2& centre, double radius, double length) {
  Loop loop;
  for (int i = 0; i < 4 * k; ++i) {
    // Two half circles of 2k - 1 steps each, joined by straight lines.
    const int half = i / (2 * k), step = i % (2 * k);
    const double angle = -90 + 180.0 * half + 180.0 * step / (2 * k - 1);
    loop.push_back(centre + Vec2(half == 0 ? length / 2 : -length / 2, 0) + radius * Vec2(cosine(angle), sine(angle)));
  }
  return loop;
}

/// An OBJ file, turned about z by degrees.
inline std::string turned_about_z(const std::string& obj, double angle) {
  std::istringstream lines(obj);
  std::string turned;
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    std::string key;
    Vec3 p{0};
    if (words >> key >> p.x >> p.y >> p.z; key == "v")
      line = "v " + format_number(cosine(angle) * p.x - sine(angle) * p.y) + " " +
             format_number(sine(angle) * p.x + cosine(angle) * p.y) + " " + format_number(p.z);
    turned += line + "\n";
  }
  return turned;
}

/// Polygons with shared corners, written as OBJ.
class Model {
 public:
  int at(const Vec3& p) {
    const std::array<long long, 3> key{std::llround(p.x * 1e7), std::llround(p.y * 1e7), std::llround(p.z * 1e7)};
    const auto [place, made] = numbers_.try_emplace(key, static_cast<int>(points_.size()) + 1);
    if (made) points_.push_back(p);
    return place->second;
  }
  void face(std::vector<Vec3> corners) {
    std::vector<int> face;
    for (const Vec3& p : corners) {
      const int number = at(p);
      if (face.empty() || (face.back() != number && face.front() != number)) face.push_back(number);
    }
    if (face.size() > 2) faces_.push_back(face);
  }
  void strip(const Loop& above, double z, const Loop& below, double low) {
    for (std::size_t i = 0; i < above.size(); ++i) {
      const std::size_t j = (i + 1) % above.size();
      face({Vec3(above[i], z), Vec3(below[i], low), Vec3(below[j], low), Vec3(above[j], z)});
    }
  }
  void fan(const Loop& loop, double z, bool up) {
    Vec2 middle(0);
    for (const Vec2& p : loop) middle += p / double(loop.size());
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const Vec3 a(loop[i], z), b(loop[(i + 1) % loop.size()], z);
      face(up ? std::vector{Vec3(middle, z), a, b} : std::vector{Vec3(middle, z), b, a});
    }
  }
  [[nodiscard]] std::string obj() const {
    std::string text;
    for (const Vec3& p : points_)
      text += "v " + format_number(p.x) + " " + format_number(p.y) + " " + format_number(p.z) + "\n";
    for (const auto& face : faces_) {
      text += "f";
      for (const int number : face) text += " " + std::to_string(number);
      text += "\n";
    }
    return text;
  }

 private:
  std::map<std::array<long long, 3>, int> numbers_;
  std::vector<Vec3> points_;
  std::vector<std::vector<int>> faces_;
};

/// A hole from above: loops and their heights, downwards; the last one is at 0 if the hole goes through.
using Hole = std::vector<std::pair<Loop, double>>;

/// A plate of cells, each with a hole in it or none.
class Plate {
 public:
  explicit Plate(double thickness) : thickness_(thickness) {}

  void cell(const Loop& outline, const Hole& hole) {
    for (std::size_t i = 0; i < outline.size(); ++i) edges_.push_back({outline[i], outline[(i + 1) % outline.size()]});
    if (hole.empty()) {
      model_.fan(outline, thickness_, true);
      model_.fan(outline, 0, false);
      return;
    }
    const Loop& mouth = hole.front().first;
    for (std::size_t i = 0; i < outline.size(); ++i) {
      const std::size_t j = (i + 1) % outline.size();
      model_.face({Vec3(outline[i], thickness_), Vec3(outline[j], thickness_), Vec3(mouth[j], thickness_),
                   Vec3(mouth[i], thickness_)});
      if (hole.back().second == 0)
        model_.face(
            {Vec3(outline[j], 0), Vec3(outline[i], 0), Vec3(hole.back().first[i], 0), Vec3(hole.back().first[j], 0)});
    }
    for (std::size_t l = 1; l < hole.size(); ++l)
      model_.strip(reversed(hole[l - 1].first), hole[l - 1].second, reversed(hole[l].first), hole[l].second);
    if (hole.back().second == 0) return;
    model_.fan(hole.back().first, hole.back().second, true);
    model_.fan(outline, 0, false);
  }

  // Adds walls where a cell has no neighbour.
  std::string obj() {
    std::map<std::array<long long, 4>, int> count;
    const auto key = [](const Vec2& a, const Vec2& b) {
      return std::array{std::llround(a.x * 1e7), std::llround(a.y * 1e7), std::llround(b.x * 1e7),
                        std::llround(b.y * 1e7)};
    };
    for (const auto& [a, b] : edges_) ++count[key(a, b)];
    for (const auto& [a, b] : edges_)
      if (count.find(key(b, a)) == count.end())
        model_.face({Vec3(a, thickness_), Vec3(a, 0), Vec3(b, 0), Vec3(b, thickness_)});
    return model_.obj();
  }

 private:
  static Loop reversed(const Loop& loop) { return {loop.rbegin(), loop.rend()}; }

  double thickness_;
  Model model_;
  std::vector<std::pair<Vec2, Vec2>> edges_;
};

// With twelve sides; beginning like a square.
inline Loop cross_outline(const Vec2& centre, double reach, double half_width) {
  Loop loop;
  for (int quarter = 0; quarter < 4; ++quarter) {
    const Vec2 along(cosine(90.0 * quarter), sine(90.0 * quarter)), left(-along.y, along.x);
    const std::array corners{-half_width * (along + left), -half_width * along - reach * left,
                             half_width * along - reach * left, half_width * (along - left)};
    for (int side = 0; side < 3; ++side)
      for (int i = 0; i < k / 3; ++i)
        loop.push_back(centre + corners[side] + (corners[side + 1] - corners[side]) * (3.0 * i / k));
  }
  return loop;
}

// Counterclockwise, beginning in direction -135 degrees from its middle.
inline Loop square(const Vec2& low, const Vec2& size) {
  const std::array corners{low, low + Vec2(size.x, 0), low + size, low + Vec2(0, size.y)};
  Loop loop;
  for (int side = 0; side < 4; ++side)
    for (int i = 0; i < k; ++i)
      loop.push_back(corners[side] + (corners[(side + 1) % 4] - corners[side]) * (double(i) / k));
  return loop;
}

/// The same hole in the middle of each of nx times ny cells.
inline std::string plate(const Vec2& size, int nx, int ny, double thickness,
                         const std::function<Hole(const Vec2&)>& hole) {
  Plate plate(thickness);
  for (int x = 0; x < nx; ++x)
    for (int y = 0; y < ny; ++y) {
      const Vec2 low(x * size.x, y * size.y);
      plate.cell(square(low, size), hole(low + size / 2.0));
    }
  return plate.obj();
}

inline std::function<Hole(const Vec2&)> stepped_hole(const std::vector<Vec2>& radius_and_height) {
  return [=](const Vec2& centre) {
    Hole hole;
    for (const Vec2& p : radius_and_height) hole.emplace_back(circle(centre, p.x, -135), p.y);
    return hole;
  };
}

/// A ring of `count` sectors with a hole in each of them.
inline std::string flange(int count, const std::array<double, 4>& inner_outer_pitch_hole, double thickness) {
  const auto [inner, outer, pitch, radius] = inner_outer_pitch_hole;
  Plate plate(thickness);
  for (int s = 0; s < count; ++s) {
    const double from = 360.0 * s / count, to = 360.0 * (s + 1) / count, middle = (from + to) / 2;
    const auto at = [](double r, double angle) { return r * Vec2(cosine(angle), sine(angle)); };
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

/// A profile of (x, radius) around the x axis, from end to end.
inline std::string shaft(const std::vector<Vec2>& profile) {
  Model model;
  const auto ring = [](const Vec2& p) {
    std::vector<Vec3> points;
    for (int i = 0; i < 4 * k; ++i) points.emplace_back(p.x, p.y * cosine(90.0 * i / k), p.y * sine(90.0 * i / k));
    return points;
  };
  for (std::size_t s = 1; s < profile.size(); ++s) {
    const auto a = ring(profile[s - 1]), b = ring(profile[s]);
    for (std::size_t i = 0; i < a.size(); ++i) {
      const std::size_t j = (i + 1) % a.size();
      model.face({a[i], b[i], b[j], a[j]});
    }
  }
  return model.obj();
}

/// A prism along y over a counterclockwise outline in x and z.
inline std::string block(const Loop& outline, double depth) {
  Model model;
  std::vector<Vec3> front, back;
  for (const Vec2& p : outline) {
    front.emplace_back(p.x, 0, p.y);
    back.emplace_back(p.x, depth, p.y);
  }
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const std::size_t j = (i + 1) % outline.size();
    model.face({front[j], front[i], back[i], back[j]});
  }
  model.face(front);
  model.face({back.rbegin(), back.rend()});
  return model.obj();
}

/// A block whose top is a surface of free form: waves that are flat at the edges.
inline std::string waves() {
  constexpr int steps = 24;
  Model model;
  const auto at = [](int x, int y) {
    const double u = double(x) / steps, v = double(y) / steps;
    const double edge = 256 * u * u * (1 - u) * (1 - u) * v * v * (1 - v) * (1 - v);
    return Vec3(60 * u, 40 * v, 20 + 6 * edge * (1 + sine(360 * u + 200 * v)));
  };
  const auto below = [](const Vec3& p) { return Vec3(p.x, p.y, 0); };
  for (int x = 0; x < steps; ++x) {
    for (int y = 0; y < steps; ++y) {
      model.face({at(x, y), at(x + 1, y), at(x + 1, y + 1)});
      model.face({at(x, y), at(x + 1, y + 1), at(x, y + 1)});
    }
    model.face({below(at(x, 0)), below(at(x + 1, 0)), at(x + 1, 0), at(x, 0)});
    model.face({below(at(x + 1, steps)), below(at(x, steps)), at(x, steps), at(x + 1, steps)});
    model.face({below(at(0, x + 1)), below(at(0, x)), at(0, x), at(0, x + 1)});
    model.face({below(at(steps, x)), below(at(steps, x + 1)), at(steps, x + 1), at(steps, x)});
  }
  std::vector<Vec3> bottom;
  for (int x = 0; x < steps; ++x) bottom.push_back(below(at(x, steps)));
  for (int y = steps; y > 0; --y) bottom.push_back(below(at(steps, y)));
  for (int x = steps; x > 0; --x) bottom.push_back(below(at(x, 0)));
  for (int y = 0; y < steps; ++y) bottom.push_back(below(at(0, y)));
  model.face(bottom);
  return model.obj();
}

inline Loop rounded_rectangle(const Vec2& size, double radius) {
  Loop loop;
  const std::array centres{Vec2(size.x - radius, radius), size - radius, Vec2(radius, size.y - radius), Vec2(radius)};
  for (int corner = 0; corner < 4; ++corner)
    for (int i = 0; i <= k; ++i) {
      const double angle = -90 + 90.0 * corner + 90.0 * i / k;
      loop.push_back(centres[corner] + radius * Vec2(cosine(angle), sine(angle)));
    }
  return loop;
}

// Legs of 12 with a fillet of 8 between them.
inline Loop angle() {
  Loop outline{{0, 0}, {60, 0}, {60, 12}};
  for (int i = 0; i <= k; ++i) outline.push_back(Vec2(20) - 8.0 * Vec2(sine(90.0 * i / k), cosine(90.0 * i / k)));
  outline.insert(outline.end(), {{12, 50}, {0, 50}});
  return outline;
}

// Crosses; wide ones are longer than a letter, as letters that touch are.
inline std::string letters(int count, double width = 1) {
  return plate({60, 60}, count, 1, 20, [width](const Vec2& c) {
    Loop outline = cross_outline(c, 8, 2);
    for (Vec2& p : outline) p.x = c.x + width * (p.x - c.x);
    return Hole{{outline, 20}, {outline, 18}};
  });
}

// 30 holes, no two of which are in line.
inline std::string irregular_plate() {
  int number = 0;
  return plate({26, 20}, 6, 5, 10, [&number](const Vec2& c) {
    const int i = number++;
    return stepped_hole({{2, 10}, {2, 0}})(c + Vec2(0.9 * (i % 5) - 1.9, 1.1 * (i / 5) - 2.7));
  });
}

// A cylinder with a rounded edge.
inline std::vector<Vec2> rounded_pin(double radius, double edge, double length) {
  std::vector<Vec2> profile{{0, 1e-9}, {0, radius}};
  for (int i = 0; i <= k; ++i)
    profile.emplace_back(length - edge + edge * sine(90.0 * i / k), radius - edge + edge * cosine(90.0 * i / k));
  profile.emplace_back(length, 1e-9);
  return profile;
}

// Adds a ball of radius 15 to a profile that ends at radius 10.
inline std::vector<Vec2> with_ball(std::vector<Vec2> profile) {
  const double centre = profile.back().x + std::sqrt(125), begin = std::acos(-std::sqrt(125) / 15) * 180 / M_PI;
  for (int i = k - 1; i >= 0; --i)
    profile.emplace_back(centre + 15 * cosine(begin * i / k), std::max(15 * sine(begin * i / k), 1e-9));
  return profile;
}

// Steps of 5, each 4 deep.
inline Loop stairs(int count) {
  Loop outline{{0, 0}, {5.0 * count, 0}};
  for (int i = count; i > 0; --i) {
    outline.emplace_back(5.0 * i, 4.0 * (count - i + 1));
    outline.emplace_back(5.0 * (i - 1), 4.0 * (count - i + 1));
  }
  return outline;
}

struct KnownPart {
  std::string name, obj;
  std::vector<std::string> texts;  ///< all its dimensions
  std::string lacks{};             ///< how lint counts what they leave open
  std::string view{};              ///< one that shows it, beside those from the front, the top and the left
};

// Four holes of different kinds.
inline std::string mixed_plate() {
  Plate plate(20);
  const auto cell = [&](double x, const Hole& hole) { plate.cell(square({x, 0}, {40, 40}), hole); };
  cell(0, stepped_hole({{4, 20}, {4, 0}})({20, 20}));
  cell(40, {{slot({60, 20}, 5, 12), 20}, {slot({60, 20}, 5, 12), 0}});
  cell(80, stepped_hole({{7, 20}, {7, 14}, {4.5, 14}, {4.5, 0}})({100, 20}));
  cell(120, stepped_hole({{6, 20}, {3, 17}, {3, 0}})({140, 20}));
  return plate.obj();
}

inline std::vector<KnownPart> plates() {
  const auto drilled = [](double r, double top) { return stepped_hole({{r, top}, {r, 0}}); };
  return {
      {"one hole", plate({50, 30}, 1, 1, 8, drilled(5, 8)), {"50", "30", "8", "⌀10", "25", "15"}},
      {"four holes", plate({40, 30}, 2, 2, 10, drilled(4, 10)), {"80", "60", "10", "4× ⌀8", "20", "60", "15", "45"}},
      {"a row", plate({20, 30}, 4, 1, 5, drilled(3, 5)), {"80", "30", "5", "4× ⌀6", "10", "3× 20 (=60)", "15"}},
      {"a grid",
       plate({20, 24}, 3, 3, 6, drilled(2.5, 6)),
       {"60", "72", "6", "9× ⌀5", "10", "2× 20 (=40)", "12", "2× 24 (=48)"}},
      {"blind",
       plate({40, 40}, 2, 1, 25, stepped_hole({{4, 25}, {4, 7}})),
       {"80", "40", "25", "2× ⌀8 ↧18", "20", "60", "20"}},
      {"drill points",
       plate({40, 40}, 1, 2, 30, stepped_hole({{5, 30}, {5, 12}, {1e-9, 9}})),
       {"40", "80", "30", "2× ⌀10 ↧18", "20", "20", "60"}},
      {"counterbores",
       plate({40, 30}, 2, 2, 20, stepped_hole({{5.5, 20}, {5.5, 13.5}, {3.3, 13.5}, {3.3, 0}})),
       {"80", "60", "20", "4× ⌀6.6 ⌴⌀11 ↧6.5", "20", "60", "15", "45"}},
      {"countersinks",
       plate({30, 30}, 3, 1, 12, stepped_hole({{6, 12}, {3, 9}, {3, 0}})),
       {"90", "30", "12", "3× ⌀6 ⌵⌀12×90°", "15", "2× 30 (=60)", "15"}},
      {"a slot",
       plate({60, 40}, 1, 1, 8,
             [](const Vec2& c) {
               return Hole{{slot(c, 5, 20), 8}, {slot(c, 5, 20), 0}};
             }),
       {"60", "40", "8", "2× R5", "20", "20", "20"}},
      {"two slots",
       plate({50, 40}, 2, 1, 8,
             [](const Vec2& c) {
               return Hole{{slot(c, 4, 16), 8}, {slot(c, 4, 16), 0}};
             }),
       {"100", "40", "8", "4× R4", "2× 16", "17", "67", "20"}},
      {"slots in line",
       plate({50, 40}, 1, 2, 8,
             [](const Vec2& c) {
               const double radius = c.y < 40 ? 4 : 6;
               return Hole{{slot(c, radius, 16), 8}, {slot(c, radius, 16), 0}};
             }),
       {"50", "80", "8", "2× R4", "2× R6", "2× 16", "17", "20", "60"}},
      {"blind counterbores",
       plate({40, 30}, 2, 1, 30, stepped_hole({{7, 30}, {7, 24}, {4, 24}, {4, 10}})),
       {"80", "30", "30", "2× ⌀8 ↧20 ⌴⌀14 ↧6", "20", "60", "15"}},
      {"holes of all kinds",
       mixed_plate(),
       {"160", "40", "20", "⌀8", "2× R5", "12", "⌀9 ⌴⌀14 ↧6", "⌀6 ⌵⌀12×90°", "20", "54", "100", "140", "20"}}};
}

// A shaft whose head of 90 degrees is tangent to a rounded edge.
inline Loop countersunk() {
  Loop profile{{0, 1e-9}, {0, 6}, {20, 6}};
  const double radius = 2, middle = 28, touch = std::sqrt(0.5) * radius;
  const Vec2 centre(middle, 6 + (middle - touch - 20) - touch);
  constexpr int steps = 12;
  for (int i = 0; i <= steps; ++i) {
    const double angle = 135.0 * (steps - i) / steps;
    profile.push_back(centre + radius * Vec2(cosine(angle), sine(angle)));
  }
  profile.emplace_back(middle + radius, 1e-9);
  return profile;
}

inline std::vector<KnownPart> round_parts() {
  return {{"flange of 4", flange(4, {15, 50, 36, 5}, 12), {"⌀100", "12", "⌀30", "4× ⌀10", "⌀72"}},
          {"flange of 5", flange(5, {20, 60, 45, 6}, 10), {"⌀120", "10", "⌀40", "5× ⌀12", "⌀90"}},
          {"flange of 6", flange(6, {25, 60, 45, 4}, 15), {"⌀120", "15", "⌀50", "6× ⌀8", "⌀90"}},
          {"flange of 8", flange(8, {40, 90, 70, 7}, 18), {"⌀180", "18", "⌀80", "8× ⌀14", "⌀140"}},
          {"pin", shaft({{0, 1e-9}, {0, 10}, {60, 10}, {60, 1e-9}}), {"60", "⌀20"}},
          {"two steps",
           shaft({{0, 1e-9}, {0, 10}, {40, 10}, {40, 15}, {100, 15}, {100, 1e-9}}),
           {"100", "⌀30", "⌀20", "40"}},
          {"three steps",
           shaft({{0, 1e-9}, {0, 10}, {30, 10}, {30, 20}, {80, 20}, {80, 12}, {120, 12}, {120, 1e-9}}),
           {"120", "⌀40", "⌀20", "⌀24", "30", "50"}},
          {"chamfers",
           shaft({{0, 1e-9}, {0, 10}, {2, 12}, {50, 12}, {50, 18}, {88, 18}, {90, 16}, {90, 1e-9}}),
           {"90", "⌀36", "⌀24", "50", "2× 2×45°"}},
          {"a cone",
           shaft({{0, 1e-9}, {0, 10}, {30, 10}, {70, 20}, {90, 20}, {90, 1e-9}}),
           {"90", "⌀40", "⌀20", "30", "70"}},
          {"cones in a row",
           shaft({{0, 1e-9}, {0, 12}, {20, 20}, {45, 12}, {70, 20}, {100, 12}, {100, 1e-9}}),
           {"100", "⌀40", "3× ⌀24", "20", "45", "70"}},
          {"a cut cone", shaft({{0, 1e-9}, {0, 8}, {50, 25}, {60, 25}, {60, 1e-9}}), {"60", "⌀50", "⌀16", "50"}},
          {"a rounded edge", shaft(rounded_pin(20, 4, 50)), {"50", "⌀40", "R4"}},
          {"a countersunk head", shaft(countersunk()), {"30", "⌀26.34", "⌀12", "20", "90°", "R2"}},
          {"a tube", shaft({{0, 6}, {0, 10}, {60, 10}, {60, 6}, {0, 6}}), {"60", "⌀20", "⌀12"}},
          {"a bushing",
           shaft({{0, 8}, {0, 20}, {10, 20}, {10, 14}, {50, 14}, {50, 8}, {0, 8}}),
           {"50", "⌀40", "⌀28", "⌀16", "10"}},
          {"a stepped bore",
           shaft({{0, 1e-9}, {0, 20}, {60, 20}, {60, 12}, {45, 12}, {45, 8}, {20, 8}, {20, 1e-9}}),
           {"60", "⌀40", "⌀16 ↧40 ⌴⌀24 ↧15"}},
          {"a neck",
           shaft({{0, 1e-9}, {0, 12}, {30, 12}, {30, 10}, {34, 10}, {34, 16}, {70, 16}, {70, 1e-9}}),
           {"70", "⌀32", "⌀24", "⌀20", "30", "4"}},
          {"a ball", shaft(with_ball({{0, 1e-9}, {0, 10}, {40, 10}})), {"66.18", "S⌀30", "⌀20"}},
          {"a ball on a collar",
           shaft(with_ball({{0, 1e-9}, {0, 20}, {10, 20}, {10, 10}, {40, 10}})),
           {"66.18", "⌀40", "⌀20", "10", "SR15"}}};
}

// Part of a circle around the origin, from one angle to another.
inline Loop arc_of(double radius, double from, double to) {
  Loop loop;
  for (int i = 0; i <= 4 * k; ++i) {
    const double angle = from + (to - from) * i / (4 * k);
    loop.push_back(radius * Vec2(cosine(angle), sine(angle)));
  }
  return loop;
}

// Teeth with radial sides.
inline Loop teeth(int count, double tip, double root, double turned) {
  Loop outline;
  const double half = 90.0 / count;
  for (int i = 0; i < count; ++i) {
    const double at = turned + 360.0 * i / count;
    for (const Loop& part : {arc_of(tip, at - half, at + half), arc_of(root, at + half, at + 3 * half)})
      outline.insert(outline.end(), part.begin(), part.end());
  }
  return outline;
}

// A ring with a keyway in its bore: 15 degrees to both sides are 2 x 2.588 wide, and its floor is 13 above the axis.
inline std::string keyed_hub() {
  Plate plate(8);
  Loop bore = circle({0, 0}, 10, 0);
  for (int i = k - 1; i <= k + 1; ++i) bore[std::size_t(i)] = {(k - i) * bore[k - 2].x, 13};
  plate.cell(circle({0, 0}, 20, 0), {{bore, 8}, {bore, 0}});
  return plate.obj();
}

// Prisms along y over parts of circles.
inline std::vector<KnownPart> interrupted_circles() {
  const std::string no_sides_of_teeth = "completeness: 2 of 18 plane faces, 16 of 16 cylindrical faces, ";
  const double flat = std::acos(0.8) * 180 / std::numbers::pi, key = std::asin(0.3) * 180 / std::numbers::pi;
  Loop two_flats = arc_of(10, flat, 180 - flat), other = arc_of(10, 180 + flat, 360 - flat);
  two_flats.insert(two_flats.end(), other.begin(), other.end());
  Loop keyed = arc_of(10, 90 + key, 450 - key);
  keyed.insert(keyed.end(), {{3, 6.5}, {-3, 6.5}});
  return {{"a flat", block(arc_of(10, flat, 360 - flat), 40), {"18", "⌀20", "40"}},
          {"two flats", block(two_flats, 40), {"16", "⌀20", "40"}},
          {"a keyway", block(keyed, 40), {"⌀20", "40", "6", "16.5"}},
          {"teeth", block(teeth(8, 20, 15, 0), 40), {"⌀40", "40", "⌀30"}, no_sides_of_teeth},
          {"teeth beside the axes", block(teeth(8, 20, 15, 22.5), 40), {"⌀40", "40", "⌀30"}, no_sides_of_teeth},
          {"a keyed hub", keyed_hub(), {"⌀40", "8", "⌀20", "5.18", "23"}}};
}

inline std::vector<KnownPart> blocks() {
  return {
      {"a box", block({{0, 0}, {50, 0}, {50, 20}, {0, 20}}, 30), {"50", "20", "30"}},
      {"a step", block({{0, 0}, {60, 0}, {60, 15}, {35, 15}, {35, 40}, {0, 40}}, 30), {"60", "40", "30", "35", "15"}},
      {"two steps up",
       block({{0, 0}, {70, 0}, {70, 10}, {50, 10}, {50, 24}, {20, 24}, {20, 45}, {0, 45}}, 25),
       {"70", "45", "25", "20", "50", "10", "24"}},
      {"a groove",
       block({{0, 0}, {60, 0}, {60, 30}, {40, 30}, {40, 18}, {20, 18}, {20, 30}, {0, 30}}, 40),
       {"60", "30", "40", "20", "20", "18"}},
      {"a tee",
       block({{20, 0}, {40, 0}, {40, 30}, {60, 30}, {60, 42}, {0, 42}, {0, 30}, {20, 30}}, 50),
       {"60", "42", "50", "20", "20", "30"}},
      {"a chamfer", block({{0, 0}, {60, 0}, {60, 25}, {55, 30}, {0, 30}}, 20), {"60", "30", "20", "5×45°"}},
      {"four chamfers",
       block({{4, 0}, {56, 0}, {60, 4}, {60, 26}, {56, 30}, {4, 30}, {0, 26}, {0, 4}}, 20),
       {"60", "30", "20", "4× 4×45°"}},
      {"a chamfered step",
       block({{0, 0}, {70, 0}, {70, 15}, {38, 15}, {38, 36}, {34, 40}, {0, 40}}, 30),
       {"70", "40", "30", "38", "15", "4×45°"}},
      {"a slope", block({{0, 0}, {60, 0}, {60, 20}, {40, 30}, {0, 30}}, 20), {"60", "30", "20", "40", "20"}},
      {"a wedge", block({{0, 0}, {60, 0}, {45, 30}, {0, 30}}, 20), {"60", "30", "20", "45"}},
      {"a dovetail",
       block({{0, 0}, {80, 0}, {80, 30}, {50, 30}, {56, 18}, {24, 18}, {30, 30}, {0, 30}}, 25),
       {"80", "30", "25", "24", "30", "50", "56", "18"}},
      {"a fillet", block(angle(), 30), {"60", "50", "30", "12", "12", "R8"}},
      {"letters", letters(2), {"120", "60", "20", "18"}},
      {"letters that touch", letters(2, 2.25), {"120", "60", "20", "18"}},
      {"a cross", letters(1), {"60", "60", "20", "18", "22", "28", "4", "16", "22", "28", "4", "16"}},
      {"rounded corners", block(rounded_rectangle({80, 50}, 12), 10), {"80", "50", "10", "4× R12"}}};
}

}  // namespace epura::test
