// SPDX-License-Identifier: Apache-2.0
// What would break if this were wrong: the width of a shaft, and rims that do not reach the lines that they touch.
#include "drawing/exact_contours.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/nearest.hpp"
#include "drawing/arcs.hpp"
#include "drawing/curve_part.hpp"
#include "laboratory/lab.hpp"

namespace epura::test {
namespace {

using namespace laboratory;

constexpr double scale = 100;

struct Drawn {
  drawing::ViewDrawing drawing;
  double moved;  // mm
  double mm;     // of a unit of the model
};

Drawn draw(const Shape& shape, const projection::Projection& projection) {
  Lab lab;
  lab.recognises = true;
  const Result result = lab.draw(lab.world_of(shape), {projection});
  Drawn drawn{
      drawing::make_drawing({result.world, result.view, result.drawn, result.hidden}, {scale, Vec2(0)}, {"test", true}),
      0, scale / result.unit};
  drawing::find_curves(drawn.drawing.chains, 1e-3, drawing::known_circles(result.world, drawn.drawing));
  drawn.moved = drawing::move_contours(result.world, drawn.drawing);
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
TEST(ExactContours, OfShaftsAndConesTouchTheirRims) {
  for (const int sides : {12, 17, 24, 48})
    for (const double top : {1.0, 0.5}) {
      const Vec3 towards = glm::normalize(Vec3(1.2, -1, 0.7));
      const Drawn drawn = draw(frustum(1, top, 3, sides), orthographic(towards));
      EXPECT_GT(drawn.moved, 0);
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
TEST(ExactContours, EndWhereOtherLinesHideThem) {
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

TEST(ExactContours, OfPolygonsAreTheirEdges) {
  EXPECT_EQ(draw(frustum(1, 1, 3, 8), orthographic({1.2, -1, 0.7})).moved, 0);
}

}  // namespace
}  // namespace epura::test
