// Projections at their extremes: lengths known in closed form.
#include <gtest/gtest.h>

#include <cmath>

#include "shapes.hpp"

namespace epura::test {
namespace {

const double root2 = std::sqrt(2.0);
const double r = std::sqrt(2.0 / 3.0);

// The eye at height h over the far face z = 0 of the unit cube, the picture plane through the near face z = 1.
Projection over_the_cube(double h) { return perspective({0.5, 0.5, h}, {0.5, 0.5, 1}, {0, 0, 1}, {0, 1, 0}); }

TEST(ProjectionExtremes, CubeFromItsAxis) {
  for (const double h : {1 + 1e-12, 1 + 1e-6, 1.5, 3.0, 1e3, 1e6, 1e8}) {
    const Result cube = draw(world_of(box({0, 0, 0}, {1, 1, 1})), over_the_cube(h));
    // A double near 1 + 1e-12 holds h - 1 to four digits; the drawing is similar all the same.
    const double size = h < 1 + 1e-9 ? 1e-3 : 1e-8;
    EXPECT_NEAR(cube.visible(), 4, 4 * size) << h;
    const double expected = 4 * (h - 1) / h + 2 * root2 / h;
    EXPECT_NEAR(cube.hidden_length(), expected, 3 * size) << h;
  }
}

TEST(ProjectionExtremes, FarEyeGivesTheParallelDrawing) {
  for (const double h : {1e10, 1e13, 1e16, 1e17}) {
    const Result cube = draw(world_of(box({0, 0, 0}, {1, 1, 1})), over_the_cube(h));
    EXPECT_NEAR(cube.visible(), 4, 1e-9) << h;
    EXPECT_EQ(cube.pieces(false), 0) << h;
  }
}

TEST(ProjectionExtremes, OpenBoxShowsItsInside) {
  Shape open = box({0, 0, 0}, {1, 1, 1});
  open.faces.erase(open.faces.begin() + 1);  // the near face z = 1
  for (const double h : {1.001, 1.5, 4.0, 100.0}) {
    const Result result = draw(world_of(open), over_the_cube(h));
    EXPECT_NEAR(result.visible(), 4 + 4 * (h - 1) / h + 2 * root2 / h, 1e-8) << h;
    EXPECT_NEAR(result.hidden_length(), 0, 1e-12) << h;
  }
}

TEST(ProjectionExtremes, RoomFromInside) {
  // The eye stands in the middle of a room; the far wall is 2 x 2 on a picture plane through it.
  for (const double a : {1.0, 1.25, 2.0, 10.0}) {
    Projection inside = perspective({0, 0, 0}, {0, 0, -2}, {0, 0, 1}, {0, 1, 0});
    inside.window = Window{{-a, -a}, {a, a}};
    const Result room = draw(world_of(box({-1, -1, -2}, {1, 1, 5})), inside);
    EXPECT_NEAR(room.visible(), 8 + 4 * root2 * (a - 1), 1e-8) << a;
    EXPECT_NEAR(room.hidden_length(), 0, 1e-12) << a;
  }
}

TEST(ProjectionExtremes, FloorThroughThePlaneOfTheEye) {
  Projection p = perspective({0, 0, 1}, {0, 1, 1}, {0, -1, 0}, {0, 0, 1});
  p.window = Window{{-1, -1}, {1, 1}};
  const Shape floor{{{-1, -5, 0}, {1, -5, 0}, {1, 10, 0}, {-1, 10, 0}}, {{0, 1, 2, 3}}, {}};
  for (const double near : {1e-3, 1e-6, 1e-12}) {
    const Result result = draw(world_of(floor), p, {}, {.near = near, .far = {}});
    EXPECT_NEAR(result.visible(), 1.8 * root2 + 0.2, 1e-8) << near;
    EXPECT_EQ(result.pieces(false), 0);
  }
}

TEST(ProjectionExtremes, PlatesOverTwelveDecades) {
  const int plates = 13;
  const double d = 0.01;
  Shape all;
  for (int i = 0; i < plates; ++i) {
    const double distance = std::pow(10.0, 6 - i);
    const double shift = d * (plates - 1 - i);
    Shape one = plate(shift, shift, 1 + shift, 1 + shift, -1);
    all.add(one.scaled(distance));
  }
  const Projection p = perspective({0, 0, 0}, {0, 0, -1}, {0, 0, 1}, {0, 1, 0});
  const Result result = draw(world_of(all), p);
  EXPECT_NEAR(result.visible(), 2 * plates + 2 + 2 * d * (plates - 1), 1e-6);
}

TEST(ProjectionExtremes, RailsToTheHorizon) {
  // Sleepers at distance 2^j between rails one to the left and right, one below the eye.
  const int sleepers = 12;
  Shape track;
  for (int j = 0; j <= sleepers; ++j) {
    const double z = std::ldexp(1.0, j);
    track.points.push_back({-1, z, -1});
    track.points.push_back({1, z, -1});
    if (j > 0) track.faces.push_back({2 * j - 2, 2 * j - 1, 2 * j + 1, 2 * j});
  }
  const Projection p = perspective({0, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1});
  const Result result = draw(world_of(track), p, {.smooth = true});
  const double rails = 2 * root2 * (1 - std::ldexp(1.0, -sleepers));
  EXPECT_NEAR(result.visible(), rails + 4 * (1 - std::ldexp(1.0, -(sleepers + 1))), 1e-9);
}

TEST(ProjectionExtremes, ObliqueCubeWithLongDepth) {
  for (const double l : {0.5, 1.0, 10.0, 1e3, 1e6}) {
    Projection p = orthographic({0, -1, 0});
    // Not at 45 degrees: there the hidden receding edge would run on under a visible one.
    p.projector = {l * std::cos(0.4), -1, l * std::sin(0.4)};
    const Result cube = draw(world_of(box({0, 0, 0}, {1, 1, 1})), p);
    EXPECT_NEAR(cube.visible(), 6 + 3 * l, 1e-7 * l) << l;
    EXPECT_NEAR(cube.hidden_length(), 2 + l, 1e-7 * l) << l;
  }
}

TEST(ProjectionExtremes, ShiftedPrincipalPointShiftsTheDrawing) {
  const World cube = world_of(box({0, 0, 0}, {1, 1, 1}));
  const Result plain = draw(cube, perspective({3, -4, 2}, {0, 0, 0}, {1, -2, 0.5}, {0, 0, 1}));
  for (const double shift : {1.0, 1e6, 1e12}) {
    Projection p = plain.view.projection;
    p.point = p.point + shift * p.u;
    const Result shifted = draw(cube, p);
    EXPECT_NEAR(shifted.visible(), plain.visible(), 1e-3 * shift / 1e12 + 1e-9) << shift;
    EXPECT_NEAR(shifted.hidden_length(), plain.hidden_length(), 1e-3 * shift / 1e12 + 1e-9) << shift;
  }
}

TEST(ProjectionExtremes, PowersOfTwoScaleTheDrawingExactly) {
  const Result plain = draw(world_of(box({0, 0, 0}, {1, 1, 1})), orthographic({1, 1, 1}));
  for (const int k : {-1000, -60, 60, 1000}) {
    const Result scaled = draw(world_of(box({0, 0, 0}, {1, 1, 1}).scaled(std::ldexp(1.0, k))), orthographic({1, 1, 1}));
    ASSERT_EQ(scaled.drawing.segments.size(), plain.drawing.segments.size()) << k;
    for (std::size_t i = 0; i < plain.drawing.segments.size(); ++i) {
      EXPECT_EQ(scaled.drawing.segments[i].from, plain.drawing.segments[i].from) << k;
      EXPECT_EQ(scaled.drawing.segments[i].to, plain.drawing.segments[i].to) << k;
      EXPECT_EQ(scaled.drawing.segments[i].visible, plain.drawing.segments[i].visible) << k;
    }
  }
}

TEST(ProjectionExtremes, MirroredModelGivesTheMirroredDrawing) {
  Shape shape = box({0, 0, 0}, {1, 2, 3});
  shape.add(box({0.5, -1, 0.2}, {2, 0.5, 0.7}));
  Shape mirrored = shape;
  for (Point& p : mirrored.points) p[0] = -p[0];
  const Result one = draw(world_of(shape), orthographic({1, -2, 0.7}));
  const Result two = draw(world_of(mirrored), orthographic({-1, -2, 0.7}));
  EXPECT_NEAR(one.visible(), two.visible(), 1e-9);
  EXPECT_NEAR(one.hidden_length(), two.hidden_length(), 1e-9);
}

TEST(ProjectionExtremes, SceneAndEyeMovedTogether) {
  const Vec3 eye(3, -4, 2);
  const Result plain = draw(world_of(box({0, 0, 0}, {1, 1, 1})), perspective(eye, {0, 0, 0}, {1, -2, 0.5}, {0, 0, 1}));
  for (const int j : {24, 30, 40, 50}) {
    const double d = std::ldexp(1.0, j);
    const Result moved = draw(world_of(box({0, 0, 0}, {1, 1, 1}).moved(d, d, d)),
                              perspective(eye + Vec3(d), Vec3(d), {1, -2, 0.5}, {0, 0, 1}));
    EXPECT_NEAR(moved.visible(), plain.visible(), 1e-9) << j;
    EXPECT_NEAR(moved.hidden_length(), plain.hidden_length(), 1e-9) << j;
  }
}

TEST(ProjectionExtremes, EyeInThePlaneOfAPlate) {
  for (const double e : {0.0, 1e-15, 1e-13}) {
    const World world = world_of({plate(-1, 1, 1, 2, 0), box({-0.5, 4, -0.5}, {0.5, 5, 0.5})});
    const Result result = draw(world, perspective({0, 0, e}, {0, 1, e}, {0, -1, 0}, {0, 0, 1}));
    // The plate is a line over the cube's front face and hides nothing of it: 4 edges and the plate's near edge.
    EXPECT_NEAR(result.visible(), 4 * 0.25 + 2, 1e-7) << e;
  }
}

TEST(ProjectionExtremes, EyeOnAVertexOrInAFace) {
  for (const Vec3& eye : {Vec3(0, 0, 0), Vec3(0.5, 0.5, 0), Vec3(0.25, 0.25, 0.25)}) {
    const World world = world_of({box({0, 0, 0}, {1, 1, 1}), box({-1, 3, -1}, {2, 4, 2})});
    const Result result = draw(world, perspective(eye, eye + Vec3(0, 1, 0), {0, -1, 0}, {0, 0, 1}));
    for (const Segment& s : result.drawing.segments) {
      EXPECT_TRUE(std::isfinite(s.from.x) && std::isfinite(s.from.y));
      EXPECT_TRUE(std::isfinite(s.to.x) && std::isfinite(s.to.y));
    }
  }
}

TEST(ProjectionExtremes, FarCoordinatesKeepTheDrawing) {
  const Result cube = draw(world_of(box({0, 0, 0}, {0.25, 0.25, 0.25}).moved(1e7, 1e7, 1e7)), orthographic({1, 1, 1}));
  EXPECT_NEAR(cube.visible(), 9 * r / 4, 1e-8);
  EXPECT_NEAR(cube.hidden_length(), 3 * r / 4, 1e-8);
}

}  // namespace
}  // namespace epura::test
