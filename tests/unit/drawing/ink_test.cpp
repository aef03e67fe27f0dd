// SPDX-License-Identifier: Apache-2.0
#include "drawing/ink.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

namespace epura::test::ink_test {
namespace {

constexpr double tolerance = 1e-6;
constexpr double min = 1e-4;

drawing::Piece piece(Vec2 from, Vec2 to, bool visible, int edge, EdgeKind kind = EdgeKind::crease) {
  return {from, to, visible, true, kind, edge, {0, 1}};
}

double length(const drawing::Piece& p) { return glm::length(p.to - p.from); }

double ink(const std::vector<drawing::Piece>& pieces, bool visible) {
  double sum = 0;
  for (const drawing::Piece& p : pieces) sum += p.visible == visible ? length(p) : 0;
  return sum;
}

TEST(Ink, VisibleBeatsHiddenWhoeverComesFirst) {
  for (const bool first : {false, true}) {
    const auto kept = drawing::resolve_coincident({piece({0, 0}, {4, 0}, first, 0), piece({4, 0}, {0, 0}, !first, 1)},
                                                  tolerance, min);
    ASSERT_EQ(kept.size(), 1U);
    EXPECT_TRUE(kept[0].visible);
    EXPECT_EQ(kept[0].edge, first ? 0 : 1);
  }
}

TEST(Ink, WhatItsStyleDoesNotDrawTakesNothingFromWhatIsDrawn) {
  drawing::Piece without_ink = piece({-1, 0}, {9, 0}, true, 0);
  without_ink.drawn = false;
  const auto kept = drawing::resolve_coincident({without_ink, piece({0, 0}, {4, 0}, false, 1)}, tolerance, min);
  ASSERT_EQ(kept.size(), 3U);
  EXPECT_EQ(ink(kept, false), 4);
  EXPECT_EQ(ink(kept, true), 6);
}

TEST(Ink, StepsBetweenRimsGiveWayToRims) {
  drawing::Piece step = piece({0, 0}, {9, 0}, true, 0, EdgeKind::contour);
  step.is_step = true;
  const auto kept =
      drawing::resolve_coincident({step, piece({0, 0}, {4, 0}, true, 1, EdgeKind::crease)}, tolerance, min);
  ASSERT_EQ(kept.size(), 2U);
  EXPECT_EQ(kept[0].edge, 0);
  EXPECT_EQ(length(kept[0]), 5);
  EXPECT_EQ(kept[1].edge, 1);
  EXPECT_EQ(length(kept[1]), 4);
}

TEST(Ink, AmongEqualsTheStrongerKindThenTheLongerThenTheEarlierEdgeStays) {
  const auto by_kind = drawing::resolve_coincident(
      {piece({0, 0}, {4, 0}, true, 0, EdgeKind::smooth), piece({0, 0}, {4, 0}, true, 1, EdgeKind::contour)}, tolerance,
      min);
  ASSERT_EQ(by_kind.size(), 1U);
  EXPECT_EQ(by_kind[0].kind, EdgeKind::contour);
  const auto by_length =
      drawing::resolve_coincident({piece({0, 0}, {4, 0}, true, 3), piece({0, 0}, {5, 0}, true, 7)}, tolerance, min);
  ASSERT_EQ(by_length.size(), 1U);
  EXPECT_EQ(by_length[0].edge, 7);
  drawing::Piece part = piece({0, 0}, {4, 0}, true, 7);
  part.line = 6;  // of which this is a facet's part
  const auto by_line = drawing::resolve_coincident({piece({0, 0}, {5, 0}, true, 3), part}, tolerance, min);
  ASSERT_EQ(by_line.size(), 2U);
  EXPECT_EQ(length(by_line[1]), 4);
  const auto by_edge =
      drawing::resolve_coincident({piece({0, 0}, {4, 0}, true, 7), piece({0, 0}, {4, 0}, true, 3)}, tolerance, min);
  ASSERT_EQ(by_edge.size(), 1U);
  EXPECT_EQ(by_edge[0].edge, 3);
}

// Copies too short for an overlap to count.
TEST(Ink, OfShortCopiesOneStays) {
  const std::vector<drawing::Piece> kept =
      drawing::resolve_coincident({piece({0, 0}, {min / 2, 0}, false, 0), piece({min / 2, 0}, {0, 0}, true, 1),
                                   piece({0, 0}, {min / 2, 0}, true, 2)},
                                  tolerance, min);
  ASSERT_EQ(kept.size(), 1U);
  EXPECT_TRUE(kept[0].visible);
  EXPECT_EQ(kept[0].edge, 1);
}

TEST(Ink, AHiddenLineKeepsWhatNoVisibleOneCovers) {
  // Covered from 3 to 5 of 10, and by a slanted direction, given backwards.
  const Vec2 along = Vec2(3, 4) / 5.0;
  const auto at = [&](double x) { return Vec2(1, 1) + x * along; };
  const auto kept =
      drawing::resolve_coincident({piece(at(0), at(10), false, 0), piece(at(5), at(3), true, 1)}, tolerance, min);
  ASSERT_EQ(kept.size(), 3U);
  EXPECT_NEAR(glm::distance(kept[0].from, at(0)) + glm::distance(kept[0].to, at(3)), 0, 1e-12);
  EXPECT_NEAR(glm::distance(kept[1].from, at(5)) + glm::distance(kept[1].to, at(10)), 0, 1e-12);
  EXPECT_NEAR(kept[0].s[1], 0.3, 1e-12);
  EXPECT_NEAR(kept[1].s[0], 0.5, 1e-12);
  EXPECT_TRUE(kept[2].visible);
  EXPECT_EQ(kept[2].s, (std::array{0.0, 1.0}));
}

TEST(Ink, PartialOverlapsOfOneLook) {
  const auto kept =
      drawing::resolve_coincident({piece({0, 0}, {6, 0}, true, 0), piece({4, 0}, {10, 0}, true, 1)}, tolerance, min);
  EXPECT_NEAR(ink(kept, true), 10, 1e-12);
  ASSERT_EQ(kept.size(), 2U);
  EXPECT_NEAR(kept[1].from.x, 6, 1e-12);
}

TEST(Ink, SeveralCoversAddUp) {
  std::vector<drawing::Piece> pieces{piece({0, 0}, {10, 0}, false, 0)};
  for (int i = 0; i < 5; ++i) pieces.push_back(piece({2.0 * i, 0}, {2.0 * i + 1.5, 0}, true, i + 1));
  const auto kept = drawing::resolve_coincident(pieces, tolerance, min);
  EXPECT_NEAR(ink(kept, false), 2.5, 1e-12);
  EXPECT_NEAR(ink(kept, true), 7.5, 1e-12);
}

TEST(Ink, CrossingParallelAndTouchingLinesStay) {
  const std::vector<drawing::Piece> pieces{piece({0, 0}, {10, 0}, true, 0), piece({5, -5}, {5, 5}, false, 1),
                                           piece({0, 0.1}, {10, 0.1}, false, 2), piece({10, 0}, {20, 0}, false, 3),
                                           piece({0, 0}, {10, 0.001}, false, 4)};
  const auto kept = drawing::resolve_coincident(pieces, tolerance, min);
  ASSERT_EQ(kept.size(), 5U);
  for (int i = 0; i < 4; ++i) EXPECT_EQ(kept[i].from, pieces[i].from) << i;
  // The last one leaves the first at an angle of 1e-4: within the tolerance only over 1e-2.
  EXPECT_NEAR(length(kept[4]), 10, 0.011);
}

TEST(Ink, WithinTheToleranceLinesCoincide) {
  const auto kept = drawing::resolve_coincident(
      {piece({0, 0}, {10, 0}, true, 0), piece({-1, 0.9 * tolerance}, {11, -0.9 * tolerance}, false, 1)}, tolerance,
      min);
  EXPECT_NEAR(ink(kept, false), 2, 1e-9);
}

TEST(Ink, ALineIsCoveredWhereBothEndsOfThePartLieOnIt) {
  using Part = std::array<double, 2>;
  const drawing::Ruler line({0, 0}, {10, 0});
  EXPECT_EQ(drawing::covered_part(line, {2, 0}, {14, tolerance / 2}, tolerance, min), (Part{2, 10}));
  EXPECT_EQ(drawing::covered_part(line, {0, 0}, {10, 2 * tolerance}, tolerance, min), (Part{0, 0}));
  EXPECT_EQ(drawing::covered_part(line, {10, 0}, {0, -2 * tolerance}, tolerance, min), (Part{0, 0}));
}

TEST(Ink, PointsAndShortRemaindersAreDropped) {
  EXPECT_TRUE(drawing::resolve_coincident({piece({1, 1}, {1, 1}, true, 0)}, tolerance, min).empty());
  const auto kept = drawing::resolve_coincident(
      {piece({0, 0}, {10 + min / 2, 0}, false, 0), piece({0, 0}, {10, 0}, true, 1)}, tolerance, min);
  ASSERT_EQ(kept.size(), 1U);
  EXPECT_TRUE(kept[0].visible);
  EXPECT_TRUE(drawing::resolve_coincident({}, tolerance, min).empty());
}

TEST(Ink, DirectionsNearZeroAndPiAreNeighbours) {
  const auto kept = drawing::resolve_coincident(
      {piece({0, 0}, {10, 1e-8}, true, 0), piece({10, 0}, {0, 1e-8}, false, 1)}, tolerance, min);
  EXPECT_EQ(kept.size(), 1U);
  // The very same with upright lines, where nothing is special.
  EXPECT_EQ(drawing::resolve_coincident({piece({0, 0}, {1e-8, 10}, true, 0), piece({1e-8, 0}, {0, 10}, false, 1)},
                                        tolerance, min)
                .size(),
            1U);
}

TEST(Ink, IsTheUnionOfManyIntervalsOnALine) {
  // Random intervals on one slanted line: visible ink is their union, hidden ink what the visible leaves of the rest.
  std::mt19937 random(5);
  const auto uniform = [&] { return static_cast<double>(random()) / 4294967296.0; };
  for (int round = 0; round < 50; ++round) {
    std::vector<drawing::Piece> pieces;
    for (int i = 0; i < 30; ++i) {
      const double a = 100 * uniform(), b = a + 0.01 + 8 * uniform();
      const Vec2 along(0.6, 0.8);
      pieces.push_back(piece(a * along, b * along, i % 3 == 0, i));
      if (i % 2 == 0) std::swap(pieces.back().from, pieces.back().to);
    }
    const auto covered = [&](double x, bool visible) {
      return std::any_of(pieces.begin(), pieces.end(), [&](const drawing::Piece& p) {
        const double a = glm::length(p.from), b = glm::length(p.to);
        return p.visible == visible && std::min(a, b) <= x && x <= std::max(a, b);
      });
    };
    double visible = 0, hidden = 0;
    const double step = 0.01;
    for (double x = step / 2; x < 110; x += step) {
      if (covered(x, true))
        visible += step;
      else if (covered(x, false))
        hidden += step;
    }
    const auto kept = drawing::resolve_coincident(pieces, tolerance, min);
    EXPECT_NEAR(ink(kept, true), visible, 0.3);
    EXPECT_NEAR(ink(kept, false), hidden, 0.3);
  }
}

}  // namespace
}  // namespace epura::test::ink_test
