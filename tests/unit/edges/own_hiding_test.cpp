// SPDX-License-Identifier: Apache-2.0
// What surfaces hide of their own contours, and what only their facets do.
#include "edges/own_hiding.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "base/nearest.hpp"
#include "shapes.hpp"
#include "visibility/clear_contours.hpp"

namespace epura::test {
namespace {

constexpr double pi = std::numbers::pi;

// A torus (20, 8) around z; `skew` moves vertices on it at random, by up to that part of the way to the next.
Shape torus(int around, int along, double skew = 0) {
  std::mt19937 random(around);
  const auto moved = [&](int i, int count) {
    return 2 * pi * (i + skew * (std::ldexp(static_cast<double>(random()), -31) - 1)) / count + pi / 90;
  };
  Shape shape;
  for (int i = 0; i < along; ++i)
    for (int j = 0; j < around; ++j) {
      const double a = moved(i, along), t = moved(j, around), away = 20 + 8 * std::cos(t);
      shape.points.push_back({away * std::cos(a), away * std::sin(a), 8 * std::sin(t)});
    }
  const auto number = [&](int i, int j) { return i % along * around + j % around; };
  for (int i = 0; i < along; ++i)
    for (int j = 0; j < around; ++j) {
      const std::array corners{number(i, j), number(i + 1, j), number(i + 1, j + 1), number(i, j + 1)};
      const std::size_t first = random() % 2;
      for (const std::size_t k : {first, first + 2})
        shape.faces.push_back({corners[k % 4], corners[(k + 1) % 4], corners[(k + 2) % 4]});
    }
  return shape;
}

// Whether the solid of a torus (20, 8) around z lies between a place on its contour and the viewer.
bool torus_hides(const Vec3& place, const Vec3& towards) {
  for (double way = 0.5; way < 60; way += 0.05) {
    const Vec3 p = place + way * glm::normalize(towards);
    if (std::hypot(std::hypot(p.x, p.y) - 20, p.z) < 8 - 1e-3) return true;
  }
  return false;
}

// Places on the visible contour of that torus: it bends away from the viewer on both sides, and nothing is in front.
// Near cusps it bends little: nothing below `least` counts.
std::vector<Vec3> visible_contour_of_torus(const Vec3& towards, double least = 0) {
  constexpr int places = 4000;
  std::vector<Vec3> found;
  for (int i = 0; i < 2 * places; ++i) {
    const double a = 2 * pi * i / places, side = i < places ? 1 : -1;
    const Vec3 out(std::cos(a), std::sin(a), 0), on(-std::sin(a), std::cos(a), 0), axis(0, 0, 1);
    const double t = std::atan2(-side * glm::dot(out, towards), side * towards.z), away = 20 + 8 * std::cos(t);
    const double around_tube = glm::dot(std::cos(t) * axis - std::sin(t) * out, towards);
    const double around_axis = glm::dot(on, towards);
    // The normal curvature along the projector, by the principal ones (Euler).
    const double bend = around_tube * around_tube / 8 + around_axis * around_axis * std::cos(t) / away;
    const Vec3 place = away * out + 8 * std::sin(t) * axis;
    if (bend > least && !torus_hides(place, towards)) found.push_back(place);
  }
  return found;
}

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
  return most / (drawing.max.x - drawing.min.x) * 56;  // from units of the page to those of the torus
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

features::PartFace face_of(features::SurfaceKind kind) {
  features::PartFace face;
  face.surface.kind = kind;
  face.surface.axis = {0, 0, 1};
  face.surface.radius = 20;
  face.surface.minor = 8;
  return face;
}

edges::FeatureEdge judged(const features::PartFace& face, const Vec3& at, const Vec3& view) {
  edges::FeatureEdge contour{};
  edges::judge_own_hiding(face, {at, at}, {view, view}, contour);
  return contour;
}

TEST(OwnHiding, NeverByBallsShaftsAndConesFromOutside) {
  using enum features::SurfaceKind;
  for (const auto kind : {sphere, cylinder, cone}) {
    features::PartFace face = face_of(kind);
    EXPECT_EQ(judged(face, {20, 0, 0}, {0, 1, 0}).clear, HUGE_VALF);
    face.inwards = true;
    EXPECT_EQ(judged(face, {20, 0, 0}, {0, 1, 0}).clear, 0);
  }
  EXPECT_EQ(judged(face_of(cylinder), {20, 0, 0}, {0, 0, 1}).clear, 0);  // along the axis
  EXPECT_EQ(judged(face_of(free_form), {20, 0, 0}, {0, 1, 0}).clear, 0);
}

// Projectors that touch the torus, from outside or in a fillet, meet it again at twice `clear`, or not at all.
TEST(OwnHiding, OfATorusIsWhereProjectorsMeetItAgain) {
  features::PartFace face = face_of(features::SurfaceKind::torus);
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

// The places on the visible contour of the torus, of about 7000, that have no visible line within a distance.
int places_without_ink(const world::World& world, bool looks_behind_facets, double distance) {
  constexpr double least_bend = 0.01;
  const Vec3 towards(1, -1, 1);
  view::ProjectedScene view = view::project_scene(world, orthographic(towards), {});
  edges::FeatureEdges drawn = edges::find_feature_edges(world, view, {});
  if (looks_behind_facets) visibility::find_clear_contours(world, view, drawn);
  const visibility::HiddenSpans hidden = visibility::find_hidden(world, view, drawn);
  const view::PaperMap paper{1, Vec2(0)};
  const Mat4 to_page = view::world_to_page(view, paper);
  std::vector<std::array<Vec2, 2>> lines;
  for (std::size_t e = 0; e < drawn.edges.size(); ++e)
    hidden.visit_parts(e, [&](double from, double to, bool visible) {
      const auto at = [&](double s) { return drawing::position_on_paper(view, paper, drawn.edges[e], s); };
      if (visible) lines.push_back({at(from), at(to)});
    });
  const double near = distance * view.map.normalisation;
  int without = 0;
  for (const Vec3& p : visible_contour_of_torus(towards, least_bend)) {
    const Vec2 place = Vec2(to_page * Vec4(p, 1));
    double nearest = HUGE_VAL;
    for (const auto& line : lines) nearest = std::min(nearest, distance_to_segment(place, line[0], line[1]));
    if (nearest > near) ++without;
  }
  return without;
}

// Skewed facets hide some of the contour of their surface.
TEST(OwnHiding, ByFacetsLeavesNoGaps) {
  for (const int around : {24, 36, 48}) {
    const world::World world = recognised(world_of(torus(around, 5 * around / 2, 0.3)));
    ASSERT_NE(world.models[0].part, nullptr);
    ASSERT_EQ(world.models[0].part->faces.size(), 1U);
    const double distance = 60.0 / around / around;
    EXPECT_GT(places_without_ink(world, false, distance), 100);
    EXPECT_EQ(places_without_ink(world, true, distance), 0);
  }
}

// What is in front of the torus hides it.
TEST(OwnHiding, ByOtherBodiesStays) {
  Shape both = torus(36, 90, 0.3);
  const auto first = static_cast<int>(both.points.size());
  const Shape plate = box({-40, -40, 60}, {40, 40, 61});
  both.points.insert(both.points.end(), plate.points.begin(), plate.points.end());
  for (auto face : plate.faces) {
    for (int& corner : face) corner += first;
    both.faces.push_back(face);
  }
  const world::World world = recognised(world_of(both));
  view::ProjectedScene view = view::project_scene(world, from_above(), {});
  edges::FeatureEdges drawn = edges::find_feature_edges(world, view, {});
  visibility::find_clear_contours(world, view, drawn);
  EXPECT_GT(drawn.clear_contours.size(), 0U);
  const visibility::HiddenSpans hidden = visibility::find_hidden(world, view, drawn);
  for (std::size_t e = 0; e < drawn.edges.size(); ++e)
    if (world.points[drawn.edges[e].vertex[0]].z < 50)
      hidden.visit_parts(e, [&](double, double, bool visible) { EXPECT_FALSE(visible) << e; });
}

}  // namespace
}  // namespace epura::test
