// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "drawing/near_parts.hpp"
#include "drawing/near_prefilter.hpp"

namespace epura::test::near_glance_test {
namespace {

constexpr drawing::AlongLimits limits{0.1, 1e-5};

// Polylines of facets of all lengths, many of them in bundles: beside each other, across each other, or running back.
std::vector<drawing::Piece> bundles(int seed) {
  std::mt19937 random(static_cast<unsigned>(seed));
  const auto number = [&](double least, double most) {
    return std::uniform_real_distribution<double>(least, most)(random);
  };
  std::vector<drawing::Piece> pieces;
  for (int bundle = 0; bundle < 40; ++bundle) {
    const Vec2 start(number(0, 60), number(0, 60));
    const double angle = number(0, 7), facet = std::pow(10.0, number(-2, 0.5));
    for (int line = 0; line < 4; ++line) {
      Vec2 at = start + Vec2(number(-0.1, 0.1), number(-0.1, 0.1));
      double turn = angle + number(-0.3, 0.3);
      for (int i = 0; i < 7; ++i) {
        turn += number(-0.3, 0.3);
        const Vec2 next = at + facet * number(0.1, 1) * Vec2(std::cos(turn), std::sin(turn));
        pieces.push_back({at, next, line % 2 == 0, true, EdgeKind::crease, static_cast<int>(pieces.size()), {0, 1}});
        at = next;
      }
    }
  }
  return pieces;
}

struct Taken {
  std::vector<drawing::Piece> pieces;
  std::vector<signed char> strength;
  drawing::Polylines polylines;
  drawing::NearPrefilter prefilter;

  explicit Taken(int seed)
      : pieces(bundles(seed)),
        strength(strengths(pieces)),
        polylines(pieces, strength, {}),
        prefilter(pieces, polylines, limits, {}) {}

  static std::vector<signed char> strengths(const std::vector<drawing::Piece>& pieces) {
    std::vector<signed char> all;
    for (const drawing::Piece& piece : pieces) all.push_back(piece.visible ? 2 : 1);
    return all;
  }
};

// The search among all pieces that were taken before finds none that the prefilter did not see; and the prefilter sees
// what is there, not more than that.
TEST(NearPrefilter, SeesTheLastLineAlongEachPiece) {
  int seen = 0, members = 0;
  for (int seed = 1; seed <= 10; ++seed) {
    const Taken taken(seed);
    drawing::KeptInk kept(taken.pieces, limits);
    int turn = 0;
    for (std::size_t line = 0; line < taken.prefilter.size(); ++line) {
      const drawing::MeasuredPolyline polyline = taken.prefilter[line];
      for (std::size_t i = 0; i < polyline.size(); ++i, ++turn) {
        EXPECT_EQ(taken.prefilter.line_at(static_cast<std::size_t>(turn)), line);
        drawing::NearParts near;
        kept.find_near(polyline, i, near);
        int last = -1;
        for (const drawing::NearPart& part : near.parts) last = std::max(last, part.by);
        EXPECT_GE(polyline[i].after, last);
        EXPECT_LT(polyline[i].after, turn);
        // Nowhere lies so much that the prefilter gives up.
        if (near.parts.empty()) {
          EXPECT_EQ(polyline[i].after, -1) << seed << ", " << turn;
        }
        seen += polyline[i].after >= 0 ? 1 : 0;
        ++members;
        kept.add(polyline.part_of({i, polyline[i].from, polyline[i].to}), polyline[i].direction);
      }
    }
  }
  EXPECT_GT(seen, members / 5);
  EXPECT_LT(seen, members * 19 / 20);
}

// What runs along members is found before those in between have their places, and then completed.
TEST(NearAhead, FindsWhatTheSearchFinds) {
  const Taken taken(3);
  const auto members = static_cast<std::size_t>(
      std::count_if(taken.strength.begin(), taken.strength.end(), [](signed char strength) { return strength >= 0; }));
  drawing::KeptInk kept(taken.pieces, limits);
  drawing::NearAhead ahead;
  std::size_t turn = 0, compared = 0, completed = 0;
  for (std::size_t line = 0; line < taken.prefilter.size(); ++line) {
    const drawing::MeasuredPolyline polyline = taken.prefilter[line];
    if (line % 8 == 0)
      ahead.look(taken.prefilter, kept, turn, taken.prefilter.first(std::min(line + 8, taken.prefilter.size())));
    for (std::size_t i = 0; i < polyline.size(); ++i, ++turn) {
      if (polyline[i].after >= 0) {
        drawing::NearParts found, expected;
        ahead.append(turn, found);
        completed += ahead.has_seen(polyline[i]) ? 0 : 1;
        if (!ahead.has_seen(polyline[i])) kept.find_newer(polyline, i, found);
        kept.find_near(polyline, i, expected);
        ASSERT_EQ(found.parts.size(), expected.parts.size());
        for (std::size_t k = 0; k < found.parts.size(); ++k) {
          EXPECT_EQ(found.parts[k].by, expected.parts[k].by);
          EXPECT_EQ(found.parts[k].stretch, expected.parts[k].stretch);
        }
        EXPECT_EQ(found.contacts, expected.contacts);
        compared += found.parts.size();
      }
      kept.add(polyline.part_of({i, polyline[i].from, polyline[i].to}), polyline[i].direction);
    }
  }
  EXPECT_EQ(turn, members);
  EXPECT_GT(compared, 50U);
  EXPECT_GT(completed, 5U);
}

}  // namespace
}  // namespace epura::test::near_glance_test
