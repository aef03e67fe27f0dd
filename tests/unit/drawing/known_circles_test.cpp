// SPDX-License-Identifier: Apache-2.0
// What would break if this were wrong: arcs of fillets in few facets, and curves where the part has none.
#include "drawing/known_circles.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "drawing/arcs.hpp"
#include "drawing/curve_part.hpp"
#include "laboratory/lab.hpp"

namespace epura::test::known_circles_test {
namespace {

using namespace laboratory;

constexpr double degree = std::numbers::pi / 180;
constexpr double scale = 100, tolerance = 1e-3;
constexpr double radius = 0.3;

// A unit square with its corner at (1, 1) rounded in a number of facets.
Shape rounded_plate(int facets) {
  std::vector<Vec2> outline{{0, 1}, {0, 0}, {1, 0}};
  for (int i = 0; i <= facets; ++i) {
    const double a = 90 * degree * i / facets;
    outline.push_back(Vec2(1 - radius) + radius * Vec2(std::cos(a), std::sin(a)));
  }
  return prism(outline, 0.2);
}

struct Drawn {
  world::World world;
  drawing::ViewDrawing drawing;
  double mm;  // of a unit of the model
};

Drawn draw(const Shape& shape, const projection::Projection& projection) {
  Lab lab;
  lab.recognises = true;
  Result result = lab.draw(lab.world_of(shape), {projection});
  drawing::ViewDrawing drawing =
      drawing::make_drawing({result.world, result.view, result.drawn, result.hidden}, {scale, Vec2(0)}, {"test", true});
  return {std::move(result.world), std::move(drawing), scale / result.unit};
}

// The curves of visible lines, after their number without known circles was checked.
std::vector<drawing::CurvePart> curves_of(Drawn& drawn) {
  std::vector<drawing::Chain> chains = drawn.drawing.chains;
  drawing::find_curves(chains, {tolerance});
  for (const drawing::Chain& chain : chains) EXPECT_TRUE(chain.curves.empty());
  drawing::find_curves(drawn.drawing.chains, {tolerance},
                       drawing::known_circles(drawing::PartEdges(drawn.world), drawn.drawing));
  std::vector<drawing::CurvePart> curves;
  for (const drawing::Chain& chain : drawn.drawing.chains)
    if (chain.visible) curves.insert(curves.end(), chain.curves.begin(), chain.curves.end());
  return curves;
}

// The upper and the lower rim of the corner, whose arc turns by 90 degrees.
TEST(KnownCircles, AreArcsOfFilletsInFewFacets) {
  for (const int facets : {3, 4, 5, 6})
    for (const Vec3& towards : {Vec3(0, 0, 1), Vec3(1, 1, 1)}) {
      const projection::Projection view = towards.x == 0 ? from_above() : orthographic(towards);
      Drawn drawn = draw(rounded_plate(facets), view);
      const std::vector<drawing::CurvePart> curves = curves_of(drawn);
      ASSERT_EQ(curves.size(), towards.x == 0 ? 1U : 2U) << facets;
      for (const drawing::CurvePart& curve : curves) {
        EXPECT_NEAR(std::abs(curve.to - curve.from), 90 * degree, 1e-6) << facets;
        EXPECT_NEAR(std::max(glm::length(curve.u), glm::length(curve.v)), radius * drawn.mm, 1e-6);
        EXPECT_NEAR(std::min(glm::length(curve.u), glm::length(curve.v)), radius * drawn.mm * glm::normalize(towards).z,
                    1e-6);
      }
    }
}

TEST(KnownCircles, AreThoseOfTheSurfaceWhereALineHidesTheirMiddle) {
  Shape shape = rounded_plate(6);
  shape.add(box({0.85, 0.85, 1}, {0.95, 0.95, 1.1}));
  Drawn drawn = draw(shape, orthographic({1, 1, 1}));
  for (const drawing::CurvePart& curve : curves_of(drawn))
    EXPECT_NEAR(std::max(glm::length(curve.u), glm::length(curve.v)), radius * drawn.mm, 1e-6);
}

// The end of a shaft that is not cut squarely, by so little that its rim could pass for a circle on the page: as a
// circle, it would be drawn up to 6e-4 mm beside the rim.
TEST(KnownCircles, AreNoneWhereAPlaneCutsACylinderObliquely) {
  constexpr double slope = 1e-5;
  Shape shape = frustum(1, 1, 1, 24);
  for (Point& point : shape.points)
    if (point[2] > 0.5) point[2] += slope * point[0];
  Drawn drawn = draw(shape, orthographic({1, 1, 1}));
  const drawing::KnownCircles known = drawing::known_circles(drawing::PartEdges(drawn.world), drawn.drawing);
  EXPECT_EQ(known.ellipses.size(), 1U);
  drawing::find_curves(drawn.drawing.chains, {tolerance}, known);
  const auto page = [&](const Vec3& point) { return Vec2(drawn.drawing.world_to_page * Vec4(point, 1)); };
  // Of either rim: centre, and the halves of two conjugate diameters.
  const std::array rims{std::array{page({0, 0, 0}), page({1, 0, 0}), page({0, 1, 0})},
                        std::array{page({0, 0, 1}), page({1, 0, 1 + slope}), page({0, 1, 1})}};
  int arcs = 0;
  for (const drawing::Chain& chain : drawn.drawing.chains)
    for (const drawing::CurvePart& curve : chain.curves) {
      ++arcs;
      for (const double part : {0.0, 0.25, 0.5, 0.75, 1.0}) {
        const Vec2 place = drawing::position_on_curve(curve, curve.from + part * (curve.to - curve.from));
        double least = HUGE_VAL;
        for (const auto& [centre, u, v] : rims) {
          const Vec2 a = u - centre, b = v - centre, p = place - centre;
          // Its coordinates along the diameters have the length 1 on the rim.
          const double off = std::hypot(cross(p, b), cross(a, p)) / std::abs(cross(a, b)) - 1;
          least = std::min(least, std::abs(off) * drawn.mm);
        }
        EXPECT_LT(least, 1e-8);
      }
    }
  EXPECT_EQ(arcs, 4);
}

TEST(KnownCircles, AreNoneOnPolygonsAndInCentralProjections) {
  Drawn prism = draw(frustum(1, 1, 1, 8), orthographic({1, 1, 1}));
  EXPECT_TRUE(curves_of(prism).empty());
  Drawn central = draw(rounded_plate(5), perspective({3, 3, 3}, {0, 0, 0}, {1, 1, 1}, {0, 0, 1}));
  EXPECT_TRUE(drawing::known_circles(drawing::PartEdges(central.world), central.drawing).ellipses.empty());
}

}  // namespace
}  // namespace epura::test::known_circles_test
