// SPDX-License-Identifier: Apache-2.0
#include "sheet/paper.hpp"

#include <gtest/gtest.h>

#include <string>
#include <tuple>
#include <vector>

#include "base/error.hpp"

namespace epura::paper_test {
namespace {

TEST(Paper, ASizesLieOnTheirSideUnlessPortrait) {
  const sheet::Paper a3 = sheet::make_paper(scene::parse_paper_size("A3", "--sheet"), false);
  EXPECT_EQ(a3.width, 420);
  EXPECT_EQ(a3.height, 297);
  EXPECT_EQ(a3.left, 20);
  EXPECT_EQ(a3.other, 10);
  const sheet::Paper a4 = sheet::make_paper(scene::parse_paper_size("a4", "--sheet"), true);
  EXPECT_EQ(a4.width, 210);
  EXPECT_EQ(a4.height, 297);
  EXPECT_EQ(a4.left, 20) << "for filing";
  EXPECT_EQ(a4.other, 10);
  EXPECT_EQ(sheet::make_paper(scene::parse_paper_size("A0", "--sheet"), false).width, 1189);
}

TEST(Paper, AnsiSizesAreThoseOfAsmeY14) {
  // Sheet and drawing area in inches: ASME Y14.1-2020, table 1.
  const std::vector<std::tuple<std::string, Vec2, Vec2>> sizes = {{"ANSI-A", {11, 8.5}, {10.5, 7.74}},
                                                                  {"ansi-b", {17, 11}, {15.76, 10.24}},
                                                                  {"ANSI-C", {22, 17}, {21, 15.5}},
                                                                  {"ANSI-D", {34, 22}, {32, 21}},
                                                                  {"ANSI-E", {44, 34}, {43, 32}}};
  for (const auto& [name, sheet, area] : sizes)
    for (const bool portrait : {false, true}) {
      const sheet::Paper paper = sheet::make_paper(scene::parse_paper_size(name, "--sheet"), portrait);
      const auto turned = [portrait = portrait](const Vec2& size) { return portrait ? Vec2(size.y, size.x) : size; };
      const Vec2 room = sheet::drawing_area(paper).size() / 25.4;
      EXPECT_NEAR(glm::length(Vec2(paper.width, paper.height) / 25.4 - turned(sheet)), 0, 1e-9) << name;
      EXPECT_NEAR(glm::length(room - turned(area)), 0, 1e-9) << name;
      EXPECT_NEAR(glm::length(sheet::drawing_area(paper).centre() - Vec2(paper.width, paper.height) / 2.0), 0, 1e-9);
    }
  EXPECT_EQ(sheet::size_name(scene::parse_paper_size("ansi-c", "--sheet")), "C");
}

TEST(Paper, CustomSizesAndNone) {
  EXPECT_EQ(sheet::make_paper(scene::parse_paper_size("none", "--sheet"), false).width, 0);
  const sheet::Paper custom = sheet::make_paper(scene::parse_paper_size("300x200.5", "--sheet"), true);
  EXPECT_EQ(custom.width, 300);
  EXPECT_EQ(custom.height, 200.5);
  const sheet::Paper tiny = sheet::make_paper(scene::parse_paper_size("10x20", "--sheet"), false);
  EXPECT_LT(tiny.left + tiny.other, 10);
}

TEST(Paper, RefusesWhatIsNoSize) {
  for (const std::string text : {"", "A", "A5", "ANSI-F", "ANSI-", "ansib", "A44", "x", "3x", "0x10", "-3x4", "nanx3",
                                 "infx3", "1e9x3", "3x4x5", "3 x 4"}) {
    try {
      sheet::make_paper(scene::parse_paper_size(text, "--sheet"), false);
      ADD_FAILURE() << text;
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::input);
      EXPECT_FALSE(error.hint().empty());
    }
  }
}

TEST(Scale, RatiosNumbersAndFit) {
  EXPECT_EQ(scene::parse_scale("1:2", "--scale"), (scene::ScaleChoice{0.5, false}));
  EXPECT_EQ(scene::parse_scale("5:1", "--scale"), (scene::ScaleChoice{5, false}));
  EXPECT_EQ(scene::parse_scale("0.25", "--scale"), (scene::ScaleChoice{0.25, false}));
  EXPECT_EQ(scene::parse_scale("1/2", "--scale"), (scene::ScaleChoice{0.5, false}));
  EXPECT_EQ(scene::parse_scale("50%", "--scale"), (scene::ScaleChoice{0.5, false}));
  EXPECT_EQ(scene::parse_scale("fit", "--scale"), scene::ScaleChoice());
  EXPECT_EQ(scene::parse_scale("auto", "--scale"), (scene::ScaleChoice{{}, true}));
  for (const std::string text : {"", "1:0", "0:1", "0", "-1", "1:-2", "-1:-2", "1:2:3", "1:", ":2", "inf", "nan",
                                 "1:inf", "big", "1/0", "1/2:3", "%", "1:2%", "1/2/3"})
    EXPECT_THROW(scene::parse_scale(text, "--scale"), Error) << text;
}

Vec2 on_page(const sheet::Placement& placement, const Vec2& p) { return p * placement.scale + placement.shift; }

TEST(Placement, FitsAndCentresInTheDrawingArea) {
  // The drawing area of A3 is 20 ... 410 by 10 ... 287.
  const sheet::Placement wide = sheet::place_ink({-5, 0}, {5, 1}, std::nullopt,
                                                 sheet::make_paper(scene::parse_paper_size("A3", "--sheet"), false));
  EXPECT_DOUBLE_EQ(wide.scale, 39);
  EXPECT_TRUE(wide.inside);
  EXPECT_NEAR(on_page(wide, {-5, 0.5}).x, 20, 1e-9);
  EXPECT_NEAR(on_page(wide, {5, 0.5}).x, 410, 1e-9);
  EXPECT_NEAR(on_page(wide, {5, 0.5}).y, 148.5, 1e-9);
  EXPECT_DOUBLE_EQ(sheet::place_ink({0, 0}, {1, 100}, std::nullopt,
                                    sheet::make_paper(scene::parse_paper_size("A3", "--sheet"), false))
                       .scale,
                   2.77);
}

TEST(Placement, PaperIsCutToTheDrawing) {
  const sheet::Placement placement =
      sheet::place_ink({10, 20}, {40, 60}, 2, sheet::make_paper(scene::parse_paper_size("none", "--sheet"), false));
  EXPECT_DOUBLE_EQ(placement.paper.width, 60 + 10);
  EXPECT_DOUBLE_EQ(placement.paper.height, 80 + 10);
  EXPECT_NEAR(on_page(placement, {10, 20}).x, 5, 1e-12);
  EXPECT_NEAR(on_page(placement, {10, 20}).y, 5, 1e-12);
  EXPECT_TRUE(placement.inside);
  // As large as on A4, where 277 - 10 by 190 mm are free.
  EXPECT_DOUBLE_EQ(sheet::place_ink({0, 0}, {1, 0.1}, std::nullopt,
                                    sheet::make_paper(scene::parse_paper_size("none", "--sheet"), false))
                       .scale,
                   267);
}

TEST(Placement, SaysWhenTheDrawingIsTooLarge) {
  EXPECT_FALSE(
      sheet::place_ink({0, 0}, {300, 10}, 1, sheet::make_paper(scene::parse_paper_size("A4", "--sheet"), false))
          .inside);
  EXPECT_THROW(
      sheet::place_ink({0, 0}, {300, 10}, 1e6, sheet::make_paper(scene::parse_paper_size("A4", "--sheet"), false)),
      Error);
}

TEST(Placement, PointsAndLinesHaveAPlace) {
  const sheet::Placement point = sheet::place_ink({3, 4}, {3, 4}, std::nullopt,
                                                  sheet::make_paper(scene::parse_paper_size("A4", "--sheet"), false));
  EXPECT_EQ(point.scale, 1);
  EXPECT_NEAR(on_page(point, {3, 4}).x, 20 + 267 / 2.0, 1e-12);
  EXPECT_DOUBLE_EQ(sheet::place_ink({0, 0}, {0, 19}, std::nullopt,
                                    sheet::make_paper(scene::parse_paper_size("A4", "--sheet"), false))
                       .scale,
                   10);
}

}  // namespace
}  // namespace epura::paper_test
