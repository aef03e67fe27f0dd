// SPDX-License-Identifier: Apache-2.0
#include "drawing/strands.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <set>

namespace epura::test::strands_test {
namespace {

constexpr double tolerance = 1e-6, spread = 0.06;

// Of 1 to 40 mm in any direction on a square of 100 mm.
std::vector<drawing::Piece> lines_at_random(int count) {
  std::mt19937 random(1);
  const auto uniform = [&](double from, double to) {
    return from + (to - from) * static_cast<double>(random()) / 4294967296.0;
  };
  std::vector<drawing::Piece> pieces;
  for (int i = 0; i < count; ++i) {
    const Vec2 from(uniform(0, 100), uniform(0, 100));
    const double angle = uniform(0, 2 * std::numbers::pi), length = uniform(1, 40);
    pieces.push_back(
        {from, from + length * Vec2(std::cos(angle), std::sin(angle)), true, true, EdgeKind::crease, i, {0, 1}});
  }
  return pieces;
}

template <class Visit>
void visit_divided(const drawing::Strands& strands, const Visit& visit) {
  if (const auto parts = drawing::divide(strands, tolerance, true)) {
    visit_divided(parts->first, visit);
    visit_divided(parts->second, visit);
  } else
    visit(strands);
}

template <class Visit>
void visit_all(const std::vector<drawing::Piece>& pieces, const Visit& visit) {
  const drawing::DirectionClasses directions(pieces, spread, {});
  for (std::size_t i = 0; i < directions.size(); ++i) visit_divided(directions.strands(i), visit);
}

// Pairs to be tried, and strands held, for each piece.
std::array<double, 2> load_of(int count) {
  double pairs = 0, strands = 0;
  visit_all(lines_at_random(count), [&](const drawing::Strands& few) {
    const auto ends =
        std::count_if(few.begin(), few.end(), [](const drawing::Strand& s) { return s.begins || s.ends; });
    pairs += static_cast<double>(few.size()) * static_cast<double>(ends);
    strands += static_cast<double>(few.size());
  });
  return {pairs / count, strands / count};
}

// Each crosses a good part of all others: ten times as many lines have a hundred times as many crossings, and ten times
// as many pairs for each line. Long cells leave a quarter of these.
TEST(Strands, OfLinesAtRandomMeetFewPairs) {
  const auto few = load_of(10000), many = load_of(100000);
  EXPECT_LT(many[0], 2.7 * few[0]);
  EXPECT_LT(many[1], 3.2 * few[1]);
}

TEST(Strands, MeetWhereOneEndsBesideTheOther) {
  std::vector<drawing::Piece> pieces = lines_at_random(3000);
  const std::size_t count = pieces.size();
  for (std::size_t i = 0; i < count; ++i) {  // a part of each, some way inside
    drawing::Piece part = pieces[i];
    part.from = 0.7 * pieces[i].from + 0.3 * pieces[i].to;
    part.to = 0.4 * pieces[i].from + 0.6 * pieces[i].to;
    if (i % 2 == 0) std::swap(part.from, part.to);
    pieces.push_back(part);
  }
  std::set<std::size_t> met;
  visit_all(pieces, [&](const drawing::Strands& few) {
    std::set<std::size_t> begin, here;
    for (const drawing::Strand& s : few) {
      here.insert(static_cast<std::size_t>(s.piece));
      if (s.begins) begin.insert(static_cast<std::size_t>(s.piece));
    }
    for (const std::size_t piece : begin)
      if (piece >= count && here.contains(piece - count)) met.insert(piece);
  });
  EXPECT_EQ(met.size(), count);
}

TEST(Strands, OnOneLineAreNotDivided) {
  std::vector<drawing::Piece> pieces;
  for (int i = 0; i < 1000; ++i)
    pieces.push_back({{1e-5 * i, 1e-9 * i}, {50 + 1e-5 * i, 0}, true, true, EdgeKind::crease, i, {0, 1}});
  double strands = 0;
  visit_all(pieces, [&](const drawing::Strands& few) { strands += static_cast<double>(few.size()); });
  EXPECT_LE(strands, 4.0 * static_cast<double>(pieces.size()));
}

}  // namespace
}  // namespace epura::test::strands_test
