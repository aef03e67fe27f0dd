// SPDX-License-Identifier: Apache-2.0
// Constructions of projections on real sheets: in all files, at the places that the drawing says, and refused in words.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "../output/json_reader.hpp"
#include "base/vec.hpp"
#include "folder.hpp"
#include "program.hpp"

namespace epura::test::constructions_test {
namespace {

Vec2 pair(const Json& json) { return {json.items.at(0).number(), json.items.at(1).number()}; }

// A cube with a side of 10 and a wedge on it.
constexpr const char* model =
    "v 0 0 0\nv 10 0 0\nv 10 10 0\nv 0 10 0\nv 0 0 10\nv 10 0 10\nv 10 10 10\nv 0 10 10\nv 0 5 14\nv 10 5 14\n"
    "f 4 3 2 1\nf 1 2 6 5\nf 2 3 7 10 6\nf 3 4 8 7\nf 4 1 5 9 8\nf 5 6 10 9\nf 9 10 7 8\n";

class Constructions : public testing::Test {
 protected:
  Folder folder;
  std::string house = folder.file("house.obj", model);

  Outcome draw(std::vector<std::string> options) {
    options.insert(options.begin(), {"draw", house, "-o", "x.json", "-o", "x.svg", "--svg-text", "text"});
    return epura(options, folder / "");
  }
  Json construction(std::size_t view = 0) const {
    return JsonReader(read_file(folder / "x.json")).read()["views"].items.at(view)["construction"];
  }
  Vec2 at(const std::string& symbol, std::size_t view = 0) const {
    const Json json = construction(view);
    for (const Json& point : json["points"].items) {
      if (point["symbol"].text == symbol) return pair(point["at"]);
      if (std::find(point.names.begin(), point.names.end(), "also") == point.names.end()) continue;
      for (const Json& other : point["also"].items)
        if (other.text == symbol) return pair(point["at"]);
    }
    ADD_FAILURE() << "no point " << symbol;
    return {0, 0};
  }
  std::string svg() const { return read_file(folder / "x.svg"); }
};

TEST_F(Constructions, VanishingPointsAreThoseOfTheDrawing) {
  const Outcome run = draw({"--projection", "three-point", "--construction", "vp,horizon,to-vp,principal"});
  ASSERT_EQ(run.code, 0) << run.err;
  const Json view = JsonReader(read_file(folder / "x.json")).read()["views"].items.at(0);
  const char* const names[] = {"VP_x", "VP_y", "VP_z"};
  for (std::size_t i = 0; i < 3; ++i)
    EXPECT_NEAR(glm::length(at(names[i]) - pair(view["vanishing_points"].items[i])), 0, 1e-6) << names[i];
  // The principal point is where the altitudes of the vanishing points meet.
  const Vec2 x = at("VP_x"), y = at("VP_y"), z = at("VP_z"), pp = at("PP");
  EXPECT_NEAR(glm::dot(glm::normalize(x - pp), glm::normalize(y - z)), 0, 1e-9);
  EXPECT_NEAR(glm::dot(glm::normalize(z - pp), glm::normalize(x - y)), 0, 1e-9);
  EXPECT_NE(svg().find("construction"), std::string::npos);
}

// Every line to a vanishing point goes on along its edge.
TEST_F(Constructions, LinesContinueEdges) {
  ASSERT_EQ(draw({"--projection", "two-point", "--construction", "to-vp:0-1"}).code, 0);
  const Json json = JsonReader(read_file(folder / "x.json")).read()["views"].items.at(0);
  const Json& line = json["construction"]["lines"].items.at(0);
  for (const Json& segment : json["segments"].items) {
    const Json& edge = segment["edge"];
    if (edge.items.size() != 2 || edge.items[0].number() != 0 || edge.items[1].number() != 1) continue;
    const Vec2 from = pair(line["from"]), along = glm::normalize(pair(line["to"]) - from);
    for (const char* end : {"from", "to"}) {
      const Vec2 p = pair(segment[end]) - from;
      EXPECT_NEAR(cross(along, p), 0, 1e-6);
    }
  }
}

TEST_F(Constructions, FittingSheetsHoldTheVanishingPoints) {
  ASSERT_EQ(draw({"--projection", "two-point", "--construction", "vp,station", "--fit", "construction"}).code, 0);
  for (const char* symbol : {"VP_x", "VP_y", "SP"}) {
    EXPECT_GT(at(symbol).x, 0);
    EXPECT_LT(at(symbol).x, 297);
    EXPECT_GT(at(symbol).y, 0);
    EXPECT_LT(at(symbol).y, 210);
  }
}

// The direction is parallel to the picture but for 1e-9: its vanishing point is a billion eye distances away.
TEST_F(Constructions, FarPointsHaveArrows) {
  const Outcome run =
      draw({"--projection", "one-point", "--construction", "vp:1,0.000000001,0", "--fit", "construction"});
  ASSERT_EQ(run.code, 0) << run.err;
  EXPECT_GT(glm::length(at("VP_1,1e-09,0")), 1e9);
  EXPECT_NE(svg().find(" km"), std::string::npos);
  EXPECT_LT(svg().size(), 100'000U);
}

TEST_F(Constructions, DirectionsMayHaveAnyLength) {
  ASSERT_EQ(draw({"--projection", "two-point", "--construction", "vp:1,1,0"}).code, 0);
  const Vec2 expected = at("VP_1,1,0");
  for (const char* direction : {"vp:1e-200,1e-200,0", "vp:1e160,1e160,0", "vp:1e308,1e308,0"}) {
    const Outcome run = draw({"--projection", "two-point", "--construction", direction});
    ASSERT_EQ(run.code, 0) << run.err;
    EXPECT_LT(glm::length(at("VP_1,1,0") - expected), 1e-9) << direction;
  }
}

TEST_F(Constructions, EpurasHaveCorrespondenceLines) {
  const Outcome run = draw({"--views", "epura"});
  ASSERT_EQ(run.code, 0) << run.err;
  for (const char name : std::string("ABCDEFGHIJ")) {
    const Vec2 plan = at(std::string(1, name) + "_1"), elevation = at(std::string(1, name) + "_2");
    EXPECT_NEAR(plan.x, elevation.x, 1e-9) << name;
    EXPECT_LT(plan.y, elevation.y);
  }
  const Vec2 left = at("L"), right = at("T");
  EXPECT_EQ(left.y, right.y);
}

// Of the sloping roof, by the scale of the sheet.
TEST_F(Constructions, EpurasShowTrueLengthsAndShapes) {
  const Outcome run =
      draw({"--views", "epura", "--construction", "true-length:4-8,true-shape:5,traces:5", "--scale", "2:1"});
  ASSERT_EQ(run.code, 0) << run.err;
  EXPECT_NEAR(glm::length(at("A_2") - at("B'_2")), 2 * std::sqrt(41), 1e-9);
  EXPECT_NE(svg().find(">TL 6.40312<"), std::string::npos);
}

// The house is cut 4 above its floor: the section is a square as wide as the house, at that height.
TEST_F(Constructions, EpurasAreCutByAnyPlane) {
  const Outcome run = draw({"--views", "epura", "--construction", "section:3,3,4:0,0,-2,point:0", "--scale", "2:1"});
  ASSERT_EQ(run.code, 0) << run.err;
  const double floor = at("A_2").y, ground = at("L").y;
  int in_plan = 0, in_elevation = 0;
  const Json json = construction();
  for (const Json& line : json["lines"].items) {
    const Vec2 from = pair(line["from"]), to = pair(line["to"]);
    if (std::abs(from.y - floor - 2 * 4) < 1e-9 && from.y == to.y) ++in_elevation;
    if (from.y < ground - 2 && to.y < ground - 2 && std::abs(glm::length(to - from) - 2 * 10) < 1e-9) ++in_plan;
  }
  EXPECT_EQ(in_plan, 4);
  EXPECT_EQ(in_elevation, 4);
  EXPECT_NE(svg().find("with the normal 0,0,-2"), std::string::npos);
  EXPECT_EQ(draw({"--views", "epura", "--construction", "section:3,3,99:0,0,1"}).code, 2) << "it cuts nothing";
}

TEST_F(Constructions, PlanesHaveTracesInPerspectives) {
  const Outcome run = draw({"--projection", "two-point", "--construction", "traces:5,traces:0,0,5:1,1,1,legend"});
  ASSERT_EQ(run.code, 0) << run.err;
  EXPECT_EQ(construction()["lines"].items.size(), 2U);
  EXPECT_NE(svg().find(">trace in the picture of the plane of face 5<"), std::string::npos);
}

TEST_F(Constructions, AxonometriesHaveFiguresBesideThem) {
  const Outcome run = draw({"--projection", "isometric", "--construction", "axes,ellipses,trace-triangle"});
  ASSERT_EQ(run.code, 0) << run.err;
  EXPECT_EQ(construction()["figures"].items.size(), 3U);
  EXPECT_EQ(run.err.find("no place"), std::string::npos) << run.err;
  EXPECT_NE(svg().find(">30°<"), std::string::npos);
}

// A projection is constructed from its plane and projectors, whoever wrote it.
TEST_F(Constructions, PluginsOfOthersAreConstructed) {
  const Outcome run =
      draw({"--plugin-path", EPURA_TEST_BAD_PLUGINS "/good", "--projection", "plain", "--construction", "axes"});
  ASSERT_EQ(run.code, 0) << run.err;
  EXPECT_EQ(construction()["figures"].items.size(), 1U);
}

TEST_F(Constructions, BadRequestsAreRefusedInWords) {
  const auto refusal = [&](const std::string& projection, const std::string& kinds) {
    const Outcome run = draw({"--projection", projection, "--construction", kinds});
    EXPECT_EQ(run.code, 2) << projection << " " << kinds;
    EXPECT_NE(run.err.find("hint: "), std::string::npos) << run.err;
    return run.err;
  };
  EXPECT_NE(refusal("one-point", "vp:1,0,0").find("parallel to the picture"), std::string::npos);
  EXPECT_NE(refusal("two-point", "to-vp:0-6").find("edge that does not exist"), std::string::npos);
  EXPECT_NE(refusal("two-point", "to-vp:0-99").find("no vertex 99"), std::string::npos);
  EXPECT_NE(refusal("two-point", "to-vp:3:0-1").find("model 3"), std::string::npos);
  EXPECT_NE(refusal("isometric", "horizon").find("has no meaning"), std::string::npos);
  EXPECT_NE(refusal("two-point", "axes").find("has no meaning"), std::string::npos);
  EXPECT_NE(refusal("two-point", "horizont").find("did you mean 'horizon'"), std::string::npos);
  EXPECT_NE(refusal("two-point", "vp:0,0,0").find("is not a construction"), std::string::npos);
  EXPECT_NE(refusal("two-point", "traces:0,0,1:0,0,0").find("a point of the plane"), std::string::npos);
  EXPECT_NE(refusal("one-point", "traces:0,0,1:0,1,0").find("parallel to the picture"), std::string::npos);
  EXPECT_NE(refusal("two-point", "true-length:0-1:auxiliary").find("change of planes"), std::string::npos);
  EXPECT_NE(refusal("isometric", "label:A_1:1e308,0,1e308").find("within 1e15 mm"), std::string::npos);
  EXPECT_NE(refusal("cavalier", "trace-triangle").find("parallel to the picture"), std::string::npos);
  EXPECT_EQ(draw({"--views", "front,left", "--layout", "monge"}).code, 2);
  EXPECT_EQ(draw({"--views", "epura", "--third-angle"}).code, 2);
  EXPECT_EQ(draw({"--views", "epura", "--construction", "true-shape:77"}).code, 2);
}

// Of several views, each shows what it can.
TEST_F(Constructions, ListsAreForAllViewsThatSuit) {
  const Outcome run = draw({"--views", "front,isometric,two-point", "--construction", "axes,vp,horizon"});
  ASSERT_EQ(run.code, 0) << run.err;
  EXPECT_EQ(construction(1)["figures"].items.size(), 1U);
  EXPECT_NO_FATAL_FAILURE(at("VP_x", 2));
}

}  // namespace
}  // namespace epura::test::constructions_test
