// SPDX-License-Identifier: Apache-2.0
#include "drawing/near_ink.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <random>

#include "at_length.hpp"

namespace epura::test::near_ink_test {
namespace {

using Pieces = std::vector<drawing::Piece>;

constexpr double distance = 0.1, touching = 1e-5;
constexpr double pi = std::numbers::pi;

void add(Pieces& pieces, Vec2 from, Vec2 to, bool visible = true) {
  pieces.push_back({from, to, visible, true, EdgeKind::crease, static_cast<int>(pieces.size()), {0, 1}});
}

// Closed if the last point is the first one.
void add_line(Pieces& pieces, const std::vector<Vec2>& points, bool visible = true) {
  for (std::size_t i = 1; i < points.size(); ++i) add(pieces, points[i - 1], points[i], visible);
}

std::vector<Vec2> rim(double radius, int corners, double turn) {
  std::vector<Vec2> points;
  for (int i = 0; i <= corners; ++i) {
    const double angle = 2 * pi * ((i % corners) + turn) / corners;
    points.push_back(radius * Vec2(std::cos(angle), std::sin(angle)));
  }
  return points;
}

Pieces joined(const Pieces& pieces, double within = distance) {
  std::vector<signed char> strength;
  for (const drawing::Piece& piece : pieces) strength.push_back(piece.visible ? 2 : 1);
  return drawing::join_near(pieces, strength, within, touching);
}

bool same(const drawing::Piece& a, const drawing::Piece& b) {
  return a.from == b.from && a.to == b.to && a.visible == b.visible && a.edge == b.edge && a.s == b.s;
}

bool unchanged(const Pieces& pieces) {
  const Pieces left = joined(pieces);
  return std::equal(left.begin(), left.end(), pieces.begin(), pieces.end(), same);
}

double ink(const Pieces& pieces, bool visible) {
  double sum = 0;
  for (const drawing::Piece& p : pieces) sum += p.visible == visible ? drawing::length_of(p) : 0;
  return sum;
}

// To the nearest ink that is at least as strong.
double distance_to(const Pieces& pieces, const Vec2& place, bool visible) {
  double least = HUGE_VAL;
  for (const drawing::Piece& p : pieces) {
    if (visible && !p.visible) continue;
    const Vec2 step = p.to - p.from;
    const double part = std::clamp(glm::dot(place - p.from, step) / glm::dot(step, step), 0.0, 1.0);
    least = std::min(least, glm::distance(place, p.from + part * step));
  }
  return least;
}

// Ends in the air: no other piece as strong touches them.
int loose_ends(const Pieces& pieces) {
  int count = 0;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    Pieces others = pieces;
    others.erase(others.begin() + static_cast<std::ptrdiff_t>(i));
    for (const Vec2& end : {pieces[i].from, pieces[i].to})
      count += distance_to(others, end, pieces[i].visible) > 2 * touching ? 1 : 0;
  }
  return count;
}

// Sagitta of 64 facets: r (1 - cos(pi / 64)) = 0.0012 r.
TEST(NearInk, LinesThatRunAlongOneAnotherForAMomentStay) {
  for (const double length : {0.3, 3.0}) {
    Pieces pieces;
    add(pieces, {0, 0}, {100, 0});
    add_line(pieces, {{50, 9}, {50, 0.08}, {50 + length, 0.08}, {50 + length, 9}}, false);
    const double removed = ink(pieces, false) - ink(joined(pieces), false);
    if (length < 5 * distance)
      EXPECT_NEAR(removed, 0, 1e-9);
    else
      EXPECT_GT(removed, length - 2 * distance);
  }
}

TEST(NearInk, IsTakenAroundACornerOfLinesThatMeet) {
  Pieces pieces;
  add(pieces, {0, 0}, {50, 0});
  add(pieces, {50, 0}, {50, 50});
  // The corner is farther away than the distance.
  add_line(pieces, {{0, -0.09}, {50.09, -0.09}, {50.09, 50}}, false);
  EXPECT_EQ(ink(joined(pieces), false), 0);
}

TEST(NearInk, OfTwoRimsSeenAlongTheAxisOneIsDrawn) {
  for (const bool back_is_visible : {false, true}) {
    Pieces pieces;
    add_line(pieces, rim(30, 64, 0.5), back_is_visible);
    add_line(pieces, rim(30.01, 64, 0));
    const Pieces left = joined(pieces);
    ASSERT_EQ(left.size(), 64U);
    for (std::size_t i = 0; i < 64; ++i) EXPECT_TRUE(same(left[i], pieces[64 + i])) << i;
  }
}

// Where the sagitta is more than the distance, the rims cross one another instead.
TEST(NearInk, RimsFartherApartThanTheDistanceStayWhole) {
  Pieces pieces;
  add_line(pieces, rim(30, 48, 0));
  add_line(pieces, rim(30, 48, 0.5));
  EXPECT_TRUE(std::ranges::equal(joined(pieces, 0.01), pieces, same));
  EXPECT_TRUE(std::ranges::equal(joined(pieces, 0), pieces, same));
}

TEST(NearInk, OfLinesSideBySideThoseStayThatNoneThatStaysIsNearTo) {
  Pieces pieces;
  for (const double y : {0.0, 0.08, 0.16, 0.24, 0.36}) add(pieces, {0, y}, {100, y});
  const Pieces left = joined(pieces);
  ASSERT_EQ(left.size(), 3U);
  EXPECT_EQ(left[0].edge, 0);
  EXPECT_EQ(left[1].edge, 2);
  EXPECT_EQ(left[2].edge, 4);
}

TEST(NearInk, VisibleInkTakesHiddenInkAndNeverTheOtherWay) {
  Pieces pieces;
  add(pieces, {0, 0.06}, {100, 0.06}, false);
  add(pieces, {40, 0}, {60, 0}, true);
  const Pieces left = joined(pieces);
  EXPECT_EQ(ink(left, true), 20);
  EXPECT_NEAR(ink(left, false), 80 + 2 * 0.06, 1e-12);  // both ends are linked
  EXPECT_EQ(std::ranges::count_if(left, [](const drawing::Piece& piece) { return drawing::is_link(piece); }), 2);
  EXPECT_EQ(loose_ends(left), 4);  // those that the lines have
  const auto end = std::ranges::find(left, Vec2(40, 0.06), &drawing::Piece::to);
  ASSERT_NE(end, left.end());
  EXPECT_EQ(end->s, (std::array{0.0, 0.4}));
}

TEST(NearInk, LinesThatCrossOrMeetAtASlightAngleStayWhole) {
  for (const double degrees : {1.5, 3.5, 5.0, 10.0, 25.0, 60.0, 90.0}) {
    const Vec2 way(std::cos(degrees * pi / 180), std::sin(degrees * pi / 180));
    Pieces crossing, meeting;
    add(crossing, {-50, 0}, {50, 0});
    add(crossing, -40.0 * way, 40.0 * way);
    EXPECT_TRUE(unchanged(crossing)) << degrees;
    add(meeting, {0, 0}, {50, 0});
    add(meeting, {0, 0}, 40.0 * way);
    EXPECT_TRUE(unchanged(meeting)) << degrees;
    std::vector<Vec2> fine;  // the same in pieces that are shorter than the distance
    for (int i = -500; i <= 500; ++i) fine.push_back(0.04 * i * way);
    add_line(crossing, fine);
    crossing.erase(crossing.begin() + 1);
    EXPECT_TRUE(unchanged(crossing)) << degrees;
  }
}

TEST(NearInk, AThinSheetBecomesALine) {
  Pieces thin, thick;
  add_line(thin, {{0, 0}, {100, 0}, {100, 0.08}, {0, 0.08}, {0, 0}});
  const Pieces left = joined(thin);
  ASSERT_EQ(left.size(), 1U);
  EXPECT_EQ(drawing::length_of(left[0]), 100);
  add_line(thick, {{0, 0}, {100, 0}, {100, 0.12}, {0, 0.12}, {0, 0}});
  EXPECT_TRUE(unchanged(thick));
}

TEST(NearInk, CornersGoWithTheirSides) {
  const auto square = [](double half) {
    return std::vector<Vec2>{{-half, -half}, {half, -half}, {half, half}, {-half, half}, {-half, -half}};
  };
  Pieces pieces;
  add_line(pieces, square(10), true);
  add_line(pieces, square(10.08), false);
  const Pieces left = joined(pieces);
  EXPECT_EQ(left.size(), 4U);
  EXPECT_EQ(ink(left, true), 80);
}

TEST(NearInk, LinesThatEndedOnATakenLineReachTheOneThatIsDrawn) {
  Pieces pieces;
  add(pieces, {0, 0}, {100, 0});
  add(pieces, {1, 0.08}, {99, 0.08});
  add(pieces, {50, 0.08}, {50, 20});    // from beyond
  add(pieces, {30, -20}, {30, 0.08});   // through the line that stays
  add(pieces, {70, 0.08}, {70.05, 0});  // between both
  const Pieces left = joined(pieces);
  EXPECT_EQ(loose_ends(left), 2 + 2);  // of the long line, and the far ones
  const auto of_edge = [&](int edge) {
    return std::count_if(left.begin(), left.end(), [&](const drawing::Piece& p) { return p.edge == edge; });
  };
  EXPECT_EQ(of_edge(1), 0);
  EXPECT_EQ(of_edge(2), 2);
  EXPECT_EQ(of_edge(4), 0);
  const auto cut = std::ranges::find(left, 3, &drawing::Piece::edge);
  EXPECT_NEAR(glm::distance(cut->to, Vec2(30, 0)), 0, 1e-12);
  EXPECT_NEAR(cut->s[1], 20 / 20.08, 1e-12);
}

TEST(NearInk, VisibleLinesThatEndedOnATakenHiddenLineStay) {
  for (const bool visible : {true, false}) {
    Pieces pieces;
    add(pieces, {0, 0}, {10, 0});
    add(pieces, {0, 0.05}, {10, 0.05}, false);
    add(pieces, {5, 0.05}, {5, 4}, visible);
    const Pieces left = joined(pieces);
    EXPECT_NEAR(ink(left, true) + ink(left, false), 10 + (visible ? 3.95 : 4), 1e-12);
  }
}

TEST(NearInk, ALineThatJoinsTwoOthersGoesOnJoiningThem) {
  Pieces pieces;
  add(pieces, {-10, 0}, {0, 0});
  add(pieces, {0.09, 0}, {12, 0});
  add(pieces, {-5, -0.025}, {3, -0.025});
  const Pieces left = joined(pieces);
  EXPECT_EQ(loose_ends(left), 2);
  EXPECT_NEAR(ink(left, true), 10 + 11.91 + 0.09 + 2 * 0.025, 1e-9);
}

// What is no ink neither takes nor is taken.
TEST(NearInk, WhatIsNotDrawnTakesNothing) {
  Pieces pieces;
  add(pieces, {0, 0}, {100, 0});
  add(pieces, {0, 0.05}, {90, 0.05}, false);
  const Pieces left = drawing::join_near(pieces, {-1, 1}, distance, touching);
  EXPECT_TRUE(std::ranges::equal(left, pieces, same));
}

Pieces random_drawing(std::mt19937& random) {
  const auto number = [&](double least, double most) {
    return std::uniform_real_distribution<double>(least, most)(random);
  };
  Pieces pieces;
  for (int line = 0; line < 12; ++line) {
    const bool visible = number(0, 1) < 0.5;
    const double size = std::pow(10.0, number(-1.5, 0.7)), slope = number(-0.1, 0.1);
    Vec2 at(number(0, 5), number(0, 1));
    double angle = number(0, 1) < 0.7 ? slope : number(0, 2 * pi);
    std::vector<Vec2> points{at};
    for (int i = 0; i < 8; ++i, angle += slope) points.push_back(at += size * Vec2(std::cos(angle), std::sin(angle)));
    add_line(pieces, points, visible);
  }
  return pieces;
}

TEST(NearInk, WhateverIsTakenHasInkAsStrongBesideIt) {
  std::mt19937 random(7);
  int taken = 0;
  const int rounds = at_length() ? 400 : 80;
  for (int round = 0; round < rounds; ++round) {
    const Pieces pieces = random_drawing(random), left = joined(pieces);
    taken += left.size() < pieces.size() ? 1 : 0;
    for (const drawing::Piece& piece : pieces)
      for (int i = 0; i <= 20; ++i) {
        const Vec2 place = piece.from + i / 20.0 * (piece.to - piece.from);
        ASSERT_LE(distance_to(left, place, piece.visible), std::numbers::sqrt2 * distance + 2 * touching)
            << "round " << round << ", piece " << piece.edge << " at " << i / 20.0;
      }
  }
  EXPECT_GT(taken, rounds / 4);
}

// A drawing beside its mirror image: lines of equal length, with ends at equal distances.
TEST(NearInk, NumberingDoesNotDecideWhichLineStays) {
  using Place = std::array<double, 5>;
  const auto places = [](const Pieces& pieces) {
    std::vector<Place> found;
    const auto rounded = [](double x) { return std::round(x * 1e8) + 0.0; };
    for (const drawing::Piece& p : joined(pieces)) {
      const std::array a{rounded(p.from.x), rounded(p.from.y)}, b{rounded(p.to.x), rounded(p.to.y)};
      const auto& [first, last] = std::minmax(a, b);
      found.push_back({first[0], first[1], last[0], last[1], p.visible ? 1.0 : 0.0});
    }
    std::ranges::sort(found);
    return found;
  };
  std::mt19937 random(13);
  for (int round = 0; round < 200; ++round) {
    Pieces pieces = random_drawing(random);
    const auto on_grid = [](const Vec2& p) { return glm::round(p * 0x1p20) / 0x1p20; };
    const std::size_t count = pieces.size();
    for (std::size_t i = 0; i < count; ++i) {
      drawing::Piece& own = pieces[i];
      own.from = on_grid(own.from);
      own.to = on_grid(own.to);
      drawing::Piece mirrored = own;
      mirrored.from.x = 4 - own.from.x;
      mirrored.to.x = 4 - own.to.x;
      pieces.push_back(mirrored);
    }
    const std::vector<Place> before = places(pieces);
    std::shuffle(pieces.begin(), pieces.end(), random);
    for (drawing::Piece& p : pieces)
      if (random() % 2 == 0) {
        std::swap(p.from, p.to);
        std::swap(p.s[0], p.s[1]);
      }
    EXPECT_EQ(places(pieces), before) << round;
  }
}

TEST(NearInk, WhatStaysKeepsItsPlaceAndLooseEndsStayFew) {
  std::mt19937 random(11);
  int before = 0, after = 0;
  for (int round = 0; round < 200; ++round) {
    const Pieces pieces = random_drawing(random), left = joined(pieces);
    for (const drawing::Piece& piece : left) {
      const drawing::Piece& whole = pieces[static_cast<std::size_t>(piece.edge)];
      for (int i = 0; i < 2; ++i) {
        const Vec2 place = whole.from + piece.s[i] * (whole.to - whole.from);
        const Vec2 end = i == 0 ? piece.from : piece.to;
        ASSERT_LE(glm::distance(place, end), is_link(piece) && i == 1 ? 2.5 * distance : 1e-9) << "round " << round;
      }
      EXPECT_EQ(piece.visible, whole.visible);
    }
    before += loose_ends(pieces);
    after += loose_ends(left);
  }
  EXPECT_LE(after, before);
}

// An arc beside its tangent, which it does not meet, is near over 2 sqrt(2 r d) = 3.6 mm, but not one line with it.
TEST(NearInk, LinesThatBendTowardsAnotherAndAwayStayWhole) {
  for (const double apart : {0.01, 0.03, -0.01}) {
    Pieces pieces;
    add_line(pieces, {{-100, 20 + apart}, {100, 20 + apart}});
    add_line(pieces, rim(20, 120, 0.5 + 0.25));
    EXPECT_TRUE(unchanged(pieces)) << apart;
  }
}

// The same distance over the same length, but with corners at both ends.
TEST(NearInk, LinesBetweenCornersAreRemoved) {
  Pieces pieces;
  add_line(pieces, {{-100, 0}, {100, 0}});
  add_line(pieces, {{-1.8, 10}, {-1.8, 0.03}, {1.8, 0.03}, {1.8, 10}});
  EXPECT_NEAR(ink(pieces, true) - ink(joined(pieces), true), 3.6, 0.1);
}

TEST(NearInk, VisibleInkDoesNotDependOnHiddenInk) {
  std::mt19937 random(13);
  for (int round = 0; round < 200; ++round) {
    const Pieces pieces = random_drawing(random);
    Pieces visible, left;
    std::ranges::copy_if(pieces, std::back_inserter(visible), &drawing::Piece::visible);
    std::ranges::copy_if(joined(pieces), std::back_inserter(left), &drawing::Piece::visible);
    EXPECT_TRUE(std::ranges::equal(joined(visible), left, same)) << round;
  }
}

}  // namespace
}  // namespace epura::test::near_ink_test
