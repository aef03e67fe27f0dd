// SPDX-License-Identifier: Apache-2.0
// What would break if this were wrong: notes on the drawing or on each other, leaders through texts.
#include "annotations/callouts.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "annotations/callout_symbols.hpp"
#include "sheet/free_rectangles.hpp"

namespace epura::test::callouts_test {
namespace {

// A rectangle with its outline as segments.
drawing::ViewDrawing rectangle_view(const sheet::Rectangle& box) {
  drawing::ViewDrawing view{};
  view.name = "front";
  view.box.min = box.min;
  view.box.max = box.max;
  const std::vector<Vec2> corners{box.min, {box.max.x, box.min.y}, box.max, {box.min.x, box.max.y}};
  for (std::size_t i = 0; i < 4; ++i) {
    drawing::Segment segment{};
    segment.from = corners[i];
    segment.to = corners[(i + 1) % 4];
    segment.visible = true;
    segment.t = {0, 1};
    view.segments.push_back(segment);
  }
  return view;
}

class Callouts : public testing::Test {
 protected:
  sheet::Lettering lettering;
  sheet::DimensionStyle style{lettering, 0.25};
  sheet::Rectangle box{{100, 80}, {180, 130}};
  drawing::ViewDrawing view = rectangle_view(box);
  sheet::Rectangle dimension{{100, 134}, {180, 145}};
  sheet::Neighbours around{sheet::Rectangle{{20, 10}, {287, 200}}, {sheet::turned_box(dimension)}};
  sheet::CalloutLayers layers = sheet::callout_layers("front", style);
  sheet::Layer& layer = layers.notes;

