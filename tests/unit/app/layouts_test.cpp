// SPDX-License-Identifier: Apache-2.0
// What would break if this were wrong: sheets that leave something out at a scale, and not at a larger one, and those
// whose dimensions run into the title block.
#include <gtest/gtest.h>

#include <algorithm>

#include "composition/layout.hpp"
#include "composition/occupied_room.hpp"
#include "drawn_texts.hpp"
#include "errors.hpp"
#include "folder.hpp"
#include "known_parts.hpp"
#include "program.hpp"

namespace epura::test::layouts_test {
namespace {

TEST(Layouts, ALargerScaleIsTriedBeforeSmallerOnes) {
  pipeline::SheetPlan usual;
  usual.chosen = true;
  usual.scale = 0.1;
  const std::vector<pipeline::LayoutRequest> layouts = pipeline::roomier_layouts({}, usual);
  ASSERT_GT(layouts.size(), 3U);
  EXPECT_EQ(layouts[0].kept_scale, 0.2);
  EXPECT_EQ(layouts[1].kept_scale, 0.2);
  EXPECT_GT(layouts[0].room_share, layouts[1].room_share);
  for (std::size_t i = 2; i < layouts.size(); ++i) EXPECT_LT(layouts[i].kept_scale, layouts[i - 1].kept_scale);
  usual.chosen = false;
  EXPECT_TRUE(pipeline::roomier_layouts({}, usual).empty());
}

// As in other views, no line of a dimension may be there.
TEST(Layouts, TheTitleBlockIsClosedToDimensions) {
  sheet::SheetFurniture furniture;
  furniture.paper = {420, 297, 20, 10};
  furniture.frame = FrameKind::full;
  furniture.title_block = sheet::TitleBlock{};
  const auto block = sheet::block_boxes(furniture).title_block;
  ASSERT_TRUE(block);
  const sheet::Neighbours around = pipeline::neighbours_of(furniture, {}, {}, sheet::Lettering());
  const auto is_in_it = [&](const sheet::TurnedBox& box) {
    return sheet::overlap(box, sheet::turned_box({block->centre(), block->centre()}));
  };
  EXPECT_TRUE(std::any_of(around.views.begin(), around.views.end(), is_in_it));
}

// Neither lines of dimensions nor centre lines pass through them.
TEST(Layouts, TextsOfAxonometricViewsAreClearOfLines) {
  const Folder folder;
  std::vector<std::string> parts{EPURA_TEST_SAMPLES "/step/clamp.step"};
  for (const KnownPart& part : plates()) parts.push_back(folder.file(part.name + ".obj", part.obj));
  for (const std::string& part : parts) {
    const Outcome run = epura({"draw", part, "--projection", "isometric", "--dimensions", "auto", "--sheet", "A3",
                               "--scale", "auto", "--svg-text", "text", "-o", "x.svg"},
                              folder / "");
    EXPECT_EQ(run.code, 0) << run.err;
    const std::string svg = read_file(folder / "x.svg");
    const std::vector<sheet::TurnedBox> lines = lines_in(svg);
    EXPECT_GT(lines.size(), 20U) << part;
    for (const auto& [text, box] : boxes_in(dimension_layers(svg)))
      for (const sheet::TurnedBox& line : lines)
        EXPECT_FALSE(sheet::overlap(box, line)) << part << ": " << text << " at " << line.centre.x;
  }
}

// Fifteen lengths on a side of the view are too many; a sheet whose holes are in a table need not be larger for them.
TEST(Layouts, ManyHolesAreInATable) {
  const Folder folder;
  const std::string part = folder.file("part.obj", irregular_plate());
  for (const char* size : {"A3", "auto"}) {
    const Outcome run = epura(
        {"lint", part, "--views", "front,top", "--dimensions", "auto", "--sheet", size, "-o", "x.svg"}, folder / "");
    EXPECT_EQ(run.code, 0) << size << ": " << run.out << run.err;
    const std::string drawn = read_file(folder / "x.svg");
    const std::vector<std::string> found = dimensions_in(drawn);
    EXPECT_EQ(std::count(found.begin(), found.end(), "⌀4"), 30) << size;
    EXPECT_EQ(std::count(found.begin(), found.end(), "0"), 0) << size;
    EXPECT_TRUE(contains(drawn, "width=\"420mm\" height=\"297mm\"")) << size;
  }
}

// Where no other sheet may be chosen.
TEST(Layouts, FansAreTold) {
  const Folder folder;
  const auto lint = [&folder](int steps, const char* scale) {
    return epura({"lint", folder.file("part.obj", block(stairs(steps), 30)), "--views", "front,top,left",
                  "--dimensions", "auto", "--sheet", "A3", "--scale", scale},
                 folder / "");
  };
  EXPECT_EQ(lint(13, "1:1").code, 0);
  const Outcome small = lint(13, "1:5"), many = lint(30, "1:1");
  EXPECT_EQ(small.code, 1);
  EXPECT_TRUE(contains(small.out, "crowded: too many ordinates on one side: '")) << small.out;
  EXPECT_EQ(many.code, 1);
  EXPECT_TRUE(contains(many.out, "crowded: too many ordinates on one side: '5, 10, 15, ")) << many.out;
}

// Its overall size must have room beside its rows.
TEST(Layouts, AStairIsNotDrawnSmallerThanItsRowsNeed) {
  const Folder folder;
  const std::string part = folder.file("part.obj", block(stairs(18), 20));
  const Outcome run =
      epura({"lint", part, "--views", "front,top,left", "--dimensions", "auto", "-o", "x.svg"}, folder / "");
  EXPECT_EQ(run.code, 0) << run.out << run.err;
  EXPECT_TRUE(contains(read_file(folder / "x.svg"), "aria-label=\"1:1\""));
}

}  // namespace
}  // namespace epura::test::layouts_test
