// SPDX-License-Identifier: Apache-2.0
// What surfaces hide of their own contours, and what only their facets do.
#include "edges/own_hiding.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "skewed_torus.hpp"

namespace epura::test::own_hiding_test {
namespace {

constexpr double pi = std::numbers::pi;

// How far visible lines of a drawing of that torus are from its visible contour, at most.
double farthest_of_torus(const world::World& world, const Vec3& towards) {
  const drawing::ViewDrawing drawing = draw(world, orthographic(towards)).drawing;
  std::vector<Vec2> contour;
  for (const Vec3& p : visible_contour_of_torus(towards)) contour.emplace_back(drawing.world_to_page * Vec4(p, 1));
  double most = 0;
  for (const drawing::Segment& segment : drawing.segments)
    for (const Vec2& end : {segment.from, segment.to}) {
      double nearest = HUGE_VAL;
      for (const Vec2& place : contour) nearest = std::min(nearest, glm::distance(place, end));
      if (segment.visible) most = std::max(most, nearest);
    }
  return most / (drawing.box.max.x - drawing.box.min.x) * 56;  // from units of the page to those of the torus
}

// Beyond a cusp, and where one contour passes behind another next to it, facets would have visible contours.
TEST(OwnHiding, ContoursOfATorusEndInCusps) {
  const Vec3 towards(1, -1, 1);
  for (const int around : {24, 48}) {
    const world::World world = world_of(torus(around, 5 * around / 2));
    EXPECT_LT(farthest_of_torus(recognised(world), towards), 60.0 / around / around) << around;
    EXPECT_GT(farthest_of_torus(world, towards), 8.0 / around) << around;
  }
}

// Its inside is seen through a hole in the outer half: nothing there is beyond a cusp.
TEST(OwnHiding, IsNotKnownOfOpenSurfaces) {
  Shape open = torus(48, 120);
  open.faces.erase(open.faces.begin());
  const world::World world = recognised(world_of(open));
  view::ProjectedScene view = view::project_scene(world, orthographic({1, -1, 1}), {});
  for (const edges::FeatureEdge& edge : edges::find_feature_edges(world, view, {}).edges) {
    EXPECT_EQ(edge.hollow, 0);
    EXPECT_EQ(edge.clear, 0);
  }
}

surfaces::PartFace face_of(surfaces::SurfaceKind kind) {
  surfaces::PartFace face;
  face.surface.kind = kind;
  face.surface.axis = {0, 0, 1};
  face.surface.radius = 20;
  face.surface.minor = 8;
  return face;
}

edges::FeatureEdge judged(const surfaces::PartFace& face, const Vec3& at, const Vec3& view) {
  edges::FeatureEdge contour{};
  edges::judge_own_hiding(face, {at, at}, {view, view}, contour);
  return contour;
}

TEST(OwnHiding, NeverByBallsFromOutside) {
  surfaces::PartFace face = face_of(surfaces::SurfaceKind::sphere);
  EXPECT_EQ(judged(face, {20, 0, 0}, {0, 1, 0}).clear, HUGE_VALF);
  face.inwards = true;
  EXPECT_EQ(judged(face, {20, 0, 0}, {0, 1, 0}).clear, 0);
  EXPECT_EQ(judged(face_of(surfaces::SurfaceKind::free_form), {20, 0, 0}, {0, 1, 0}).clear, 0);
}

// Projectors that touch the torus, from outside or in a fillet, meet it again at twice `clear`, or not at all.
TEST(OwnHiding, OfATorusIsWhereProjectorsMeetItAgain) {
  surfaces::PartFace face = face_of(surfaces::SurfaceKind::torus);
  const auto distance = [&](const Vec3& p) {
    return (std::hypot(std::hypot(p.x, p.y) - 20, p.z) - 8) * (face.inwards ? -1 : 1);
  };
  std::mt19937 random(5);
  std::uniform_real_distribution<double> angle(0, 2 * pi);
  std::array<int, 2> again{}, never{}, hollow{};
  for (int i = 0; i < 4000; ++i) {
    face.inwards = i % 2 == 1;
    const double a = angle(random), t = angle(random), b = angle(random);
    const Vec3 out(std::cos(a), std::sin(a), 0), on(-std::sin(a), std::cos(a), 0), axis(0, 0, 1);
    const Vec3 at = (20 + 8 * std::cos(t)) * out + 8 * std::sin(t) * axis;
    const Vec3 view = std::cos(b) * on + std::sin(b) * (std::cos(t) * axis - std::sin(t) * out);
    const edges::FeatureEdge contour = judged(face, at, view);
    if (contour.hollow != 0) {
      ++hollow[i % 2];
      EXPECT_LT(distance(at + 0.01 * view), 0);
      continue;
    }
    const double end = std::isfinite(contour.clear) ? 2 * contour.clear : 80;
    for (double way = 0.02; way < 0.99; way += 0.02) ASSERT_GT(distance(at + way * end * view), 0) << way * end;
    ++(end == 80 ? never : again)[i % 2];
    if (end < 80) {
      EXPECT_NEAR(distance(at + end * view), 0, 1e-4) << end;
    }
  }
  EXPECT_GT(again[0], 100);
  EXPECT_GT(never[0], 100);
  EXPECT_GT(hollow[0], 100);
  EXPECT_GT(again[1], 100);
  EXPECT_EQ(never[1], 0);
  EXPECT_GT(hollow[1], 100);
}

}  // namespace
}  // namespace epura::test::own_hiding_test
