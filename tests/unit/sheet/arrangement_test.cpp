// SPDX-License-Identifier: Apache-2.0
#include "sheet/arrangement.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "base/error.hpp"
#include "sheet/free_rectangles.hpp"

namespace epura::arrangement_test {
namespace {

using enum sheet::ViewPlace;

// A box of 60 x 40 x 20 around the origin, seen from all sides.
sheet::ViewToPlace view_of_box(sheet::ViewPlace place, const Vec3& size = {60, 40, 20}) {
  Vec2 half = Vec2(size.x, size.z) / 2.0;
  if (place == left || place == right) half = Vec2(size.y, size.z) / 2.0;
  if (place == top || place == bottom) half = Vec2(size.x, size.y) / 2.0;
  if (place == pictorial || place == other) half = Vec2(size.x + size.y, size.x + size.z) / 3.0;
  sheet::ViewToPlace view;
  view.place = place;
  view.box = {-half, half};
  return view;
}

std::vector<sheet::ViewToPlace> views_of_box(const std::vector<sheet::ViewPlace>& places) {
  std::vector<sheet::ViewToPlace> views;
  for (const sheet::ViewPlace place : places) views.push_back(view_of_box(place));
  return views;
}

sheet::DrawingRoom a3() {
  const sheet::Paper paper = sheet::make_paper(scene::parse_paper_size("A3", "--sheet"), false);
  return {paper, sheet::Rectangle{{230, 10}, {410, 50}}, 5, 20};
}

// Nothing over anything else, and all in the drawing area.
void expect_tidy(const sheet::Arrangement& arrangement, const sheet::DrawingRoom& room) {
  const sheet::Paper& paper = arrangement.paper;
  const sheet::Rectangle area{{paper.left, paper.other}, {paper.width - paper.other, paper.height - paper.other}};
  for (std::size_t i = 0; i < arrangement.views.size(); ++i) {
    const sheet::Rectangle& box = arrangement.views[i].box;
    EXPECT_EQ(arrangement.views[i].view, i);
    EXPECT_TRUE(area.holds(box, 1e-6)) << i;
    EXPECT_FALSE(room.title_block && box.overlaps(*room.title_block, 1e-6)) << i;
    for (std::size_t j = 0; j < i; ++j) EXPECT_FALSE(box.overlaps(arrangement.views[j].box, 1e-6)) << i << " " << j;
  }
}

bool above(const sheet::ViewSpot& a, const sheet::ViewSpot& b) { return a.box.min.y > b.box.max.y; }
bool right_of(const sheet::ViewSpot& a, const sheet::ViewSpot& b) { return a.box.min.x > b.box.max.x; }

TEST(Arrangement, FirstAngleShowsFromAboveBelowAndFromTheLeftAtTheRight) {
  const auto views = views_of_box({front, back, left, right, top, bottom});
  const sheet::Arrangement made = sheet::arrange(views, {}, ProjectionAngle::first, a3());
  const auto& v = made.views;
  EXPECT_TRUE(above(v[0], v[4]));  // front above the view from above
  EXPECT_TRUE(above(v[5], v[0]));
  EXPECT_TRUE(right_of(v[2], v[0]));
  EXPECT_TRUE(right_of(v[0], v[3]));
  EXPECT_TRUE(right_of(v[1], v[2]));
  EXPECT_TRUE(made.inside);
  expect_tidy(made, a3());
}

// The second front view is one of the others, beside which there is no fixed place.
TEST(Arrangement, AViewBesideOneOfTwoFrontViewsHasAPlace) {
  for (const std::size_t parent : {0U, 1U}) {
    auto views = views_of_box({front, front, other});
    views[2].beside.emplace(parent, Vec2(1, 0));
    const sheet::Arrangement made = sheet::arrange(views, {}, ProjectionAngle::first, a3());
    ASSERT_EQ(made.views.size(), 3U);
    EXPECT_TRUE(made.inside);
    expect_tidy(made, a3());
  }
}

TEST(Arrangement, ThirdAngleShowsFromAboveAboveAndFromTheLeftAtTheLeft) {
  const auto views = views_of_box({front, back, left, right, top, bottom});
  const sheet::Arrangement made = sheet::arrange(views, {}, ProjectionAngle::third, a3());
  const auto& v = made.views;
  EXPECT_TRUE(above(v[4], v[0]));
  EXPECT_TRUE(above(v[0], v[5]));
  EXPECT_TRUE(right_of(v[0], v[2]));
  EXPECT_TRUE(right_of(v[3], v[0]));
  EXPECT_TRUE(right_of(v[1], v[3]));
  expect_tidy(made, a3());
}

// Without a title block the sheet is symmetrical, and so are the two ways to arrange.
TEST(Arrangement, FirstAndThirdAngleAreMirrorArrangements) {
  const auto views = views_of_box({front, left, right, top, bottom});
  const sheet::DrawingRoom room{sheet::make_paper(scene::parse_paper_size("A3", "--sheet"), false)};
  const auto first = sheet::arrange(views, {}, ProjectionAngle::first, room);
  const auto third = sheet::arrange(views, {}, ProjectionAngle::third, room);
  ASSERT_EQ(first.scale, third.scale);
  const Vec2 centre(215, 148.5);
  for (std::size_t i = 0; i < views.size(); ++i) {
    const Vec2 there = first.views[i].box.centre() - centre, here = third.views[i].box.centre() - centre;
    EXPECT_LT(glm::length(there + here), 1e-9) << i;
  }
}

TEST(Arrangement, AlignsWithAFrontViewThatIsNotThere) {
  const auto views = views_of_box({left, top});
  const auto made = sheet::arrange(views, {}, ProjectionAngle::first, a3()).views;
  const auto with_front = sheet::arrange(views_of_box({left, top, front}), {}, ProjectionAngle::first, a3()).views;
  EXPECT_TRUE(right_of(made[0], made[1]));
  EXPECT_TRUE(above(made[0], made[1]));
  EXPECT_TRUE(right_of(with_front[0], with_front[1]));
}

// Scales of ISO 5455 from 1:100 to 100:1, ascending.
constexpr std::array<double, 13> standard_scales{0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1, 2, 5, 10, 20, 50, 100};

TEST(Arrangement, StandardScaleIsTheLargestThatFits) {
  const auto views = views_of_box({front, left, top});
  const sheet::Arrangement standard = sheet::arrange(views, {std::nullopt, true}, ProjectionAngle::first, a3());
  EXPECT_TRUE(standard.inside);
  for (const double scale : standard_scales)
    EXPECT_EQ(sheet::arrange(views, {scale}, ProjectionAngle::first, a3()).inside, scale <= standard.scale) << scale;
  EXPECT_TRUE(std::count(standard_scales.begin(), standard_scales.end(), standard.scale) == 1) << standard.scale;
}

TEST(Arrangement, PictorialViewTakesASmallerStandardScaleWhereItsOwnHasNoRoom) {
  auto views = views_of_box({front, left, top, pictorial});
  views[3].box = {{-200, -150}, {100, 150}};
  const sheet::Arrangement made = sheet::arrange(views, {2.0}, ProjectionAngle::first, a3());
  EXPECT_EQ(made.scale, 2);
  EXPECT_EQ(made.views[0].scale, 2);
  EXPECT_LT(made.views[3].scale, 2);
  EXPECT_TRUE(std::count(standard_scales.begin(), standard_scales.end(), made.views[3].scale) == 1);
  EXPECT_TRUE(made.inside);
  expect_tidy(made, a3());
}

TEST(Arrangement, PictorialViewKeepsTheScaleWhereThereIsRoom) {
  const auto made = sheet::arrange(views_of_box({front, pictorial}), {1.0}, ProjectionAngle::first, a3());
  EXPECT_EQ(made.views[1].scale, 1);
  expect_tidy(made, a3());
}

// At two fifths of the scale of the others, it would leave them a third of theirs; a tenth is enough for it then.
TEST(Arrangement, AVeryLargePictorialViewDoesNotMakeTheOthersSmall) {
  const std::vector<sheet::ViewToPlace> views{view_of_box(front), view_of_box(pictorial, {2400, 1600, 800})};
  const sheet::Arrangement made = sheet::arrange(views, {}, ProjectionAngle::first, a3());
  EXPECT_GT(made.views[0].scale, 0.9);  // the drawing area is 277 high, the pictorial view 0.4 * 1067 at a scale of 0.4
  EXPECT_LT(made.views[1].scale, 0.4 * made.views[0].scale);
  expect_tidy(made, a3());
}

TEST(Arrangement, OnlyPictorialViewsStandInAGrid) {
  const auto made =
      sheet::arrange(views_of_box({pictorial, pictorial, pictorial, pictorial}), {}, ProjectionAngle::first, a3());
  expect_tidy(made, a3());
  EXPECT_EQ(made.views[0].shift.y, made.views[1].shift.y);
  EXPECT_EQ(made.views[0].scale, made.views[3].scale);
}

TEST(Arrangement, SaysWhenAGivenScaleIsTooLarge) {
  const auto made = sheet::arrange(views_of_box({front, left, top, pictorial}), {20.0}, ProjectionAngle::first, a3());
  EXPECT_FALSE(made.inside);
  EXPECT_EQ(made.scale, 20);
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = 0; j < i; ++j) EXPECT_FALSE(made.views[i].box.overlaps(made.views[j].box));
}

TEST(Arrangement, ViewsKeepTheirGivenPlaces) {
  auto views = views_of_box({front, left, pictorial});
  views[2].at = Vec2(350, 220);
  const auto made = sheet::arrange(views, {}, ProjectionAngle::first, a3());
  expect_tidy(made, a3());
  EXPECT_LT(glm::length(made.views[2].scale * sheet::Rectangle{views[2].box.min, views[2].box.max}.centre() +
                        made.views[2].shift - Vec2(350, 220)),
            1e-9);
}

TEST(Arrangement, SaysWhenGivenPlacesOverlap) {
  auto views = views_of_box({front, pictorial});
  for (const double x : {120.0, 320.0}) {
    views[0].at = Vec2(100, 200);
    views[1].at = Vec2(x, 200);
    EXPECT_EQ(sheet::arrange(views, {1.0}, ProjectionAngle::first, a3()).inside, x > 200);
  }
}

TEST(Arrangement, SecondViewOfAPlaceStandsBeside) {
  auto views = views_of_box({front, front, left});
  views[1].after.y = sheet::label_room;
  expect_tidy(sheet::arrange(views, {}, ProjectionAngle::first, a3()), a3());
}

TEST(Arrangement, ViewsWithTheirOwnScaleKeepIt) {
  auto views = views_of_box({front, top, other});
  views[2].scale = 3;
  const auto made = sheet::arrange(views, {1.0}, ProjectionAngle::third, a3());
  EXPECT_EQ(made.views[2].scale, 3);
  expect_tidy(made, a3());
}

TEST(Arrangement, CutsPaperToSeveralViews) {
  const sheet::DrawingRoom room{sheet::make_paper(scene::parse_paper_size("none", "--sheet"), false)};
  for (const double scale : {0.01, 1.0, 50.0}) {
    const auto made =
        sheet::arrange(views_of_box({front, left, top, pictorial}), {scale}, ProjectionAngle::first, room);
    EXPECT_TRUE(made.inside);
    EXPECT_EQ(made.views[0].scale, scale);
    expect_tidy(made, room);
    sheet::Rectangle all = made.views[0].box;
    for (const sheet::ViewSpot& spot : made.views) all = sheet::united(all, spot.box);
    EXPECT_NEAR(all.min.x, 5, 1e-9);
    EXPECT_NEAR(all.min.y, 5, 1e-9);
    EXPECT_NEAR(all.max.x, made.paper.width - 5, 1e-9);
    EXPECT_NEAR(all.max.y, made.paper.height - 5, 1e-9);
  }
  EXPECT_THROW(sheet::arrange(views_of_box({front, left}), {1e6}, ProjectionAngle::first, room), Error);
}

TEST(Arrangement, OneViewAloneStandsAsItAlwaysDid) {
  for (const std::string size : {"none", "A3", "60x40"})
    for (const std::optional<double> scale : {std::optional<double>(), std::optional<double>(0.37)}) {
      const sheet::Paper paper = sheet::make_paper(scene::parse_paper_size(size, "--sheet"), false);
      const sheet::Placement placed = sheet::place_ink({-3.1, 0.2}, {17.3, 4.4}, scale, paper);
      sheet::ViewToPlace view;
      view.box = {{-3.1, 0.2}, {17.3, 4.4}};
      view.place = pictorial;
      const sheet::Arrangement made = sheet::arrange(std::vector{view}, {scale}, ProjectionAngle::first, {paper});
      EXPECT_EQ(made.scale, placed.scale);
      EXPECT_EQ(made.views[0].shift, placed.shift);
      EXPECT_EQ(made.paper.width, placed.paper.width);
      EXPECT_EQ(made.inside, placed.inside);
    }
}

TEST(Arrangement, ViewsWithoutExtentAndOfExtremeSizeFindAPlace) {
  for (const double size : {0.0, 1e-280, 1e-9, 1e9, 1e280}) {
    std::vector<sheet::ViewToPlace> views;
    for (const sheet::ViewPlace place : {front, top, pictorial, other}) views.push_back(view_of_box(place, Vec3(size)));
    for (const bool standard : {false, true}) {
      const auto made = sheet::arrange(views, {std::nullopt, standard}, ProjectionAngle::first, a3());
      EXPECT_TRUE(made.inside) << size;
      EXPECT_GT(made.scale, 0);
      expect_tidy(made, a3());
    }
  }
}

// Dimensions around a view can take all of the paper, whatever the scale of the view.
TEST(Arrangement, ViewsWithoutRoomAtAnyScaleAreBeyondTheSheet) {
  std::vector<sheet::ViewToPlace> views = views_of_box({front, right});
  views[0].before = {300, 0};
  views[0].after = {300, 0};
  for (const bool standard : {false, true}) {
    const auto made = sheet::arrange(views, {std::nullopt, standard}, ProjectionAngle::first, a3());
    EXPECT_FALSE(made.inside);
    EXPECT_GT(made.scale, 0);
  }
}

TEST(FreeRectangles, AreMaximal) {
  const sheet::Rectangle block[] = {{{60, 0}, {100, 20}}};
  const auto free = sheet::free_rectangles({{0, 0}, {100, 100}}, block);
  ASSERT_EQ(free.size(), 2U);
  EXPECT_EQ(free[0].max, Vec2(60, 100));
  EXPECT_EQ(free[1].min, Vec2(0, 20));
}

// Models, sets of views, sheets and scales drawn by lot.
TEST(ArrangementProperty, AllIsInsideApartAndAligned) {
  std::mt19937 random(7);
  const auto up_to = [&random](int n) { return static_cast<int>(random() % static_cast<unsigned>(n)); };
  for (int round = 0; round < 600; ++round) {
    const Vec3 size = Vec3(1 + up_to(100), 1 + up_to(100), 1 + up_to(100)) * std::pow(10.0, up_to(7) - 3);
    const Vec2 offset = Vec2(up_to(100), up_to(100)) * 0.3;
    const auto angle = up_to(2) == 0 ? ProjectionAngle::first : ProjectionAngle::third;
    std::vector<sheet::ViewToPlace> views;
    for (int i = 1 + up_to(8); i > 0; --i) {
      sheet::ViewToPlace view = view_of_box(static_cast<sheet::ViewPlace>(up_to(8)), size);
      view.box = {view.box.min + offset, view.box.max + offset};
      if (view.place == other) view.after.y = sheet::label_room;
      views.push_back(view);
    }
    const std::array<std::string, 5> sizes = {"A4", "A3", "A1", "300x200", "200x500"};
    sheet::DrawingRoom room{
        sheet::make_paper(scene::parse_paper_size(sizes[static_cast<std::size_t>(up_to(5))], "--sheet"), false)};
    if (up_to(2) == 0) room.clearance = 5;
    if (up_to(3) > 0)
      room.title_block = {{room.paper.width - room.paper.other - 120, room.paper.other},
                          {room.paper.width - room.paper.other, room.paper.other + 20 + up_to(20)}};
    const auto made = sheet::arrange(views, {std::nullopt, up_to(2) == 0}, angle, room);
    EXPECT_TRUE(made.inside) << round;
    expect_tidy(made, room);
    std::array<const sheet::ViewSpot*, 8> first{};
    for (const sheet::ViewSpot& spot : made.views) {
      const auto place = static_cast<std::size_t>(views[spot.view].place);
      if (first[place] == nullptr) first[place] = &spot;
    }
    for (const auto& [group, axis] :
         {std::pair(std::array{front, top, bottom}, 0), std::pair(std::array{front, left, right}, 1)})
      for (const sheet::ViewPlace a : group)
        for (const sheet::ViewPlace b : group) {
          const sheet::ViewSpot *one = first[std::size_t(a)], *two = first[std::size_t(b)];
          if (one != nullptr && two != nullptr) {
            EXPECT_NEAR(one->shift[axis], two->shift[axis], 1e-9) << round;
          }
        }
  }
}

projection::Projection seen_from(const Vec3& normal, const Vec3& up) {
  projection::Projection projection;
  projection.name = "anything";
  projection.n = projection.projector = glm::normalize(normal);
  projection.v = glm::normalize(up - glm::dot(up, projection.n) * projection.n);
  projection.u = glm::cross(projection.v, projection.n);
  return projection;
}

TEST(ViewPlace, IsThatOfTheGeometryWhateverTheName) {
  const Vec3 up(0, 0, 1);
  EXPECT_EQ(sheet::view_place(seen_from({0, -1, 0}, up)), sheet::ViewPlace::front);
  EXPECT_EQ(sheet::view_place(seen_from({0, 3, 0}, up)), sheet::ViewPlace::back);
  EXPECT_EQ(sheet::view_place(seen_from({-1, 0, 0}, up)), sheet::ViewPlace::left);
  EXPECT_EQ(sheet::view_place(seen_from({1, 0, 0}, up)), sheet::ViewPlace::right);
  EXPECT_EQ(sheet::view_place(seen_from({0, 0, 1}, {0, 1, 0})), sheet::ViewPlace::top);
  EXPECT_EQ(sheet::view_place(seen_from({0, 0, -1}, {0, -1, 0})), sheet::ViewPlace::bottom);
  // Turned on the page, or seen along no axis.
  EXPECT_EQ(sheet::view_place(seen_from({0, -1, 0}, {1, 0, 0})), sheet::ViewPlace::other);
  EXPECT_EQ(sheet::view_place(seen_from({1, -1, 0}, up)), sheet::ViewPlace::other);
  EXPECT_EQ(sheet::view_place(seen_from({1, -1, 1}, up)), sheet::ViewPlace::pictorial);
  projection::Projection oblique = seen_from({0, -1, 0}, up);
  oblique.projector = {0.5, -1, 0.5};
  EXPECT_EQ(sheet::view_place(oblique), sheet::ViewPlace::pictorial);
  oblique.projector = {0, -10, 0};
  EXPECT_EQ(sheet::view_place(oblique), sheet::ViewPlace::front);
  oblique.central = true;
  EXPECT_EQ(sheet::view_place(oblique), sheet::ViewPlace::pictorial);
}

// Gaps shrink so that a larger scale fits, but not below the height of a label in them.
TEST(Arrangement, LabelsHaveRoomInNarrowGaps) {
  auto views = views_of_box({front, top});
  views[1].labelled = true;
  for (int height = 60; height < 140; height += 2) {
    for (sheet::ViewToPlace& view : views) view.box = {Vec2(-30, -height / 2.0), Vec2(30, height / 2.0)};
    const auto made = sheet::arrange(views, {std::nullopt, true}, ProjectionAngle::first, a3());
    const auto ink_top = made.views[1].shift.y + made.views[1].scale * views[1].box.max.y;
    const auto ink_bottom = made.views[0].shift.y + made.views[0].scale * views[0].box.min.y;
    EXPECT_GE(ink_bottom - ink_top, sheet::label_room - 1e-6) << height;
  }
}

}  // namespace
}  // namespace epura::arrangement_test
