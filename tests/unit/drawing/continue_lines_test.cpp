// SPDX-License-Identifier: Apache-2.0
#include "drawing/continue_lines.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <utility>

#include "base/nearest.hpp"
#include "drawing/dangles.hpp"
#include "drawing/polylines.hpp"

namespace epura::test::continue_lines_test {
namespace {

using drawing::Piece;
using Pieces = std::vector<Piece>;

constexpr double distance = 0.1;

struct Pen {
  bool visible = true;
  EdgeKind kind = EdgeKind::contour;
};

void add(Pieces& pieces, const std::vector<Vec2>& points, const Pen& pen = {}) {
  for (std::size_t i = 1; i < points.size(); ++i)
    pieces.push_back({points[i - 1], points[i], pen.visible, true, pen.kind, static_cast<int>(pieces.size()), {0, 1}});
}

// The part of a circle of radius 20 between two angles.
std::vector<Vec2> arc(double from, double to, double radius = 20) {
  std::vector<Vec2> points;
  for (int i = 0; i <= 8; ++i) {
    const double angle = from + (to - from) * i / 8;
    points.push_back(radius * Vec2(std::cos(angle), std::sin(angle)));
  }
  return points;
}

Pieces continued(const Pieces& pieces) {
  return drawing::continue_lines(pieces, std::vector<int>(pieces.size(), 0), {distance, 1e-6}).pieces;
}

std::size_t count_lines(const Pieces& pieces) {
  return drawing::Polylines(pieces, std::vector<signed char>(pieces.size(), 1), {}).size();
}

double distance_from(const Pieces& ink, const Vec2& at) {
  double nearest = HUGE_VAL;
  for (const Piece& p : ink) nearest = std::min(nearest, glm::distance(at, nearest_on_segment(at, p.from, p.to)));
  return nearest;
}

void expect_near(const Pieces& ink, const Pieces& other) {
  for (const Piece& p : ink)
    for (const double u : {0.0, 0.5, 1.0}) EXPECT_LE(distance_from(other, p.from + u * (p.to - p.from)), distance);
}

bool is_unchanged(const Pieces& pieces) {
  const Pieces after = continued(pieces);
  return std::equal(after.begin(), after.end(), pieces.begin(), pieces.end(), [](const Piece& a, const Piece& b) {
    return a.from == b.from && a.to == b.to && a.s == b.s && a.edge == b.edge;
  });
}

TEST(ContinueLines, MakesOneLineOfPartsThatOverlap) {
  Pieces pieces;
  for (int i = 0; i < 6; ++i) add(pieces, arc(0.3 * i, 0.3 * i + 0.34, i % 2 == 0 ? 20 : 20.03));
  const Pieces line = continued(pieces);
  EXPECT_EQ(count_lines(line), 1U);
  expect_near(line, pieces);
  expect_near(pieces, line);
  double length = 0;
  for (const Piece& p : line) length += drawing::length_of(p);
  EXPECT_NEAR(length, 20 * (0.3 * 5 + 0.34), 0.2);
}

TEST(ContinueLines, MakesOneLineOfPartsThatNearlyMeet) {
  Pieces pieces;
  for (int i = 0; i < 6; ++i) add(pieces, arc(0.3 * i, 0.3 * i + 0.296, i % 2 == 0 ? 20 : 20.03));
  const Pieces line = continued(pieces);
  EXPECT_EQ(count_lines(line), 1U);
  expect_near(line, pieces);
}

// How far what is removed lies from the ink that is left is stated, not more than twice too large here.
void expect_stated(const Pieces& pieces, const drawing::LeftInk& left) {
  double farthest = 0;
  for (const Piece& p : pieces)
    for (int i = 0; i <= 64; ++i)
      farthest = std::max(farthest, distance_from(left.pieces, p.from + i / 64.0 * (p.to - p.from)));
  EXPECT_GT(farthest, 0.01);
  EXPECT_LE(farthest, left.within);
  EXPECT_LE(left.within, 2 * farthest);
}

TEST(ContinueLines, StatesHowFarInkIsMoved) {
  Pieces pieces;
  for (int i = 0; i < 6; ++i) add(pieces, arc(0.3 * i, 0.3 * i + 0.34, i % 2 == 0 ? 20 : 20.06));
  expect_stated(pieces, drawing::continue_lines(pieces, std::vector<int>(pieces.size(), 0), {distance, 1e-6}));
  Pieces one;
  add(one, {{0, 0}, {10, 0}});
  EXPECT_EQ(drawing::continue_lines(one, {0}, {distance, 1e-6}).within, 0);
}

// What is left of a piece lies on its edge; a link begins there.
TEST(ContinueLines, KeepsPiecesOnTheirEdges) {
  Pieces pieces;
  add(pieces, {{0, 0}, {10, 0}});
  add(pieces, {{9, 0.05}, {20, 0.05}});
  const Pieces line = continued(pieces);
  ASSERT_EQ(line.size(), 3U);
  int links = 0;
  for (const Piece& p : line) {
    const Piece& whole = pieces[static_cast<std::size_t>(p.edge)];
    EXPECT_LT(glm::distance(p.from, whole.from + p.s[0] * (whole.to - whole.from)), 1e-12);
    links += is_link(p) ? 1 : 0;
    const double off = glm::distance(p.to, whole.from + p.s[1] * (whole.to - whole.from));
    EXPECT_LT(off, is_link(p) ? 2 * distance : 1e-12);
  }
  EXPECT_EQ(links, 1);
  EXPECT_EQ(count_lines(line), 1U);
}

TEST(ContinueLines, DoesNotDependOnOrderAndDirection) {
  std::mt19937 random(5);
  Pieces pieces;
  for (int i = 0; i < 8; ++i) add(pieces, arc(0.3 * i, 0.3 * i + 0.33, i % 2 == 0 ? 20 : 20.02));
  for (int turn = 0; turn < 20; ++turn) {
    std::shuffle(pieces.begin(), pieces.end(), random);
    for (Piece& p : pieces)
      if (random() % 2 == 0) std::swap(p.from, p.to);
    EXPECT_EQ(count_lines(continued(pieces)), 1U);
  }
}

TEST(ContinueLines, LeavesOtherLinesAlone) {
  const auto two = [](const std::vector<Vec2>& second, const Pen& first_pen = {}, const Pen& second_pen = {}) {
    Pieces pieces;
    add(pieces, {{0, 0}, {10, 0}}, first_pen);
    add(pieces, second, second_pen);
    return pieces;
  };
  const std::vector<Vec2> beside{{9.5, 0.05}, {20, 0.05}};
  EXPECT_FALSE(is_unchanged(two(beside)));
  EXPECT_TRUE(is_unchanged(two(beside, {true, EdgeKind::crease}, {true, EdgeKind::crease})));
  EXPECT_TRUE(is_unchanged(two(beside, {}, {false})));
  EXPECT_TRUE(is_unchanged(two({{9.5, 0.2}, {20, 0.2}}))) << "too far";
  EXPECT_TRUE(is_unchanged(two({{10.05, 0}, {10.05, 9}}))) << "a corner";
  EXPECT_TRUE(is_unchanged(two({{10, 0.05}, {0, 1.5}}))) << "a cusp";
  EXPECT_TRUE(is_unchanged(two({{5, 0.05}, {20, 0.05}}))) << "a long way";
  EXPECT_TRUE(is_unchanged(two({{10, 1e-7}, {20, 0}}))) << "meets it already";
  const Pieces others = two(beside);
  EXPECT_EQ(drawing::continue_lines(others, {0, 1}, {distance, 1e-6}).pieces.size(), 2U);
}

// --- dangles

Pieces without_specks(const Pieces& pieces) {
  return drawing::drop_dangles(pieces, std::vector<signed char>(pieces.size(), 1), {distance, 1e-6}).pieces;
}

std::size_t left_of(const std::vector<Vec2>& dangle, const Pen& pen, const Pen& line) {
  Pieces pieces;
  add(pieces, {{0, 0}, {10, 0}}, line);
  add(pieces, dangle, pen);
  return without_specks(pieces).size() - 1;
}

TEST(Dangles, AreDroppedOnOtherInk) {
  const std::vector<Vec2> dangle{{5, 0.01}, {5.02, 0.03}, {5.04, 0.02}};
  EXPECT_EQ(left_of(dangle, {}, {}), 0U);
  EXPECT_EQ(left_of(dangle, {true, EdgeKind::crease}, {}), 0U);
  EXPECT_EQ(left_of(dangle, {false}, {true}), 0U);
  EXPECT_EQ(left_of(dangle, {true}, {false}), 2U) << "visible";
}

TEST(Dangles, HaveInkWithinTheStatedDistance) {
  Pieces pieces;
  add(pieces, {{0, 0}, {10, 0}});
  add(pieces, {{5, 0.05}, {5.02, 0.07}, {5.04, 0.04}});
  expect_stated(pieces, drawing::drop_dangles(pieces, {1, 1, 1}, {distance, 1e-6}));
}

TEST(Dangles, StayElsewhere) {
  EXPECT_EQ(left_of({{5, 0.05}, {5, 0.12}}, {}, {}), 1U) << "sticks out";
  EXPECT_EQ(left_of({{5, 1}, {5.01, 1}}, {}, {}), 1U) << "alone";
  EXPECT_EQ(left_of({{5, 0.05}, {5.15, 0.05}}, {}, {}), 1U) << "long";
  Pieces dangles;
  add(dangles, {{5, 0}, {5.01, 0}});
  add(dangles, {{5, 0.01}, {5.01, 0.01}});
  EXPECT_EQ(without_specks(dangles).size(), 2U) << "on one another";
}

// Ends that were found in different ways, by hiding and by coincidence, differ by a few cells of the page's grid.
TEST(Dangles, ThatContinueLinesStay) {
  Pieces pieces;
  add(pieces, {{0, 0}, {5, 0}});
  add(pieces, {{5 + 3e-7, 0}, {5.07, 0}});
  add(pieces, {{5.07 + 3e-7, 0}, {10, 0}});
  EXPECT_EQ(without_specks(pieces).size(), 3U);
}

TEST(Dangles, LinksStay) {
  Pieces pieces;
  add(pieces, {{0, 0}, {10, 0}});
  add(pieces, {{5, 0.05}, {5, 0}});
  pieces.back().s = {0.5, 0.5};
  EXPECT_EQ(without_specks(pieces).size(), 2U);
}

TEST(Dangles, MayEndInLinks) {
  Pieces pieces;
  add(pieces, {{0, 0}, {10, 0}});
  add(pieces, {{5, 0.01}, {5.02, 0.03}});
  add(pieces, {{5.02, 0.03}, {5.02, 0}});
  pieces.back().s = {1, 1};
  EXPECT_EQ(without_specks(pieces).size(), 1U);
}

TEST(Dangles, MayBeLinksTooShortToBeSeen) {
  for (const double length : {0.001, 0.05}) {
    Pieces pieces;
    add(pieces, {{0, 0}, {10, 0}});
    add(pieces, {{4, 0.08}, {6, 0.08}});
    add(pieces, {{5, 0.08}, {5, 0.08 - length}});
    pieces.back().s = {1, 1};
    EXPECT_EQ(without_specks(pieces).size(), length < 0.01 ? 2U : 3U);
  }
}

TEST(Dangles, MayBeLinksFromLinesThatGoOn) {
  Pieces pieces;
  add(pieces, {{0, 0}, {10, 0}});
  add(pieces, {{4, 0.08}, {5, 0.08}, {6, 0.08}});
  add(pieces, {{5, 0.08}, {5, 0.01}});
  pieces.back().s = {1, 1};
  EXPECT_EQ(without_specks(pieces).size(), 3U);
}

// --- spurious

Pieces line_with_a_part(double length, bool visible) {
  Pieces pieces;
  add(pieces, {{0, 0}, {5, 0}}, {!visible});
  add(pieces, {{5, 0}, {5 + length, 0}}, {visible});
  add(pieces, {{5 + length, 0}, {10, 0}}, {!visible});
  return pieces;
}

std::size_t count_visible(Pieces pieces, bool is_moved = true) {
  const std::vector<char> moved(pieces.size(), is_moved ? 1 : 0);
  pieces = drawing::vote_on_visibility(std::move(pieces), moved, 0.01, {});
  return static_cast<std::size_t>(
      std::count_if(pieces.begin(), pieces.end(), [](const Piece& p) { return p.visible; }));
}

TEST(Glints, TakeOnTheVisibilityOfTheLineAroundThem) {
  EXPECT_EQ(count_visible(line_with_a_part(0.005, true)), 0U);
  EXPECT_EQ(count_visible(line_with_a_part(0.005, false)), 3U);
  EXPECT_EQ(count_visible(line_with_a_part(0.05, true)), 1U) << "seen";
  EXPECT_EQ(count_visible(line_with_a_part(0.005, true), false), 1U) << "in its place on the mesh";
  Pieces corner = line_with_a_part(0.005, true);
  add(corner, {{5, 0}, {5, 5}});
  EXPECT_EQ(count_visible(corner), 2U) << "another visible line ends there";
  for (int first = 0; first < 4; ++first) {
    const std::array<Vec2, 4> corners{Vec2(0, 0), Vec2(5, 0), Vec2(5, 4), Vec2(0, 0.005)};
    Pieces ring;
    for (int i = 0; i < 4; ++i)
      add(ring, {corners[(first + i) % 4], corners[(first + i + 1) % 4]}, {(first + i) % 4 == 3});
    EXPECT_EQ(count_visible(ring), 0U) << "a closed line from corner " << first;
  }
  Pieces again;  // after a hidden piece, 29 of 0.004 mm, of which two thirds are visible
  add(again, {{0, 0}, {5, 0}}, {false});
  for (int i = 0; i < 30; ++i) add(again, {{5 + 0.004 * i, 0}, {5 + 0.004 * (i + 1), 0}}, {i % 3 != 0});
  add(again, {{5.12, 0}, {10, 0}}, {false});
  EXPECT_EQ(count_visible(again), 29U) << "too much to be hidden";
  Pieces last = line_with_a_part(0.005, true);
  last.pop_back();
  EXPECT_EQ(count_visible(last), 1U) << "the end of a line";
}

}  // namespace
}  // namespace epura::test::continue_lines_test
