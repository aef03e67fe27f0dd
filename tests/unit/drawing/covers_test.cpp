// SPDX-License-Identifier: Apache-2.0
#include "drawing/covers.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <random>

#include "visibility/spans.hpp"

namespace epura::test::covers_test {
namespace {

constexpr double tolerance = 1e-6;
// With the first, pieces that lie on one another may differ in direction by much; with the second, by little.
constexpr std::array<double, 2> leasts = {8e-6, 4e-5};
constexpr double min = leasts[0];

// Every piece against every other. Where two cover the same of a piece, they are one cover.
std::vector<drawing::Cover> all_covers(const std::vector<drawing::Piece>& pieces, double min_overlap = min) {
  std::vector<drawing::Cover> covers;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const drawing::Ruler line(pieces[i].from, pieces[i].to);
    for (const drawing::Piece& upper : pieces) {
      if (!drawing::outranks(upper, pieces[i])) continue;
      const auto [from, to] = drawing::covered_part(line, upper.from, upper.to, tolerance, min_overlap);
      if (to > from) covers.push_back({static_cast<int>(i), from, to});
    }
  }
  std::sort(covers.begin(), covers.end());
  covers.erase(std::unique(covers.begin(), covers.end()), covers.end());
  return covers;
}

// Pieces of a few lines in all directions through a few points, moved aside by about the tolerance.
std::vector<drawing::Piece> bundle(int count, unsigned seed) {
  std::mt19937 random(seed);
  const auto uniform = [&](double from, double to) {
    return from + (to - from) * static_cast<double>(random()) / 4294967296.0;
  };
  std::vector<drawing::Piece> pieces;
  for (int i = 0; i < count; ++i) {
    const double angle = static_cast<double>(random() % 12) * std::numbers::pi / 6 + uniform(-1e-7, 1e-7);
    const Vec2 along(std::cos(angle), std::sin(angle));
    const Vec2 through(static_cast<double>(random() % 3), static_cast<double>(random() % 3));
    const Vec2 aside = uniform(-1e-6, 1e-6) * Vec2(-along.y, along.x);
    const double start = uniform(-5, 5), length = std::pow(10, uniform(-5, 0.7));
    pieces.push_back({through + aside + start * along,
                      through + aside + (start + length) * along,
                      random() % 2 == 0,
                      true,
                      EdgeKind::crease,
                      i,
                      {0, 1}});
  }
  return pieces;
}

TEST(Covers, AreThoseOfEveryPieceAgainstEveryOther) {
  for (const double min_overlap : leasts)
    for (unsigned seed = 0; seed < 3; ++seed) {
      const std::vector<drawing::Piece> pieces = bundle(800, seed);
      const std::vector<drawing::Cover> expected = all_covers(pieces, min_overlap);
      EXPECT_GT(expected.size(), 250U);
      EXPECT_EQ(drawing::find_covers(pieces, tolerance, min_overlap), expected);
    }
}

// Long and short pieces of two lines that cross, moved aside by a little more than the tolerance.
std::vector<drawing::Piece> crowd(int count, unsigned seed) {
  std::mt19937 random(seed);
  const auto uniform = [&](double from, double to) {
    return from + (to - from) * static_cast<double>(random()) / 4294967296.0;
  };
  std::vector<drawing::Piece> pieces;
  for (int i = 0; i < count; ++i) {
    const Vec2 along = random() % 2 == 0 ? Vec2(0.6, 0.8) : Vec2(1, 0);
    const Vec2 start = uniform(-5, 5) * along + uniform(-1.5e-6, 1.5e-6) * Vec2(-along.y, along.x);
    const double length = i % 4 == 0 ? std::pow(10, uniform(-5, 0)) : uniform(4, 6);
    const Vec2 end = start + length * along + uniform(-1e-6, 1e-6) * Vec2(-along.y, along.x);
    pieces.push_back({start, end, random() % 2 == 0, true, EdgeKind::crease, i, {0, 1}});
  }
  std::shuffle(pieces.begin(), pieces.end(), random);
  return pieces;
}

// What covers leave of each piece, but for what is too short to be drawn.
std::vector<visibility::Spans> rests(const std::vector<drawing::Piece>& pieces,
                                     const std::vector<drawing::Cover>& covers, double min_overlap) {
  std::vector<visibility::Spans> rests(pieces.size());
  std::vector<double> end(pieces.size(), 0);
  const auto add = [&](int piece, double from, double to) {
    if (to - from >= min_overlap) rests[piece].push_back({from, to});
  };
  for (const drawing::Cover& cover : covers) {
    add(cover.piece, end[cover.piece], cover.from);
    end[cover.piece] = std::max(end[cover.piece], cover.to);
  }
  for (std::size_t i = 0; i < pieces.size(); ++i) add(static_cast<int>(i), end[i], drawing::length_of(pieces[i]));
  return rests;
}

TEST(Covers, OfCrowdsLeaveWhatAllWould) {
  for (const double min_overlap : leasts) {
    const std::vector<drawing::Piece> pieces = crowd(5000, 0);
    const std::vector<drawing::Cover> all = all_covers(pieces, min_overlap),
                                      found = drawing::find_covers(pieces, tolerance, min_overlap);
    EXPECT_LT(found.size(), all.size() / 4) << "no crowds";
    EXPECT_EQ(rests(pieces, found, min_overlap), rests(pieces, all, min_overlap));
  }
}

// Many lines that nearly meet: bundles in all directions, each in several places.
TEST(Covers, OfManyBundlesLeaveWhatAllWould) {
  for (const double min_overlap : leasts) {
    const std::vector<drawing::Piece> pieces = bundle(6000, 7);
    EXPECT_EQ(rests(pieces, drawing::find_covers(pieces, tolerance, min_overlap), min_overlap),
              rests(pieces, all_covers(pieces, min_overlap), min_overlap));
  }
}

// Each goes a little farther than all before: there are as many pairs as the square of their number.
TEST(Covers, OfARowAreFoundInAFewTries) {
  std::vector<drawing::Piece> pieces;
  const Vec2 along(0.6, 0.8), across(-0.8, 0.6);
  for (int i = 0; i < 10000; ++i) {
    const Vec2 start = 1e-4 * i * along + 1e-7 * (i * 7 % 10) * across;
    pieces.push_back({start, start + 100.0 * along, false, true, EdgeKind::crease, i, {0, 1}});
  }
  const std::vector<drawing::Cover> covers = drawing::find_covers(pieces, tolerance, min);
  ASSERT_EQ(covers.size(), pieces.size() - 1);
  for (std::size_t i = 0; i < covers.size(); ++i) {
    EXPECT_EQ(covers[i].piece, static_cast<int>(i) + 1);
    EXPECT_NEAR(covers[i].from, 0, 1e-9);
    EXPECT_NEAR(covers[i].to, 100 - 1e-4, 1e-9);
  }
}

TEST(Covers, TheSameLineHalfATurnAway) {
  const auto piece = [](Vec2 from, Vec2 to, int edge) {
    return drawing::Piece{from, to, true, true, EdgeKind::crease, edge, {0, 1}};
  };
  const std::vector<drawing::Piece> pieces{piece({0, 0}, {1, 1e-9}, 0), piece({0.25, 1e-9}, {0.75, 0}, 1),
                                           piece({0.5, 0}, {-1, 0}, 2)};
  EXPECT_EQ(drawing::find_covers(pieces, tolerance, min), all_covers(pieces));
  EXPECT_EQ(drawing::find_covers(pieces, tolerance, min).size(), 3U);
  EXPECT_TRUE(drawing::find_covers({}, tolerance, min).empty());
}

}  // namespace
}  // namespace epura::test::covers_test
