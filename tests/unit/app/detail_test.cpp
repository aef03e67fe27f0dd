// SPDX-License-Identifier: Apache-2.0
// Detail views: what lies inside the boundary, at another scale.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <regex>

#include "base/text.hpp"
#include "base/vec.hpp"
#include "drawn_scenes.hpp"
#include "errors.hpp"

namespace epura::test::detail_test {
namespace {

class Details : public DrawnScenes {};

std::string model(const std::string& name) { return "[[model]]\nfile = '" + sample(name) + "'\n"; }

Vec2 point_of(const Json& pair) { return {pair.items[0].number(), pair.items[1].number()}; }

const Json& view_of(const Json& drawing, const std::string& name) {
  for (const Json& view : drawing["views"].items)
    if (view["name"].text == name) return view;
  throw std::runtime_error("no view " + name);
}

Vec2 on_page(const Json& view, const Vec3& p) {
  const auto row = [&](std::size_t i) {
    const auto& m = view["world_to_page"].items;
    return m[4 * i].number() * p.x + m[4 * i + 1].number() * p.y + m[4 * i + 2].number() * p.z + m[4 * i + 3].number();
  };
  return Vec2(row(0), row(1)) / row(3);
}

// Half the chord of a circle on the line, and the foot of its centre.
double length_in_circle(const Vec2& centre, double radius, const Vec2& from, const Vec2& to) {
  const double length = glm::distance(from, to);
  if (!(length > 0)) return 0;
  const Vec2 along = (to - from) / length;
  const double foot = glm::dot(centre - from, along), apart = glm::distance(centre, from + foot * along);
  if (apart >= radius) return 0;
  const double half = std::sqrt(radius * radius - apart * apart);
  return std::max(0.0, std::min(length, foot + half) - std::max(0.0, foot - half));
}

/// Lengths of the hidden and the visible lines.
using Lengths = std::array<double, 2>;

Lengths lengths_in(const Json& view, const Vec2& centre, double radius) {
  Lengths lengths{};
  for (const Json& segment : view["segments"].items)
    lengths[segment["visible"].type == 't' ? 1 : 0] +=
        length_in_circle(centre, radius, point_of(segment["from"]), point_of(segment["to"]));
  return lengths;
}

struct Case {
  const char *file, *projection;
  Vec3 centre;
  double radius;
};

TEST_F(Details, HaveTheLinesOfTheParentInsideTheCircleTimesTheRatio) {
  const std::array cases{Case{"bracket.obj", "front", {14, 60, 62}, 9},
                         Case{"bracket.obj", "top", {30, 10, 0}, 20},
                         Case{"bracket.obj", "isometric", {40, 60, 48}, 17},
                         Case{"bracket.obj", "cabinet", {70, 5, 5}, 12},
                         Case{"flange.obj", "front", {20, 0, 0}, 15},
                         Case{"shaft.obj", "left", {0, 0, 0}, 11},
                         Case{"gear.stl", "top", {20, 3, 0}, 14},
                         Case{"elbow.obj", "dimetric", {0, 0, 0}, 30},
                         Case{"cylinders.obj", "planometric", {10, 0, 5}, 12}};
  for (const Case& one : cases) {
    const Vec3& c = one.centre;
    const std::string name = std::string(one.file) + " " + one.projection;
    const Outcome run =
        draw(model(one.file) + "[sheet]\nscale = '1:2'\nsize = 'auto'\n[[detail]]\nname = 'X'\nradius = " +
                 format_number(one.radius) + "\ncentre = [" + format_number(c.x) + ", " + format_number(c.y) + ", " +
                 format_number(c.z) + "]\n[[view]]\nprojection = '" + one.projection +
                 "'\nhidden = 'dashed'\n[[view]]\ndetail = 'X'\nscale = '2:1'\n",
             {"--join-within", "0"});
    ASSERT_LE(run.code, 1) << name << run.err;
    const Json json = drawing();
    const Json &parent = json["views"].items.at(0), &detail = view_of(json, "detail-X");
    EXPECT_EQ(detail["projection"].text, one.projection);
    EXPECT_EQ(detail["detail"]["name"].text, "X");
    EXPECT_EQ(detail["detail"]["of"].text, parent["name"].text);
    const Vec2 middle = on_page(detail, c);
    EXPECT_LT(glm::distance(point_of(detail["detail"]["centre"]), middle), 1e-9);
    EXPECT_DOUBLE_EQ(detail["detail"]["radius"].number(), 2 * one.radius);
    const Lengths inside = lengths_in(parent, on_page(parent, c), one.radius / 2);
    const Lengths drawn = lengths_in(detail, middle, 1e9);
    EXPECT_GT(inside[1], 0.3 * one.radius) << name;
    for (const int visible : {0, 1}) EXPECT_NEAR(drawn[visible], 4 * inside[visible], 1e-4 * drawn[1]) << name;
    for (const Json& segment : detail["segments"].items)
      for (const char* end : {"from", "to"})
        EXPECT_LE(glm::distance(point_of(segment[end]), middle), 2 * one.radius + 1e-9) << name;
  }
}

// The parameters of a line that is cut off still give its ends on the edge of the model.
TEST_F(Details, KeepTheParametersOfTheirLines) {
  const Outcome run = draw(model("bracket.obj") +
                           "[[section]]\nname = 'A'\npoint = [40, 0, 0]\nnormal = [-1, 0, 0]\n[[detail]]\nname = 'X'\n"
                           "centre = [40, 58, 10]\nradius = 12\n[[view]]\nprojection = 'left'\nsection = 'A'\n"
                           "[[view]]\ndetail = 'X'\nscale = '3:1'\n");
  ASSERT_EQ(run.code, 0) << run.err;
  const Json json = drawing();
  const Json& detail = view_of(json, "detail-X");
  int cut = 0;
  for (const Json& segment : detail["segments"].items) {
    if (segment["edge"].type != 'n') continue;
    for (const std::size_t end : {0U, 1U}) {
      const auto& p = segment["world"].items[end].items;
      const Vec2 page = on_page(detail, {p[0].number(), p[1].number(), p[2].number()});
      EXPECT_LT(glm::distance(page, point_of(segment[end == 0 ? "from" : "to"])), 1e-6);
    }
    ++cut;
  }
  EXPECT_GT(cut, 2);
  // The cut face is inside the circle, too.
  for (const Json& face : detail["cut_faces"].items)
    for (const Json& ring : face["rings"].items)
      for (const Json& p : ring.items)
        EXPECT_LE(glm::distance(point_of(p), point_of(detail["detail"]["centre"])), 36 + 1e-9);
  EXPECT_FALSE(detail["cut_faces"].items.empty());
}

// The coordinates of the paths in a layer of an SVG, as differences from absolute beginnings.
std::vector<Vec2> points_in(const std::string& svg, const std::string& layer) {
  const std::size_t begin = svg.find("-" + layer + "\" inkscape:groupmode");
  if (begin == std::string::npos) return {};
  const std::string group = svg.substr(begin, svg.find("</g>", begin) - begin);
  static const std::regex move(" d=\"M([-0-9.]+)[ ]?([-0-9.]+)");
  std::vector<Vec2> points;
  for (std::sregex_iterator it(group.begin(), group.end(), move), end; it != end; ++it)
    points.emplace_back(parse_number(std::string((*it)[1])).value(), parse_number(std::string((*it)[2])).value());
  return points;
}

const std::string two_details =
    "[sheet]\nsize = 'A3'\nscale = '1:1'\n[[detail]]\nname = 'X'\ncentre = [14, 60, 62]\nradius = 4\n[[detail]]\nname "
    "= "
    "'Y'\n"
    "centre = [40, 60, 48]\nsize = [30, 10]\n[[view]]\nprojection = 'front'\n[[view]]\ndetail = 'X'\nscale = '5:1'\n"
    "[[view]]\ndetail = 'Y'\nscale = '2:1'\n";

TEST_F(Details, AreMarkedWithLettersBesideTheirCircles) {
  const Outcome run = draw(model("bracket.obj") + two_details, {"--svg-text", "text", "--centre-lines", "-o", "x.dxf"});
  ASSERT_EQ(run.code, 0) << run.err;
  const std::string svg = read_file(folder / "x.svg");
  const Json json = drawing();
  static const std::regex text(
      "<text[^>]*class=\"[a-z0-9]+-text-detail\"[^>]* x=\"([-0-9.]+)\" y=\"([-0-9.]+)\"[^>]*>"
      "([^<]*)<");
  std::vector<std::string> names;
  for (std::sregex_iterator it(svg.begin(), svg.end(), text), end; it != end; ++it) names.push_back((*it)[3]);
  EXPECT_EQ(names, (std::vector<std::string>{"X", "Y"}));
  EXPECT_TRUE(contains(svg, ">X (5:1)<"));
  EXPECT_TRUE(contains(svg, ">Y (2:1)<"));
  const std::string dxf = read_file(folder / "x.dxf");
  EXPECT_TRUE(contains(dxf, "front-detail"));
  EXPECT_TRUE(contains(dxf, "detail-X-detail"));
  // Centre lines, too, end at the boundary.
  const Vec2 middle = point_of(view_of(json, "detail-X")["detail"]["centre"]);
  const std::vector<Vec2> begins = points_in(svg, "detail-X-centre");
  EXPECT_EQ(begins.size(), 2U);
  for (const Vec2& p : begins) EXPECT_LE(glm::distance(Vec2(p.x, 297 - p.y), middle), 20 + 1e-4);
}

TEST_F(Details, OfTheCommandLineAreThoseOfAFile) {
  ASSERT_EQ(draw(model("bracket.obj") + two_details.substr(0, two_details.find("[[detail]]\nname = 'Y'")) +
                 "[[view]]\nprojection = 'front'\n[[view]]\ndetail = 'X'\nscale = '5:1'\n")
                .code,
            0);
  const std::string described = read_file(folder / "x.svg");
  const Outcome run = epura({"draw", sample("bracket.obj"), "--projection", "front", "--sheet", "A3", "--scale", "1:1",
                             "--detail", "14,60,62:4:5:1", "-o", "y.svg"},
                            folder / "");
  ASSERT_EQ(run.code, 0) << run.err;
  EXPECT_EQ(read_file(folder / "y.svg"), described);
}

TEST_F(Details, ThatCannotBeShownAreRefused) {
  const std::string detail = model("bracket.obj") + "[[detail]]\nname = 'X'\ncentre = [14, 60, 62]\n";
  const std::string views = "[[view]]\nprojection = 'front'\n[[view]]\ndetail = 'X'\n";
  const auto said = [&](const std::string& scene) {
    const Outcome run = draw(scene);
    EXPECT_NE(run.code, 0) << scene;
    return run.err;
  };
  const auto expect = [&](const std::string& scene, const std::string& what) {
    const std::string err = said(scene);
    EXPECT_TRUE(contains(err, what)) << err;
  };
  const std::string round = detail + "radius = 4\n";
  expect(round + views, "10:10: the view of detail 'X' lacks a scale");
  expect(round + views + "scale = 'fit'\n", "lacks a scale");
  expect(detail + views + "scale = '5:1'\n", "4:8: detail 'X' has no radius");
  expect(round + "size = [1, 1]\n" + views + "scale = '5:1'\n", "detail 'X' has both a radius and a size");
  expect(round + "view = 'frnt'\n" + views + "scale = '5:1'\n",
         "there is no view 'frnt'\n  hint: did you mean 'front'?");
  expect(round + "view = 'detail-X'\n" + views + "scale = '5:1'\n", "view 'detail-X' itself shows a detail");
  expect(round + "[[view]]\ndetail = 'X'\nscale = '5:1'\n", "detail 'X' has no view to enlarge");
  expect(round + views + "scale = '5:1'\nprojection = 'top'\n",
         "a view of a detail has the projection of the view that it enlarges");
  expect(round + views + "scale = '5:1'\nsection = 'A'\n[[section]]\nname = 'A'\n",
         "a view of a detail shows the section");
  expect(round + views + "scale = '5:1'\n[[view]]\ndetail = 'Z'\nscale = '5:1'\n",
         "there is no detail 'Z'\n  hint: known: X");
  expect(round + "[[view]]\nscale = '5:1'\n", "7:1: [[view]] lacks 'projection'");
  expect(round + "[[view]]\nprojection = 'two-point'\n[[view]]\ndetail = 'X'\nscale = '5:1'\n",
         "view 'two-point' is a perspective, which has no scale");
  const std::string far = model("bracket.obj") + "[[detail]]\nname = 'X'\nradius = 4\ncentre = [14, 60, 162]\n";
  expect(far + views + "scale = '5:1'\n",
         "6:10: detail 'X' around [14, 60, 162] is outside the view 'front'\n  hint: what it shows extends from [0, 0, "
         "0] to [80, 70, 75]");
}

TEST_F(Details, NotLargerThanTheirParentsOrEmptyAreReported) {
  const std::string detail = model("bracket.obj") + "[sheet]\nscale = '1:1'\n[[detail]]\nname = 'X'\nradius = 4\n";
  const std::string views = "[[view]]\nprojection = 'front'\n[[view]]\ndetail = 'X'\nscale = ";
  Outcome run = draw(detail + "centre = [14, 60, 62]\n" + views + "'1:1'\n");
  EXPECT_EQ(run.code, 0);
  EXPECT_TRUE(contains(run.err, "detail 'X' at 1:1 is not larger than in view 'front' at 1:1")) << run.err;
  run = draw(detail + "centre = [25, 60, 40]\n" + views + "'2:1'\n");
  EXPECT_EQ(run.code, 0);
  EXPECT_TRUE(contains(run.err, "detail 'X' shows no line")) << run.err;
}

TEST_F(Details, AreVerifiedAndCompared) {
  const Outcome run = draw(model("bracket.obj") + two_details, {"--verify", "-o", "y.json"});
  ASSERT_EQ(run.code, 0) << run.err;
  EXPECT_TRUE(contains(run.err + run.out, "detail-X: verified"));
  EXPECT_FALSE(contains(run.err + run.out, "without it; 1"));
  EXPECT_EQ(epura({"compare", "x.json", "y.json"}, folder / "").code, 0);
  ASSERT_EQ(
      epura({"draw", sample("bracket.obj"), "--projection", "front", "--detail", "14,60,62:4:5:1", "-o", "z.json"},
            folder / "")
          .code,
      0);
  EXPECT_EQ(epura({"compare", "x.json", "z.json"}, folder / "").code, 1);
}

TEST_F(Details, ExplainWhatTheyCutOff) {
  const Outcome run = epura({"draw", sample("bracket.obj"), "--projection", "front", "--detail", "14,60,62:8:5:1", "-o",
                             "x.svg", "--why", "0:25-26"},
                            folder / "");
  ASSERT_EQ(run.code, 0) << run.err;
  EXPECT_TRUE(contains(run.out + run.err, "no ink: outside the detail")) << run.out << run.err;
}

// Dimensions of a detail are those of the part.
TEST_F(Details, HaveTrueDimensions) {
  const Outcome run = draw(model("bracket.obj") + two_details +
                               "[[dimension]]\ntype = 'linear'\ndirection = 'horizontal'\nview = 'detail-X'\n"
                               "from = {point = [10.5, 60, 62]}\nto = {point = [17.5, 60, 62]}\n",
                           {"--svg-text", "text"});
  ASSERT_EQ(run.code, 0) << run.err;
  EXPECT_TRUE(contains(read_file(folder / "x.svg"), ">7<"));
}

}  // namespace
}  // namespace epura::test::detail_test
