// SPDX-License-Identifier: Apache-2.0
// The map of the view against the textbook matrices, which are built in another way.
#include "view/view_map.hpp"

#include <gtest/gtest.h>

#include <random>

#include "projection/matrices.hpp"
#include "shapes.hpp"
#include "view/paper_map.hpp"
#include "view/viewing_model.hpp"

namespace epura::test::view_map_test {
namespace {

using Random = std::mt19937;

double uniform(Random& random, double min, double max) {
  return min + (max - min) * (static_cast<double>(random()) / 4294967296.0);
}

Vec3 point_in(Random& random, const Box& box) {
  return {uniform(random, box.min.x, box.max.x), uniform(random, box.min.y, box.max.y),
          uniform(random, box.min.z, box.max.z)};
}

Box box_of_the_scene() { return {{-1, -2, 0.5}, {3, 1, 4}}; }

// Parallel and oblique, central from near and from far, with the plane before and behind the scene, scaled.
std::vector<projection::Projection> projections() {
  std::vector<projection::Projection> list;
  for (const Vec3& towards : {Vec3(1, -1, 1), Vec3(0, -1, 0), Vec3(0.3, 2, -5)}) {
    projection::Projection p = orthographic(towards);
    p.point = {3, -2, 7};
    p.scale = 0.7;
    list.push_back(p);
    p.projector = glm::normalize(p.n + 0.8 * p.u - 0.3 * p.v);
    list.push_back(p);
    for (const double distance : {8.0, 500.0})
      for (const double plane : {0.25, 1.0, 2.0}) {
        projection::Projection c = perspective(Vec3(1, 0, 2) + distance * p.n + 0.3 * p.u, Vec3(0), towards, {0, 0, 1});
        c.point = c.projector - plane * distance * c.n + 5.0 * c.v;
        c.scale = 2.5;
        list.push_back(c);
      }
  }
  return list;
}

TEST(ViewMap, PlacesAreThoseOfTheMatrix) {
  Random random(1);
  for (const projection::Projection& p : projections()) {
    const view::ViewMap map = view::make_view_map(p, box_of_the_scene());
    const Mat4 matrix = projection::view_matrix(p);
    for (int i = 0; i < 50; ++i) {
      const Vec3 point = point_in(random, box_of_the_scene());
      const view::Mapped mapped = map(point);
      const Vec4 expected = matrix * Vec4(point, 1);
      ASSERT_GT(mapped.w, 0);
      // From the plane's own point, in model lengths: undo the normalisation and the shift to the image of the scene's
      // middle.
      const Vec2 place = (Vec2(mapped.x, mapped.y) / mapped.w + map.image) / map.normalisation;
      EXPECT_NEAR(place.x, p.scale * expected.x / expected.w, 1e-11);
      EXPECT_NEAR(place.y, p.scale * expected.y / expected.w, 1e-11);
    }
  }
}

TEST(ViewMap, DepthIsThatOfTheMatrixUpToScaleAndShift) {
  Random random(2);
  for (const projection::Projection& p : projections()) {
    const view::ViewMap map = view::make_view_map(p, box_of_the_scene());
    const Mat4 matrix = projection::view_matrix(p);
    const auto both = [&](const Vec3& point) {
      const view::Mapped mapped = map(point);
      const Vec4 expected = matrix * Vec4(point, 1);
      return Vec2(expected.z / expected.w, mapped.z / mapped.w);
    };
    const Vec2 a = both(box_of_the_scene().min);
    const Vec2 b = both(box_of_the_scene().max);
    const double slope = (b.y - a.y) / (b.x - a.x);
    EXPECT_GT(slope, 0);
    for (int i = 0; i < 50; ++i) {
      const Vec2 c = both(point_in(random, box_of_the_scene()));
      EXPECT_NEAR(c.y, a.y + slope * (c.x - a.x), 1e-9 * std::abs(b.y - a.y));
    }
  }
}

TEST(ViewMap, DepthIsLengthAlongProjectorsAtTheMiddle) {
  for (const projection::Projection& p : projections()) {
    const view::ViewMap map = view::make_view_map(p, box_of_the_scene());
    const Vec3 middle = box_of_the_scene().centre();
    const Vec3 along = p.central ? glm::normalize(p.projector - middle) : p.projector;
    const auto depth = [&](const Vec3& point) { return map(point).z / map(point).w; };
    const auto place = [&](const Vec3& point) { return Vec2(map(point).x, map(point).y) / map(point).w; };
    const double step = 1e-4;
    const double towards = (depth(middle + step * along) - depth(middle - step * along)) / (2 * step);
    // A step beside, parallel to the plane, has the page's length of that step.
    const double beside = glm::length(place(middle + step * p.u) - place(middle - step * p.u)) / (2 * step);
    EXPECT_NEAR(towards / beside, 1, 1e-6);
  }
}

// Multiples of 2^-10 stay what they are beside 2^40.
Vec3 coarse(const Vec3& v) { return glm::round(v * 1024.0) / 1024.0; }

TEST(ViewMap, FarFromTheOriginNoDigitIsLost) {
  Random random(3);
  const Vec3 far(0x1p40);
  const Box box = box_of_the_scene();
  for (projection::Projection p : projections()) {
    p.point = coarse(p.point);
    if (p.central) p.projector = coarse(p.projector);
    projection::Projection moved = p;
    moved.point += far;
    if (p.central) moved.projector += far;
    const view::ViewMap near_map = view::make_view_map(p, box);
    const view::ViewMap far_map = view::make_view_map(moved, {box.min + far, box.max + far});
    for (int i = 0; i < 10; ++i) {
      const Vec3 point = coarse(point_in(random, box));
      const view::Mapped a = near_map(point);
      const view::Mapped b = far_map(point + far);
      EXPECT_NEAR(a.x / a.w, b.x / b.w, 1e-13);
      EXPECT_NEAR(a.y / a.w, b.y / b.w, 1e-13);
      EXPECT_NEAR(a.z / a.w, b.z / b.w, 1e-13);
    }
  }
}

// A middle less than a sixteenth of the scene's size ahead is beside the viewer.
TEST(ViewMap, RefersToAPointWellInFrontOfTheViewer) {
  const Box box{Vec3(-1), Vec3(1)};
  const auto centre_from = [&](double height) {
    return view::make_view_map(perspective({0.5, 0, height}, {0, 0, -4}, {0, 0, 1}, {0, 1, 0}), box).centre;
  };
  EXPECT_EQ(centre_from(0.25), Vec3(0));
  EXPECT_EQ(centre_from(0.0625), Vec3(0.5, 0, 0.0625 - 2));
  EXPECT_EQ(centre_from(-1), Vec3(0.5, 0, -3));
}

TEST(PaperMap, OneMatrixGoesTheWholeWay) {
  const world::World world = world_of(box({-1, -2, 0.5}, {3, 1, 4}));
  for (const projection::Projection& p : projections()) {
    const view::ProjectedScene view = view::project_scene(world, p, {});
    const double scale = 12.5;
    const projection::Window drawn = view::drawn_box(view);
    const view::PaperMap paper = view::make_paper_map(view, scale, {100, 70});
    const Mat4 matrix = view::world_to_page(view, paper);
    const Mat4 textbook = projection::view_matrix(p);
    const auto on = [](const Mat4& m, const Vec3& x) {
      const Vec4 h = m * Vec4(x, 1);
      return Vec2(h) / h.w;
    };
    Vec2 min(HUGE_VAL), max(-HUGE_VAL);
    for (std::size_t v = 0; v < world.points.size(); ++v) {
      const Vec2 place = on(matrix, world.points[v]);
      EXPECT_LT(glm::distance(place, paper(view.vertices[v])), 1e-10);
      // Distances on paper are those in the projection plane times both scales.
      const double apart = glm::distance(on(textbook, world.points[v]), on(textbook, world.points[0]));
      EXPECT_NEAR(glm::distance(place, on(matrix, world.points[0])), scale * p.scale * apart, 1e-9);
      min = glm::min(min, place);
      max = glm::max(max, place);
    }
    EXPECT_LT(glm::distance(min, Vec2(100, 70) + scale * drawn.min), 1e-9);
    EXPECT_LT(glm::distance(max, Vec2(100, 70) + scale * drawn.max), 1e-9);
  }
}

TEST(ViewingModel, OfAllStepsIsTheMapOfDrawings) {
  const world::World world = world_of(box({-1, -2, 0.5}, {3, 1, 4}));
  const Vec2 corner(30, 20);
  for (const projection::Projection& p : projections()) {
    const view::ProjectedScene view = view::project_scene(world, p, {});
    const view::ViewingModel model = view::viewing_model(view, world.box, 12.5, corner);
    EXPECT_EQ(model.steps.size(), p.central ? 4U : 3U);
    const view::PaperMap viewport = view::viewport_map(view, 12.5);
    for (std::size_t v = 0; v < world.points.size(); ++v) {
      const Vec4 h = model.product * Vec4(world.points[v], 1);
      const Vec2 place = corner + viewport(view.vertices[v]);
      EXPECT_LT(glm::distance(Vec2(h) / h.w, place), 1e-8 * (1 + glm::length(place)));
      for (int i = 0; i < 2; ++i) {
        EXPECT_GE(place[i], model.viewport.min[i] - 1e-8);
        EXPECT_LE(place[i], model.viewport.max[i] + 1e-8);
      }
    }
  }
}

TEST(PaperMap, VanishingPointsAreImagesOfTheAxes) {
  const world::World world = world_of(box({-1, -2, 0.5}, {3, 1, 4}));
  for (const projection::Projection& p : projections()) {
    const view::ProjectedScene view = view::project_scene(world, p, {});
    const view::PaperMap paper = view::make_paper_map(view, 3, {100, 70});
    const Mat4 matrix = view::world_to_page(view, paper);
    const auto points = view::vanishing_points_on_page(view, paper);
    for (int axis = 0; axis < 3; ++axis) {
      EXPECT_EQ(points[axis].has_value(), p.central && std::abs(p.n[axis]) > 1e-12);
      if (!points[axis]) continue;
      const Vec4 image = matrix[axis];
      EXPECT_LT(glm::distance(*points[axis], Vec2(image) / image.w), 1e-8 * glm::length(*points[axis]) + 1e-8);
    }
  }
}

}  // namespace
}  // namespace epura::test::view_map_test
