// SPDX-License-Identifier: Apache-2.0
#include "drawing/chains.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <random>

namespace epura::test::chains_test {
namespace {

drawing::Segment segment(Vec2 from, Vec2 to, bool visible = true, EdgeKind kind = EdgeKind::crease) {
  return {from, to, visible, kind, 0, {0, 1}, -1, {0, 1}};
}

double length(const drawing::Chain& chain) {
  double sum = 0;
  for (std::size_t i = 1; i < chain.points.size(); ++i) sum += glm::distance(chain.points[i - 1], chain.points[i]);
  return chain.closed ? sum + glm::distance(chain.points.back(), chain.points.front()) : sum;
}

TEST(Chains, JoinEndsThatDifferByRounding) {
  const auto chains = drawing::chain_segments({segment({0, 0}, {1, 1e-14}), segment({2, 1}, {1, 0})}, 1e-6);
  ASSERT_EQ(chains.size(), 1U);
  EXPECT_EQ(chains[0].points.size(), 3U);
}

TEST(Chains, JoinWhatTouchesWhicheverWayItRuns) {
  const auto chains =
      drawing::chain_segments({segment({0, 0}, {1, 0}), segment({2, 1}, {1, 0}), segment({2, 1}, {2, 2})}, 1e-6);
  ASSERT_EQ(chains.size(), 1U);
  EXPECT_EQ(chains[0].points, (std::vector<Vec2>{{0, 0}, {1, 0}, {2, 1}, {2, 2}}));
  EXPECT_EQ(chains[0].segments, (std::vector<int>{0, 1, 2}));
  EXPECT_FALSE(chains[0].closed);
}

// At (10, 0) two ends meet exactly, but turn back; the line goes on at an end that differs by rounding.
TEST(Chains, GoOnRatherThanTurnBack) {
  const auto chains = drawing::chain_segments(
      {segment({0, 0}, {10, 0}), segment({10, 0}, {0, 1}), segment({10, 5e-7}, {20, 0})}, 1e-9, {1e-6});
  ASSERT_EQ(chains.size(), 2U);
  const auto& longest = chains[chains[0].segments.size() == 2 ? 0 : 1];
  EXPECT_EQ(longest.segments, (std::vector<int>{0, 2}));
}

TEST(Chains, TurnBackWhereNothingGoesOn) {
  const auto chains = drawing::chain_segments({segment({0, 0}, {10, 0}), segment({10, 0}, {0, 1})}, 1e-9, {1e-6});
  EXPECT_EQ(chains.size(), 1U);
}

TEST(Chains, HaveNoStepsWhereEndsMeetNearly) {
  const auto chains = drawing::chain_segments(
      {segment({0, 0}, {10, 0}), segment({10, 0}, {10, -8e-7}), segment({10, -8e-7}, {20, 5})}, 1e-9, {1e-6});
  ASSERT_EQ(chains.size(), 1U);
  EXPECT_EQ(chains[0].points.size(), 3U);
}

// Where ends are a gap apart, the chain was drawn through one end or the other, as it was followed.
TEST(Chains, GoThroughTheSameEndsWhicheverWayTheyAreFollowed) {
  std::mt19937 random(3);
  const auto number = [&](double most) { return std::uniform_real_distribution<double>(-most, most)(random); };
  for (int round = 0; round < 50; ++round) {
    std::vector<drawing::Segment> lines;
    for (int i = 0; i < 8; ++i) {
      const double a = 0.7 * i, b = 0.7 * (i + 1);
      const Vec2 jitter(number(0.003), number(0.003));
      lines.push_back(segment(Vec2(10 * std::cos(a), 10 * std::sin(a)) + jitter, {10 * std::cos(b), 10 * std::sin(b)}));
    }
    const auto places = [&] {
      const auto chains = drawing::chain_segments(lines, 1e-9, {1e-6, 0.01});
      EXPECT_EQ(chains.size(), 1U);
      std::vector<std::array<double, 2>> found;
      for (const Vec2& p : chains.front().points) found.push_back({p.x, p.y});
      std::ranges::sort(found);
      return found;
    };
    const auto before = places();
    std::shuffle(lines.begin(), lines.end(), random);
    for (drawing::Segment& line : lines)
      if (random() % 2 == 0) std::swap(line.from, line.to);
    EXPECT_EQ(places(), before) << round;
  }
}

TEST(Chains, CrossGapsThatNobodySees) {
  const std::vector<drawing::Segment> lines{segment({0, 0}, {10, 0}), segment({10.009, 0}, {20, 0}),
                                            segment({20.02, 0}, {30, 0})};
  EXPECT_EQ(drawing::chain_segments(lines, 1e-9, {1e-6, 0.01}).size(), 2U);
  EXPECT_EQ(drawing::chain_segments(lines, 1e-9, {1e-6}).size(), 3U);
  for (int i = 0; i < 100; ++i) {
    const double x = 0.00037 * i;
    const std::vector<drawing::Segment> apart{segment({x, 0}, {x + 10, 0}), segment({x + 10.011, 0}, {x + 20, 0})};
    EXPECT_EQ(drawing::chain_segments(apart, 1e-9, {1e-6, 0.01}).size(), 2U) << i;
  }
  // A step is no gap.
  const auto step = drawing::chain_segments(
      {segment({0, 0}, {10, 0}), segment({10, 0}, {10, -0.008}), segment({10, -0.008}, {20, -0.008})}, 1e-9,
      {1e-6, 0.01});
  ASSERT_EQ(step.size(), 1U);
  EXPECT_EQ(step[0].points.size(), 4U);
  // Ends that touch come first, and a line does not turn back for the sake of a gap.
  EXPECT_EQ(
      drawing::chain_segments({segment({0, 0}, {10, 0}), segment({10, 0}, {20, 1}), segment({10.005, 0}, {20, 0})},
                              1e-9, {1e-6, 0.01})
          .size(),
      2U);
  EXPECT_EQ(
      drawing::chain_segments({segment({0, 0}, {10, 0}), segment({10.005, 0}, {0, 1})}, 1e-9, {1e-6, 0.01}).size(), 2U);
}

TEST(Chains, LooksAreNotMixed) {
  const auto chains = drawing::chain_segments({segment({0, 0}, {1, 0}), segment({1, 0}, {2, 0}, false),
                                               segment({2, 0}, {3, 0}, false, EdgeKind::wire), segment({3, 0}, {4, 0})},
                                              1e-6);
  EXPECT_EQ(chains.size(), 4U);
}

TEST(Chains, BodiesAndModelsAreNotMixed) {
  std::vector<drawing::Segment> lines{segment({0, 0}, {1, 0}), segment({1, 0}, {2, 0}), segment({2, 0}, {3, 0})};
  lines[1].body = 4;
  EXPECT_EQ(drawing::chain_segments(lines, 1e-6).size(), 3U);
  lines[1].body = -1;
  EXPECT_EQ(drawing::chain_segments(lines, 1e-6).size(), 1U);
  lines[2].model = 1;
  EXPECT_EQ(drawing::chain_segments(lines, 1e-6).size(), 2U);
}

TEST(Chains, KindsThatLookTheSameAreMixed) {
  const auto chains = drawing::chain_segments(
      {segment({0, 0}, {1, 0}), segment({1, 0}, {2, 0.1}, true, EdgeKind::contour), segment({2, 0.1}, {3, 0})}, 1e-6);
  ASSERT_EQ(chains.size(), 1U);
  EXPECT_EQ(chains[0].kind, EdgeKind::contour);
}

TEST(Chains, AtACornerLinesOfOneKindAreJoined) {
  const double c = 0.5, s = std::sqrt(3) / 2;  // three edges of a cube; two of them are its outline
  const auto chains =
      drawing::chain_segments({segment({0, 0}, {0, 1}), segment({0, 0}, {s, -c}, true, EdgeKind::contour),
                               segment({0, 0}, {-s, -c}, true, EdgeKind::contour)},
                              1e-6);
  ASSERT_EQ(chains.size(), 2U);
  const auto& outline = chains[chains[0].segments.size() == 2 ? 0 : 1];
  EXPECT_EQ(outline.kind, EdgeKind::contour);
  EXPECT_EQ(outline.segments.size(), 2U);
}

TEST(Chains, AtACornerALineOfAnotherKindIsNotTakenThoughStraighter) {
  const auto chains =
      drawing::chain_segments({segment({0, 0}, {0, 1}, true, EdgeKind::contour),
                               segment({0, 0}, {1, 0}, true, EdgeKind::contour), segment({0, 0}, {-1, -1})},
                              1e-6);
  ASSERT_EQ(chains.size(), 2U);
  const auto& outline = chains[chains[0].segments.size() == 2 ? 0 : 1];
  ASSERT_EQ(outline.segments.size(), 2U);
  EXPECT_EQ(outline.segments[0] + outline.segments[1], 0 + 1);
}

TEST(Chains, ACurveRunsOnWhereItsKindChanges) {
  // The rim of a cylinder is a contour up to where the straight contour of the wall begins.
  const auto chains =
      drawing::chain_segments({segment({-1, 0.2}, {0, 0}, true, EdgeKind::contour), segment({0, 0}, {1, 0.2}),
                               segment({0, 0}, {0.1, -5}, true, EdgeKind::contour)},
                              1e-6);
  ASSERT_EQ(chains.size(), 2U);
  for (const drawing::Chain& chain : chains) EXPECT_EQ(chain.segments.size() == 1, length(chain) > 4);
}

TEST(Chains, JoinEndsThatTouch) {
  // Pairs of ends lie in one cell of one of four grids, wherever they are.
  for (int i = 0; i < 64; ++i) {
    const Vec2 at(1 + 0.3 * i, 2 - 0.7 * i), beside = at + 0.9e-5 * Vec2(std::cos(i), std::sin(i));
    const auto lines = std::vector{segment({0, 40}, at), segment(beside, {30, 40})};
    EXPECT_EQ(drawing::chain_segments(lines, 1e-6, {1e-5}).size(), 1U) << i;
    EXPECT_EQ(drawing::chain_segments(lines, 1e-6, {1e-6}).size(), 2U) << i;
  }
}

TEST(Chains, AShortLineDoesNotMeetItself) {
  const auto chains = drawing::chain_segments({segment({0, 0}, {1e-6, 0})}, 1e-9, {1e-5});
  ASSERT_EQ(chains.size(), 1U);
  EXPECT_FALSE(chains[0].closed);
}

TEST(Chains, ARingIsClosedAndDoesNotRepeatItsStart) {
  const auto chains = drawing::chain_segments(
      {segment({0, 0}, {1, 0}), segment({1, 1}, {1, 0}), segment({1, 1}, {0, 1}), segment({0, 1}, {0, 0})}, 1e-6);
  ASSERT_EQ(chains.size(), 1U);
  EXPECT_TRUE(chains[0].closed);
  EXPECT_EQ(chains[0].points.size(), 4U);
  EXPECT_EQ(chains[0].segments.size(), 4U);
  EXPECT_EQ(length(chains[0]), 4);
}

TEST(Chains, ThereAndBackIsNoRing) {
  const auto chains = drawing::chain_segments({segment({0, 0}, {1, 0}), segment({1, 0}, {0, 0})}, 1e-6);
  ASSERT_EQ(chains.size(), 1U);
  EXPECT_FALSE(chains[0].closed);
  EXPECT_EQ(chains[0].segments.size(), 2U);
}

TEST(Chains, StraightCornersAreLeftOut) {
  const auto line =
      drawing::chain_segments({segment({0, 0}, {1, 1}), segment({1, 1}, {3, 3}), segment({3, 3}, {4, 4})}, 1e-6);
  ASSERT_EQ(line.size(), 1U);
  EXPECT_EQ(line[0].points, (std::vector<Vec2>{{0, 0}, {4, 4}}));
  EXPECT_EQ(line[0].segments.size(), 3U);
  // A square that begins in the middle of a side.
  const auto ring = drawing::chain_segments({segment({1, 0}, {2, 0}), segment({2, 0}, {2, 2}), segment({2, 2}, {0, 2}),
                                             segment({0, 2}, {0, 0}), segment({0, 0}, {1, 0})},
                                            1e-6);
  ASSERT_EQ(ring.size(), 1U);
  EXPECT_TRUE(ring[0].closed);
  EXPECT_EQ(ring[0].points.size(), 4U);
  EXPECT_EQ(length(ring[0]), 8);
}

TEST(Chains, CornersBeyondTheToleranceStay) {
  EXPECT_EQ(drawing::chain_segments({segment({0, 0}, {1, 1e-3}), segment({1, 1e-3}, {2, 0})}, 1e-2)[0].points.size(),
            2U);
  EXPECT_EQ(drawing::chain_segments({segment({0, 0}, {1, 1e-3}), segment({1, 1e-3}, {2, 0})}, 1e-4)[0].points.size(),
            3U);
  // Back on itself is a corner, though it lies on the line.
  EXPECT_EQ(drawing::chain_segments({segment({0, 0}, {3, 0}), segment({3, 0}, {1, 0})}, 1e-6)[0].points.size(), 3U);
}

TEST(Chains, ALongArcIsNotStraightenedAway) {
  // Each corner is within the tolerance of its neighbours' chord, but the whole must not creep.
  std::vector<drawing::Segment> arc;
  const int n = 2000;
  const auto at = [&](int i) {
    const double a = std::numbers::pi * i / n;
    return Vec2(std::cos(a), std::sin(a)) * 100.0;
  };
  for (int i = 0; i < n; ++i) arc.push_back(segment(at(i), at(i + 1)));
  const double tolerance = 1e-3;
  const auto chains = drawing::chain_segments(arc, tolerance);
  ASSERT_EQ(chains.size(), 1U);
  const std::vector<Vec2>& points = chains[0].points;
  for (int i = 0; i <= n; ++i) {
    double nearest = HUGE_VAL;
    for (std::size_t k = 1; k < points.size(); ++k) {
      const Vec2 along = points[k] - points[k - 1];
      const double s = std::clamp(glm::dot(at(i) - points[k - 1], along) / glm::dot(along, along), 0.0, 1.0);
      nearest = std::min(nearest, glm::distance(at(i), points[k - 1] + s * along));
    }
    ASSERT_LT(nearest, 2 * tolerance) << i;
  }
}

TEST(Chains, AtACrossingLinesRunStraightOn) {
  const auto chains = drawing::chain_segments(
      {segment({-1, 0}, {0, 0}), segment({0, 0}, {0, 1}), segment({0, 0}, {1, 0}), segment({0, -1}, {0, 0})}, 1e-6);
  ASSERT_EQ(chains.size(), 2U);
  for (const drawing::Chain& chain : chains) EXPECT_EQ(length(chain), 2);
  for (const drawing::Chain& chain : chains) EXPECT_EQ(chain.points.size(), 2U) << "a straight line";
}

TEST(Chains, ShortCreasesThatMeetNothingAreDropped) {
  const auto edge = [](Vec2 from, Vec2 to, int a, int b, std::array<double, 2> t = {0, 1}) {
    return drawing::Segment{from, to, true, EdgeKind::crease, 0, {a, b}, -1, t};
  };
  drawing::ViewDrawing drawing;
  drawing.segments = {edge({0, 0}, {1, 0}, 0, 1), edge({1, 0}, {1.5, 0}, 1, 2),  // free at both ends
                      edge({0, 5}, {1, 5}, 3, 4), edge({1, 5}, {9, 5}, 4, 5),    // long
                      edge({0, 8}, {1, 8}, 6, 7), edge({1, 8}, {1, 9}, 7, 8),
                      edge({1, 8}, {2, 7}, 7, 9), edge({4, 1}, {5, 1}, 10, 11, {0, 0.5})};  // goes on behind a face
  const std::size_t all = drawing.segments.size();
  const auto left = [&](double least) {
    drawing.chains = drawing::chain_segments(drawing.segments, 1e-6);
    drawing::drop_short_creases(drawing, least);
    return drawing.segments.size();
  };
  EXPECT_EQ(left(1), all);
  EXPECT_EQ(left(2), all - 2);
  drawing.segments[0].kind = EdgeKind::contour;
  EXPECT_EQ(left(2), all - 2) << "nothing more";
}

// What counts is that lines meet on the page: those of bodies that touch have no vertex in common.
TEST(Chains, ShortCreasesThatMeetLinesOfOtherBodiesAreKept) {
  const auto edge = [](Vec2 from, Vec2 to, int model, int vertex) {
    return drawing::Segment{from, to, true, EdgeKind::crease, model, {vertex, vertex + 1}, -1, {0, 1}};
  };
  for (const double away : {0.0, 0.5}) {
    drawing::ViewDrawing drawing;
    drawing.segments = {edge({0, 0}, {1, 0}, 0, 0), edge({1 + away, -4}, {1 + away, 5}, 1, 0)};
    drawing.chains = drawing::chain_segments(drawing.segments, 1e-6);
    EXPECT_EQ(drawing::drop_short_creases(drawing, 2), true);
    EXPECT_EQ(drawing.segments.size(), away > 0 ? 1U : 2U);
  }
}

TEST(Chains, HoldEverySegmentOnceAndItsLength) {
  std::mt19937 random(3);
  std::vector<drawing::Segment> segments;
  double total = 0;
  while (segments.size() < 500) {
    const auto grid = [&] { return Vec2(static_cast<double>(random() % 8), static_cast<double>(random() % 8)); };
    const Vec2 a = grid(), b = grid();
    if (a == b) continue;
    segments.push_back(segment(a, b, random() % 2 == 0));
    total += glm::distance(a, b);
  }
  std::vector<int> seen;
  double drawn = 0;
  for (const drawing::Chain& chain : drawing::chain_segments(segments, 0)) {
    for (const int s : chain.segments) {
      seen.push_back(s);
      EXPECT_EQ(segments[s].visible, chain.visible);
    }
    drawn += length(chain);
  }
  std::sort(seen.begin(), seen.end());
  for (int i = 0; i < 500; ++i) ASSERT_EQ(seen.at(i), i);
  EXPECT_EQ(seen.size(), 500U);
  EXPECT_NEAR(drawn, total, 1e-9);
}

}  // namespace
}  // namespace epura::test::chains_test
