// SPDX-License-Identifier: Apache-2.0
#include "sheet/partial_mark.hpp"

#include <gtest/gtest.h>

namespace epura::test::partial_mark_test {
namespace {

// With half a line around every point.
void expect_inside(const sheet::Layer& layer, const Vec2& min, const Vec2& max) {
  const double half = layer.style.width / 2;
  for (const sheet::Stroke& stroke : layer.strokes)
    for (const Vec2& p : stroke.points) {
      EXPECT_TRUE(p.x - half >= min.x && p.x + half <= max.x) << p.x;
      EXPECT_TRUE(p.y - half >= min.y && p.y + half <= max.y) << p.y;
    }
}

TEST(PartialMark, StandsInTheUpperMargin) {
  for (const char* size : {"A4", "A0", "100x100"}) {
    const sheet::Paper paper = sheet::make_paper(scene::parse_paper_size(size, "--sheet"), false);
    const sheet::Layer mark = sheet::partial_mark(paper, "hiding lines");
    EXPECT_EQ(mark.name, "sheet/partial");
    EXPECT_EQ(mark.strokes.size(), 1U + 2 + 2 + 2 + 1 + 2 + 1 + 2 + 3 + 1 + 1 + 1 + 1 + 2 + 1 + 1 + 1 + 2 + 1)
        << "P A R T I A L : H I D I N G L I N E S";
    expect_inside(mark, {0, paper.height - paper.other}, {paper.width, paper.height});
  }
}

TEST(PartialMark, OnA4IsSixMillimetresHigh) {
  const sheet::Layer mark =
      sheet::partial_mark(sheet::make_paper(scene::parse_paper_size("A4", "--sheet"), false), "writing");
  EXPECT_EQ(mark.strokes[0].points.front(), Vec2(20, 202));
  EXPECT_EQ(mark.strokes[0].points[1], Vec2(20, 208));
}

TEST(PartialMark, ShrinksToNarrowPaper) {
  sheet::Paper paper;
  paper.width = 10;
  paper.height = 300;
  expect_inside(sheet::partial_mark(paper, "drawing centre lines"), {-0.1, 295}, {10, 300});
}

}  // namespace
}  // namespace epura::test::partial_mark_test
