// SPDX-License-Identifier: Apache-2.0
#include "sheet/frame.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace epura::frame_test {
namespace {

sheet::Paper paper(const std::string& size, bool portrait = false) {
  return sheet::with_frame_margins(sheet::make_paper(scene::parse_paper_size(size, "--sheet"), portrait));
}

sheet::Furniture full(const sheet::Paper& paper) { return sheet::frame(paper, FrameKind::full, std::nullopt); }

std::map<std::string, int> count_texts(const sheet::Furniture& all) {
  std::map<std::string, int> count;
  for (const sheet::Text& text : all.texts) ++count[text.text];
  return count;
}

struct Size {
  std::string name;
  double width, height;  // of the drawing area, landscape
  int across;
  std::string last_letter;
};

// ISO 5457, tables 1 and 3: drawing areas and numbers of fields.
const std::vector<Size> sizes = {{"A0", 1159, 821, 24, "R"},
                                 {"A1", 811, 574, 16, "M"},
                                 {"A2", 564, 400, 12, "H"},
                                 {"A3", 390, 277, 8, "F"},
                                 {"A4", 267, 190, 6, "D"}};

// A point below a number and beside a letter is in the field of both.
TEST(Frame, AZoneIsWhatTheFrameSaysOnBothSides) {
  for (const std::string name : {"A0", "A2", "A3", "A4", "ANSI-B", "ANSI-D"})
    for (const bool portrait : {false, true}) {
      const sheet::Paper sheet = paper(name, portrait);
      const sheet::Rectangle area = sheet::drawing_area(sheet);
      for (const sheet::Text& number : full(sheet).texts)
        for (const sheet::Text& letter : full(sheet).texts) {
          const bool is_above = number.at.y > area.max.y, is_right = letter.at.x > area.max.x;
          if (!is_above || !is_right) continue;
          const Vec2 point(number.at.x, letter.at.y + letter.height / 2);
          EXPECT_EQ(sheet::zone_at(sheet, FrameKind::full, point), letter.text + number.text) << name;
        }
      EXPECT_EQ(sheet::zone_at(sheet, FrameKind::plain, Vec2(50, 50)), "");
    }
  const sheet::Paper a3 = paper("A3");
  EXPECT_EQ(sheet::zone_at(a3, FrameKind::full, Vec2(25, 280)), "A1");
  EXPECT_EQ(sheet::zone_at(a3, FrameKind::full, Vec2(205, 140)), "D4");
  EXPECT_EQ(sheet::zone_at(a3, FrameKind::full, Vec2(1000, -50)), "F8");
  EXPECT_EQ(sheet::zone_at({420, 297, 5, 5}, FrameKind::full, Vec2(200, 100)), "");
}

TEST(Frame, DrawingAreasAndFieldsOfIso5457) {
  for (const Size& size : sizes) {
    const sheet::Furniture all = full(paper(size.name));
    const sheet::Rectangle area{all.wide.front().points[0], all.wide.front().points[2]};
    EXPECT_EQ(area.min, Vec2(20, 10));
    EXPECT_EQ(area.size(), Vec2(size.width, size.height)) << size.name;
    auto count = count_texts(all);
    // A4 has fields at the top and on the right only, all others all around.
    const int sides = size.name == "A4" ? 1 : 2;
    EXPECT_EQ(count[std::to_string(size.across)], sides) << size.name;
    EXPECT_EQ(count[std::to_string(size.across + 1)], 0);
    EXPECT_EQ(count["A"], sides);
    EXPECT_EQ(count[size.last_letter], sides);
    EXPECT_EQ(count[std::string(1, static_cast<char>(size.last_letter[0] + 1))], 0);
    EXPECT_EQ(count["I"] + count["O"], 0);
    EXPECT_EQ(count[size.name], 1);
  }
}

TEST(Frame, PortraitSwapsTheFields) {
  auto count = count_texts(full(paper("A3", true)));
  EXPECT_EQ(count["6"], 2);
  EXPECT_EQ(count["7"], 0);
  EXPECT_EQ(count["H"], 2);
  EXPECT_EQ(count["J"], 0);
}

TEST(Frame, FieldsAreFiftyMillimetresFromTheCentringMarks) {
  const sheet::Paper a2 = paper("A2");
  std::set<double> ticks;
  for (const sheet::Stroke& stroke : full(a2).medium)
    if (stroke.points.size() == 2 && stroke.points[0].x == stroke.points[1].x) ticks.insert(stroke.points[0].x);
  ASSERT_EQ(ticks.size(), 11U);
  for (const double tick : ticks) EXPECT_EQ(std::fmod(std::abs(tick - a2.width / 2), 50), 0);
}

TEST(Frame, LettersGoDownAndNumbersToTheRight) {
  std::map<std::string, Vec2> at;
  for (const sheet::Text& text : full(paper("A4")).texts) at[text.text] = text.at;
  EXPECT_GT(at["A"].y, at["B"].y);
  EXPECT_LT(at["1"].x, at["2"].x);
}

TEST(Frame, CentringMarksCrossTheFrameByTenMillimetres) {
  const sheet::Furniture all = full(paper("A3"));
  ASSERT_EQ(all.wide.size(), 5U);
  EXPECT_EQ(all.wide[1].points, (std::vector<Vec2>{{210, 292}, {210, 277}}));
  EXPECT_EQ(all.wide[3].points, (std::vector<Vec2>{{15, 148.5}, {30, 148.5}}));
}

TEST(Frame, CentringMarkStopsAtATitleBlock) {
  const sheet::Furniture all = sheet::frame(paper("A4", true), FrameKind::full, sheet::Rectangle{{20, 10}, {200, 55}});
  EXPECT_EQ(all.wide[2].points, (std::vector<Vec2>{{105, 5}, {105, 10}}));
  EXPECT_EQ(all.wide[1].points, (std::vector<Vec2>{{105, 292}, {105, 277}}));
}

TEST(Frame, TrimmingMarksAreTwoRectanglesInEachCorner) {
  const sheet::Furniture all = full(paper("A3"));
  ASSERT_EQ(all.fills.size(), 4U);
  for (const sheet::Fill& fill : all.fills) {
    const std::vector<Vec2>& ring = fill.rings.at(0);
    double area = 0;
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Vec2& p = ring[i];
      const Vec2& q = ring[(i + 1) % ring.size()];
      area += cross(p, q) / 2;
      EXPECT_TRUE((sheet::Rectangle{{0, 0}, {420, 297}}.holds({p, p})));
    }
    EXPECT_NEAR(std::abs(area), 2 * 50 - 25, 1e-9);  // the rectangles share 5 x 5 mm
  }
}

