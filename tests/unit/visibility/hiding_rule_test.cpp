// SPDX-License-Identifier: Apache-2.0
#include "visibility/hiding_rule.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>

namespace epura::test::hiding_rule_test {
namespace {

// Of a plane that rises by 3 upwards and by half to the right.
view::ProjectedScene needle(double height) {
  view::ProjectedScene view;
  for (const Vec2& p : {Vec2(0, 0), Vec2(1, 0), Vec2(0.5, height)})
    view.vertices.push_back({p.x, p.y, p.x / 2 + 3 * p.y, 1});
  return view;
}

// Heights of which the products of coordinates keep all digits.
TEST(Slope, OfANeedleIsThatOfItsPlane) {
  for (const int power : {1, 9, 10, 11, 20, 30, 39}) {
    const auto slope = visibility::slope_of(needle(std::ldexp(1.0, -power)), {{0, 1, 2}, 0});
    ASSERT_TRUE(slope) << power;
    EXPECT_EQ(*slope, Vec2(0.5, 3)) << power;
  }
}

TEST(Slope, IsMissingWhereATriangleIsALine) {
  for (const int power : {40, 41, 60})
    EXPECT_FALSE(visibility::slope_of(needle(std::ldexp(1.0, -power)), {{0, 1, 2}, 0})) << power;
  EXPECT_FALSE(visibility::slope_of(needle(0), {{0, 1, 2}, 0}));
}

// A page whose grid cells have sides of 1.
class Page {
 public:
  explicit Page(const view::Contact& contact = {}) {
    view.cell = 1;
    view.extent = 1000;
    view.contact = contact;
  }

  int add(double x, double y, double depth = 0) {
    view.vertices.push_back({x, y, depth, 1});
    view.grid.push_back({static_cast<int>(std::round(x)), static_cast<int>(std::round(y))});
    return static_cast<int>(view.vertices.size()) - 1;
  }
  view::ViewTriangle triangle(const std::array<Vec2, 3>& corners) {
    return {{add(corners[0].x, corners[0].y), add(corners[1].x, corners[1].y), add(corners[2].x, corners[2].y)}, 0};
  }

