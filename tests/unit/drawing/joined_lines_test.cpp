// SPDX-License-Identifier: Apache-2.0
// What would break if this were wrong: lines end before or beyond the line that hides them as soon as arcs are drawn.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "base/nearest.hpp"
#include "drawing/curve_part.hpp"
#include "drawing/exact_lines.hpp"
#include "laboratory/lab.hpp"

namespace epura::test::joined_lines_test {
namespace {

using namespace laboratory;

constexpr double scale = 100;      // mm of the size of a part
constexpr double touching = 1e-3;  // mm
constexpr double joined = 0.01;    // mm; a fiftieth of the width of a line

class Parts {
 public:
  explicit Parts(unsigned seed) : random_(seed) {}

  double between(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random_); }
  int one_of(const std::vector<int>& numbers) {
    return numbers[std::uniform_int_distribution<std::size_t>(0, numbers.size() - 1)(random_)];
  }

  // Shafts, cones and boxes along the axes, apart or through each other.
  Shape part() {
    Shape shape;
    for (int i = one_of({1, 2, 3}); i > 0; --i) shape.add(round());
    for (int i = one_of({0, 1, 2}); i > 0; --i) {
      const double x = between(-3, 2), y = between(-3, 2), z = between(-3, 2);
      shape.add(box({x, y, z}, {x + between(0.3, 2), y + between(0.3, 2), z + between(0.3, 2)}));
    }
    return shape;
  }

  Vec3 direction() { return glm::normalize(Vec3(between(-1, 1), between(-1, 1), between(-1, 1)) + Vec3(1e-3)); }

 private:
  Shape round() {
    const double radius = between(0.3, 1.5), top = one_of({0, 1}) == 0 ? radius : between(0.3, 1.5);
    Shape shape = frustum(radius, top, between(0.3, 4), one_of({12, 16, 23, 24, 36, 48}));
    const int turn = one_of({0, 1, 2});
    for (Point& p : shape.points) std::rotate(p.begin(), p.begin() + turn, p.end());
    return shape.moved(between(-2, 2), between(-2, 2), between(-2, 2));
  }

  std::mt19937 random_;
};

// The distance of a place from a line as it is drawn.
double distance_to(const drawing::Chain& chain, const Vec2& place) {
  constexpr int steps = 400;
  double least = HUGE_VAL;
  const int count = static_cast<int>(chain.points.size());
  for (int i = 0; i + (chain.closed ? 0 : 1) < count; ++i) {
    const bool curved = std::any_of(chain.curves.begin(), chain.curves.end(),
                                    [&](const drawing::CurvePart& c) { return c.first <= i && i < c.last; });
    if (curved) continue;
    const auto at = [&](int k) { return chain.points[static_cast<std::size_t>(k % count)]; };
    least = std::min(least, distance_to_segment(place, at(i), at(i + 1)));
  }
  for (const drawing::CurvePart& curve : chain.curves) {
    const auto at = [&](int k) {
      return drawing::position_on_curve(curve, curve.from + (curve.to - curve.from) * k / steps);
    };
    for (int k = 0; k < steps; ++k) least = std::min(least, distance_to_segment(place, at(k), at(k + 1)));
  }
  return least;
}

// The greatest distance of each end of a line from what it meets on facets, as that is drawn.
std::vector<double> gaps_of(const std::vector<drawing::Chain>& facets, const drawing::ViewDrawing& drawn) {
  std::vector<double> gaps;
  for (std::size_t i = 0; i < facets.size(); ++i) {
    if (facets[i].closed) continue;
    for (const bool front : {true, false}) {
      const auto end_of = [&](const drawing::Chain& chain) {
        return front ? chain.points.front() : chain.points.back();
      };
      double gap = HUGE_VAL;
      for (std::size_t k = 0; k < facets.size(); ++k)
        if (k != i && distance_to(facets[k], end_of(facets[i])) <= drawn.distances.coincident)
          gap = std::min(gap, distance_to(drawn.chains[k], end_of(drawn.chains[i])));
      if (gap < HUGE_VAL) gaps.push_back(gap);
    }
  }
  return gaps;
}

struct Ends {
  int all = 0, open = 0;
};

struct DrawnPart {
  std::vector<double> gaps;
  bool is_crossing;
};

DrawnPart draw_part(unsigned seed) {
  Lab lab;
  lab.recognises = true;
  Parts parts(seed);
  const Shape part = parts.part();
  const bool isometric = seed % 2 == 0;
  const world::World world = lab.world_of(part);
  const Result result = lab.draw(world, {orthographic(isometric ? Vec3(1, -1, 1) : parts.direction())});
  drawing::ViewDrawing drawing =
      drawing::make_drawing({result.world, result.view, result.drawn, result.hidden}, {scale, Vec2(0)}, {"test", true});
  const std::vector<drawing::Chain> facets = drawing.chains;
  drawing::draw_exactly(world, drawing, {touching});
  const bool is_crossing = std::ranges::any_of(
      drawing.segments, [](const drawing::Segment& segment) { return segment.kind == EdgeKind::intersection; });
  return {gaps_of(facets, drawing), is_crossing};
}

// Where something hides facets and not the surface, or the reverse, both cannot agree: near corners, and more often
// where an intersection ends on a contour.
TEST(JoinedLines, StayJoinedWhenTheyAreDrawnExactly) {
  Ends apart, crossing;
  for (unsigned seed = 0; seed < 300; ++seed) {
    const DrawnPart part = draw_part(seed);
    for (const double gap : part.gaps) {
      Ends& ends = part.is_crossing ? crossing : apart;
      ++ends.all;
      ends.open += gap > joined ? 1 : 0;
    }
  }
  EXPECT_GT(apart.all, 2000);
  EXPECT_GT(crossing.all, 4000);
  EXPECT_LE(apart.open * 1000, apart.all);
  EXPECT_LE(crossing.open * 80, crossing.all);
}

// In these parts, something hides a rim so near to the contour that touches it that, on the surface, nothing would be
// left of its arc. Moved all the same, the contour would end 1.6 to 4 mm beside what it meets.
TEST(JoinedLines, StayJoinedWhereAnArcIsTooShortToMove) {
  for (const unsigned seed : {45U, 116U, 399U}) {
    const DrawnPart part = draw_part(seed);
    EXPECT_GT(part.gaps.size(), 4U) << seed;
    for (const double gap : part.gaps) EXPECT_LT(gap, joined) << seed;
  }
}

}  // namespace
}  // namespace epura::test::joined_lines_test
