// SPDX-License-Identifier: Apache-2.0
// What would break if this were wrong: the width of a shaft, and rims that do not reach the lines that they touch.
#include "drawing/exact_lines.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/nearest.hpp"
#include "drawing/curve_part.hpp"
#include "laboratory/lab.hpp"

namespace epura::test::exact_lines_test {
namespace {

using namespace laboratory;

constexpr double scale = 100;

struct Drawn {
  drawing::ViewDrawing drawing;
  double mm;  // of a unit of the model
};

Drawn draw(const Shape& shape, const projection::Projection& projection) {
  Lab lab;
  lab.recognises = true;
  const world::World world = lab.world_of(shape);
  const Result result = lab.draw(world, {projection});
  Drawn drawn{
      drawing::make_drawing({result.world, result.view, result.drawn, result.hidden}, {scale, Vec2(0)}, {"test", true}),
      scale / result.unit};
  drawing::draw_exactly(world, drawn.drawing, {1e-3});
  return drawn;
}

struct Line {
  Vec2 from, to;
};

// Straight parts of chains, and the ends of arcs beside them.
std::vector<Line> straight_lines(const drawing::Chain& chain) {
  std::vector<Line> lines;
  const int count = static_cast<int>(chain.points.size());
  for (int i = 0; i + (chain.closed ? 0 : 1) < count; ++i) {
    const bool curved = std::any_of(chain.curves.begin(), chain.curves.end(),
                                    [&](const drawing::CurvePart& c) { return c.first <= i && i < c.last; });
    if (!curved) lines.push_back({chain.points[std::size_t(i)], chain.points[std::size_t((i + 1) % count)]});
  }
  return lines;
}

void expect_arcs_end_at_points(const drawing::Chain& chain) {
  for (const drawing::CurvePart& curve : chain.curves) {
    const auto at = [&](int i) { return chain.points[std::size_t(i) % chain.points.size()]; };
    EXPECT_LT(glm::distance(drawing::position_on_curve(curve, curve.from), at(curve.first)), 1e-6);
    EXPECT_LT(glm::distance(drawing::position_on_curve(curve, curve.to), at(curve.last)), 1e-6);
  }
}

// A line of the picture of a cone is tangent to both rims: the distance of a centre is that of the tangent plane.
TEST(ExactLines, OfShaftsAndConesTouchTheirRims) {
  for (const int sides : {12, 17, 24, 48})
    for (const double top : {1.0, 0.5}) {
      const Vec3 towards = glm::normalize(Vec3(1.2, -1, 0.7));
      const Drawn drawn = draw(frustum(1, top, 3, sides), orthographic(towards));
      int lines = 0;
      for (const drawing::Chain& chain : drawn.drawing.chains) {
        expect_arcs_end_at_points(chain);
        for (const Line& line : straight_lines(chain)) {
          ++lines;
          for (const auto& [height, radius] : {std::pair(0.0, 1.0), {3.0, top}}) {
            // The distance of the line from the ellipse's centre is the ellipse's support in that direction.
            const Vec2 along = glm::normalize(line.to - line.from), across(-along.y, along.x);
            const Vec2 centre(drawn.drawing.world_to_page * Vec4(0, 0, height, 1));
            const double support = radius * drawn.mm * std::hypot(across.x, across.y * towards.z);
            EXPECT_NEAR(std::abs(glm::dot(line.from - centre, across)), support, 1e-6) << sides;
          }
        }
      }
      EXPECT_EQ(lines, 2) << sides;
    }
}

// A shaft behind a bar and, on its other side, behind another shaft: what is left of its contours ends at theirs.
TEST(ExactLines, EndWhereOtherLinesHideThem) {
  Shape shape = frustum(1, 1, 3, 24);
  shape.add(box({-3, -3, 2}, {0, -2, 2.5}));
  shape.add(frustum(0.5, 0.5, 1, 16).moved(1, -2, 0.5));
  const Vec3 towards = glm::normalize(Vec3(0.3, -1, 0.4));
  const projection::Projection view = orthographic(towards);
  const Drawn drawn = draw(shape, view);
  const Vec2 axis(drawn.drawing.world_to_page * Vec4(0, 0, 0, 1));
  int visible = 0, ends = 0;
  for (const drawing::Chain& chain : drawn.drawing.chains)
    for (const Line& line : straight_lines(chain)) {
      const double away = std::abs(line.from.x - axis.x);
      if (!chain.visible || std::abs(line.from.x - line.to.x) > 1e-6 || std::abs(away - drawn.mm) > 1e-2) continue;
      EXPECT_NEAR(away, drawn.mm, 1e-6);
      ++visible;
      for (const Vec2& end : {line.from, line.to})
        for (const auto& [y, z] : {std::pair(-3, 2.0), {-2, 2.5}}) {
          const Vec2 left(drawn.drawing.world_to_page * Vec4(-3, y, z, 1));
          const Vec2 right(drawn.drawing.world_to_page * Vec4(0, y, z, 1));
          ends += distance_to_segment(end, left, right) < 1e-6 ? 1 : 0;
        }
    }
  EXPECT_GE(visible, 3);
  EXPECT_EQ(ends, 2);
}

// The same shaft, in front of whose upper rim there are the bar and the other shaft.
TEST(ExactLines, OfRimsEndWhereOtherLinesHideThem) {
  for (const int sides : {16, 24, 48}) {
    Shape shape = frustum(1, 1, 1, sides);
    shape.add(box({-3, -3, 1.5}, {0, -2, 2}));
    shape.add(frustum(0.5, 0.5, 2, sides).moved(0.4, -2, 0.3));
    const Vec3 towards = glm::normalize(Vec3(0.1, -1, 0.5));
    const Drawn drawn = draw(shape, orthographic(towards));
    const auto page = [&](const Vec3& p) { return Vec2(drawn.drawing.world_to_page * Vec4(p, 1)); };
    const Vec3 aside = glm::normalize(glm::cross(Vec3(0, 0, 1), towards));
    std::vector<Line> hide;
    for (const double side : {-0.5, 0.5}) {
      const Vec3 foot = Vec3(0.4, -2, 0) + side * aside;
      hide.push_back({page(foot), page(foot + Vec3(0, 0, 1))});
    }
    for (const auto& [from, to] : {std::pair(Vec3(-3, -3, 1.5), Vec3(0, -3, 1.5)), {{0, -3, 1.5}, {0, -3, 2}}})
      hide.push_back({page(from), page(to)});
    int ends = 0;
    for (const drawing::Chain& chain : drawn.drawing.chains)
      for (const drawing::CurvePart& curve : chain.curves) {
        const double size = std::max(glm::length(curve.u), glm::length(curve.v));
        if (!chain.visible || chain.closed || std::abs(size - drawn.mm) > 1e-6) continue;
        for (const double angle : {curve.from, curve.to}) {
          const Vec2 end = drawing::position_on_curve(curve, angle);
          const auto off = [&](const Line& line) {
            const Vec2 along = glm::normalize(line.to - line.from);
            return std::abs(cross(along, end - line.from));
          };
          double least = HUGE_VAL;
          for (const Line& line : hide) least = std::min(least, off(line));
          // Others end where contours of the shaft itself touch them.
          if (least > 0.5) continue;
          EXPECT_LT(least, 1e-6) << sides;
          ++ends;
        }
      }
    EXPECT_EQ(ends, 3) << sides;
  }
}

// A bar through a post: x = +-sqrt(R^2 - y^2) on a circle of y and z. Contours of the bar end on the post.
// A rim of twelve chords ends at the rim of a disc above it that hides it, whose chords are shorter than the way to
// there.
TEST(ExactLines, OfCoarseRimsEndAtFineOnes) {
  for (const int sides : {12, 48, 768}) {
    Shape shape = frustum(1, 1, 1, 12);
    shape.add(frustum(0.6, 0.6, 0.05, sides).moved(0, 0, 1.7));
    const Vec3 towards = glm::normalize(Vec3(1, -1, 1));
    const Drawn drawn = draw(shape, orthographic(towards));
    const auto image = [&](double z) { return Vec2(drawn.drawing.world_to_page * Vec4(0, 0, z, 1)); };
    const auto radius_about = [&](double z, const Vec2& place) {
      const Vec2 from = (place - image(z)) / drawn.mm;
      return std::hypot(from.x, from.y / towards.z);
    };
    int ends = 0;
    for (const drawing::Chain& chain : drawn.drawing.chains)
      for (const drawing::CurvePart& curve : chain.curves)
        for (const double angle : {curve.from, curve.to}) {
          const Vec2 end = drawing::position_on_curve(curve, angle);
          const bool is_of_rim = chain.visible && glm::distance(curve.centre, image(1)) < 1e-6;
          const double off = std::min(std::abs(radius_about(1.7, end) - 0.6), std::abs(radius_about(1.75, end) - 0.6));
          if (is_of_rim && off < 1e-6) ++ends;
        }
    EXPECT_EQ(ends, 2) << sides;
  }
}

TEST(ExactLines, OfCrossingsAreOnBothSurfaces) {
  constexpr double radius = 0.6;
  for (const int sides : {16, 17, 24, 31, 48}) {
    const Shape post = frustum(1, 1, 4, sides).moved(0, 0, -2);
    Shape bar = frustum(radius, radius, 5, sides).moved(0, 0, -2.5);
    for (Point& p : bar.points) p = {p[2], p[0], p[1]};
    const Vec3 towards = glm::normalize(Vec3(1, -1, 1));
    Shape both = post;
    both.add(bar);
    const Drawn drawn = draw(both, orthographic(towards));
    const auto page = [&](double angle, double side) {
      const double y = radius * std::cos(angle);
      return Vec2(drawn.drawing.world_to_page * Vec4(side * std::sqrt(1 - y * y), y, radius * std::sin(angle), 1));
    };
    constexpr int count = 1500;
    std::vector<Vec2> curve;
    for (const double side : {-1.0, 1.0})
      for (int i = 0; i <= count; ++i) curve.push_back(page(2 * M_PI * i / count, side));
    const auto off = [&](const Vec2& place) {
      double least = HUGE_VAL;
      for (std::size_t i = 1; i < curve.size(); ++i)
        if (i != count + 1) least = std::min(least, distance_to_segment(place, curve[i - 1], curve[i]));
      return least;
    };
    int crossings = 0;
    std::vector<Vec2> all;
    for (const drawing::Chain& chain : drawn.drawing.chains) {
      all.insert(all.end(), chain.points.begin(), chain.points.end());
      const bool crosses = std::ranges::all_of(
          chain.segments, [&](int i) { return drawn.drawing.segments[std::size_t(i)].kind == EdgeKind::intersection; });
      if (!crosses) continue;
      ++crossings;
      for (std::size_t i = 0; i < chain.points.size(); ++i) {
        EXPECT_LT(off(chain.points[i]), 3e-4) << sides;  // of chords that are compared with
        const Vec2& before = chain.points[i == 0 ? 0 : i - 1];
        EXPECT_LT(off((before + chain.points[i]) / 2.0), 5e-4) << sides;
      }
    }
    EXPECT_GT(crossings, 0);
    // The normal (0, cos a, sin a) of the bar is perpendicular to the projectors.
    const double contour = std::atan2(-towards.y, towards.z);
    int ends = 0;
    for (const double angle : {contour, contour + M_PI})
      for (const Vec2& point : all) ends += glm::distance(point, page(angle, 1)) < 1e-6 ? 1 : 0;
    EXPECT_GE(ends, 4) << sides;
  }
}

// The picture of a shaft is as wide as the shaft, however few facets it has.
TEST(ExactLines, AreInTheBoxOfTheInk) {
  for (const int sides : {12, 17, 24}) {
    const Vec3 towards = glm::normalize(Vec3(0.3, -1, 0.4));
    const Drawn drawn = draw(frustum(1, 1, 3, sides), orthographic(towards));
    const Vec2 size = drawn.drawing.box.max - drawn.drawing.box.min;
    EXPECT_NEAR(size.x, 2 * drawn.mm, 1e-6) << sides;
    EXPECT_NEAR(size.y, (2 * towards.z + 3 * std::hypot(towards.x, towards.y)) * drawn.mm, 1e-6) << sides;
  }
}

TEST(ExactLines, OfPolygonsAreTheirEdges) {
  const Drawn drawn = draw(frustum(1, 1, 3, 8), orthographic({1.2, -1, 0.7}));
  for (const drawing::Chain& chain : drawn.drawing.chains) {
    EXPECT_TRUE(chain.curves.empty());
    for (const Vec2& point : chain.points)
      EXPECT_TRUE(std::any_of(drawn.drawing.segments.begin(), drawn.drawing.segments.end(),
                              [&](const drawing::Segment& s) { return s.from == point || s.to == point; }));
  }
}

}  // namespace
}  // namespace epura::test::exact_lines_test
