#include "drawing/covers.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

namespace epura::test {
namespace {

constexpr double tolerance = 1e-6;
constexpr double least = 8e-6;

// Every piece against every other.
std::vector<Cover> all_covers(const std::vector<Piece>& pieces) {
  std::vector<Cover> covers;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const Ruler line(pieces[i].from, pieces[i].to);
    for (const Piece& upper : pieces) {
      if (!(rank(upper) < rank(pieces[i]))) continue;
      const auto [from, to] = covered_part(line, upper.from, upper.to, tolerance, least);
      if (to > from) covers.push_back({static_cast<int>(i), from, to});
    }
  }
  std::sort(covers.begin(), covers.end());
  return covers;
}

// Pieces of a few lines in all directions through a few points, moved aside by about the tolerance.
std::vector<Piece> bundle(int count, unsigned seed) {
  std::mt19937 random(seed);
  const auto uniform = [&](double from, double to) {
    return from + (to - from) * static_cast<double>(random()) / 4294967296.0;
  };
  std::vector<Piece> pieces;
  for (int i = 0; i < count; ++i) {
    const double angle = static_cast<double>(random() % 12) * std::numbers::pi / 6 + uniform(-1e-7, 1e-7);
    const Vec2 along(std::cos(angle), std::sin(angle));
    const Vec2 through(static_cast<double>(random() % 3), static_cast<double>(random() % 3));
    const Vec2 aside = uniform(-1e-6, 1e-6) * Vec2(-along.y, along.x);
    const double start = uniform(-5, 5), length = std::pow(10, uniform(-5, 0.7));
    pieces.push_back({through + aside + start * along,
                      through + aside + (start + length) * along,
                      random() % 2 == 0,
                      EdgeKind::crease,
                      i,
                      {0, 1}});
  }
  return pieces;
}

TEST(Covers, AreThoseOfEveryPieceAgainstEveryOther) {
  for (unsigned seed = 0; seed < 3; ++seed) {
    const std::vector<Piece> pieces = bundle(800, seed);
    const std::vector<Cover> expected = all_covers(pieces);
    EXPECT_GT(expected.size(), 300U);
    EXPECT_EQ(find_covers(pieces, tolerance, least), expected);
  }
}

TEST(Covers, TheSameLineHalfATurnAway) {
  const auto piece = [](Vec2 from, Vec2 to, int edge) { return Piece{from, to, true, EdgeKind::crease, edge, {0, 1}}; };
  const std::vector<Piece> pieces{piece({0, 0}, {1, 1e-9}, 0), piece({0.25, 1e-9}, {0.75, 0}, 1),
                                  piece({0.5, 0}, {-1, 0}, 2)};
  EXPECT_EQ(find_covers(pieces, tolerance, least), all_covers(pieces));
  EXPECT_EQ(find_covers(pieces, tolerance, least).size(), 3U);
  EXPECT_TRUE(find_covers({}, tolerance, least).empty());
}

}  // namespace
}  // namespace epura::test
