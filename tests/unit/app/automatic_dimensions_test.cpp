// SPDX-License-Identifier: Apache-2.0
// Automatic dimensions of parts whose features are known, and what `epura lint` says of them.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <numbers>
#include <regex>

#include "base/text.hpp"
#include "base/vec.hpp"
#include "errors.hpp"
#include "folder.hpp"
#include "program.hpp"
#include "sheet/dimensions/boxes.hpp"
#include "sheet/lettering.hpp"

namespace epura::test {
namespace {

using Loop = std::vector<Vec2>;
using Words = std::vector<std::string>;

constexpr int k = 12;  // points on a side of a cell; its hole has four times as many

double cosine(double degrees) { return std::cos(degrees * std::numbers::pi / 180); }
double sine(double degrees) { return std::sin(degrees * std::numbers::pi / 180); }

Loop circle(const Vec2& centre, double radius, double begin) {
  Loop loop;
  for (int i = 0; i < 4 * k; ++i) {
    const double angle = begin + 90.0 * i / k;
    loop.push_back(centre + radius * Vec2(cosine(angle), sine(angle)));
  }
  return loop;
}

// Along x, the distance of the centres of its ends is `length`.
Loop slot(const Vec2& centre, double radius, double length) {
  Loop loop;
  for (int i = 0; i < 4 * k; ++i) {
    // Two half circles of 2k - 1 steps each, joined by straight lines.
    const int half = i / (2 * k), step = i % (2 * k);
    const double angle = -90 + 180.0 * half + 180.0 * step / (2 * k - 1);
    loop.push_back(centre + Vec2(half == 0 ? length / 2 : -length / 2, 0) + radius * Vec2(cosine(angle), sine(angle)));
  }
  return loop;
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
Loop cross(const Vec2& centre, double reach, double half_width) {
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
Loop square(const Vec2& low, const Vec2& size) {
  const std::array corners{low, low + Vec2(size.x, 0), low + size, low + Vec2(0, size.y)};
  Loop loop;
  for (int side = 0; side < 4; ++side)
    for (int i = 0; i < k; ++i)
      loop.push_back(corners[side] + (corners[(side + 1) % 4] - corners[side]) * (double(i) / k));
  return loop;
}

/// The same hole in the middle of each of nx times ny cells.
std::string plate(const Vec2& size, int nx, int ny, double thickness, const std::function<Hole(const Vec2&)>& hole) {
  Plate plate(thickness);
  for (int x = 0; x < nx; ++x)
    for (int y = 0; y < ny; ++y) {
      const Vec2 low(x * size.x, y * size.y);
      plate.cell(square(low, size), hole(low + size / 2.0));
    }
  return plate.obj();
}

std::function<Hole(const Vec2&)> stepped_hole(const std::vector<Vec2>& radius_and_height) {
  return [=](const Vec2& centre) {
    Hole hole;
    for (const Vec2& p : radius_and_height) hole.emplace_back(circle(centre, p.x, -135), p.y);
    return hole;
  };
}

/// A ring of `count` sectors with a hole in each of them.
std::string flange(int count, const std::array<double, 4>& inner_outer_pitch_hole, double thickness) {
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
std::string shaft(const std::vector<Vec2>& profile) {
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
std::string block(const Loop& outline, double depth) {
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

Loop rounded_rectangle(const Vec2& size, double radius) {
  Loop loop;
  const std::array centres{Vec2(size.x - radius, radius), size - radius, Vec2(radius, size.y - radius), Vec2(radius)};
  for (int corner = 0; corner < 4; ++corner)
    for (int i = 0; i <= k; ++i) {
      const double angle = -90 + 90.0 * corner + 90.0 * i / k;
      loop.push_back(centres[corner] + radius * Vec2(cosine(angle), sine(angle)));
    }
  return loop;
}

std::string letters(int count) {
  return plate({60, 60}, count, 1, 20, [](const Vec2& c) { return Hole{{cross(c, 8, 2), 20}, {cross(c, 8, 2), 18}}; });
}

// A cylinder with a rounded edge.
std::vector<Vec2> rounded_pin(double radius, double edge, double length) {
  std::vector<Vec2> profile{{0, 1e-9}, {0, radius}};
  for (int i = 0; i <= k; ++i)
    profile.emplace_back(length - edge + edge * sine(90.0 * i / k), radius - edge + edge * cosine(90.0 * i / k));
  profile.emplace_back(length, 1e-9);
  return profile;
}

// Adds a ball of radius 15 to a profile that ends at radius 10.
std::vector<Vec2> with_ball(std::vector<Vec2> profile) {
  const double centre = profile.back().x + std::sqrt(125), begin = std::acos(-std::sqrt(125) / 15) * 180 / M_PI;
  for (int i = k - 1; i >= 0; --i)
    profile.emplace_back(centre + 15 * cosine(begin * i / k), std::max(15 * sine(begin * i / k), 1e-9));
  return profile;
}

// Steps of 5, each 4 deep.
Loop stairs(int count) {
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
};

std::vector<KnownPart> plates() {
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
       {"60", "40", "8", "2× R5", "20", "20", "20"}}};
}

std::vector<KnownPart> round_parts() {
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
           {"120", "⌀40", "⌀20", "⌀24", "30", "80"}},
          {"chamfers",
           shaft({{0, 1e-9}, {0, 10}, {2, 12}, {50, 12}, {50, 18}, {88, 18}, {90, 16}, {90, 1e-9}}),
           {"90", "⌀36", "⌀24", "50", "2× 2×45°"}},
          {"a cone",
           shaft({{0, 1e-9}, {0, 10}, {30, 10}, {70, 20}, {90, 20}, {90, 1e-9}}),
           {"90", "⌀40", "⌀20", "30", "70"}},
          {"a cut cone", shaft({{0, 1e-9}, {0, 8}, {50, 25}, {60, 25}, {60, 1e-9}}), {"60", "⌀50", "⌀16", "50"}},
          {"a rounded edge", shaft(rounded_pin(20, 4, 50)), {"50", "⌀40", "R4"}},
          {"a ball", shaft(with_ball({{0, 1e-9}, {0, 10}, {40, 10}})), {"66.18", "S⌀30", "⌀20"}},
          {"a ball on a collar",
           shaft(with_ball({{0, 1e-9}, {0, 20}, {10, 20}, {10, 10}, {40, 10}})),
           {"66.18", "⌀40", "⌀20", "10", "SR15"}}};
}

std::vector<KnownPart> blocks() {
  return {
      {"a box", block({{0, 0}, {50, 0}, {50, 20}, {0, 20}}, 30), {"50", "20", "30"}},
      {"a step", block({{0, 0}, {60, 0}, {60, 15}, {35, 15}, {35, 40}, {0, 40}}, 30), {"60", "40", "30", "35", "15"}},
      {"two steps up",
       block({{0, 0}, {70, 0}, {70, 10}, {50, 10}, {50, 24}, {20, 24}, {20, 45}, {0, 45}}, 25),
       {"70", "45", "25", "20", "50", "10", "24"}},
      {"a groove",
       block({{0, 0}, {60, 0}, {60, 30}, {40, 30}, {40, 18}, {20, 18}, {20, 30}, {0, 30}}, 40),
       {"60", "30", "40", "20", "40", "18"}},
      {"a tee",
       block({{20, 0}, {40, 0}, {40, 30}, {60, 30}, {60, 42}, {0, 42}, {0, 30}, {20, 30}}, 50),
       {"60", "42", "50", "20", "40", "30"}},
      {"letters", letters(2), {"120", "60", "20", "18"}},
      {"a cross", letters(1), {"60", "60", "20", "18", "22", "28", "32", "38", "22", "28", "32", "38"}},
      {"rounded corners", block(rounded_rectangle({80, 50}, 12), 10), {"80", "50", "10", "4× R12"}}};
}

std::vector<std::string> sorted(std::vector<std::string> texts) {
  std::sort(texts.begin(), texts.end());
  return texts;
}

// The texts of all dimensions of a drawing.
std::vector<std::string> dimensions_in(const std::string& svg) {
  std::vector<std::string> texts;
  const std::string begin = "inkscape:label=\"dimensions\"";
  static const std::regex text("aria-label=\"([^\"]*)\"");
  for (std::size_t at = svg.find(begin); at != std::string::npos; at = svg.find(begin, at + 1)) {
    const std::string layer = svg.substr(at, svg.find("<g id=", at) - at);
    for (std::sregex_iterator it(layer.begin(), layer.end(), text), end; it != end; ++it)
      texts.push_back((*it)[1].str());
  }
  return texts;
}

// The boxes of all texts of a drawing with `--svg-text text`, measured with the font itself; y is down.
std::vector<std::pair<std::string, sheet::TurnedBox>> boxes_in(const std::string& svg) {
  static const std::regex text(
      "<text[^>]* x=\"([^\"]*)\" y=\"([^\"]*)\" font-size=\"([^\"]*)\"(?: text-anchor=\"([a-z]*)\")?"
      "(?: transform=\"rotate\\(([^ ]*) [^>]*)?>([^<]*)</text>");
  const sheet::Lettering lettering;
  std::vector<std::pair<std::string, sheet::TurnedBox>> boxes;
  for (std::sregex_iterator it(svg.begin(), svg.end(), text), end; it != end; ++it) {
    const std::smatch& m = *it;
    const auto number = [&](std::size_t i) { return m[i].matched ? *parse_number(m[i].str()) : 0; };
    const double height = number(3) / lettering.em(), width = lettering.width(m[6].str(), height);
    const Vec2 along(cosine(number(5)), sine(number(5))), up(along.y, -along.x);
    const double shift = m[4] == "middle" ? 0 : m[4] == "end" ? -width / 2 : width / 2;
    boxes.push_back(
        {m[6].str(), {Vec2(number(1), number(2)) + shift * along + height / 2 * up, along, {width / 2, height / 2}}});
  }
  return boxes;
}

class AutomaticDimensions : public testing::Test {
 protected:
  Folder folder;

  Outcome lint(const std::string& model, const std::string& dimensions, const Words& more = {}) {
    Words arguments{"lint",    model, "--views", "front,top,left", "--dimensions", dimensions,
                    "--sheet", "A3",  "-o",      "x.svg"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return epura(arguments, folder / "");
  }
  void expect_known(const std::vector<KnownPart>& parts) {
    for (const KnownPart& part : parts) {
      const Outcome run = lint(folder.file("part.obj", part.obj), "auto");
      EXPECT_EQ(run.code, 0) << part.name << ": " << run.out << run.err;
      EXPECT_EQ(sorted(dimensions_in(read_file(folder / "x.svg"))), sorted(part.texts)) << part.name;
    }
  }
};

TEST_F(AutomaticDimensions, OfPlatesAreEachThereOnce) { expect_known(plates()); }
TEST_F(AutomaticDimensions, OfRoundPartsAreEachThereOnce) { expect_known(round_parts()); }
TEST_F(AutomaticDimensions, OfBlocksAreEachThereOnce) { expect_known(blocks()); }

// In whatever arrangement, lint finds that nothing is missing, repeated or crossing.
TEST_F(AutomaticDimensions, AreCompleteInEveryArrangement) {
  for (const auto& parts : {plates(), round_parts(), blocks()})
    for (const KnownPart& part : parts)
      for (const char* arrangement : {"baseline", "chain", "ordinate"}) {
        const Outcome run = lint(folder.file("part.obj", part.obj), "auto", {"--arrangement", arrangement});
        EXPECT_EQ(run.code, 0) << part.name << " " << arrangement << ": " << run.out << run.err;
      }
}

// Measured apart from lint: no text lies on another one.
TEST_F(AutomaticDimensions, HaveTextsThatDoNotTouch) {
  for (const auto& parts : {plates(), round_parts(), blocks()})
    for (const KnownPart& part : parts) {
      EXPECT_EQ(lint(folder.file("part.obj", part.obj), "auto", {"--svg-text", "text"}).code, 0) << part.name;
      const auto boxes = boxes_in(read_file(folder / "x.svg"));
      EXPECT_GE(boxes.size(), part.texts.size()) << part.name;
      for (std::size_t i = 0; i < boxes.size(); ++i)
        for (std::size_t j = i + 1; j < boxes.size(); ++j)
          EXPECT_FALSE(sheet::overlap(boxes[i].second, boxes[j].second))
              << part.name << ": " << boxes[i].first << " on " << boxes[j].first;
    }
}

TEST_F(AutomaticDimensions, SayTheSameInOtherArrangements) {
  const std::string holes = folder.file("part.obj", plates()[1].obj);
  const Words common{"80", "60", "10", "4× ⌀8"};
  const std::vector<std::pair<const char*, Words>> arranged{{"baseline", {"20", "60", "15", "45"}},
                                                            {"chain", {"20", "40", "15", "30"}},
                                                            {"ordinate", {"0", "20", "60", "0", "15", "45"}}};
  for (const auto& [arrangement, positions] : arranged) {
    EXPECT_EQ(lint(holes, "auto", {"--arrangement", arrangement}).code, 0);
    Words expected = common;
    expected.insert(expected.end(), positions.begin(), positions.end());
    EXPECT_EQ(sorted(dimensions_in(read_file(folder / "x.svg"))), sorted(expected)) << arrangement;
  }
}

// More parallel lines than a person follows become one row.
TEST_F(AutomaticDimensions, OfManyStepsHaveACommonOrigin) {
  const Outcome run = lint(folder.file("part.obj", block(stairs(13), 30)), "auto");
  EXPECT_EQ(run.code, 0) << run.out << run.err;
  Words expected{"65", "52", "30", "0", "0"};
  for (int i = 1; i < 13; ++i) {
    expected.push_back(std::to_string(5 * i));
    expected.push_back(std::to_string(4 * i));
  }
  EXPECT_EQ(sorted(dimensions_in(read_file(folder / "x.svg"))), sorted(expected));
}

TEST_F(AutomaticDimensions, ArrangementsNeedThem) {
  const Outcome run = lint(folder.file("part.obj", plates()[1].obj), "overall", {"--arrangement", "chain"});
  EXPECT_EQ(run.code, 2);
  EXPECT_TRUE(contains(run.err, "--arrangement: needs automatic dimensions")) << run.err;
}

// Positions from the lower left corner, numbered from left to right and upwards; lint counts them.
TEST_F(AutomaticDimensions, OfHolesInATable) {
  const Outcome run = lint(folder.file("part.obj", plates()[1].obj), "hole-table");
  EXPECT_EQ(run.code, 0) << run.out << run.err;
  const Words expected{"80",   "60", "10", "A1",   "A2", "A3", "A4",        // dimensions and labels
                       "X",    "Y",                                         // at the origin
                       "Hole", "X",  "Y",  "Size",                          // captions
                       "A1",   "20", "15", "⌀8",   "A2", "20", "45", "⌀8",  // rows
                       "A3",   "60", "15", "⌀8",   "A4", "60", "45", "⌀8"};
  const Words found = dimensions_in(read_file(folder / "x.svg"));
  EXPECT_EQ(sorted(found), sorted(expected));
  const auto first = std::search(found.begin(), found.end(), expected.begin() + 13, expected.end());
  EXPECT_NE(first, found.end()) << "the rows are not in order";
}

TEST_F(AutomaticDimensions, OfBlindHolesInATable) {
  const Outcome run = lint(folder.file("part.obj", plates()[6].obj), "hole-table");
  EXPECT_EQ(run.code, 0) << run.out << run.err;
  const Words found = dimensions_in(read_file(folder / "x.svg"));
  EXPECT_EQ(std::count(found.begin(), found.end(), "⌀6.6 ⌴⌀11 ↧6.5"), 4);
}

TEST_F(AutomaticDimensions, TableWithoutRoomIsReported) {
  const std::string part = folder.file("part.obj", plates()[3].obj);
  const Outcome run = epura({"draw", part, "--projection", "top", "--dimensions", "hole-table", "--sheet", "110x110",
                             "--scale", "1:1", "-o", "x.svg"},
                            folder / "");
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_TRUE(contains(run.err, "no room for the table of the holes in the view 'top'")) << run.err;
}

TEST_F(AutomaticDimensions, HolesBelongToAutomaticOnes) {
  folder.file("part.obj", plates()[0].obj);
  const std::string scene =
      folder.file("scene.toml", "[[model]]\nfile = 'part.obj'\n[[dimension]]\ntype = 'overall'\nholes = 'table'\n");
  const Outcome run = epura({"draw", scene, "-o", "x.svg"}, folder / "");
  EXPECT_NE(run.code, 0);
  EXPECT_TRUE(contains(run.err, "5:9: a dimension of type 'overall' has no 'holes'")) << run.err;
}

// Diameters that are written as 3.17 and 3.18, as in files of single precision.
TEST_F(AutomaticDimensions, LintKnowsEqualHolesThatAreRoundedApart) {
  const auto hole = [](const Vec2& centre) {
    const double radius = centre.x < 40 ? 1.58749 : 1.58751;
    return stepped_hole({{radius, 8}, {radius, 0}})(centre);
  };
  EXPECT_EQ(lint(folder.file("part.obj", plate({40, 30}, 2, 1, 8, hole)), "auto").code, 0);
}

// What cannot be checked is not passed over in silence.
TEST_F(AutomaticDimensions, LintNamesWhatItCannotCheck) {
  const std::string file = folder.file("part.obj", plates()[0].obj);
  const Outcome mesh = epura({"lint", file, "--views", "front,top,left", "--dimensions", "overall", "--sheet", "A3",
                              "--surfaces", "mesh", "-o", "x.svg"},
                             folder / "");
  EXPECT_EQ(mesh.code, 1);
  EXPECT_TRUE(contains(mesh.out, "not dimensioned: model 0: nothing is recognised")) << mesh.out;
}

TEST_F(AutomaticDimensions, LintFindsDimensionsOutsideADetail) {
  folder.file("part.obj", plates()[0].obj);
  const auto run = [&](const std::string& end) {
    const std::string scene =
        folder.file("scene.toml",
                    "[[model]]\nfile = 'part.obj'\n[[detail]]\nname = 'X'\ncentre = [25, 15, 8]\nradius = 12\n"
                    "[[view]]\nprojection = 'top'\n[[view]]\ndetail = 'X'\nscale = '2:1'\n[sheet]\nscale = '1:1'\n"
                    "[[dimension]]\ntype = 'linear'\ndirection = 'horizontal'\nview = 'detail-X'\n"
                    "from = {point = [20, 15, 8]}\nto = {point = " +
                        end + "}\n");
    return epura({"lint", scene}, folder / "").out;
  };
  const std::string sentence = "ends outside the boundary of detail X (view 'detail-X')";
  EXPECT_TRUE(contains(run("[38, 15, 8]"), sentence)) << "13 mm from the centre";
  EXPECT_FALSE(contains(run("[36, 15, 8]"), sentence)) << "11 mm from the centre";
}

TEST_F(AutomaticDimensions, LintSaysWhatIsMissing) {
  const std::string part = folder.file("part.obj", plates()[4].obj);
  const Outcome run = lint(part, "overall");
  EXPECT_EQ(run.code, 1);
  for (const char* sentence : {"not dimensioned: 2× hole ⌀8 ↧18\n", "hole ⌀8: position along x (20)",
                               "hole ⌀8: position along x (60)", "hole ⌀8: position along y (20)"})
    EXPECT_TRUE(contains(run.out, sentence)) << sentence << "\n" << run.out;
  const Outcome json =
      epura({"lint", part, "--views", "front,top,left", "--dimensions", "overall", "--json", "-"}, folder / "");
  EXPECT_TRUE(contains(json.out, "{\"kind\": \"not dimensioned\", \"what\": \"2× hole ⌀8 ↧18\"}")) << json.out;
}

TEST_F(AutomaticDimensions, LintFindsWhatIsThereTwice) {
  folder.file("part.obj", blocks()[1].obj);
  const std::string linear = "[[dimension]]\ntype = 'linear'\ndirection = 'horizontal'\n";
  const std::string scene =
      folder.file("scene.toml",
                  "[[model]]\nfile = 'part.obj'\n[[view]]\nprojection = 'front'\n[[view]]\nprojection = 'left'\n"
                  "[[dimension]]\ntype = 'auto'\n" +
                      linear + "from = {point = [35, 0, 40]}\nto = {point = [60, 0, 15]}\n");
  const Outcome run = epura({"lint", scene}, folder / "");
  EXPECT_EQ(run.code, 1);
  EXPECT_TRUE(contains(run.out, "dimensioned twice: 25 along x")) << run.out;
}

TEST_F(AutomaticDimensions, LintFindsCrossingsAndTheEndOfTheSheet) {
  folder.file("part.obj", blocks()[0].obj);
  const std::string wide = "[[dimension]]\ntype = 'linear'\ndirection = 'horizontal'\noffset = -10\n";
  const std::string scene = folder.file(
      "scene.toml",
      "[sheet]\nsize = '60x40'\nscale = '1:1'\n[[model]]\nfile = 'part.obj'\n[[view]]\nprojection = 'front'\n" + wide +
          "from = {point = [0, 0, 0]}\nto = {point = [30, 0, 0]}\n" + wide +
          "from = {point = [20, 0, 0]}\nto = {point = [50, 0, 0]}\n");
  const Outcome run = epura({"lint", scene}, folder / "");
  EXPECT_EQ(run.code, 1);
  EXPECT_TRUE(contains(run.out, "crossing: '30' and '30' (view 'front')")) << run.out;
  EXPECT_TRUE(contains(run.out, "off the sheet: dimensions extend beyond the sheet (view 'front')")) << run.out;
}

}  // namespace
}  // namespace epura::test
