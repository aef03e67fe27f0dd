// SPDX-License-Identifier: Apache-2.0
// What would break if this were wrong: curves that are drawn where the model has none, and the lengths of dashes.
#include "drawing/arcs.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "drawing/conic_fit.hpp"
#include "drawing/curve_part.hpp"

namespace epura::test::arcs_test {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double tolerance = 0.01;

Vec2 turned(const Vec2& p, double angle) {
  return {std::cos(angle) * p.x - std::sin(angle) * p.y, std::sin(angle) * p.x + std::cos(angle) * p.y};
}

// An ellipse with half axes a along `slant` and b across it.
drawing::Ellipse ellipse(Vec2 centre, double a, double b, double slant = 0) {
  return {centre, turned({a, 0}, slant), turned({0, b}, slant)};
}

std::vector<Vec2> points_of(const drawing::Ellipse& e, double from, double to, int steps) {
  std::vector<Vec2> points;
  for (int i = 0; i <= steps; ++i) points.push_back(e.at(from + (to - from) * i / steps));
  return points;
}

// The largest distance of the curve from its chords, measured at many points.
double highest_over_chords(const drawing::Ellipse& e, double from, double to, int steps) {
  const std::vector<Vec2> points = points_of(e, from, to, steps);
  double highest = 0;
  for (int i = 0; i < steps; ++i) {
    const Vec2 a = points[std::size_t(i)], d = glm::normalize(points[std::size_t(i) + 1] - a);
    for (int j = 0; j <= 200; ++j) {
      const Vec2 p = e.at(from + (to - from) * (i + j / 200.0) / steps) - a;
      highest = std::max(highest, std::abs(cross(d, p)));
    }
  }
  return highest;
}

drawing::Chain chain_of(std::vector<Vec2> points, bool closed) {
  if (closed) points.pop_back();
  return {std::move(points), closed, true, EdgeKind::crease, {0}};
}

drawing::CurveReport find(drawing::Chain& chain) {
  std::vector<drawing::Chain> chains{chain};
  const drawing::CurveReport report = drawing::find_curves(chains, {tolerance});
  chain = chains.front();
  return report;
}

// Corners lie on their curves, at angles that go one way from `from` to `to`.
void expect_consistent(const drawing::Chain& chain) {
  for (const drawing::CurvePart& part : chain.curves) {
    ASSERT_LT(part.first, part.last);
    const Vec2 first = chain.points[std::size_t(part.first)];
    const Vec2 last = chain.points[std::size_t(part.last) % chain.points.size()];
    EXPECT_LT(glm::distance(drawing::position_on_curve(part, part.from), first), 2 * tolerance);
    EXPECT_LT(glm::distance(drawing::position_on_curve(part, part.to), last), 2 * tolerance);
    EXPECT_NEAR(glm::dot(part.u, part.v), 0, 1e-9 * glm::length(part.u) * glm::length(part.v));
  }
}

struct Round {
  double a, b, slant;
  int steps;
};

class Whole : public testing::TestWithParam<Round> {};
INSTANTIATE_TEST_SUITE_P(Arcs, Whole,
                         testing::Values(Round{20, 20, 0, 12}, Round{20, 20, 0, 13}, Round{90, 90, 0.3, 400},
                                         Round{20, 11, 0.7, 12}, Round{20, 11, 2, 64}, Round{50, 1, 1, 24},
                                         Round{80, 0.2, 3, 96}, Round{3, 2.9, 0, 36}));

TEST_P(Whole, RingsAreOneCurve) {
  const auto [a, b, slant, steps] = GetParam();
  const drawing::Ellipse e = ellipse({130, -70}, a, b, slant);
  for (const double sign : {1.0, -1.0}) {
    drawing::Chain chain = chain_of(points_of(e, 0.4, 0.4 + sign * 2 * pi, steps), true);
    const drawing::CurveReport report = find(chain);
    EXPECT_EQ(report.circles, a == b ? 1 : 0);
    EXPECT_EQ(report.ellipses, a == b ? 0 : 1);
    EXPECT_LT(report.deviation, 1e-7);
    const double rise = highest_over_chords(e, 0.4, 0.4 + sign * 2 * pi, steps);
    EXPECT_NEAR(report.bulge, rise, 1e-3 * rise);
    ASSERT_EQ(chain.curves.size(), 1U);
    const drawing::CurvePart& part = chain.curves[0];
    EXPECT_EQ(part.first, 0);
    EXPECT_EQ(part.last, steps);
    EXPECT_NEAR(part.to - part.from, sign * 2 * pi, 1e-6);
    EXPECT_LT(glm::distance(part.centre, e.centre), 1e-6);
    EXPECT_NEAR(std::max(glm::length(part.u), glm::length(part.v)), a, 1e-6);
    EXPECT_NEAR(std::min(glm::length(part.u), glm::length(part.v)), b, 1e-6);
    expect_consistent(chain);
  }
}

TEST(Arcs, OfAClosedLineThatBeginsInACurveMoveItsLinesWithItsPoints) {
  // A slot, from the middle of one end.
  std::vector<Vec2> slot = points_of(ellipse({20, 0}, 5, 5), 0, pi / 2, 8);
  for (const Vec2& p : points_of(ellipse({0, 0}, 5, 5), pi / 2, 3 * pi / 2, 16)) slot.push_back(p);
  for (const Vec2& p : points_of(ellipse({20, 0}, 5, 5), -pi / 2, 0, 8)) slot.push_back(p);
  drawing::Chain chain = chain_of(slot, true);
  slot.pop_back();
  chain.segments.resize(slot.size());
  for (std::size_t i = 0; i < slot.size(); ++i) chain.segments[i] = static_cast<int>(i);
  find(chain);
  EXPECT_EQ(chain.curves.size(), 2U);
  ASSERT_EQ(chain.segments.size(), slot.size());
  ASSERT_EQ(chain.points.size(), slot.size());
  EXPECT_NE(chain.segments[0], 0);
  for (std::size_t i = 0; i < slot.size(); ++i)
    EXPECT_LT(glm::distance(chain.points[i], slot[static_cast<std::size_t>(chain.segments[i])]), 1e-9);
}

TEST(Arcs, PolygonsStayPolygons) {
  for (int n = 3; n < 12; ++n)
    for (const double flat : {1.0, 0.4}) {
      drawing::Chain chain = chain_of(points_of(ellipse({0, 0}, 30, 30 * flat, 0.2), 0, 2 * pi, n), true);
      EXPECT_EQ(find(chain).circles + find(chain).ellipses, 0) << n;
    }
}

TEST(Arcs, NoiseHasNone) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> place(0, 50), step(-1, 1);
  for (int round = 0; round < 200; ++round) {
    std::vector<Vec2> scattered, walk{{0, 0}}, wavy;
    for (int i = 0; i < 60; ++i) {
      scattered.emplace_back(place(random), place(random));
      walk.push_back(walk.back() + Vec2(1 + step(random), step(random)));
      wavy.emplace_back(place(random) / 50 + i, 0.05 * step(random));
    }
    for (const auto& points : {scattered, walk, wavy}) {
      drawing::Chain chain = chain_of(points, false);
      find(chain);
      EXPECT_TRUE(chain.curves.empty());
    }
  }
}

