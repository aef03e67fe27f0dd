// SPDX-License-Identifier: Apache-2.0
#include "drawing/make_drawing.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "drawing/breaks.hpp"
#include "drawing/chains.hpp"
#include "drawing/clip_drawing.hpp"
#include "shapes.hpp"

namespace epura::test::make_drawing_test {
namespace {

TEST(MakeDrawing, LinesCoincideWithinContactOrFourCellsOfThePage) {
  const Result r = draw(world_of(four_boxes()), from_above());
  const double expected = 2 * std::max(4 * r.view.cell, r.view.contact.touching);
  EXPECT_DOUBLE_EQ(drawing::coincidence_on_paper(r.view, {2, Vec2(0)}).tolerance, expected);
}

// In a perspective, the middle of an edge on paper is not its middle in space.
TEST(MakeDrawing, ParametersAreThoseInSpace) {
  const Vec3 eye(4, -3, 3.5), point(0.5);
  const Result r = draw(world_of(four_boxes()), perspective(eye, point, {4, -3, 3}, {0, 0, 1}));
  const projection::Projection& p = r.view.projection;
  const mesh::Mesh& mesh = *r.world.models[0].mesh;
  const auto image = [&](const drawing::Segment& s, double t) {
    const Vec3 a = mesh.point(s.edge[0]), b = mesh.point(s.edge[1]), at = a + t * (b - a);
    const Vec3 on_plane = eye + glm::dot(point - eye, p.n) / glm::dot(at - eye, p.n) * (at - eye) - point;
    return Vec2(glm::dot(on_plane, p.u), glm::dot(on_plane, p.v));
  };
  int cut = 0;
  for (const drawing::Segment& s : r.drawing.segments) {
    if (s.edge[0] < 0 || (s.t[0] == 0 && s.t[1] == 1)) continue;
    ++cut;
    EXPECT_LT(glm::distance(r.unit * (s.to - s.from), image(s, s.t[1]) - image(s, s.t[0])), 1e-6);
  }
  EXPECT_GT(cut, 10);
}

TEST(MakeDrawing, FoldsAreNotDrawn) {
  Result r = draw(world_of(four_boxes()), orthographic({0.31, -0.62, 0.41}));
  const auto drawn = [&] {
    return drawing::make_drawing({r.world, r.view, r.drawn, r.hidden}, {1, Vec2(0)}, {"test", true}).segments;
  };
  const auto count = [](const std::vector<drawing::Segment>& segments, bool visible) {
    return std::ranges::count_if(segments, [&](const drawing::Segment& s) { return s.visible == visible; });
  };
  const std::vector<drawing::Segment> before = drawn();
  for (std::size_t e = 0; e < r.drawn.edges.size(); ++e)
    r.hidden.visit_parts(e, [&](double from, double to, bool visible) {
      if (!visible) r.hidden.folds.push_back({static_cast<int>(e), from, to});
    });
  const std::vector<drawing::Segment> after = drawn();
  EXPECT_GT(count(before, false), 0);
  EXPECT_EQ(count(after, false), 0);
  EXPECT_EQ(count(after, true), count(before, true));
}

drawing::ViewDrawing lines_of_length(const std::vector<double>& lengths) {
  drawing::ViewDrawing drawing;
  for (std::size_t i = 0; i < lengths.size(); ++i) {
    const Vec2 from(0, static_cast<double>(i)), to = from + Vec2(lengths[i], 0);
    const auto number = static_cast<int>(i);
    drawing.segments.push_back({from, to, true, EdgeKind::crease, 0, {number, number + 1}, -1, {0, 1}});
    drawing.chains.push_back({{from, to}, false, true, EdgeKind::crease, {number}});
  }
  return drawing;
}

TEST(Thin, KeepsTheLongestLines) {
  drawing::ViewDrawing drawing = lines_of_length({1, 3, 2});
  EXPECT_EQ(drawing::keep_longest_chains(drawing, 2), 1U);
  ASSERT_EQ(drawing.segments.size(), 2U);
  EXPECT_EQ(drawing.segments[0].to.x, 3);
  EXPECT_EQ(drawing.segments[1].to.x, 2);
  EXPECT_EQ(drawing.chains[1].segments, std::vector<int>{1});
}

TEST(ClipDrawing, PartsHaveTheirParametersAlongTheWholeLine) {
  drawing::ViewDrawing drawing = lines_of_length({10});
  drawing.segments[0].t = {0.5, 1};
  drawing::clip_to(drawing, drawing::Boundary{{4, 0}, {2, 1}, false});
  ASSERT_EQ(drawing.segments.size(), 1U);
  EXPECT_DOUBLE_EQ(drawing.segments[0].t[0], 0.6);  // x = 2 of 10
  EXPECT_DOUBLE_EQ(drawing.segments[0].t[1], 0.8);
}

TEST(Breaks, PartsAreMovedTogetherUpToAGap) {
  drawing::Breaks breaks;
  breaks.along[0] = {{10, 40}, {60, 65}};
  breaks.gap = 3;
  const std::vector<drawing::KeptPart> parts = drawing::kept_parts(breaks);
  ASSERT_EQ(parts.size(), 3U);
  EXPECT_EQ(parts[0].shift.x, 0);
  EXPECT_EQ(parts[1].shift.x, -27);  // 40 comes to 10 + 3
  EXPECT_EQ(parts[2].shift.x, -29);
  const auto left = drawing::remaining_line(breaks, {50, 1}, {50, 2});
  ASSERT_EQ(left.size(), 1U);
  EXPECT_EQ(left[0][0].x, 23);
}

}  // namespace
}  // namespace epura::test::make_drawing_test
