// SPDX-License-Identifier: Apache-2.0
// Broken-out sections: the models cut inside a freehand line, and unchanged outside it.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "../output/json_reader.hpp"
#include "base/text.hpp"
#include "base/vec.hpp"
#include "errors.hpp"
#include "folder.hpp"
#include "program.hpp"

namespace epura::test::broken_out_test {
namespace {

using Ring = std::vector<Vec2>;

// A block 80 x 40 x 16 with two square holes through its height: x 14 to 26 and x 50 to 60, both y 4 to 16.
std::string block() {
  const std::array<int, 6> x{0, 14, 26, 50, 60, 80};
  const std::array<int, 4> y{0, 4, 16, 40};
  std::string obj;
  for (const int z : {0, 16})
    for (const int b : y)
      for (const int a : x) obj += "v " + std::to_string(a) + " " + std::to_string(b) + " " + std::to_string(z) + "\n";
  const auto vertex = [](int i, int j, int k) { return " " + std::to_string(1 + i + 6 * j + 24 * k); };
  const auto is_full = [](int i, int j) {
    return i >= 0 && j >= 0 && i < 5 && j < 3 && !(j == 1 && (i == 1 || i == 3));
  };
  const auto wall = [&](std::array<int, 2> a, std::array<int, 2> b) {
    obj += "f" + vertex(a[0], a[1], 0) + vertex(b[0], b[1], 0) + vertex(b[0], b[1], 1) + vertex(a[0], a[1], 1) + "\n";
  };
  for (int i = 0; i < 5; ++i)
    for (int j = 0; j < 3; ++j) {
      if (!is_full(i, j)) continue;
      obj += "f" + vertex(i, j, 1) + vertex(i + 1, j, 1) + vertex(i + 1, j + 1, 1) + vertex(i, j + 1, 1) + "\n";
      obj += "f" + vertex(i, j, 0) + vertex(i, j + 1, 0) + vertex(i + 1, j + 1, 0) + vertex(i + 1, j, 0) + "\n";
      if (!is_full(i, j - 1)) wall({i, j}, {i + 1, j});
      if (!is_full(i + 1, j)) wall({i + 1, j}, {i + 1, j + 1});
      if (!is_full(i, j + 1)) wall({i + 1, j + 1}, {i, j + 1});
      if (!is_full(i - 1, j)) wall({i, j + 1}, {i, j});
    }
  return obj;
}

const std::string around_hole =
    "[[broken_out]]\npoint = [20, 10, 8]\n"
    "outline = [[8, 0, -6], [8, 0, 22], [32, 0, 22], [32, 0, -6]]\n";

Vec2 point_of(const Json& pair) { return {pair.items[0].number(), pair.items[1].number()}; }

Ring ring_of(const Json& points) {
  Ring ring;
  for (const Json& point : points.items) ring.push_back(point_of(point));
  return ring;
}

double area_of(const Ring& ring) {
  double area = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vec2 a = ring[i], b = ring[(i + 1) % ring.size()];
    area += cross(a, b) / 2;
  }
  return std::abs(area);
}

// What a ring has in an upright rectangle, cut off at one side after the other (Sutherland, Hodgman).
Ring cut_to(Ring ring, const Vec2& min, const Vec2& max) {
  for (const int axis : {0, 1})
    for (const double side : {1.0, -1.0}) {
      const double at = side > 0 ? min[axis] : max[axis];
      Ring rest;
      for (std::size_t i = 0; i < ring.size(); ++i) {
        const Vec2 p = ring[i], q = ring[(i + 1) % ring.size()];
        const double a = side * (p[axis] - at), b = side * (q[axis] - at);
        if (a >= 0) rest.push_back(p);
        if ((a < 0) != (b < 0)) rest.push_back(p + a / (a - b) * (q - p));
      }
      ring = std::move(rest);
    }
  return ring;
}

double length_of(const Ring& line) {
  double length = 0;
  for (std::size_t i = 0; i + 1 < line.size(); ++i) length += glm::distance(line[i], line[i + 1]);
  return length;
}

double length(const Json& view, bool visible) {
  double sum = 0;
  for (const Json& segment : view["segments"].items)
    if ((segment["visible"].type == 't') == visible)
      sum += glm::distance(point_of(segment["from"]), point_of(segment["to"]));
  return sum;
}

class BrokenOut : public testing::Test {
 protected:
  Folder folder;
  std::string model = folder.file("block.obj", block());

