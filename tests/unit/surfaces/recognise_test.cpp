// SPDX-License-Identifier: Apache-2.0
// What would break if this were wrong: edges of parts, centre lines, diameters, and polygons taken for round faces.
#include "surfaces/recognise.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <random>
#include <tuple>

#include "base/parallel.hpp"
#include "shapes.hpp"

namespace epura::recognise_test {
namespace {

using namespace test;

surfaces::PartFaces recognise(const Part& part) { return surfaces::recognise_faces(part.mesh()); }

/// A turned part: chamfer, shank, fillet against a shoulder, rounded edge, and a face on top. Eight faces.
std::vector<Vec2> shaft_profile(int steps) {
  return joined({{{0, 0}, {9, 0}, {10, 1}},
                 {{10, 10}},
                 arc({12, 10}, 2, 180, 90, steps),
                 {{19, 12}},
                 arc({19, 13}, 1, -90, 0, steps),
                 {{20, 30}, {0, 30}}});
}

void expect_shaft(const surfaces::PartFaces& part, double scale = 1, double tolerance = 1e-6) {
  ASSERT_EQ(part.faces.size(), 8U);
  EXPECT_EQ(count(part, surfaces::SurfaceKind::plane), 3);
  EXPECT_EQ(count(part, surfaces::SurfaceKind::cylinder), 2);
  EXPECT_EQ(count(part, surfaces::SurfaceKind::cone), 1);
  EXPECT_EQ(count(part, surfaces::SurfaceKind::torus), 2);
  EXPECT_EQ(count(part, surfaces::BorderKind::sharp), 3);
  EXPECT_EQ(count(part, surfaces::BorderKind::tangent), 4);
  std::vector<double> cylinders, tori;
  for (const surfaces::PartFace& face : part.faces) {
    if (face.surface.kind == surfaces::SurfaceKind::cylinder) cylinders.push_back(face.surface.radius);
    if (face.surface.kind == surfaces::SurfaceKind::torus) tori.push_back(face.surface.minor);
    if (face.surface.kind == surfaces::SurfaceKind::torus) {
      EXPECT_EQ(face.inwards, face.surface.minor > 1.5 * scale);
    }
  }
  std::sort(cylinders.begin(), cylinders.end());
  std::sort(tori.begin(), tori.end());
  EXPECT_NEAR(cylinders[0], 10 * scale, tolerance * scale);
  EXPECT_NEAR(cylinders[1], 20 * scale, tolerance * scale);
  EXPECT_NEAR(tori[0], 1 * scale, tolerance * scale);
  EXPECT_NEAR(tori[1], 2 * scale, tolerance * scale);
  EXPECT_NEAR(std::abs(only(part, surfaces::SurfaceKind::cone).surface.slope), 1, tolerance);
}

TEST(RecogniseFaces, Cylinders) {
  for (const int segments : {12, 16, 24, 64, 200}) {
    const surfaces::PartFaces part = recognise(revolved({{0, 0}, {5, 0}, {5, 8}, {0, 8}}, segments));
    ASSERT_EQ(part.faces.size(), 3U) << segments;
    const surfaces::PartFace& face = only(part, surfaces::SurfaceKind::cylinder);
    EXPECT_NEAR(face.surface.radius, 5, 1e-12);
    EXPECT_EQ(face.triangles, 2 * segments);
    EXPECT_EQ(face.sweep, 360);
    EXPECT_NEAR(face.to - face.from, 8, 1e-12);
    EXPECT_FALSE(face.inwards);
    EXPECT_EQ(count(part, surfaces::BorderKind::sharp), 2);
    EXPECT_EQ(part.borders.size(), 2U);
    for (const surfaces::PartBorder& border : part.borders) {
      EXPECT_TRUE(border.closed);
      EXPECT_EQ(border.edges.size(), std::size_t(segments));
      EXPECT_NEAR(border.angle, 90, 1e-9);
    }
  }
}

TEST(RecogniseFaces, ConesToTheirApex) {
  for (const int segments : {12, 24, 64}) {
    const surfaces::PartFaces part = recognise(revolved({{0, 0}, {5, 0}, {0, 8}}, segments));
    ASSERT_EQ(part.faces.size(), 2U) << segments;
    EXPECT_NEAR(std::abs(only(part, surfaces::SurfaceKind::cone).surface.slope), 5.0 / 8, 1e-12);
    EXPECT_EQ(part.borders.size(), 1U);
  }
}

TEST(RecogniseFaces, SpheresAndTori) {
  for (const int rows : {8, 12, 32}) {
    const double first = 180.0 / rows;
    const surfaces::PartFaces ball =
        recognise(revolved(joined({{{0, -3}}, arc({0, 0}, 3, first - 90, 90 - first, rows - 2), {{0, 3}}}), 2 * rows)
                      .triangulate());
    ASSERT_EQ(ball.faces.size(), 1U) << rows;
    EXPECT_NEAR(only(ball, surfaces::SurfaceKind::sphere).surface.radius, 3, 1e-12);
    EXPECT_TRUE(ball.borders.empty());
  }
  for (const int rows : {12, 15, 24}) {
    const surfaces::PartFaces ring = recognise(revolved(arc({10, 0}, 3, 0, 360, rows), 2 * rows).round_to_float());
    ASSERT_EQ(ring.faces.size(), 1U) << rows;
    EXPECT_NEAR(ring.faces[0].surface.radius, 10, 1e-5);
    EXPECT_NEAR(ring.faces[0].surface.minor, 3, 1e-5);
    EXPECT_TRUE(ring.borders.empty());
  }
}

TEST(RecogniseFaces, FilletsOfTwoFacetsAndOfMany) {
  for (const int steps : {2, 3, 4, 5, 8})
    for (const int segments : {24, 48, 96}) {
      SCOPED_TRACE(std::to_string(steps) + " " + std::to_string(segments));
      expect_shaft(recognise(revolved(shaft_profile(steps), segments)));
    }
}

TEST(RecogniseFaces, FilletsOfStraightEdges) {
  for (const int steps : {3, 4, 6}) {
    const surfaces::PartFaces part =
        recognise(prism(joined({arc({8, 3}, 2, 0, 90, steps), arc({-8, 3}, 2, 90, 180, steps),
                                arc({-8, -3}, 2, 180, 270, steps), arc({8, -3}, 2, 270, 360, steps)}),
                        30));
    ASSERT_EQ(part.faces.size(), 10U) << steps;
    EXPECT_EQ(count(part, surfaces::SurfaceKind::cylinder), 4);
    EXPECT_EQ(count(part, surfaces::BorderKind::tangent), 8);
    EXPECT_EQ(count(part, surfaces::BorderKind::sharp), 16);
    for (const surfaces::PartFace& face : part.faces)
      if (face.surface.kind == surfaces::SurfaceKind::cylinder) {
        EXPECT_NEAR(face.surface.radius, 2, 1e-12);
        EXPECT_NEAR(face.sweep, 90, 1e-6);
      }
  }
}

TEST(RecogniseFaces, APolygonIsNotRound) {
  for (const int sides : {3, 4, 5, 6, 8, 10, 11}) {
    const surfaces::PartFaces part = recognise(prism(regular_polygon(sides, 5), 7));
    EXPECT_EQ(part.faces.size(), std::size_t(sides) + 2) << sides;
    EXPECT_EQ(count(part, surfaces::SurfaceKind::plane), sides + 2);
    EXPECT_EQ(count(part, surfaces::BorderKind::sharp), 3 * sides);
  }
  const surfaces::PartFaces nut = recognise(plate_with_hole(regular_polygon(6, 9), 5, 5, 10));
  EXPECT_EQ(count(nut, surfaces::SurfaceKind::cylinder), 1);
  EXPECT_EQ(count(nut, surfaces::SurfaceKind::plane), 8);
  const surfaces::PartFaces pyramid = recognise(revolved({{0, 0}, {5, 0}, {0, 8}}, 8));
  EXPECT_EQ(count(pyramid, surfaces::SurfaceKind::plane), 9);
  const surfaces::PartFaces gem = recognise(revolved({{0, -5}, {5, 0}, {3, 2}, {0, 2}}, 8));
  EXPECT_EQ(count(gem, surfaces::SurfaceKind::plane), 17);
  EXPECT_EQ(gem.faces.size(), 17U);
  for (const int sides : {6, 8}) {
    std::vector<Vec2> outline;
    for (int i = 0; i < sides; ++i)
      for (const double turn : {-2.0, 2.0}) {
        const double angle = (360.0 * i / sides + turn) * pi / 180;
        outline.emplace_back(20 * std::cos(angle), 20 * std::sin(angle));
      }
    const surfaces::PartFaces chamfered = recognise(prism(outline, 15));
    EXPECT_EQ(count(chamfered, surfaces::SurfaceKind::plane), 2 * sides + 2) << sides;
    EXPECT_EQ(count(chamfered, surfaces::BorderKind::sharp), 6 * sides) << sides;
  }
}

TEST(RecogniseFaces, ChamfersAreSharpHoweverShallow) {
  // 14 degrees: less than any crease angle that keeps tessellations smooth.
  const surfaces::PartFaces pin = recognise(revolved({{0, 0}, {9.9, 0}, {10, 0.4}, {10, 5}, {9.9, 5.4}, {0, 5.4}}, 36));
  EXPECT_EQ(pin.faces.size(), 5U);
  EXPECT_EQ(count(pin, surfaces::SurfaceKind::cone), 2);
  EXPECT_NEAR(only(pin, surfaces::SurfaceKind::cylinder).surface.radius, 10, 1e-12);
  EXPECT_EQ(count(pin, surfaces::BorderKind::sharp), 4);
}

TEST(RecogniseFaces, ShallowCapsOfSpheresStayFlat) {
  // A ball with a flat: all its corners lie on the sphere, too.
  const surfaces::PartFaces knob =
      recognise(revolved(joined({{{0, -3}}, arc({0, 0}, 3, -85, 70, 31), {{0, 3 * std::sin(70 * pi / 180)}}}), 64));
  EXPECT_EQ(knob.faces.size(), 2U);
  EXPECT_EQ(count(knob, surfaces::SurfaceKind::sphere), 1);
  EXPECT_EQ(count(knob, surfaces::BorderKind::sharp), 1);
}

TEST(RecogniseFaces, AFlatOfAShaftIsNoPartOfIt) {
  // The flat takes 40 degrees, facets take 5.
  std::vector<Vec2> outline = arc({0, 0}, 10, 20, 340, 64);
  const surfaces::PartFaces part = recognise(prism(outline, 30));
  EXPECT_EQ(part.faces.size(), 4U);
  EXPECT_NEAR(only(part, surfaces::SurfaceKind::cylinder).sweep, 320, 1e-6);
  EXPECT_EQ(count(part, surfaces::BorderKind::sharp), 6);
}

TEST(RecogniseFaces, ANarrowFlatBetweenFewFacetsIsNoPartOfIt) {
  // The flat takes 63 degrees, facets take 30: nine times their height.
  std::vector<Vec2> outline = arc({0, 0}, 6, 31.5, 328.5, 10);
  const surfaces::PartFaces part = recognise(prism(outline, 30));
  EXPECT_EQ(part.faces.size(), 4U);
  EXPECT_EQ(count(part, surfaces::BorderKind::sharp), 6);
}

TEST(RecogniseFaces, HolesFaceInwards) {
  for (const bool fine : {false, true}) {
    Part part = plate_with_hole(20, 5, 8, fine ? 40 : 8);
    if (fine) part.triangulate().round_to_float();
    const surfaces::PartFaces faces = recognise(part);
    EXPECT_EQ(faces.faces.size(), 7U);
    EXPECT_TRUE(only(faces, surfaces::SurfaceKind::cylinder).inwards);
    EXPECT_NEAR(only(faces, surfaces::SurfaceKind::cylinder).surface.radius, 8, 1e-6);
    // A body that is stored inside out is the same part.
    EXPECT_TRUE(only(recognise(part.turn_inside_out()), surfaces::SurfaceKind::cylinder).inwards);
  }
}

// A shaft in its bearing: the facets between them are there twice, and four triangles meet at each of their edges.
TEST(RecogniseFaces, BodiesThatTouchHaveFacesOfTheirOwn) {
  Part both = revolved({{5, 0}, {9, 0}, {9, 8}, {5, 8}, {5, 0}}, 32);
  const Part shaft = revolved({{0, -3}, {5, -3}, {5, 0}, {5, 8}, {5, 12}, {0, 12}}, 32);
  for (std::vector<int> face : shaft.faces) {
    for (int& v : face) v += static_cast<int>(both.points.size());
    both.faces.push_back(face);
  }
  both.points.insert(both.points.end(), shaft.points.begin(), shaft.points.end());
  const surfaces::PartFaces part = recognise(both);
  ASSERT_EQ(part.faces.size(), 7U);
  EXPECT_EQ(count(part, surfaces::SurfaceKind::plane), 4);
  std::vector<std::tuple<int, bool, double>> cylinders;
  for (const surfaces::PartFace& face : part.faces)
    if (face.surface.kind == surfaces::SurfaceKind::cylinder)
      cylinders.emplace_back(face.body, face.inwards, std::round(face.to - face.from));
  std::sort(cylinders.begin(), cylinders.end());
  const std::vector<std::tuple<int, bool, double>> expected{{0, false, 8}, {0, true, 8}, {1, false, 15}};
  EXPECT_EQ(cylinders, expected);
  EXPECT_EQ(part.borders.size(), 6U);
}

TEST(RecogniseFaces, PoseAndUnitDoNotMatter) {
  const Mat4 turn = glm::rotate(Mat4(1), 1.234, glm::normalize(Vec3(1, 2, -3)));
  for (const double scale : {1e-200, 1e-3, 1.0, 1e3, 1e200})
    for (const bool mirrored : {false, true}) {
      Part part = revolved(shaft_profile(4), 36).triangulate();
      part.move([&](const Vec3& p) {
        const Vec3 turned = Vec3(turn * Vec4(mirrored ? Vec3(-p.x, p.y, p.z) : p, 1));
        return scale * turned;
      });
      if (mirrored) part.turn_inside_out();
      expect_shaft(recognise(part), scale, 1e-9);
    }
}

TEST(RecogniseFaces, SinglePrecisionFarFromTheOrigin) {
  Part part = revolved(shaft_profile(5), 48);
  part.move([](const Vec3& p) { return p + Vec3(300, -500, 800); }).round_to_float();
  const surfaces::PartFaces faces = recognise(part);
  expect_shaft(faces, 1, 1e-3);
  EXPECT_GT(faces.tolerance, 1e-4);
}

/// By triangle of the shuffled part, the same whatever the order of faces was.
std::vector<std::tuple<int, int, double>> summary(const surfaces::PartFaces& part) {
  std::vector<std::tuple<int, int, double>> all;
  for (const surfaces::PartFace& face : part.faces)
    all.emplace_back(int(face.surface.kind), face.triangles, std::round(face.area * 1e6) / 1e6);
  std::sort(all.begin(), all.end());
  return all;
}

TEST(RecogniseFaces, TheOrderOfFacesDoesNotMatter) {
  const auto make = [] { return revolved(shaft_profile(3), 24).triangulate(); };
  const surfaces::PartFaces plain = recognise(make());
  for (const unsigned seed : {1U, 2U, 3U}) {
    const surfaces::PartFaces shuffled = recognise(make().shuffle(seed));
    EXPECT_EQ(summary(shuffled), summary(plain));
    EXPECT_EQ(count(shuffled, surfaces::BorderKind::tangent), count(plain, surfaces::BorderKind::tangent));
  }
}

TEST(RecogniseFaces, NothingInAScan) {
  std::mt19937 random(3);
  std::normal_distribution<double> noise(0, 0.01);
  Part ball = revolved(joined({{{0, -3}}, arc({0, 0}, 3, -87, 87, 58), {{0, 3}}}), 120).triangulate();
  ball.move([&](const Vec3& p) { return p + Vec3(noise(random), noise(random), noise(random)); });
  const surfaces::PartFaces scan = recognise(ball);
  EXPECT_TRUE(scan.faces.empty());
  EXPECT_TRUE(scan.borders.empty());
  EXPECT_LT(scan.recognised, 0.25);
  EXPECT_EQ(scan.face_of_triangle, std::vector<int>(ball.mesh().polygon.size(), -1));
}

TEST(RecogniseFaces, FreeFormsAreOneFace) {
  // A bulged lid on a box: its walls are planes, its top is no quadric.
  constexpr int n = 24;
  const auto lid = [](int i, int j) {
    const double x = 2.0 * i / n - 1, y = 2.0 * j / n - 1;
    return Vec3(10 * x, 10 * y, 8 + 2 * std::cos(x * pi / 2) * std::cos(y * pi / 2) * (1 + 0.3 * x));
  };
  const surfaces::PartFaces faces = recognise(closed_sheet(n, n, lid, 0));
  EXPECT_EQ(count(faces, surfaces::SurfaceKind::free_form), 1);
  EXPECT_EQ(count(faces, surfaces::SurfaceKind::plane), 5);
  EXPECT_EQ(faces.faces.size(), 6U);
  EXPECT_EQ(count(faces, surfaces::BorderKind::sharp), 12);
}

TEST(RecogniseFaces, CurvesOfVaryingCurvatureAreNotRowsOfArcs) {
  constexpr int columns = 90, rows = 3;
  std::mt19937 random(1);
  const auto wave = [&random](int i, int j) {
    const bool inside = i > 0 && i < columns && j > 0 && j < rows;
    const double shift = inside ? 0.3 * (double(random()) / double(std::mt19937::max()) - 0.5) : 0;
    const double x = 100 * (i + shift) / columns;
    return Vec3(x, 20.0 * j / rows, 6 * std::sin(0.06 * x) + 3 * std::sin(0.17 * x));
  };
  const surfaces::PartFaces faces = recognise(closed_sheet(columns, rows, wave, -30).round_to_float());
  EXPECT_EQ(count(faces, surfaces::SurfaceKind::free_form), 1);
  EXPECT_EQ(count(faces, surfaces::SurfaceKind::cylinder), 0);
  EXPECT_EQ(faces.faces.size(), 6U);
  EXPECT_EQ(count(faces, surfaces::BorderKind::sharp), 12);
}

TEST(RecogniseFaces, TrianglesThatTiltAlongTheBorderOfAFreeForm) {
  Part part = coarsely_bordered([](double x, double y) { return 0.1 * x * x - 0.07 * y * y + 0.01 * x * x * x; });
  // 7 vertices in the first row, 13 in each of the others.
  std::vector<int> rim{0, 1, 2, 3, 4, 5, 6, 19, 32, 45};
  for (int v = 58; v >= 46; --v) rim.push_back(v);
  for (const int v : {33, 20, 7}) rim.push_back(v);
  close_below(part, rim, -1);
  const surfaces::PartFaces faces = recognise(part);
  EXPECT_EQ(faces.faces.size(), 6U);
  EXPECT_EQ(count(faces, surfaces::SurfaceKind::free_form), 1);
  EXPECT_EQ(count(faces, surfaces::BorderKind::sharp), 12);
  EXPECT_EQ(faces.borders.size(), 12U);
}

// Between outlines of equally many points, with caps.
Part loft(const std::vector<std::vector<Vec2>>& outlines, double height) {
  Part part;
  const int n = static_cast<int>(outlines[0].size()), last = static_cast<int>(outlines.size()) - 1;
  for (int k = 0; k <= last; ++k)
    for (const Vec2& p : outlines[k]) part.add({p.x, p.y, height * k / last});
  for (int k = 0; k < last; ++k)
    for (int i = 0; i < n; ++i) {
      const int j = (i + 1) % n;
      const std::array<int, 4> c{k * n + i, k * n + j, (k + 1) * n + j, (k + 1) * n + i};
      part.faces.push_back({c[0], c[1], c[2]});
      part.faces.push_back({c[0], c[2], c[3]});
    }
  std::vector<int> bottom, top;
  for (int i = 0; i < n; ++i) {
    bottom.insert(bottom.begin(), i);
    top.push_back(last * n + i);
  }
  part.faces.push_back(bottom);
  part.faces.push_back(top);
  return part;
}

TEST(RecogniseFaces, AFilletOfVaryingRadiusIsOneFreeForm) {
  std::vector<std::vector<Vec2>> outlines;
  for (int k = 0; k <= 24; ++k) {
    const double u = k / 24.0, r = 2 + 3 * u * u;
    outlines.push_back(joined({{{0, 0}, {10, 0}, {10, 10}}, arc({r, 10 - r}, r, 90, 180, 6)}));
  }
  const surfaces::PartFaces part = recognise(loft(outlines, 30));
  EXPECT_EQ(count(part, surfaces::SurfaceKind::plane), 6);
  EXPECT_EQ(count(part, surfaces::SurfaceKind::free_form), 1);
  EXPECT_EQ(part.faces.size(), 7U);
  EXPECT_EQ(count(part, surfaces::BorderKind::tangent), 2);
  EXPECT_EQ(count(part, surfaces::BorderKind::sharp), 13);
}

TEST(RecogniseFaces, AStripOfNearlyFlatPairsIsOneFreeForm) {
  std::vector<std::vector<Vec2>> outlines;
  for (const Vec2& radius : {Vec2(5, 4), Vec2(5.2, 4.3)}) {
    outlines.push_back({{0, -20}, {30, -20}, {30, 10}});
    for (const Vec2& p : arc({0, 0}, 1, 90, 180, 12))
      outlines.back().emplace_back(radius.x + radius.x * p.x, 10 - radius.y + radius.y * p.y);
  }
  const surfaces::PartFaces part = recognise(loft(outlines, 30));
  EXPECT_EQ(count(part, surfaces::SurfaceKind::plane), 6);
  EXPECT_EQ(count(part, surfaces::SurfaceKind::free_form), 1);
  EXPECT_EQ(part.faces.size(), 7U);
  EXPECT_EQ(count(part, surfaces::BorderKind::sharp), 13);
}

TEST(RecogniseFaces, VerticesOfTrimmedBordersNeedNotBeExact) {
  for (const int steps : {24, 30}) {
    Part part = prism(joined({arc({8, 3}, 2, 0, 90, steps), arc({-8, 3}, 2, 90, 180, steps),
                              arc({-8, -3}, 2, 180, 270, steps), arc({8, -3}, 2, 270, 360, steps)}),
                      30)
                    .triangulate();
    // By up to 25 times what is taken for exact.
    int moved = 0;
    part.move([&](const Vec3& p) {
      const Vec3 from(std::abs(p.x) - 8, std::abs(p.y) - 3, 0);
      const double angle = std::atan2(from.y, from.x);
      if (p.z == 0 || angle < 0.7 || angle > 1.1) return p;
      const double by = ++moved % 2 == 0 ? 1.5e-4 : -1e-4;
      return p + by * Vec3(p.x > 0 ? from.x : -from.x, p.y > 0 ? from.y : -from.y, 0) / 2.0;
    });
    ASSERT_GE(moved, 8);
    const surfaces::PartFaces faces = recognise(part);
    EXPECT_EQ(faces.faces.size(), 10U) << steps;
    EXPECT_EQ(count(faces, surfaces::SurfaceKind::cylinder), 4) << steps;
    EXPECT_EQ(count(faces, surfaces::BorderKind::sharp), 16) << steps;
  }
}

// A round corner, both of whose ends are trimmed along inexact curves: no triangle has three exact vertices.
TEST(RecogniseFaces, NoTriangleOfACylinderNeedsExactVertices) {
  Part part = prism(joined({arc({8, 3}, 2, 0, 90, 20), {{-10, 5}, {-10, -5}, {10, -5}}}), 30).triangulate();
  int moved = 0;
  part.move([&](const Vec3& p) {
    const Vec3 from(p.x - 8, p.y - 3, 0);
    if (from.x < 0.1 || from.y < 0.1) return p;
    const double by = ++moved % 2 == 0 ? 6e-5 : -6e-5;
    return p + by * from / 2.0;
  });
  ASSERT_GE(moved, 38);
  const surfaces::PartFaces faces = recognise(part);
  EXPECT_EQ(count(faces, surfaces::SurfaceKind::cylinder), 1);
  EXPECT_EQ(count(faces, surfaces::SurfaceKind::plane), 6);
  EXPECT_EQ(faces.faces.size(), 7U);
}

// A net of triangles with its vertices moved along the surface, and diagonals either way.
Part askew(int rows, int columns, const std::function<Vec3(double, double)>& place) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> part_of_step(-0.25, 0.25);
  Part part;
  std::vector<std::vector<int>> net(columns);
  for (int i = 0; i < columns; ++i)
    for (int j = 0; j <= rows; ++j) {
      const double u = i + part_of_step(random), v = j == 0 || j == rows ? j : j + part_of_step(random);
      net[i].push_back(part.add(place(2 * pi * u / columns, v / rows)));
    }
  for (int i = 0; i < columns; ++i)
    for (int j = 0; j < rows; ++j) {
      const int a = net[i][j], b = net[(i + 1) % columns][j], c = net[(i + 1) % columns][j + 1], d = net[i][j + 1];
      const bool turned = random() % 2 == 0;
      part.faces.push_back(turned ? std::vector{a, b, c} : std::vector{a, b, d});
      part.faces.push_back(turned ? std::vector{a, c, d} : std::vector{b, c, d});
    }
  return part.round_to_float();
}

TEST(RecogniseFaces, TrianglesNeedNotLieAlongTheSurface) {
  const auto ring = [](double u, double r, double z) { return Vec3(r * std::cos(u), r * std::sin(u), z); };
  const std::vector<std::pair<surfaces::SurfaceKind, Part>> parts{
      {surfaces::SurfaceKind::cylinder, askew(12, 36, [&](double u, double v) { return ring(u, 10, 20 * v); })},
      {surfaces::SurfaceKind::cylinder, askew(1, 36, [&](double u, double v) { return ring(u, 10, 20 * v); })},
      {surfaces::SurfaceKind::cone, askew(12, 36, [&](double u, double v) { return ring(u, 10 - 4 * v, 9 * v); })},
      {surfaces::SurfaceKind::cone, askew(1, 48, [&](double u, double v) { return ring(u, 10 - 4 * v, 9 * v); })},
      {surfaces::SurfaceKind::sphere,
       askew(16, 36,
             [&](double u, double v) { return ring(u, 10 * std::cos(2.4 * v - 1.2), 10 * std::sin(2.4 * v - 1.2)); })},
      {surfaces::SurfaceKind::torus,
       askew(24, 60, [&](double u, double v) { return ring(u, 10 + 3 * std::cos(6 * v), 3 * std::sin(6 * v)); })}};
  for (const auto& [kind, part] : parts) {
    const surfaces::PartFaces faces = recognise(part);
    ASSERT_EQ(faces.faces.size(), 1U) << int(kind);
    EXPECT_EQ(faces.faces[0].surface.kind, kind);
    if (kind != surfaces::SurfaceKind::cone) {
      EXPECT_NEAR(faces.faces[0].surface.radius, 10, 1e-5);
    }
  }
}

TEST(RecogniseFaces, FacetsThatTiltAlongTheBorderOfAFillet) {
  // As tessellators of CAD programs leave them: the face has more vertices inside than on its border.
  std::vector<Ring> rings{{38, 0, 30}, {38, 8, 30}};
  for (const double angle : {15.0, 30.0, 45.0, 60.0, 75.0})
    rings.push_back({36 + 2 * std::cos(angle * pi / 180), 8 + 2 * std::sin(angle * pi / 180), 88});
  rings.push_back({36, 10, 30});
  rings.push_back({20, 14, 30});
  const surfaces::PartFaces part = recognise(stitched(rings).round_to_float());
  EXPECT_EQ(part.faces.size(), 5U);
  EXPECT_EQ(count(part, surfaces::SurfaceKind::torus), 1);
  EXPECT_EQ(count(part, surfaces::BorderKind::tangent), 1);
  EXPECT_EQ(count(part, surfaces::BorderKind::sharp), 3);
}

TEST(RecogniseFaces, RingsOfUnequalTriangles) {
  std::vector<Ring> rings{{20, 0, 28}, {20, 10, 28}};
  const std::array degrees{3, 6, 10, 16};
  for (std::size_t i = 0; i < degrees.size(); ++i) {
    const Ring last = rings.back();
    const double radius = last.radius - 8 * std::tan(degrees[i] * pi / 180);
    rings.push_back({radius, last.height + 8, 27 - int(i)});
    rings.push_back({radius, last.height + 12, 27 - int(i)});
  }
  const surfaces::PartFaces part = recognise(stitched(rings).round_to_float());
  EXPECT_EQ(part.faces.size(), 11U);
  EXPECT_EQ(count(part, surfaces::SurfaceKind::cylinder), 5);
  std::vector<double> slopes;
  for (const surfaces::PartFace& face : part.faces)
    if (face.surface.kind == surfaces::SurfaceKind::cone)
      slopes.push_back(std::atan(std::abs(face.surface.slope)) * 180 / pi);
  std::sort(slopes.begin(), slopes.end());
  ASSERT_EQ(slopes.size(), 4U);
  for (std::size_t i = 0; i < slopes.size(); ++i) EXPECT_NEAR(slopes[i], degrees[i], 1e-4);
}

TEST(RecogniseFaces, AFlatRingOfATorusBelongsToIt) {
  Part part = revolved(arc({10, 0}, 3, 15, 375, 12), 24, pi).triangulate();
  part.move([](const Vec3& p) { return p + Vec3(1.1, 2.2, 3.3); }).round_to_float();
  const surfaces::PartFaces ring = recognise(part);
  ASSERT_EQ(ring.faces.size(), 1U);
  EXPECT_EQ(ring.faces[0].surface.kind, surfaces::SurfaceKind::torus);
  EXPECT_EQ(count(ring, surfaces::BorderKind::sharp), 0);
}

TEST(RecogniseFaces, MitredFilletsStayApart) {
  for (const int steps : {4, 7, 8, 9, 10, 11, 12, 13, 14, 16}) {
    std::vector<Vec2> profile{{20, 0}};
    for (const Vec2& p : arc({17, 12}, 3, 0, 90, steps)) profile.push_back(p);
    Part part;
    for (const Vec2& p : profile)
      for (const Vec2& corner : {Vec2(1, 1), Vec2(-1, 1), Vec2(-1, -1), Vec2(1, -1)})
        part.add({p.x * corner.x, (p.x + 10) * corner.y, p.y});
    const int last = 4 * (static_cast<int>(profile.size()) - 1);
    for (int k = 0; k < last; k += 4)
      for (int i = 0; i < 4; ++i) part.faces.push_back({k + i, k + (i + 1) % 4, k + 4 + (i + 1) % 4, k + 4 + i});
    part.faces.push_back({3, 2, 1, 0});
    part.faces.push_back({last, last + 1, last + 2, last + 3});
    const surfaces::PartFaces faces = recognise(part);
    EXPECT_EQ(count(faces, surfaces::SurfaceKind::cylinder), 4) << steps;
    EXPECT_EQ(count(faces, surfaces::SurfaceKind::plane), 6) << steps;
    EXPECT_EQ(count(faces, surfaces::BorderKind::tangent), 8) << steps;
    // Around the bottom, up the sides, and the mitres.
    EXPECT_EQ(count(faces, surfaces::BorderKind::sharp), 12) << steps;
  }
}

TEST(RecogniseFaces, EveryTriangleHasAFaceAndEveryBorderTwo) {
  const Part part = plate_with_hole(20, 5, 8, 8);
  const mesh::Mesh mesh = part.mesh();
  const surfaces::PartFaces faces = surfaces::recognise_faces(mesh);
  std::vector<int> triangles(faces.faces.size());
  for (const int face : faces.face_of_triangle) ++triangles.at(std::size_t(face));
  for (std::size_t f = 0; f < triangles.size(); ++f) EXPECT_EQ(triangles[f], faces.faces[f].triangles);
  for (const surfaces::PartBorder& border : faces.borders)
    for (const int e : border.edges) {
      std::array<int, 2> sides{};
      for (std::size_t i = 0; i < 2; ++i) sides[i] = faces.face_of_triangle[mesh.triangles_of(mesh.edges[e])[i]];
      std::sort(sides.begin(), sides.end());
      EXPECT_EQ(sides, border.faces);
    }
}

TEST(RecogniseFaces, ManyPartsOfOneFileAreWhatEachIsAlone) {
  constexpr int parts = 40;
  Part all;
  for (int i = 0; i < parts; ++i) {
    // Of two sizes, so that largest facets do not come part by part; each has a vertex of the one before.
    Part one = revolved(shaft_profile(4), 36).triangulate();
    one.move([&](const Vec3& p) { return (i % 2 == 0 ? 1.0 : 0.5) * p; });
    const int first = static_cast<int>(all.points.size());
    const Vec3 shift = i == 0 ? Vec3(0) : all.points.back() - one.points.front();
    for (const Vec3& p : one.points) all.add(p + shift);
    for (std::vector<int> face : one.faces) {
      for (int& v : face) v = v == 0 && i > 0 ? first - 1 : v + first;
      all.faces.push_back(face);
    }
  }
  const mesh::Mesh mesh = all.mesh();
  const surfaces::PartFaces found = surfaces::recognise_faces(mesh);
  EXPECT_EQ(found.faces.size(), 8U * parts);
  EXPECT_EQ(count(found, surfaces::SurfaceKind::torus), 2 * parts);
  EXPECT_EQ(count(found, surfaces::SurfaceKind::cone), parts);
  EXPECT_EQ(count(found, surfaces::BorderKind::tangent), 4 * parts);
  std::vector<double> radii;
  for (const surfaces::PartFace& face : found.faces)
    if (face.surface.kind == surfaces::SurfaceKind::cylinder) radii.push_back(face.surface.radius);
  std::sort(radii.begin(), radii.end());
  ASSERT_EQ(radii.size(), 2U * parts);
  for (int i = 0; i < 2 * parts; ++i) EXPECT_NEAR(radii[i], i < parts / 2 ? 5 : i < 3 * parts / 2 ? 10 : 20, 1e-5);
  const ThreadLimit one_thread(1);
  EXPECT_EQ(surfaces::recognise_faces(mesh).face_of_triangle, found.face_of_triangle);
}

TEST(RecogniseFaces, OpenMeshesHaveOpenBorders) {
  const surfaces::PartFaces pipe = recognise(revolved({{5, 0}, {5, 8}}, 32));
  ASSERT_EQ(pipe.faces.size(), 1U);
  EXPECT_EQ(count(pipe, surfaces::BorderKind::open), 2);
}

TEST(RecogniseFaces, FoldsTellWhetherItIsWorthWhile) {
  const auto pipe = [](int sides) { return revolved({{5, 0}, {5, 8}}, sides).mesh(); };
  EXPECT_TRUE(surfaces::has_shallow_folds(pipe(24), 5));
  EXPECT_TRUE(surfaces::has_shallow_folds(pipe(100), 0.005));
  EXPECT_FALSE(surfaces::has_shallow_folds(pipe(100), 5));
  EXPECT_FALSE(surfaces::has_shallow_folds(pipe(6), 5));
}

}  // namespace
}  // namespace epura::recognise_test