// Line, half circle, line, half circle.
TEST(Arcs, ASlotHasTwo) {
  std::vector<Vec2> points = points_of(ellipse({40, 0}, 6, 6), -pi / 2, pi / 2, 10);
  const auto left = points_of(ellipse({-40, 0}, 6, 6), pi / 2, 3 * pi / 2, 10);
  points.insert(points.end(), left.begin(), left.end());
  for (std::size_t turn = 0; turn < points.size(); ++turn) {
    std::rotate(points.begin(), points.begin() + 1, points.end());
    drawing::Chain chain{points, true, true, EdgeKind::crease, {0}};
    EXPECT_EQ(find(chain).circles, 2);
    ASSERT_EQ(chain.curves.size(), 2U);
    for (const drawing::CurvePart& part : chain.curves) {
      EXPECT_EQ(part.last - part.first, 10);
      EXPECT_NEAR(part.to - part.from, pi, 1e-9);
      EXPECT_NEAR(std::abs(part.centre.x), 40, 1e-9);
    }
    EXPECT_LE(chain.curves[0].last, chain.curves[1].first);
    EXPECT_LE(chain.curves[1].last, int(points.size()));
    expect_consistent(chain);
  }
}

// Along a circle and back, between its own corners.
TEST(Arcs, EndWhereALineTurnsBack) {
  const drawing::Ellipse e = ellipse({0, 0}, 30, 30);
  std::vector<Vec2> points = points_of(e, 0, pi, 18);
  const std::vector<Vec2> back = points_of(e, pi - pi / 36, pi / 2 - pi / 36, 9);
  points.insert(points.end(), back.begin(), back.end());
  drawing::Chain chain = chain_of(points, false);
  find(chain);
  ASSERT_FALSE(chain.curves.empty());
  EXPECT_EQ(chain.curves[0].first, 0);
  EXPECT_EQ(chain.curves[0].last, 18);
  EXPECT_NEAR(chain.curves[0].to - chain.curves[0].from, pi, 1e-9);
}

