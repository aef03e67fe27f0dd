// SPDX-License-Identifier: Apache-2.0
// The rule for single points against rational numbers: needles at a corner where an edge begins.
#include "study/methods/point_rule.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "oracle/truth.hpp"

namespace epura::test::point_rule_test {
namespace {

// What is forgiven, of a drawing of size 1: as much as points beside a side are, and in depth from a common corner on.
constexpr double joined = 0x1p-44;
constexpr double beside = 0x1p-43;

class Needles {
 public:
  explicit Needles(unsigned seed) : random_(seed) {}

  // An edge from vertex 0 or 3 to the other, and a triangle 0, 1, 2 along it: as low as 2^-38 of its length, as steep
  // as may be, its plane a little before the edge or behind it.
  view::ProjectedScene view() {
    const Vec2 corner(number(-0.5, 0.5), number(-0.5, 0.5));
    const double angle = number(0, 2 * M_PI), length = number(0.01, 0.4);
    const Vec2 along(std::cos(angle), std::sin(angle)), across(-along.y, along.x);
    const double height = length * power(-38, -1);
    view::ProjectedScene view;
    view.extent = 1;
    view.vertices = {at(corner), at(corner + length * along), at(corner + number(0.3, 1) * length * along)};
    view.vertices[2] = at(Vec2(view.vertices[2].x, view.vertices[2].y) + height * across);
    view.triangles = {{{0, 1, 2}, 0}};
    const Vec2 way = number(0.5, 2) * length * along + number(-0.5, 1.5) * height * across;
    view.vertices.push_back(at(corner + way));
    view::PageVertex& end = view.vertices.back();
    end.depth = 0;
    const PointTruth truth = truth_of_point(triangle(view), {view.vertices[0], end}, 1);
    end.depth = truth.ahead + (random_() % 2 == 0 ? 1 : -1) * truth.steepness * power(-46, 0);
    return view;
  }
  // Many of them near 0.
  double position() { return power(-40, 0); }

  static std::array<view::PageVertex, 3> triangle(const view::ProjectedScene& view) {
    return {view.vertices[0], view.vertices[1], view.vertices[2]};
  }

 private:
  double number(double min, double max) { return min + (max - min) * (static_cast<double>(random_()) / 4294967296.0); }
  double power(double min, double max) { return std::exp2(number(min, max)); }
  view::PageVertex at(const Vec2& place) { return {place.x, place.y, number(-0.5, 0.5), 1}; }

  std::mt19937 random_;
};

TEST(PointRule, HoldsForNeedlesAtACorner) {
  int hidden = 0, visible = 0;
  for (unsigned seed = 1; seed <= 20000; ++seed) {
    Needles needles(seed);
    view::ProjectedScene view = needles.view();
    view.contact = {joined, joined, 0};
    const bool forward = seed % 2 == 0;
    const study::PointRule rule(view, forward ? visibility::PageEdge{0, 3} : visibility::PageEdge{3, 0});
    const double s = needles.position();
    const PointTruth truth = truth_of_point(Needles::triangle(view), {view.vertices[0], view.vertices[3]}, s);
    const bool hides = rule.hides(view.triangles[0], forward ? s : 1 - s);
    if (truth.inside > 0 && truth.ahead > 4 * joined * truth.steepness * s) {
      EXPECT_TRUE(hides) << seed;
      ++hidden;
    }
    if (truth.inside < -beside || truth.ahead < 0) {
      EXPECT_FALSE(hides) << seed;
      ++visible;
    }
  }
  EXPECT_GT(hidden, 1000);
  EXPECT_GT(visible, 1000);
}

}  // namespace
}  // namespace epura::test::point_rule_test
