// SPDX-License-Identifier: Apache-2.0
// What dimensions say: true measures, or a reason why there are none.
#include "dimensions/dimensions.hpp"

#include <gtest/gtest.h>

#include "dimensions_support.hpp"
#include "errors.hpp"

namespace epura::test::dimensions_test {
namespace {

void expect_at(const Vec2& p, const Vec2& q) { EXPECT_LT(glm::length(p - q), 1e-6) << p.x << ' ' << p.y; }

TEST(Dimensions, LengthsOfATriangle) {
  const world::World world = placed(wedge());
  for (const double scale : {0.2, 1.0, 5.0}) {
    const drawing::ViewDrawing front = drawing_of(world, orthographic(from_front), scale);
    EXPECT_EQ(text_of(world, front, dimension("aligned", {0, 2})), "50");
    EXPECT_EQ(text_of(world, front, dimension("linear", {0, 2}, "horizontal")), "40");
    EXPECT_EQ(text_of(world, front, dimension("linear", {2, 0}, "vertical")), "30");
    // One end lies behind the other.
    EXPECT_EQ(text_of(world, front, dimension("linear", {0, 5}, "horizontal")), "40");
    EXPECT_EQ(text_of(world, front, dimension("overall", {}, "width")), "40");
    EXPECT_EQ(text_of(world, front, dimension("overall", {}, "height")), "30");
  }
  const drawing::ViewDrawing left = drawing_of(world, orthographic(from_left));
  EXPECT_EQ(text_of(world, left, dimension("overall", {}, "depth")), "10");
  EXPECT_EQ(text_of(world, left, dimension("aligned", {0, 3})), "10");
}

TEST(Dimensions, AnglesOfATriangle) {
  const world::World world = placed(wedge());
  const drawing::ViewDrawing front = drawing_of(world, orthographic(from_front));
  EXPECT_EQ(text_of(world, front, dimension("angular", {0, 1, 2})), "36.87°");
  EXPECT_EQ(text_of(world, front, dimension("angular", {2, 0, 1})), "53.13°");
  EXPECT_EQ(text_of(world, front, dimension("angular", {1, 2, 0})), "90°");
}

TEST(Dimensions, FollowTheModel) {
  for (const char* steps : {"", "rotate:y,30", "translate:1000,-300,20", "rotate:y,-200 translate:7,0,0"}) {
    const world::World world = placed(wedge(), steps);
    const drawing::ViewDrawing front = drawing_of(world, orthographic(from_front), 2);
    const sheet::Layer layer = layer_of(world, front, {dimension("aligned", {0, 2}), dimension("angular", {0, 1, 2})});
    EXPECT_EQ(layer.texts[0].text, "50") << steps;
    EXPECT_EQ(layer.texts[1].text, "36.87°") << steps;
    // The dimension line is the edge, moved square to it.
    const auto page = [&](int v) { return Vec2(front.world_to_page * Vec4(world.points[std::size_t(v)], 1)); };
    auto [a, b] = tips(layer);
    if (glm::dot(b - a, page(2) - page(0)) < 0) std::swap(a, b);
    expect_at(b - a, page(2) - page(0));
    EXPECT_NEAR(glm::length(b - a), 100, 1e-6);
    EXPECT_NEAR(glm::dot(a - page(0), page(2) - page(0)), 0, 1e-5);
    EXPECT_NEAR(glm::length(a - page(0)), 10, 1e-6) << "there is no ink before the longest side";
  }
  EXPECT_EQ(text_of(placed(wedge(), "scale:0.5"), drawing_of(placed(wedge(), "scale:0.5"), orthographic(from_front)),
                    dimension("aligned", {0, 2})),
            "25");
}

TEST(Dimensions, CirclesSeenAsCircles) {
  const world::World world = placed(cylinder(64, 10, 7), "scale:2 translate:5,6,7");
  const drawing::ViewDrawing top = drawing_of(world, from_above());
  const sheet::Layer layer = layer_of(world, top, {dimension("diameter", {3}), dimension("radius", {70})});
  EXPECT_EQ(layer.texts[0].text, "⌀40");
  EXPECT_EQ(layer.texts[1].text, "R20");
  const Vec2 centre(top.world_to_page * Vec4(5, 6, 7, 1));
  for (const sheet::Fill& arrow : layer.fills) {
    const Vec2 tip = arrow.rings[0][0], foot = (arrow.rings[0][1] + arrow.rings[0][2]) * 0.5;
    EXPECT_NEAR(glm::length(tip - centre), 20, 1e-6);
    EXPECT_NEAR(std::abs(glm::dot(glm::normalize(tip - foot), glm::normalize(tip - centre))), 1, 1e-9);
  }
}

TEST(Dimensions, CirclesSeenEdgeOn) {
  const world::World world = placed(cylinder(64, 10, 60), "rotate:x,90 rotate:z,20");
  const drawing::ViewDrawing top = drawing_of(world, from_above());
  const sheet::Layer layer = layer_of(world, top, {dimension("diameter", {3})});
  EXPECT_EQ(layer.texts[0].text, "⌀20");
  EXPECT_NEAR(glm::length(tips(layer)[0] - tips(layer)[1]), 20, 1e-6);
  const Error error = error_of([&] { layer_of(world, top, {dimension("radius", {3})}); });
  EXPECT_TRUE(contains(error.what(), "does not show the circle in its true form")) << error.what();
}

TEST(Dimensions, ACircleThroughAPointOfTheWorld) {
  const world::World world = placed(cylinder(64, 10, 7));
  const drawing::ViewDrawing top = drawing_of(world, from_above());
  scene::DimensionDescription radius = dimension("radius", {});
  radius.anchors = {Vec3(0, 10, 7)};
  EXPECT_EQ(text_of(world, top, radius), "R10");
}

TEST(Dimensions, TheTextMayBeAnother) {
  const world::World world = placed(wedge());
  const drawing::ViewDrawing front = drawing_of(world, orthographic(from_front));
  scene::DimensionDescription width = dimension("linear", {0, 1}, "horizontal");
  width.text = {"2x <> (<>)", "scene.toml:1:1"};
  EXPECT_EQ(text_of(world, front, width), "2x 40 (40)");
  width.text = {"free", "scene.toml:1:1"};
  EXPECT_EQ(text_of(world, front, width), "free");
  width.text = {"<> \xF4\x8F\xBF\xBD", "scene.toml:1:1"};
  EXPECT_TRUE(
      contains(error_of([&] { text_of(world, front, width); }).what(), "no installed font has '\xF4\x8F\xBF\xBD'"));
}

TEST(Dimensions, TwoDecimalsAtMost) {
  const auto width_of = [](double width) {
    const world::World world = placed(box({0, 0, 0}, {width, 5, 5}));
    return text_of(world, drawing_of(world, orthographic(from_front)), dimension("linear", {0, 1}, "horizontal"));
  };
  EXPECT_EQ(width_of(12.3456), "12.35");
  EXPECT_EQ(width_of(12.5), "12.5");
  EXPECT_EQ(width_of(12.0000000001), "12");
  EXPECT_EQ(width_of(0.1 + 0.2), "0.3");
}

TEST(Dimensions, AxonometricViewsShowTrueLengthsAlongTheAxes) {
  const world::World world = placed(wedge());
  const drawing::ViewDrawing isometric = drawing_of(world, orthographic(from_corner));
  EXPECT_EQ(text_of(world, isometric, dimension("aligned", {0, 1})), "40");
  EXPECT_EQ(text_of(world, isometric, dimension("aligned", {1, 4})), "10");
  EXPECT_EQ(text_of(world, isometric, dimension("aligned", {1, 2})), "30");
  // Extension lines of the width follow the axis of depth, 30 degrees up to the right.
  const std::vector<Vec2> line = layer_of(world, isometric, {dimension("aligned", {0, 1})}).strokes[0].points;
  EXPECT_NEAR((line[1].y - line[0].y) / (line[1].x - line[0].x), std::tan(std::numbers::pi / 6), 1e-6);
}

TEST(Dimensions, ObliqueViewsShowTrueLengthsInTheirPlane) {
  const world::World world = placed(wedge());
  projection::Projection cavalier = orthographic(from_front);
  cavalier.projector = {std::sqrt(0.5), -1, std::sqrt(0.5)};
  const drawing::ViewDrawing drawing = drawing_of(world, cavalier);
  EXPECT_EQ(text_of(world, drawing, dimension("aligned", {0, 2})), "50");
  EXPECT_EQ(text_of(world, drawing, dimension("angular", {0, 1, 2})), "36.87°");
  EXPECT_TRUE(contains(error_of([&] { text_of(world, drawing, dimension("aligned", {0, 5})); }).what(), "shortens"));
  EXPECT_TRUE(contains(error_of([&] {
                         text_of(world, drawing, dimension("linear", {0, 5}, "horizontal"));
                       }).what(),
                       "shortens"));
}

struct Refusal {
  scene::DimensionDescription dimension;
  const char* reason;
};

void expect_refusals(const world::World& world, const drawing::ViewDrawing& drawing,
                     const std::vector<Refusal>& refusals) {
  for (const Refusal& refusal : refusals) {
    const Error error = error_of([&] { text_of(world, drawing, refusal.dimension); });
    EXPECT_TRUE(contains(error.what(), refusal.reason)) << error.what() << "\nnot: " << refusal.reason;
    EXPECT_TRUE(error.where().starts_with("scene.toml:")) << error.where();
  }
}

TEST(Dimensions, RefusedForWhatTheViewShows) {
  const world::World world = placed(wedge());
  const Vec3 eye(60, -200, 50);
  const Refusal perspective_one{dimension("aligned", {0, 2}), "perspective"};
  expect_refusals(world, drawing_of(world, perspective(eye, {0, 0, 0}, {0, -1, 0}, {0, 0, 1})),
                  {perspective_one, {dimension("overall", {}, "width"), "perspective"}});
  expect_refusals(world, drawing_of(world, orthographic(from_corner)),
                  {{dimension("aligned", {0, 2}), "foreshortens the measured line"},
                   {dimension("linear", {0, 1}, "horizontal"), "foreshortens the measured length"},
                   {dimension("angular", {0, 1, 2}), "changes the angle"},
                   {dimension("overall", {}, "width"), "true length"}});
  expect_refusals(world, drawing_of(world, orthographic(from_left)),
                  {{dimension("aligned", {0, 1}), "looks along the measured line"},
                   {dimension("linear", {0, 1}, "horizontal"), "one above the other"},
                   {dimension("overall", {}, "width"), "true length"}});
}

TEST(Dimensions, RefusedForWhatTheySay) {
  const world::World world = placed(wedge());
  scene::DimensionDescription far_off = dimension("linear", {0, 1}, "horizontal"),
                              flat = dimension("angular", {0, 1, 2});
  far_off.offset = {1e300, ""};
  flat.offset = {0, ""};
  scene::DimensionDescription nowhere = dimension("aligned", {0});
  nowhere.anchors.emplace_back(Vec3(0, HUGE_VAL, 0));
  scene::DimensionDescription other_model = dimension("aligned", {0});
  other_model.anchors.emplace_back(std::array{3, 0});
  expect_refusals(world, drawing_of(world, orthographic(from_front)),
                  {{dimension("", {0, 1}), "has no type"},
                   {dimension("linear", {0, 1}), "has no direction"},
                   {dimension("linear", {0, 1}, "width"), "'width' is not a direction"},
                   {dimension("aligned", {0, 1}, "horizontal"), "only linear and overall"},
                   {dimension("aligned", {0}), "number of its anchors is 1"},
                   {dimension("angular", {0, 1}), "number of its anchors is 2"},
                   {dimension("aligned", {0, 99}), "model 0 has no vertex 99"},
                   {dimension("aligned", {0, -1}), "model 0 has no vertex -1"},
                   {other_model, "there is no model 3"},
                   {dimension("aligned", {1, 1}), "at the same place"},
                   {dimension("angular", {0, 0, 1}), "at the same place"},
                   {nowhere, "are not finite"},
                   {dimension("linear", {0, 1}, "vertical"), "side by side"},
                   {dimension("radius", {0}), "rim of a circle"},
                   {far_off, "not a length on a sheet"},
                   {flat, "which is positive"}});
}

TEST(Dimensions, NoAngleBetweenLegsOnOneLine) {
  const world::World world = placed(box({0, 0, 0}, {10, 10, 10}));
  scene::DimensionDescription angle = dimension("angular", {0, 1});
  angle.anchors.emplace_back(Vec3(20, 0, 0));
  expect_refusals(world, drawing_of(world, orthographic(from_front)), {{angle, "the angle is zero"}});
}

TEST(Dimensions, TheNearestCircleIsNamed) {
  const world::World world = placed(cylinder(64, 10, 7));
  scene::DimensionDescription radius = dimension("radius", {});
  radius.anchors = {Vec3(14, 0, 7)};
  const Error error = error_of([&] { text_of(world, drawing_of(world, from_above()), radius); });
  EXPECT_TRUE(contains(error.hint(), "radius 10 around 0,0,7; for example, use its vertex 64")) << error.hint();
}

TEST(Dimensions, AnUnevenScaleLeavesNoCircle) {
  const world::World world = placed(cylinder(64, 10, 7), "scale:1,2,1");
  const Error error = error_of([&] { text_of(world, drawing_of(world, from_above()), dimension("radius", {0})); });
  EXPECT_TRUE(contains(error.what(), "rim of a circle")) << error.what();
}

TEST(Dimensions, OverallOnesOfAShaftAreItsDiameter) {
  // No corner of the polygon lies on x: it is 19.9 wide.
  const std::string steps = "rotate:z,5.625";
  const world::World world = recognised(placed(cylinder(32, 10, 7), steps));
  const drawing::ViewDrawing front = drawing_of(world, orthographic(from_front));
  EXPECT_EQ(text_of(world, front, dimension("overall", {}, "width")), "⌀20");
  EXPECT_EQ(text_of(world, front, dimension("overall", {}, "height")), "7");
  const world::World mesh = placed(cylinder(32, 10, 7), steps);
  EXPECT_EQ(text_of(mesh, drawing_of(mesh, orthographic(from_front)), dimension("overall", {}, "width")), "19.9");
  // What reaches as far as the part, or as its mesh, is whole; less is not.
  drawing::ViewDrawing less = front;
  for (drawing::Segment& s : less.segments)
    for (Vec2* p : {&s.from, &s.to}) p->x = 100 + 0.99 * (p->x - 100);
  expect_refusals(world, less, {{dimension("overall", {}, "width"), "does not show all of the models"}});
  // Contours of free forms are drawn a little beside those of the mesh.
  less.distances.contours_moved = 5;
  EXPECT_EQ(text_of(world, less, dimension("overall", {}, "width")), "⌀20");
}

TEST(Dimensions, VerticesOfRoundFacesHaveTheirCircle) {
  const world::World world = recognised(placed(cylinder(32, 10, 7), "scale:3"));
  EXPECT_EQ(text_of(world, drawing_of(world, from_above()), dimension("diameter", {3})), "⌀60");
  // Vertices in the middle of a bore lie on no rim.
  Shape two = cylinder(32, 10, 7);
  for (int i = 64; i < 96; ++i)
    two.points.push_back({two.points[std::size_t(i - 32)][0], two.points[std::size_t(i - 32)][1], 12});
  two.faces.resize(two.faces.size() - 1);
  std::vector<int> top;
  for (int i = 0; i < 32; ++i) {
    two.faces.push_back({32 + i, 32 + (i + 1) % 32, 64 + (i + 1) % 32, 64 + i});
    top.push_back(64 + i);
  }
  two.faces.push_back(top);
  const world::World long_one = recognised(placed(two));
  EXPECT_EQ(text_of(long_one, drawing_of(long_one, from_above()), dimension("radius", {40})), "R10");
}

TEST(Dimensions, OverallOnesWantAllOfTheModels) {
  const world::World world = placed(wedge());
  drawing::ViewDrawing front = drawing_of(world, orthographic(from_front));
  std::erase_if(front.segments, [](const drawing::Segment& s) { return std::min(s.from.x, s.to.x) < 90; });
  expect_refusals(world, front, {{dimension("overall", {}, "width"), "does not show all of the models"}});
  front.segments.clear();
  expect_refusals(world, front, {{dimension("overall", {}, "width"), "does not show all of the models"}});
}

// The tip of a leader is on the ellipse, where the point of the circle is.
TEST(Dimensions, CirclesSeenAsEllipses) {
  const world::World world = placed(cylinder(64, 10, 7));
  const drawing::ViewDrawing corner = drawing_of(world, orthographic(from_corner));
  const sheet::Layer layer = layer_of(world, corner, {dimension("diameter", {70}), dimension("radius", {70})});
  ASSERT_EQ(layer.texts.size(), 2U);
  EXPECT_EQ(layer.texts[0].text, "⌀20");
  EXPECT_EQ(layer.texts[1].text, "R10");
  const auto page = [&](const Vec4& p) { return Vec2(corner.world_to_page * p); };
  const Vec2 centre = page({0, 0, 7, 1}), u = page({10, 0, 0, 0}), v = page({0, 10, 0, 0});
  for (const sheet::Fill& arrow : layer.fills) {
    const Vec2 off = arrow.rings[0][0] - centre;
    const double along_u = cross(off, v) / cross(u, v), along_v = cross(u, off) / cross(u, v);
    EXPECT_NEAR(std::hypot(along_u, along_v), 1, 1e-9);
  }
}

}  // namespace
}  // namespace epura::test::dimensions_test