TEST(Frame, AnsiZonesCountFromTheLowerRightCorner) {
  const sheet::Paper b = paper("ANSI-B");
  const sheet::Furniture all = full(b);
  auto count = count_texts(all);
  EXPECT_EQ(all.texts.size(), 12U);
  for (const std::string zone : {"1", "4", "A", "B"}) EXPECT_EQ(count[zone], 2) << zone;
  std::map<std::string, Vec2> at;
  for (const sheet::Text& text : all.texts) at[text.text] = text.at;
  EXPECT_LT(at["A"].y, at["B"].y);
  EXPECT_GT(at["1"].x, at["2"].x);
  EXPECT_EQ(all.wide.size(), 1U) << "no centring marks of ISO 5457";
  EXPECT_EQ(full(paper("ANSI-E")).texts.size(), 32U);
  EXPECT_EQ(count_texts(full(paper("ANSI-D", true)))["H"], 2);
  EXPECT_TRUE(full(paper("ANSI-A")).texts.empty()) << "size A has no zones";
  EXPECT_FALSE(full(paper("431.8x279.4")).texts.size() == 12U) << "sizes in millimetres have the frame of ISO 5457";
}

TEST(Frame, SmallSheetsHaveAPlainOne) {
  for (const std::string size : {"60x40", "1x1", "200x100", "500x100"}) {
    const sheet::Paper small = paper(size);
    const sheet::Furniture all = full(small);
    EXPECT_EQ(all.wide.size(), 1U) << size;
    EXPECT_TRUE(all.medium.empty() && all.texts.empty() && all.fills.empty());
    EXPECT_EQ(small.left, sheet::make_paper(scene::parse_paper_size(size, "--sheet"), false).left);
  }
  EXPECT_TRUE(sheet::frame(paper("A3"), FrameKind::none, {}).wide.empty());
  EXPECT_EQ(sheet::frame(paper("A3"), FrameKind::plain, {}).wide.size(), 1U);
}

TEST(Frame, LongSheetsHaveLettersBeyondZ) {
  auto count = count_texts(full(paper("1000x100000")));
  EXPECT_EQ(count["Z"], 2);
  EXPECT_EQ(count["AA"], 2);
  EXPECT_EQ(count["ZZ"], 2);
  EXPECT_EQ(count["AAA"], 2);
  for (const auto& [text, times] : count) EXPECT_EQ(times, 2) << text;
  EXPECT_EQ(count.size(), 2000U + 20U);
}

}  // namespace
}  // namespace epura::frame_test