  view::ProjectedScene view;
};

TEST(Overlap, CornersOnTheLineOfAnEdgeAreLeftOfIt) {
  Page page;
  const visibility::PageEdge edge{page.add(0, 0), page.add(8, 0)};
  const auto right = page.triangle({Vec2(2, 0), Vec2(6, 0), Vec2(4, -4)});
  const auto left = page.triangle({Vec2(2, 0), Vec2(6, 0), Vec2(4, 4)});
  const auto overlap = visibility::overlap_of(page.view, edge, right);
  ASSERT_TRUE(overlap);
  EXPECT_EQ(overlap->from, 0.25);
  EXPECT_EQ(overlap->to, 0.75);
  EXPECT_FALSE(visibility::meets_on_grid(page.view, edge, left));
}

TEST(Overlap, HasALength) {
  Page page;
  const visibility::PageEdge edge{page.add(0, 0), page.add(8, 0)};
  const auto meets = [&](const std::array<Vec2, 3>& corners) {
    return visibility::meets_on_grid(page.view, edge, page.triangle(corners));
  };
  EXPECT_FALSE(meets({Vec2(-4, -4), Vec2(0, -4), Vec2(0, 4)}));
  EXPECT_TRUE(meets({Vec2(-4, -4), Vec2(1, -4), Vec2(1, 4)}));
  EXPECT_FALSE(meets({Vec2(8, -4), Vec2(12, 4), Vec2(8, 4)}));
  EXPECT_TRUE(meets({Vec2(7, -4), Vec2(12, 4), Vec2(7, 4)}));
}

// Sides a quarter of a cell inside the edge, which the grid places at its ends.
TEST(Overlap, BeginsAndEndsWhereTheGridPlacesIt) {
  Page page;
  const visibility::PageEdge edge{page.add(0, 0), page.add(800, 0)};
  const auto begin = page.triangle({Vec2(0.25, -100), Vec2(0.25, 100), Vec2(400.25, 100)});
  const auto end = page.triangle({Vec2(799.75, -100), Vec2(799.75, 100), Vec2(399.75, 100)});
  const auto at_begin = visibility::overlap_of(page.view, edge, begin);
  const auto at_end = visibility::overlap_of(page.view, edge, end);
  ASSERT_TRUE(at_begin && at_end);
  EXPECT_EQ(at_begin->in.t, 0);
  EXPECT_NEAR(at_begin->out.t, 200.25 / 800, 1e-15);
  EXPECT_NEAR(at_end->in.t, 599.75 / 800, 1e-15);
  EXPECT_EQ(at_end->out.t, 1);
}

TEST(Overlap, OfNeighboursAbutsToTheLastBit) {
  std::mt19937 numbers(3);
  std::uniform_real_distribution<double> place(-100, 100);
  int met = 0;
  for (int i = 0; i < 1000; ++i) {
    Page page;
    const auto anywhere = [&] { return page.add(place(numbers), place(numbers)); };
    const visibility::PageEdge edge{anywhere(), anywhere()};
    const int a = anywhere(), b = anywhere(), c = anywhere(), d = anywhere();
    const auto one = visibility::overlap_of(page.view, edge, {{a, b, c}, 0});
    const auto other = visibility::overlap_of(page.view, edge, {{b, a, d}, 1});
    if (!one || !other) continue;
    const auto on_common_side = [&](const visibility::Overlap& overlap) {
      return overlap.in.u == a && overlap.in.v == b ? overlap.in : overlap.out;
    };
    const visibility::SideCrossing first = on_common_side(*one), second = on_common_side(*other);
    if (first.u != a || first.v != b || second.u != a || second.v != b) continue;
    EXPECT_EQ(first.t, second.t);
    EXPECT_EQ(first.s, second.s);
    ++met;
  }
  EXPECT_GT(met, 50);
}

// Rounding turns an edge of a hundred cells: far away, its line on the grid meets a side which the edge's own line
// misses by thousands of cells. The depth of the triangle above the edge is that of its plane all the same.
TEST(Overlap, OfAShortEdgeHasTheDepthOfThePlane) {
  Page page;
  const auto plane = [](const Vec2& p) { return 0.001 * p.x + 0.002 * p.y; };
  const auto add = [&](const Vec2& p) { return page.add(p.x, p.y, plane(p)); };
  const Vec2 from(0.4, 0.4), to(100, 0.6);
  const visibility::PageEdge edge{add(from), add(to)};
  const view::ViewTriangle triangle{{add({1e6, 5e3}), add({1e6, 1e5}), add({-1e6, -6e4})}, 0};
  const auto overlap = visibility::overlap_of(page.view, edge, triangle);
  ASSERT_TRUE(overlap);
  EXPECT_EQ(overlap->from, 0);
  EXPECT_EQ(overlap->to, 1);
  for (const double t : {0.0, 0.5, 1.0})
    EXPECT_NEAR(overlap->depth(t, [&](int v) { return page.view.vertices[v].depth; }), plane(from + t * (to - from)),
                1e-9);
}

// What a triangle of depth z = slope y hides of an edge whose depth goes from one number to another.
std::optional<std::array<double, 2>> hidden_by_plane(double slope, double from, double to,
                                                     const view::Contact& contact) {
  Page page(contact);
  const visibility::PageEdge edge{page.add(0, 0, from), page.add(8, 0, to)};
  const view::ViewTriangle triangle{
      {page.add(-40, -40, -40 * slope), page.add(80, -40, -40 * slope), page.add(4, 80, 80 * slope)}, 0};
  return visibility::hidden_part(page.view, edge, triangle);
}

TEST(HiddenPart, BeginsAndEndsBehindContact) {
  using Part = std::array<double, 2>;
  EXPECT_EQ(hidden_by_plane(0, 1, -1, {0.25, 0, 0}), (Part{0.625, 1}));
  EXPECT_EQ(hidden_by_plane(0, -1, 1, {0.25, 0, 0}), (Part{0, 0.375}));
  EXPECT_EQ(hidden_by_plane(0, -1, -1, {0.25, 0, 0}), (Part{0, 1}));
  EXPECT_EQ(hidden_by_plane(0, -0.25, -0.25, {0.25, 0, 0}), std::nullopt);
  EXPECT_EQ(hidden_by_plane(0, 1, 1, {0.25, 0, 0}), std::nullopt);
}

TEST(HiddenPart, MeasuresContactAlongTheNormal) {
  const auto part = hidden_by_plane(3, 1, -1, {0.0625, 0, 0});
  ASSERT_TRUE(part);
  EXPECT_NEAR((*part)[0], 0.625, 1e-14);
  EXPECT_EQ((*part)[1], 1);
}

// A level triangle covers the quarter of an edge beside their common corner, from which the edge falls by 1.
TEST(HiddenPart, AtACommonCornerIsDecidedByTheOtherEnd) {
  using Part = std::array<double, 2>;
  const auto hidden = [](bool turned, double joined) {
    Page page({1, joined, 0});
    const int corner = page.add(0, 0, 0), end = page.add(16, 0, -1);
    const view::ViewTriangle triangle{{corner, page.add(4, -4, 0), page.add(4, 4, 0)}, 0};
    return visibility::hidden_part(
        page.view, turned ? visibility::PageEdge{end, corner} : visibility::PageEdge{corner, end}, triangle);
  };
  EXPECT_EQ(hidden(false, 0.2), (Part{0, 0.25}));
  EXPECT_EQ(hidden(true, 0.2), (Part{0.75, 1}));
  for (const bool turned : {false, true}) EXPECT_EQ(hidden(turned, 0.3), std::nullopt);
}

}  // namespace
}  // namespace epura::test::hiding_rule_test
