// SPDX-License-Identifier: Apache-2.0
// What would break if this were wrong: where centre lines lie, and what they are covered by.
#include "sheet/centre_lines.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace epura {
namespace {

constexpr sheet::LineWidths widths{0.5, 0.25};

scene::PlacedCircle circle(Vec3 centre, Vec3 axis, double radius, std::vector<int> vertices = {}) {
  return {0, {centre, axis, radius, 0, std::move(vertices), true}};
}

// A view whose page has x and y (right and up) along two directions of the world.
drawing::ViewDrawing view(Vec3 right, Vec3 up) {
  drawing::ViewDrawing drawing;
  drawing.name = "front";
  const Vec3 towards = glm::cross(right, up);
  drawing.world_to_page = rows(Vec4(right, 0), Vec4(up, 0), Vec4(towards, 0), Vec4(0, 0, 0, 1));
  return drawing;
}

const drawing::ViewDrawing top = view({1, 0, 0}, {0, 1, 0});
const drawing::ViewDrawing front = view({1, 0, 0}, {0, 0, 1});

struct Span {
  Vec2 from, to;
};

// Ends of the lines, each from its lower left end, in order.
std::vector<Span> spans(const sheet::Layer& layer) {
  std::vector<Span> all;
  const auto less = [](const Vec2& a, const Vec2& b) {
    return std::abs(a.x - b.x) > 1e-3 ? a.x < b.x : a.y < b.y - 1e-3;
  };
  for (const sheet::Stroke& stroke : layer.strokes) {
    Span span{stroke.points.at(0), stroke.points.at(1)};
    if (less(span.to, span.from)) std::swap(span.from, span.to);
    all.push_back(span);
  }
  std::sort(all.begin(), all.end(), [&](const Span& a, const Span& b) { return less(a.from, b.from); });
  return all;
}

void expect_spans(const sheet::Layer& layer, const std::vector<Span>& wanted) {
  const std::vector<Span> found = spans(layer);
  ASSERT_EQ(found.size(), wanted.size());
  for (std::size_t i = 0; i < found.size(); ++i) {
    EXPECT_LT(glm::distance(found[i].from, wanted[i].from), 1e-3)
        << i << " " << found[i].from.x << " " << found[i].from.y;
    EXPECT_LT(glm::distance(found[i].to, wanted[i].to), 1e-3) << i << " " << found[i].to.x << " " << found[i].to.y;
  }
}

sheet::Layer lines(const drawing::ViewDrawing& drawing, const std::vector<scene::PlacedCircle>& circles,
                   const std::vector<sheet::Layer>& drawn = {}) {
  return sheet::centre_lines({drawing, circles, {sheet::ModelStyle{}}}, widths, drawn);
}

TEST(CentreLines, OfACircleAreACross) {
  const sheet::Layer layer = lines(top, {circle({30, 20, 5}, {0, 0, 1}, 10)});
  EXPECT_EQ(layer.name, "front/centre");
  EXPECT_EQ(layer.style.width, 0.25);
  EXPECT_EQ(layer.style.dashes.dots, 1);
  expect_spans(layer, {{{17, 20}, {43, 20}}, {{30, 7}, {30, 33}}});
  for (const sheet::Stroke& stroke : layer.strokes) {
    // An odd number of dashes: the middle is a dash, not a dot.
    const sheet::Dashes& d = stroke.dashes;
    const double period = d.dash + 2 * d.gap + d.dot, dashes = (26 - d.dash) / period + 1;
    EXPECT_NEAR(std::remainder(dashes - 1, 2), 0, 1e-9) << dashes;
    EXPECT_GT(d.dash, 0);
  }
}

TEST(CentreLines, OfConcentricCirclesTheLargestCounts) {
  expect_spans(lines(top, {circle({30, 20, 5}, {0, 0, 1}, 4), circle({30, 20, 0}, {0, 0, -1}, 10)}),
               {{{17, 20}, {43, 20}}, {{30, 7}, {30, 33}}});
}

TEST(CentreLines, OfShortLinesAreContinuous) {
  for (const sheet::Stroke& stroke : lines(top, {circle({0, 0, 0}, {0, 0, 1}, 2)}).strokes)
    EXPECT_EQ(stroke.dashes.dash, 0);
}

TEST(CentreLines, OfAShaftSeenFromTheSideAreItsAxis) {
  expect_spans(lines(front, {circle({0, 0, 10}, {1, 0, 0}, 5), circle({40, 0, 10}, {-1, 0, 0}, 5),
                             circle({60, 7, 10}, {1, 0, 0}, 9)}),
               {{{-3, 10}, {63, 10}}});
}

TEST(CentreLines, OneCircleEdgeOnHasAnAxis) {
  expect_spans(lines(front, {circle({0, 0, 10}, {0, 0, 1}, 5)}), {{{0, 7}, {0, 13}}});
}

TEST(CentreLines, ObliqueCirclesHaveAnAxisWhenThereAreTwo) {
  const double root = std::sqrt(0.5);
  const drawing::ViewDrawing slanted = view({1, 0, 0}, {0, root, root});
  EXPECT_TRUE(lines(slanted, {circle({0, 0, 0}, {0, 0, 1}, 10)}).strokes.empty());
  // Seen at 45 degrees, circles reach 10 sqrt(1/2) along the image of their axis.
  expect_spans(lines(slanted, {circle({0, 0, 0}, {0, 0, 1}, 10), circle({0, 0, 20}, {0, 0, 1}, 10)}),
               {{{0, -10 * root - 3}, {0, 30 * root + 3}}});
}

TEST(CentreLines, OverlappingOnesAreOneLine) {
  // Two holes in a row, and the axis of a third one behind them.
  expect_spans(lines(top, {circle({0, 0, 0}, {0, 0, 1}, 5), circle({12, 0, 0}, {0, 0, 1}, 5),
                           circle({40, 0, -9}, {1, 0, 0}, 5), circle({14, 0, -9}, {1, 0, 0}, 5)}),
               {{{-8, 0}, {43, 0}}, {{0, -8}, {0, 8}}, {{12, -8}, {12, 8}}});
}

TEST(CentreLines, OtherLinesWin) {
  const sheet::Stroke edge{{{10, 20.01}, {35, 20}}};
  const sheet::Stroke crossing{{{40, 0}, {40, 40}}};
  const std::vector<sheet::Layer> drawn{{"front/visible", {"visible", 0.5}, {edge, crossing}}};
  expect_spans(lines(top, {circle({30, 20, 5}, {0, 0, 1}, 10)}, drawn), {{{30, 7}, {30, 33}}, {{35, 20}, {43, 20}}});
}

TEST(CentreLines, CentralProjectionsHaveNone) {
  drawing::ViewDrawing central = top;
  central.projection.central = true;
  EXPECT_TRUE(lines(central, {circle({30, 20, 5}, {0, 0, 1}, 10)}).strokes.empty());
}

TEST(CentreLines, WithoutHiddenLinesOnlyWhatIsSeenHasThem) {
  drawing::ViewDrawing drawing = top;
  drawing.segments.push_back({{0, 0}, {1, 1}, true, EdgeKind::crease, 0, {7, 4}, -1, {0, 1}});
  drawing.segments.push_back({{0, 0}, {1, 1}, false, EdgeKind::crease, 0, {20, 21}, -1, {0, 1}});
  const std::vector<scene::PlacedCircle> circles{circle({0, 0, 0}, {0, 0, 1}, 10, {4, 5, 6, 7}),
                                                 circle({50, 0, 0}, {0, 0, 1}, 10, {20, 21, 22, 23})};
  EXPECT_EQ(
      sheet::centre_lines({drawing, circles, {{LineRole::visible, HiddenLines::none}}}, widths, {}).strokes.size(), 2U);
  EXPECT_EQ(
      sheet::centre_lines({drawing, circles, {{LineRole::visible, HiddenLines::dashed}}}, widths, {}).strokes.size(),
      4U);
}

}  // namespace
}  // namespace epura