  Outcome draw(const std::string& scene, std::vector<std::string> options = {}) {
    options.insert(options.begin(), {"draw",
                                     folder.file("scene.toml",
                                                 "[[model]]\nfile = 'block.obj'\n[sheet]\nsize = 'A3'\n"
                                                 "scale = '2:1'\n" +
                                                     scene),
                                     "-o", "x.json", "-o", "x.svg"});
    return epura(options, folder / "");
  }
  Json view(const std::string& scene, std::size_t number = 0, const std::vector<std::string>& options = {}) {
    const Outcome run = draw(scene, options);
    EXPECT_EQ(run.code, 0) << run.err;
    return JsonReader(read_file(folder / "x.json")).read()["views"].items.at(number);
  }
  // Where the block is: its corner (x, z) in a front view at 2:1.
  static Vec2 at(const Json& view, double x, double z) {
    const auto& m = view["world_to_page"].items;
    return {m[0].number() * x + m[2].number() * z + m[3].number(),
            m[4].number() * x + m[6].number() * z + m[7].number()};
  }
};

const std::string front = "[[view]]\nprojection = 'front'\n";

TEST_F(BrokenOut, HaveTheCutFacesInsideTheLine) {
  const Json json = view(front + around_hole);
  const Ring ring = ring_of(json["broken_out"].items.at(0)["ring"]);
  const double around = area_of(cut_to(ring, at(json, 0, 0), at(json, 80, 16)));
  const double hole = area_of(cut_to(ring, at(json, 14, 0), at(json, 26, 16)));
  EXPECT_NEAR(hole, 4 * 12 * 16, 1e-6);  // all of it
  double area = 0;
  for (const Json& face : json["cut_faces"].items)
    for (const Json& part : face["rings"].items) area += area_of(ring_of(part));
  EXPECT_NEAR(area, around - hole, 1e-6);
  EXPECT_GT(area, 4 * 5 * 16);
}

TEST_F(BrokenOut, ShowWhatIsCutAndHideNothingElse) {
  const Json whole = view(front), cut = view(front + around_hole);
  EXPECT_NEAR(length(whole, false), 2 * 4 * 16, 1e-4);
  EXPECT_NEAR(length(cut, false), 2 * 2 * 16, 1e-4);  // those of the other hole
  EXPECT_NEAR(length(cut, true), length(whole, true) + 2 * 2 * 16, 1e-4);
  for (const Json& segment : cut["segments"].items)
    if (segment["visible"].type == 'f') {
      EXPECT_GT(point_of(segment["from"]).x, at(cut, 45, 0).x);
    }
}

TEST_F(BrokenOut, DrawTheLineWhereSomethingIsRemoved) {
  const Json json = view(front + around_hole);
  const Json& one = json["broken_out"].items.at(0);
  const Ring ring = ring_of(one["ring"]);
  const Vec2 min = at(json, 0, 0), max = at(json, 80, 16);
  double expected = 0, drawn = 0;
  const Ring inside = cut_to(ring, min, max);  // and two pieces of the sides of the rectangle
  for (std::size_t i = 0; i < inside.size(); ++i) {
    const Vec2 a = inside[i], b = inside[(i + 1) % inside.size()];
    if (!(a.y == b.y && (a.y == min.y || a.y == max.y))) expected += glm::distance(a, b);
  }
  EXPECT_EQ(one["lines"].items.size(), 2U);
  for (const Json& line : one["lines"].items) drawn += length_of(ring_of(line));
  EXPECT_NEAR(drawn, expected, 1e-6);
  EXPECT_GT(drawn, 2 * 2 * 16);
  EXPECT_TRUE(contains(read_file(folder / "x.svg"), "-front-limit\" "));
}

// A line that reaches far beyond the outline everywhere gives the section.
TEST_F(BrokenOut, AroundEverythingAreSections) {
  const Json out = view(front + "[[broken_out]]\npoint = [20, 10, 8]\nradius = 70\n");
  const Json section =
      view("[[section]]\nname = 'A'\npoint = [20, 10, 8]\n" + front + "section = 'A'\nhidden = 'none'\n");
  EXPECT_EQ(length(out, false), 0);
  EXPECT_NEAR(length(out, true), length(section, true), 1e-6);
  EXPECT_TRUE(out["broken_out"].items.at(0)["lines"].items.empty());
  EXPECT_EQ(out["cut_faces"].items.size(), section["cut_faces"].items.size());
}

// Beside the models and where the plane lies in front of them, nothing is removed, whatever another one removes.
TEST_F(BrokenOut, ThatRemoveNothingAreRefused) {
  const std::string aside = "[[broken_out]]\npoint = [200, 10, 8]\nradius = 6\n";
  const std::string nothing = "the broken-out section removes nothing inside its line in view 'front'";
  for (const std::string& scene : {front + aside, front + "[[broken_out]]\npoint = [20, 10, 8]\nradius = 6\n" + aside,
                                   "[[model]]\nfile = 'block.obj'\ntransform = 'translate:0,-60,40'\n" + front +
                                       "[[broken_out]]\npoint = [40, -40, 8]\nradius = 6\n"}) {
    const Outcome run = draw(scene);
    EXPECT_EQ(run.code, 2);
    const std::string& said = run.err;
    EXPECT_TRUE(contains(said, nothing)) << said;
    EXPECT_TRUE(contains(said, "scene.toml:")) << said;
    EXPECT_TRUE(contains(said, "the models reach from ")) << said;
  }
}

// A bar through the first hole that stays whole: neither hatched nor crossed by the line.
TEST_F(BrokenOut, LeaveBodiesWhole) {
  std::string bar = "o bar\n";
  for (const int z : {-4, 20})
    for (const int y : {4, 16})
      for (const int x : {14, 26})
        bar += "v " + std::to_string(x) + " " + std::to_string(y) + " " + std::to_string(z) + "\n";
  bar += "f 1 3 4 2\nf 5 6 8 7\nf 1 2 6 5\nf 2 4 8 6\nf 4 3 7 8\nf 3 1 5 7\n";
  folder.file("bar.obj", bar);
  const std::string scene =
      "[[model]]\nfile = 'bar.obj'\n" + front + "[[broken_out]]\npoint = [20, 10, 8]\nradius = 9\n";
  const auto length_on_bar = [&](const Json& json) {
    const double min = at(json, 14, 0).x, max = at(json, 26, 0).x;
    double sum = 0;
    for (const Json& line : json["broken_out"].items.at(0)["lines"].items) {
      const Ring points = ring_of(line);
      for (std::size_t i = 0; i + 1 < points.size(); ++i)
        if (const double x = (points[i].x + points[i + 1].x) / 2; x > min + 1e-6 && x < max - 1e-6)
          sum += glm::distance(points[i], points[i + 1]);
    }
    return sum;
  };
  EXPECT_GT(length_on_bar(view(scene)), 2 * 2 * 12);
  const Json whole = view("[[style]]\nmatch = 'bar'\ncut = false\n" + scene);
  EXPECT_EQ(length_on_bar(whole), 0);
  for (const Json& face : whole["cut_faces"].items) EXPECT_EQ(face["model"].number(), 0);
}

TEST_F(BrokenOut, AreSeenInDetailsAndInterruptedViews) {
  const Json detail = view(front + around_hole +
                               "[[detail]]\nname = 'X'\ncentre = [8, 0, 8]\nradius = 5\n[[view]]\ndetail = 'X'\n"
                               "scale = '5:1'\n",
                           1);
  EXPECT_EQ(detail["detail"]["of"].text, "front");
  EXPECT_FALSE(detail["cut_faces"].items.empty());
  const Vec2 middle = point_of(detail["detail"]["centre"]);
  ASSERT_EQ(detail["broken_out"].items.at(0)["lines"].items.size(), 1U);
  const Ring line = ring_of(detail["broken_out"].items[0]["lines"].items[0]);
  EXPECT_NEAR(glm::distance(line.front(), middle), 25, 1e-9);
  EXPECT_NEAR(glm::distance(line.back(), middle), 25, 1e-9);
  const Json whole = view(front + around_hole), broken = view(front + "break = 'x:40:70'\n" + around_hole);
  double before = 0, after = 0;
  for (const Json& part : whole["broken_out"].items.at(0)["lines"].items) before += length_of(ring_of(part));
  for (const Json& part : broken["broken_out"].items.at(0)["lines"].items) after += length_of(ring_of(part));
  EXPECT_NEAR(after, before, 1e-9);
}

TEST_F(BrokenOut, AreVerifiedAndExplained) {
  const Outcome run = draw(front + around_hole, {"--verify"});
  EXPECT_EQ(run.code, 0) << run.err;
  // The edge of the hole from (14, 4, 0) to (14, 4, 16), which is cut off.
  const Outcome why = draw(front + "hidden = 'dashed'\n" + around_hole, {"--why", "0:7-31"});
  EXPECT_EQ(why.code, 0) << why.err;
  EXPECT_TRUE(contains(why.out + why.err, "no ink: inside a broken-out section")) << why.out << why.err;
}

TEST_F(BrokenOut, AreRefusedWithPlaceAndHint) {
  const auto refused = [&](const std::string& scene, const std::string& said) {
    const Outcome run = draw(scene);
    EXPECT_EQ(run.code, 2) << scene;
    EXPECT_TRUE(contains(run.err, "scene.toml:")) << run.err;
    EXPECT_TRUE(contains(run.err, said)) << run.err;
    EXPECT_TRUE(contains(run.err, "hint: ")) << run.err;
  };
  const std::string out = "[[broken_out]]\npoint = [20, 10, 8]\n";
  refused(front + out, "has no line");
  refused(front + out + "radius = 3\noutline = [[0,0,0],[1,0,0],[0,0,1]]\n", "both a radius and an outline");
  refused(front + out + "outline = [[0,0,0],[1,0,0]]\n", "fewer than three points");
  std::string many;
  for (int i = 0; i <= 1000; ++i) many += "[" + std::to_string(i) + ",0,0],";
  refused(front + out + "outline = [" + many + "]\n", "the outline has 1001 points, allowed are 1000");
  refused(front + out + "outline = [[0,0,0],[10,0,0],[20,30,0]]\n", "has no area in view 'front'");
  refused(front + "[[broken_out]]\nradius = 3\n", "lacks 'point'");
  refused(front + out + "radius = 3\nview = 'fornt'\n", "there is no view 'fornt'");
  refused(front + "[[broken_out]]\npoint = [20, -20, 8]\nradius = 5\n", "the plane cuts nothing");
  refused(front + "[[broken_out]]\npoint = [20, 90, 8]\nradius = 5\n", "removes everything");
  refused(front + out + "radius = 5\n[[broken_out]]\npoint = [26, 12, 8]\nradius = 4\n", "overlaps another one");
  refused("[[section]]\nname = 'A'\npoint = [20, 10, 8]\n" + front + "section = 'A'\n" + out + "radius = 5\n",
          "is cut already");
  refused("[[view]]\nprojection = 'one-point'\n" + out + "radius = 5\n", "is a perspective");
}

}  // namespace
}  // namespace epura::test::broken_out_test