// Noise that an ellipse fits a little better.
TEST(Arcs, OfACircleStayCirclesDespiteNoise) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> noise(-0.3 * tolerance, 0.3 * tolerance);
  for (int round = 0; round < 100; ++round) {
    std::vector<Vec2> points;
    for (int i = 0; i <= 30; ++i) {
      const double angle = 2 * pi * i / 30, radius = 40 + noise(random);
      points.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
    }
    points.back() = points.front();
    drawing::Chain chain = chain_of(points, true);
    const drawing::CurveReport report = find(chain);
    EXPECT_EQ(report.circles, 1);
    EXPECT_EQ(report.ellipses, 0);
  }
}

TEST(Arcs, EndsOnChordsAreMovedOntoTheCurve) {
  const drawing::Ellipse e = ellipse({0, 0}, 50, 20, 0.5);
  std::vector<Vec2> points = points_of(e, 0, pi, 20);
  points.front() = 0.4 * points[0] + 0.6 * points[1];
  points.back() = 0.3 * points[19] + 0.7 * points[20];
  drawing::Chain chain = chain_of(points, false);
  find(chain);
  ASSERT_EQ(chain.curves.size(), 1U);
  EXPECT_EQ(chain.curves[0].first, 0);
  EXPECT_EQ(chain.curves[0].last, 20);
  expect_consistent(chain);
  EXPECT_LT(e.distance(chain.points.front()), 1e-9);
  EXPECT_LT(glm::distance(chain.points.front(), points.front()), 50 * (1 - std::cos(pi / 40)));
}

// A fillet of 0.3 mm between long straight lines, which run on to the flat ends of an ellipse.
TEST(Arcs, DoNotReplaceStraightLinesBesideAFillet) {
  const drawing::Ellipse e = ellipse({0, 0}, 1071, 9.8);
  std::vector<Vec2> points;
  for (const double angle : {-0.34, -0.021, -0.016, -0.011, -0.007, -0.002, 0.002, 0.007, 0.011, 0.016, 0.021, 0.34})
    points.push_back(e.at(angle));
  points.insert(points.begin(), points.front() - Vec2(1, -0.5));
  points.push_back(points.back() - Vec2(1, 0.5));
  drawing::Chain chain = chain_of(points, false);
  const drawing::CurveReport report = find(chain);
  EXPECT_LT(report.bulge, 2 * tolerance);
  for (const drawing::CurvePart& part : chain.curves)
    for (int i = part.first; i < part.last; ++i)
      EXPECT_LT(glm::distance(points[std::size_t(i)], points[std::size_t(i) + 1]), 1) << "lines stay lines";
}

TEST(Arcs, OfALineThatGoesOnStraightTheEndStays) {
  std::vector<Vec2> points = points_of(ellipse({0, 0}, 50, 50), 0, pi / 2, 10);
  points.emplace_back(-60, 50);
  drawing::Chain chain = chain_of(points, false);
  find(chain);
  ASSERT_EQ(chain.curves.size(), 1U);
  EXPECT_EQ(chain.curves[0].last, 10);
  EXPECT_EQ(chain.points.back(), Vec2(-60, 50));
}

TEST(Arcs, PartsOfEllipsesAreFound) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> unit(0, 1);
  for (int round = 0; round < 300; ++round) {
    const double a = 2 + 100 * unit(random), b = a * (0.05 + 0.9 * unit(random));
    const drawing::Ellipse e = ellipse({200 * unit(random), 200 * unit(random)}, a, b, pi * unit(random));
    const double from = 2 * pi * unit(random), sweep = pi * (0.5 + 1.4 * unit(random));
    drawing::Chain chain = chain_of(points_of(e, from, from + sweep, 12 + int(60 * unit(random))), false);
    const drawing::CurveReport report = find(chain);
    ASSERT_EQ(chain.curves.size(), 1U) << round;
    EXPECT_EQ(chain.curves[0].last, int(chain.points.size()) - 1);
    EXPECT_LT(report.deviation, tolerance);
    // Between the corners, too.
    for (int i = 0; i <= 100; ++i) {
      const drawing::CurvePart& part = chain.curves[0];
      EXPECT_LT(e.distance(drawing::position_on_curve(part, part.from + (part.to - part.from) * i / 100)),
                2 * tolerance)
          << round;
    }
  }
}

}  // namespace
}  // namespace epura::test::arcs_test
