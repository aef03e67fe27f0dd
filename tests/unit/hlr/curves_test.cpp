// SPDX-License-Identifier: Apache-2.0
// Lines of known lengths, and where they come from.
#include <algorithm>
#include <array>
#include <limits>
#include <set>
#include <string>
#include <thread>
#include <tuple>
#include <vector>

#include "shapes.hpp"

namespace epura::test::curves_test {
namespace {

bool is_visible(const epura_hlr_curve& curve) { return curve.visible != 0; }
bool is_hidden(const epura_hlr_curve& curve) { return curve.visible == 0; }

TEST(HlrCurves, OfABoxAreNineVisibleEdgesAndThreeHiddenOnes) {
  const HlrModel model;
  add_box(model, {1, 2, 3});
  model.finish();
  const Drawing drawing = model.draw(request_for(isometric));
  const double edge = std::sqrt(2.0 / 3);  // of unit length, as all three axes are seen
  EXPECT_NEAR(length_of_all(drawing, is_visible), edge * 3 * (1 + 2 + 3), 1e-9);
  EXPECT_NEAR(length_of_all(drawing, is_hidden), edge * (1 + 2 + 3), 1e-9);
  const epura_hlr_result& result = *epura_hlr_result_of(drawing.get());
  for (std::size_t i = 0; i < 8; ++i) EXPECT_NEAR(result.matrix[i], isometric[i], 1e-12);
  EXPECT_TRUE(std::isnan(result.error));
}

TEST(HlrCurves, TellWhichFacesMeetInThem) {
  const HlrModel model;
  add_box(model, {1, 2, 3});
  model.finish();
  const Drawing drawing = model.draw(request_for(isometric));
  std::set<std::array<std::uint32_t, 2>> pairs;
  for (const epura_hlr_curve& curve : curves_of(drawing)) {
    const std::array faces{curve.faces[0].face, curve.faces[1].face};
    pairs.insert({std::min(faces[0], faces[1]), std::max(faces[0], faces[1])});
    EXPECT_EQ(curve.edge, EPURA_NONE);
    EXPECT_EQ(curve.faces[0].shape, 0U);
  }
  // Each face meets all but itself and that across.
  EXPECT_EQ(pairs.size(), 12U);
  for (const auto& [one, other] : pairs) EXPECT_NE(one / 2, other / 2);
}

TEST(HlrCurves, OfACylinderAreArcsAndGenerators) {
  const HlrModel model;
  add_cylinder(model, 5, 12);
  model.finish();
  // From the front, 45 degrees from above: circles are ellipses with semi-axes 5 and 5 sin 45.
  const std::array matrix{1.0, 0.0, 0.0, 0.0, 0.0, half, half, 0.0, 0.0, -half, half, 0.0, 0.0, 0.0, 0.0, 1.0};
  epura_hlr_request request = request_for(matrix);
  request.arcs = 0.01;
  request.finds_error = 1;
  const Drawing drawing = model.draw(request);
  const auto of_edge = [](std::uint32_t edge, bool visible) {
    return [=](const epura_hlr_curve& c) { return c.edge == edge && (c.visible != 0) == visible; };
  };
  double ellipse = 0;  // its length, by chords of 0.01 degrees
  for (int i = 0; i < 36000; ++i) {
    const double a = 2 * std::numbers::pi * (i + 0.5) / 36000;
    ellipse += 5 * std::hypot(std::sin(a), half * std::cos(a)) * 2 * std::numbers::pi / 36000;
  }
  EXPECT_NEAR(length_of_all(drawing, of_edge(1, true)), ellipse, 1e-3);
  EXPECT_NEAR(length_of_all(drawing, of_edge(0, true)), ellipse / 2, 1e-3);
  EXPECT_NEAR(length_of_all(drawing, of_edge(0, false)), ellipse / 2, 1e-3);
  for (const epura_hlr_curve& curve : curves_of(drawing)) {
    if (curve.edge == EPURA_NONE) {  // a generator on the silhouette
      EXPECT_EQ(curve.kind, std::uint32_t{EPURA_HLR_CONTOUR});
      EXPECT_EQ(curve.faces[0].face, 2U);
      EXPECT_NEAR(length_of(drawing, curve), 12 * half, 1e-3);
      const double x = epura_hlr_result_of(drawing.get())->points[2 * curve.first];
      EXPECT_NEAR(std::abs(x), 5, 1e-3);
      continue;
    }
    EXPECT_EQ(curve.type, std::uint32_t{EPURA_HLR_ELLIPSE});
    EXPECT_NEAR(std::hypot(curve.u[0], curve.u[1]) * std::hypot(curve.v[0], curve.v[1]), 25 * half, 1e-3);
  }
  const double error = epura_hlr_result_of(drawing.get())->error;
  EXPECT_GT(error, 0);
  EXPECT_LT(error, 0.1);
}

TEST(HlrCurves, OfShapesThatStandSeveralTimesTellTheNode) {
  const HlrModel model;
  add_box(model, {1, 1, 1});
  model.node(0, {0, 0, 0});
  model.node(0, {5, 0, 0});
  model.node(0, {5.5, 0.5, 0.5});  // through the second one
  model.finish();
  const Drawing drawing = model.draw(request_for(isometric));
  std::array<double, 3> lengths{};
  for (const epura_hlr_curve& curve : curves_of(drawing)) {
    ASSERT_LT(curve.faces[0].node, 3U);
    if (curve.kind == EPURA_HLR_INTERSECTION)
      EXPECT_NE(curve.faces[0].node, curve.faces[1].node);
    else
      EXPECT_EQ(curve.faces[0].node, curve.faces[1].node);
    lengths[curve.faces[0].node] += length_of(drawing, curve);
  }
  EXPECT_NEAR(lengths[0], 12 * std::sqrt(2.0 / 3), 1e-9);
  EXPECT_GE(std::ranges::count_if(curves_of(drawing), [](const auto& c) { return c.kind == EPURA_HLR_INTERSECTION; }),
            1);
}

TEST(HlrCurves, OfWiresHaveTheirNumbers) {
  const HlrModel model;
  model.shape("sketch");
  model.points({0, 0, 0, 4, 0, 0, 4, 3, 0, 9, 9, 0});
  model.edge(EPURA_WIRE, {0, 1});
  model.edge(EPURA_WIRE, {1, 2, 3});
  model.finish();
  const Drawing drawing = model.draw(request_for(top));
  const auto wire = [](std::uint32_t number) {
    return [=](const epura_hlr_curve& c) { return c.edge == number && c.kind == EPURA_HLR_WIRE; };
  };
  EXPECT_NEAR(length_of_all(drawing, wire(0)), 4, 1e-9);
  EXPECT_NEAR(length_of_all(drawing, wire(1)), 3 + std::hypot(5, 6), 1e-9);
}

TEST(HlrCurves, AreLeftOutIfNotWanted) {
  const HlrModel model;
  add_box(model, {1, 2, 3});
  model.finish();
  epura_hlr_request request = request_for(isometric);
  request.only_visible = 1;
  EXPECT_EQ(length_of_all(model.draw(request), is_hidden), 0);
  request.kinds = EPURA_HLR_CONTOUR;
  const Drawing outline = model.draw(request);
  EXPECT_NEAR(length_of_all(outline, is_visible), std::sqrt(2.0 / 3) * 2 * (1 + 2 + 3), 1e-9);
}

TEST(HlrCurves, FollowAnyProjection) {
  const HlrModel model;
  add_box(model, {1, 2, 3});
  model.finish();
  epura_view view{};
  view.size = sizeof view;
  view.normal[1] = -1;
  view.up[2] = 1;
  view.projector[1] = -1;
  view.scale = 2;
  view.front = std::numeric_limits<double>::infinity();
  view.back = -view.front;
  epura_hlr_request request{};
  request.size = sizeof request;
  request.view = &view;
  EXPECT_NEAR(length_of_all(model.draw(request), is_visible), 2 * 2 * (1 + 3), 1e-9);
  // From (0, -9, 0) onto y = 0: what is at y = 2 is 9 / 11 as large, and lies inside.
  view.projectors = EPURA_CENTRAL;
  view.projector[1] = -9;
  view.scale = 1;
  const double nearer = 2 * (1 + 3), farther = 9.0 / 11 * nearer;
  const Drawing central = model.draw(request);
  EXPECT_NEAR(length_of_all(central, is_visible), nearer, 1e-9);
  const double x = 1 - 9.0 / 11, z = 3 - 3 * 9.0 / 11;
  // Two sides of the rear face coincide with those of the front, as do three of the edges between both.
  EXPECT_NEAR(length_of_all(central, is_hidden), farther / 2 + std::hypot(x, z), 1e-9);

  epura_projection row{};
  row.size = sizeof row;
  row.name = "front";
  row.project = [](const double*, const epura_scene* scene, epura_view* seen) -> const char* {
    if (scene->most[2] != 3) return "the box is another one";
    seen->normal[1] = seen->projector[1] = -1;
    seen->up[2] = 1;
    return nullptr;
  };
  request.view = nullptr;
  request.projection = &row;
  EXPECT_NEAR(length_of_all(model.draw(request), is_visible), nearer, 1e-9);
}

TEST(HlrCurves, AreTheSameOnAllThreadsAtOnce) {
  const HlrModel model;
  add_cylinder(model, 5, 12);
  add_box(model, {1, 2, 3});
  model.finish();
  const auto points = [&] {
    const Drawing drawing = model.draw(request_for(isometric));
    const epura_hlr_result& result = *epura_hlr_result_of(drawing.get());
    return std::vector<double>(result.points, result.points + 2 * result.point_count);
  };
  const std::vector<double> alone = points();
  std::array<bool, 8> same{};
  std::vector<std::thread> threads;
  for (bool& is_same : same) threads.emplace_back([&] { is_same = points() == alone; });
  for (std::thread& thread : threads) thread.join();
  for (const bool is_same : same) EXPECT_TRUE(is_same);
}

}  // namespace
}  // namespace epura::test::curves_test
