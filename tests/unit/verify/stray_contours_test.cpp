// SPDX-License-Identifier: Apache-2.0
// Contours that are drawn away from their faces are found, with place and length; right ones are not.
#include "verify/stray_contours.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "drawing/make_drawing.hpp"
#include "shapes.hpp"

namespace epura::test::stray_contours_test {
namespace {

using Profile = std::vector<std::array<double, 2>>;

Profile arc(double radius, double tube, int bands, double turn) {
  Profile profile;
  for (int i = 0; i <= bands; ++i) {
    const double a = turn * (double(i) / bands - 0.5);
    profile.push_back({radius + tube * std::cos(a), tube * std::sin(a)});
  }
  return profile;
}

report::OutlineCheck checked(const Result& r) {
  report::OutlineCheck check;
  check.length = 1;
  const verify::VerifyInput input{r.world, r.view.projection, {}, r.drawn, r.hidden, r.drawing};
  verify::add_stray_contours(input, {r.view.extent, r.view.contact.touching}, check);
  return check;
}

bool is_any_moved(const Result& r) {
  return std::ranges::any_of(r.drawn.edges, [](const auto& edge) { return edge.shown[0] >= 0; });
}

Shape pipe() { return revolved({{10, 0}, {10, 5}, {10, 10}, {10, 15}, {10, 20}}, 32); }

TEST(StrayContours, ContoursOnTheirSurfacesAreRight) {
  const Shape cone = revolved({{0, 0}, {12, 0}, {9, 4}, {6, 8}, {3, 12}, {0, 12}}, 24);
  const Shape ball = revolved(arc(0, 10, 16, std::numbers::pi), 24);
  const Shape ring = revolved(arc(30, 10, 20, 2 * std::numbers::pi), 40);
  for (const Shape& shape : {pipe(), cone, ball, ring})
    for (const projection::Projection& view :
         {orthographic({0.1, -1, 0.3}), orthographic({1, -1, 1}), orthographic({0.3, 0.2, 1}),
          perspective({70, -60, 50}, {0, 0, 0}, {70, -60, 50}, {0, 0, 1})}) {
      const Result r = draw(recognised(world_of(shape)), view);
      EXPECT_EQ(checked(r).unfounded, 0);
    }
  EXPECT_TRUE(is_any_moved(draw(recognised(world_of(pipe())), orthographic({0.1, -1, 0.3}))));
}

// One end of a contour of a pipe is drawn 40 mm beyond the face, as if the face did not end there.
TEST(StrayContours, AContourBeyondItsFaceIsFoundWithPlaceAndLength) {
  for (const double beyond : {-40.0, 40.0, 90.0}) {
    Result r = draw(recognised(world_of(pipe())), orthographic({0.1, -1, 0}));
    const auto contour = std::ranges::find_if(r.drawn.edges, [&](const edges::FeatureEdge& edge) {
      return edge.kind == EdgeKind::contour && edge.shown[0] >= 0 && edge.shown[1] >= 0;
    });
    ASSERT_NE(contour, r.drawn.edges.end());
    const Vec3 end = r.world.points[static_cast<std::size_t>(contour->vertex[1])];
    const Vec3 far(end.x, end.y, beyond < 0 ? beyond : 20 + beyond);
    contour->shown[1] = view::add_point(r.view, far);
    r.drawing = drawing::make_drawing({r.world, r.view, r.drawn, r.hidden}, {1, Vec2(0)}, {"pipe", true});
    const report::OutlineCheck found = checked(r);
    ASSERT_EQ(found.worst.size(), 1U);
    EXPECT_GT(found.unfounded, 0);
    EXPECT_LT(found.at_most, 1.001);
    EXPECT_EQ(found.worst[0].what, "unfounded");
    EXPECT_NEAR(found.worst[0].length * r.unit, std::abs(beyond), 3) << "mm, but for the height over facets";
    const Vec4 place = r.drawing.world_to_page * Vec4(far, 1);
    EXPECT_LT(glm::distance(found.worst[0].page, Vec2(place) / place.w) * r.unit, 1);
    EXPECT_EQ(found.worst[0].edge, contour->vertex);
  }
}

}  // namespace
}  // namespace epura::test::stray_contours_test
