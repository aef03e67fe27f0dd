// SPDX-License-Identifier: Apache-2.0
#include "mesh/even_odd.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace epura::even_odd_test {
namespace {

void add_ring(mesh::Outlines& outlines, const std::vector<Vec2>& ring) {
  const int first = static_cast<int>(outlines.places.size());
  const int count = static_cast<int>(ring.size());
  outlines.places.insert(outlines.places.end(), ring.begin(), ring.end());
  for (int i = 0; i < count; ++i) outlines.segments.push_back({first + i, first + (i + 1) % count});
}

double signed_area(const mesh::Outlines& outlines, const std::array<int, 3>& t) {
  const Vec2 a = outlines.places[t[0]], b = outlines.places[t[1]], c = outlines.places[t[2]];
  return ((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x)) / 2;
}

double filled_area(mesh::Outlines outlines) {
  double sum = 0;
  for (const auto& triangle : mesh::fill_even_odd(outlines)) {
    EXPECT_GE(signed_area(outlines, triangle), -1e-15);  // where segments cross, places are rounded
    sum += signed_area(outlines, triangle);
  }
  return sum;
}

TEST(EvenOdd, FillsSquaresWithHolesAndIslands) {
  mesh::Outlines outlines;
  add_ring(outlines, {{0, 0}, {10, 0}, {10, 10}, {0, 10}});
  EXPECT_EQ(filled_area(outlines), 100);
  add_ring(outlines, {{2, 2}, {2, 8}, {8, 8}, {8, 2}});
  EXPECT_EQ(filled_area(outlines), 64);
  add_ring(outlines, {{4, 4}, {6, 4}, {6, 6}, {4, 6}});
  EXPECT_EQ(filled_area(outlines), 68);
  EXPECT_TRUE(mesh::is_inside(outlines, {1, 5}));
  EXPECT_FALSE(mesh::is_inside(outlines, {3, 5}));
  EXPECT_TRUE(mesh::is_inside(outlines, {5, 5}));
  EXPECT_FALSE(mesh::is_inside(outlines, {11, 5}));
}

TEST(EvenOdd, FillsAStarThatCrossesItself) {
  mesh::Outlines star;
  std::vector<Vec2> ring;
  for (int i = 0; i < 5; ++i) ring.emplace_back(std::sin(4 * M_PI * i / 5), std::cos(4 * M_PI * i / 5));
  add_ring(star, ring);
  // Five tips around a pentagon that is crossed twice. Radius of the pentagon: sin 18 / sin 54 degrees.
  const double inner = std::sin(M_PI / 10) / std::sin(3 * M_PI / 10);
  const double whole = 5 * inner * std::sin(M_PI / 5);
  const double pentagon = 2.5 * inner * inner * std::sin(2 * M_PI / 5);
  EXPECT_NEAR(filled_area(star), whole - pentagon, 1e-12);
}

TEST(EvenOdd, FillsBowTiesAndCoincidentRings) {
  mesh::Outlines tie;
  add_ring(tie, {{0, 0}, {4, 4}, {4, 0}, {0, 4}});
  EXPECT_NEAR(filled_area(tie), 8, 1e-12);
  add_ring(tie, {{0, 0}, {4, 4}, {4, 0}, {0, 4}});
  EXPECT_NEAR(filled_area(tie), 0, 1e-12);
}

TEST(EvenOdd, AgreesWithCrossingNumbers) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> place(0, 1);
  mesh::Outlines outlines;
  for (int r = 0; r < 6; ++r) {
    std::vector<Vec2> ring;
    for (int i = 0; i < 9; ++i) ring.emplace_back(place(random), place(random));
    add_ring(outlines, ring);
  }
  mesh::Outlines filled = outlines;
  const auto triangles = mesh::fill_even_odd(filled);
  for (int i = 0; i < 4000; ++i) {
    const Vec2 p(place(random), place(random));
    int holding = 0;
    for (auto [a, b, c] : triangles) {
      const bool inside = signed_area({{filled.places[a], filled.places[b], p}, {}}, {0, 1, 2}) >= 0 &&
                          signed_area({{filled.places[b], filled.places[c], p}, {}}, {0, 1, 2}) >= 0 &&
                          signed_area({{filled.places[c], filled.places[a], p}, {}}, {0, 1, 2}) >= 0;
      holding += inside ? 1 : 0;
    }
    EXPECT_EQ(holding, mesh::is_inside(outlines, p) ? 1 : 0) << p.x << " " << p.y;
  }
}

TEST(EvenOdd, TakesTimeInProportionToManyPlaces) {
  mesh::Outlines comb;
  std::vector<Vec2> ring;
  constexpr int teeth = 20000;
  for (int i = 0; i < teeth; ++i) ring.insert(ring.end(), {Vec2(i, 1 + 1e-6 * i), Vec2(i + 0.5, 0)});
  ring.insert(ring.end(), {Vec2(teeth, -1), Vec2(0, -1)});
  add_ring(comb, ring);
  mesh::Outlines turned = comb;
  for (Vec2& p : turned.places) p = {-p.y, p.x};
  EXPECT_NEAR(filled_area(turned) / (teeth * 1.5), 1, 0.01);
}

}  // namespace
}  // namespace epura::even_odd_test