  sheet::Callout note(const std::string& text, const Vec2& point) const {
    sheet::Callout callout = sheet::note_callout({text}, true, style);
    callout.target = {point, LeaderEnd::dot};
    return callout;
  }
  // In a view without dimensions.
  sheet::PlacedLayer place(const std::vector<sheet::Callout>& callouts) {
    const world::World nothing{};
    const std::vector<sheet::ItemBeside> items = sheet::callout_items(callouts, view, style);
    sheet::PlacedLayer placed = sheet::place_dimensions({nothing, view, {}, 0, false, {}, items}, style, around);
    without_place = sheet::draw_callouts(layers, callouts, placed, style).without_place;
    return placed;
  }
  std::vector<std::size_t> without_place{};
  sheet::Rectangle box_of(const sheet::Text& text) const { return sheet::around(sheet::box_of(text, lettering)); }
};

TEST_F(Callouts, StandOutsideTheViewClearOfEverything) {
  std::vector<sheet::Callout> notes;
  for (int i = 0; i < 6; ++i)
    notes.push_back(note("NOTE " + std::to_string(i), {110.0 + 20 * (i % 3), 95.0 + 15 * (i / 3)}));
  place(notes);
  EXPECT_TRUE(without_place.empty());
  ASSERT_EQ(layer.texts.size(), 6U);
  ASSERT_EQ(layer.strokes.size(), 6U);
  for (std::size_t i = 0; i < 6; ++i) {
    const sheet::Rectangle text = box_of(layer.texts[i]);
    EXPECT_FALSE(text.overlaps(box)) << i;
    EXPECT_FALSE(text.overlaps(dimension)) << i;
    EXPECT_TRUE(around.paper->holds(text)) << i;
    const std::vector<Vec2>& leader = layer.strokes[i].points;
    ASSERT_EQ(leader.size(), 3U);
    EXPECT_EQ(leader[0], notes[i].target->point);
    EXPECT_EQ(leader[1].y, leader[2].y) << "the reference line is horizontal";
    EXPECT_LT(leader[1].y, text.min.y) << "and below the text";
    EXPECT_NE(leader[0].x, leader[1].x) << "leaders are oblique";
    EXPECT_NE(leader[0].y, leader[1].y);
    EXPECT_FALSE(overlap(sheet::line_box(leader[0], leader[1]), sheet::turned_box(dimension))) << i;
    for (std::size_t j = 0; j < 6; ++j) {
      if (i == j) continue;
      EXPECT_FALSE(text.overlaps(box_of(layer.texts[j]))) << i << " and " << j;
      EXPECT_FALSE(overlap(sheet::line_box(leader[0], leader[1]), sheet::box_of(layer.texts[j], lettering)));
    }
  }
}

TEST_F(Callouts, AreLeftOutWhereThereIsNoPlace) {
  around.paper = box;
  around.boxes = {sheet::turned_box(box)};
  const std::vector<sheet::Callout> notes{note("NOTE", {140, 100})};
  place(notes);
  EXPECT_EQ(without_place, std::vector<std::size_t>{0});
  EXPECT_TRUE(layer.texts.empty());
  EXPECT_TRUE(layer.strokes.empty());
}

TEST_F(Callouts, StandWhereTheyAreToldAndTellThatTheyMeet) {
  std::vector<sheet::Callout> notes{note("FREE", {140, 100}), note("ON A LINE", {120, 100})};
  notes[0].at = Vec2(200, 160);
  notes[1].at = Vec2(90, 90);
  EXPECT_TRUE(place(notes).has_conflicts) << "one of them is on a line";
  ASSERT_EQ(layer.texts.size(), 2U);
  EXPECT_DOUBLE_EQ(box_of(layer.texts[0]).max.y, 160);
  EXPECT_DOUBLE_EQ(layer.strokes[0].points[1].x, 200) << "its leader begins at the nearer end";
}

TEST_F(Callouts, EndWithADotAnArrowOrNothing) {
  std::vector<sheet::Callout> notes{note("A", {140, 100}), note("B", {180, 100}), note("C", {150, 90})};
  notes[1].target->end = LeaderEnd::arrow;
  notes[2].target->end = LeaderEnd::none;
  place(notes);
  ASSERT_EQ(layer.fills.size(), 2U);
  const auto radius = [&](const Vec2& p) { return glm::length(p - Vec2(140, 100)); };
  for (const Vec2& p : layer.fills[0].rings[0]) EXPECT_NEAR(radius(p), 0.625, 1e-9);
  EXPECT_EQ(layer.fills[1].rings[0][0], Vec2(180, 100)) << "the tip of the arrow";
}

// The border of the view at its right side, with nothing beyond it.
sheet::CalloutTarget right_side(double y) { return {{180, y}, LeaderEnd::arrow, Vec2(1, 0), true}; }

TEST_F(Callouts, ReachFramesPerpendicularToTheLine) {
  scene::ToleranceFrame frame{Characteristic::position, {{"⌀0.1"}, {"M", true}}, {{{"A"}}}};
  std::vector<sheet::Callout> callouts{sheet::tolerance_frame(frame, style)};
  callouts[0].target = right_side(100);
  place(callouts);
  ASSERT_EQ(layer.strokes.size(), 1U);
  ASSERT_EQ(layer.strokes[0].points.size(), 2U) << "straight";
  EXPECT_NEAR(layer.strokes[0].points[1].y, 100, 1e-9);
  const sheet::Stroke& outline =
      layers.symbols.strokes.back().closed ? layers.symbols.strokes.back() : layers.symbols.strokes.front();
  ASSERT_TRUE(outline.closed);
  EXPECT_NEAR(outline.points[0].y, 100 - style.text, 1e-9) << "it meets the frame, 2 h high, in the middle of its side";
  EXPECT_NEAR(outline.points[0].x, layer.strokes[0].points[1].x, 1e-9);
  EXPECT_DOUBLE_EQ(layers.symbols.style.width, 0.35) << "a tenth of the height of capitals";
}

// A frame whose own side of the part is full of lettering, as is the way to it.
TEST_F(Callouts, EndAtAnotherPointWhereThatIsBetter) {
  scene::ToleranceFrame frame{Characteristic::position, {{"⌀0.1"}, {"M", true}}, {{{"A"}}}};
  std::vector<sheet::Callout> callouts{sheet::tolerance_frame(frame, style)};
  callouts[0].target = right_side(100);
  around.boxes.push_back(sheet::turned_box({{182, 60}, {287, 160}}));
  place(callouts);
  ASSERT_EQ(layer.strokes.size(), 1U);
  EXPECT_EQ(layer.strokes[0].points[0], Vec2(180, 100));
  layers = sheet::callout_layers("front", style);
  callouts[0].others = {{{100, 100}, LeaderEnd::arrow, Vec2(-1, 0), true}};
  place(callouts);
  ASSERT_EQ(layer.strokes.size(), 1U);
  EXPECT_EQ(layer.strokes[0].points[0], Vec2(100, 100));
  EXPECT_LT(layer.strokes[0].points[1].x, 100);
}

// A line of a dimension close beside the straight way to the frame.
TEST_F(Callouts, KeepLeadersClearOfParallelLines) {
  scene::ToleranceFrame frame{Characteristic::position, {{"⌀0.1"}, {"M", true}}, {{{"A"}}}};
  for (const double beside : {0.3, 0.6, -0.6}) {
    std::vector<sheet::Callout> callouts{sheet::tolerance_frame(frame, style)};
    callouts[0].target = right_side(100);
    callouts[0].others = {right_side(110)};
    around.boxes = {sheet::line_box({181, 100 + beside}, {186, 100 + beside})};
    layers = sheet::callout_layers("front", style);
    place(callouts);
    ASSERT_EQ(layer.strokes.size(), 1U);
    EXPECT_EQ(layer.strokes[0].points[0], Vec2(180, 110)) << beside;
  }
}

TEST_F(Callouts, StandDatumsOnTheirLines) {
  std::vector<sheet::Callout> callouts{sheet::datum_frame({"A"}, style)};
  callouts[0].target = right_side(100);
  place(callouts);
  ASSERT_EQ(layer.fills.size(), 1U);
  std::vector<Vec2> triangle = layer.fills[0].rings[0];
  ASSERT_EQ(triangle.size(), 3U);
  EXPECT_NEAR(triangle[0].x, 180, 1e-9) << "its base is on the line";
  EXPECT_NEAR(triangle[1].x, 180, 1e-9);
  EXPECT_NEAR(std::abs(triangle[0].y - triangle[1].y), style.text, 1e-9);
  EXPECT_GT(triangle[2].x, 180) << "it is outside";
  EXPECT_NEAR(triangle[2].y, 100, 1e-9);
  callouts[0].at = Vec2(200, 170);
  callouts[0].target = {{140, 130}, LeaderEnd::arrow, Vec2(0, 1), true};
  place(callouts);
  triangle = layer.fills[1].rings[0];
  EXPECT_NEAR(triangle[2].x, 140, 1e-9) << "it stands upright, wherever its frame is";
}

TEST_F(Callouts, BendLeadersOfDatumsPastLettering) {
  const sheet::Rectangle text{{185, 96}, {200, 104}};
  around.boxes.push_back(sheet::turned_box(text));
  std::vector<sheet::Callout> callouts{sheet::datum_frame({"A"}, style)};
  callouts[0].target = right_side(100);
  place(callouts);
  EXPECT_TRUE(without_place.empty());
  ASSERT_EQ(layer.strokes.size(), 1U);
  const std::vector<Vec2>& leader = layer.strokes[0].points;
  ASSERT_EQ(leader.size(), 4U);
  EXPECT_NEAR(leader[1].y, 100, 1e-9) << "as far as the tip of the triangle, it is perpendicular";
  EXPECT_EQ(leader[2].y, leader[3].y);
  for (std::size_t i = 1; i < leader.size(); ++i)
    EXPECT_FALSE(overlap(sheet::line_box(leader[i - 1], leader[i]), sheet::turned_box(text)));
}

// ISO 1302: arms at 60 degrees; a bar or a circle between them.
// From wherever it comes, the arrow is on the nearest point of the rim, and the leader aims at the centre.
TEST_F(Callouts, EndOnRimsOnTheWayToTheirCentres) {
  const Vec2 centre(140, 105);
  for (const sheet::RimOnPaper& rim : {sheet::RimOnPaper{centre, {8, 0}, {0, 8}}, {centre, {6, 2}, {-1, 5}}}) {
    std::vector<sheet::Callout> notes{note("TO A HOLE", centre + rim.v), note("TO IT", centre + rim.v)};
    for (sheet::Callout& one : notes) one.target->rim = rim;
    notes[1].at = Vec2(60, 60);
    layers = sheet::callout_layers("front", style);
    place(notes);
    ASSERT_EQ(layer.strokes.size(), 2U);
    for (const sheet::Stroke& leader : layer.strokes) {
      const Vec2 from = leader.points[0] - centre, way = leader.points[1] - centre;
      EXPECT_NEAR(from.x * way.y - from.y * way.x, 0, 1e-9);
      EXPECT_GT(glm::dot(from, way), 0);
      const double det = rim.u.x * rim.v.y - rim.u.y * rim.v.x;
      const Vec2 part = Vec2(from.x * rim.v.y - from.y * rim.v.x, rim.u.x * from.y - rim.u.y * from.x) / det;
      EXPECT_NEAR(glm::length(part), 1, 1e-9) << "on the rim";
    }
  }
}

// A row of points close to each other, as many notes as two columns beside the view hold.
TEST_F(Callouts, HavePlacesWhileThereIsRoom) {
  std::vector<sheet::Callout> notes;
  for (int i = 0; i < 26; ++i) notes.push_back(note("NOTE OF SOME LENGTH", {102.0 + 3 * i, 105}));
  place(notes);
  EXPECT_TRUE(without_place.empty()) << without_place.size();
}

TEST_F(Callouts, ComeFromOutsideOfHatching) {
  view.cuts.faces.push_back(
      {0, 0, {{{100, 80}, {180, 80}, {180, 130}, {150, 130}, {150, 100}, {130, 100}, {130, 130}, {100, 130}}}});
  around.boxes.clear();
  std::vector<sheet::Callout> notes{note("IN THE SLOT", {130, 115})};
  notes[0].target->normal = Vec2(1, 0);
  notes[0].target->is_border = true;
  place(notes);
  ASSERT_EQ(layer.strokes.size(), 1U);
  const Vec2 bend = layer.strokes[0].points[1], up = bend - Vec2(130, 115);
  EXPECT_GT(up.x, 0);
  EXPECT_LT(130 + up.x * 15 / up.y, 150) << "through the mouth of the slot";
}

TEST_F(Callouts, DrawSymbolsOfSurfaceTexture) {
  const auto symbol = [&](MaterialRemoval removal) { return sheet::texture_symbol({removal, {"Ra 3.2"}}, style); };
  EXPECT_EQ(symbol(MaterialRemoval::any).strokes.size(), 1U);
  const sheet::Callout required = symbol(MaterialRemoval::required), prohibited = symbol(MaterialRemoval::prohibited);
  ASSERT_EQ(required.strokes.size(), 2U);
  ASSERT_EQ(prohibited.strokes.size(), 2U);
  const std::vector<Vec2>& arms = required.strokes[0].points;
  ASSERT_EQ(arms.size(), 4U) << "with the line above the text";
  EXPECT_EQ(arms[1].y, 0) << "it stands on the surface";
  EXPECT_NEAR(arms[0].y / (arms[1].x - arms[0].x), std::sqrt(3.0), 1e-9);
  EXPECT_NEAR(arms[2].y / (arms[2].x - arms[1].x), std::sqrt(3.0), 1e-9);
  EXPECT_EQ(required.strokes[1].points[0], arms[0]);
  EXPECT_FALSE(prohibited.strokes[1].curves.empty());
  const sheet::Rectangle words = box_of(required.texts[0]);
  EXPECT_GT(words.min.x, arms[2].x);
  EXPECT_LT(words.max.y, arms[2].y);
}

TEST_F(Callouts, WriteTheDecimalSignOfTheSheet) {
  style.notation.sign = DecimalSign::comma;
  EXPECT_EQ(sheet::texture_symbol({{}, {"Ra 3.2"}}, style).texts[0].text, "Ra 3,2");
  EXPECT_EQ(sheet::tolerance_frame({{}, {{"0.1"}}}, style).texts[0].text, "0,1");
}

TEST_F(Callouts, NumberGeneralNotesAndBreakLongLines) {
  const std::vector<std::vector<std::string>> notes{{"one two three four five six seven eight"}, {"first", "second"}};
  const sheet::Callout list = sheet::general_notes("Notes", notes, 50, style);
  std::vector<std::string> texts;
  for (const sheet::Text& text : list.texts) {
    texts.push_back(text.text);
    EXPECT_LE(box_of(text).max.x, 50);
    EXPECT_GE(text.at.y, 0);
  }
  ASSERT_GE(texts.size(), 7U);
  EXPECT_EQ(texts[0], "Notes");
  EXPECT_EQ(texts[1], "1.");
  EXPECT_TRUE(std::string("one two three four five six seven eight").starts_with(texts[2]));
  EXPECT_EQ((std::vector<std::string>(texts.end() - 3, texts.end())),
            (std::vector<std::string>{"2.", "first", "second"}));
  EXPECT_EQ(list.texts[1].at.y, list.texts[2].at.y) << "a number and its note have one base line";
  EXPECT_EQ(list.texts[2].at.x, list.texts[3].at.x) << "further lines are below the first one";
}

// The room without the taken strip is a free part on the left and one on the right.
TEST(NearestFreePosition, IsTheOneTowardsAPoint) {
  const sheet::Rectangle room{{0, 0}, {100, 50}};
  const std::vector<sheet::Rectangle> taken{{{30, 0}, {60, 50}}};
  const auto left = sheet::nearest_free_position(room, taken, {20, 10}, {0, 0});
  ASSERT_TRUE(left);
  EXPECT_EQ(*left, Vec2(3, 3));
  const auto right = sheet::nearest_free_position(room, taken, {30, 10}, {0, 0});
  ASSERT_TRUE(right) << "too wide for the left part";
  EXPECT_EQ(*right, Vec2(63, 3));
  EXPECT_FALSE(sheet::nearest_free_position(room, taken, {40, 10}, {0, 0}));
}

}  // namespace
}  // namespace epura::test::callouts_test
