// SPDX-License-Identifier: Apache-2.0
// What the built-in families promise, held against independent geometry.
#include "support.hpp"

namespace epura::test::families_test {
namespace {

const Vec3 ex{1, 0, 0}, ey{0, 1, 0}, ez{0, 0, 1};

double angle(const Vec2& v) { return degrees(std::atan2(v.y, v.x)); }

TEST(orthographic, views_show_the_axes_where_a_draughtsman_expects_them) {
  struct Case {
    const char* name;
    Vec2 x, y, z;
  };
  for (const auto& [name, x, y, z] : {Case{"front", {1, 0}, {0, 0}, {0, 1}}, Case{"back", {-1, 0}, {0, 0}, {0, 1}},
                                      Case{"left", {0, 0}, {-1, 0}, {0, 1}}, Case{"right", {0, 0}, {1, 0}, {0, 1}},
                                      Case{"top", {1, 0}, {0, 1}, {0, 0}}, Case{"bottom", {1, 0}, {0, -1}, {0, 0}}}) {
    const projection::Projection p = make(name, a_box());
    EXPECT_EQ(step(p, ex), x) << name;
    EXPECT_EQ(step(p, ey), y) << name;
    EXPECT_EQ(step(p, ez), z) << name;
    EXPECT_EQ(p.n, p.projector) << name;
    EXPECT_EQ(p.scale, 1) << name;
  }
}

TEST(orthographic, nearer_side_is_the_one_the_view_is_named_after) {
  EXPECT_GT(depth(make("front", a_box()), -ey), 0 + depth(make("front", a_box()), ey));
  EXPECT_GT(depth(make("left", a_box()), -ex), depth(make("left", a_box()), ex));
  EXPECT_GT(depth(make("top", a_box()), ez), depth(make("top", a_box()), -ez));
}

TEST(orthographic, auxiliary_shows_a_slanted_face_in_true_shape) {
  const projection::Projection p = make("auxiliary:direction=1,-2,2:up=0,1,1", a_box());
  const Vec3 a{2, 1, 0}, b{2, -1, -2};  // both perpendicular to the direction
  EXPECT_NEAR(glm::length(step(p, a)), glm::length(a), 1e-14);
  EXPECT_NEAR(glm::length(step(p, b)), glm::length(b), 1e-14);
  EXPECT_NEAR(glm::dot(step(p, a), step(p, b)), glm::dot(a, b), 1e-14);
}

// Straight down and straight up, with nothing but the direction or the eye.
TEST(families, views_along_z_stand_as_the_top_and_bottom_view_do) {
  for (const char* from : {"0,0,1", "0,0,2.5"})
    for (const char* view : {"auxiliary:direction=", "phigs:kind=parallel:vpn=", "look-at:ref=0,0,0:eye=",
                             "frustum:ref=0,0,0:eye=", "observer:c=0,0,0:o="}) {
      const projection::Projection top = make("top", a_box()), p = make(std::string(view) + from, a_box());
      EXPECT_EQ(p.u, top.u) << view;
      EXPECT_EQ(p.v, top.v) << view;
    }
  for (const char* view : {"auxiliary:direction=0,0,-1", "phigs:kind=parallel:vpn=0,0,-3",
                           "look-at:eye=0,0,-9:ref=0,0,0", "frustum:eye=0,0,-9:ref=0,0,0"}) {
    const projection::Projection bottom = make("bottom", a_box()), p = make(view, a_box());
    EXPECT_EQ(p.u, bottom.u) << view;
    EXPECT_EQ(p.v, bottom.v) << view;
  }
}

TEST(families, an_upward_direction_that_was_chosen_must_not_be_seen_end_on) {
  for (const char* view : {"auxiliary:direction=1,0,0:up=1,0,0", "auxiliary:direction=0,0,1:up=0,0,-1"})
    EXPECT_TRUE(contains(error_of([&] { make(view, a_box()); }).what(), "up direction is parallel")) << view;
}

TEST(axonometric, isometric_axes_are_equally_long_and_120_degrees_apart) {
  const projection::Projection p = make("isometric", a_box());
  for (const Vec3& axis : {ex, ey, ez}) EXPECT_NEAR(glm::length(step(p, axis)), std::sqrt(2.0 / 3), 1e-15);
  EXPECT_NEAR(angle(step(p, ex)), -30, 1e-12);
  EXPECT_NEAR(angle(step(p, ey)), 30, 1e-12);
  EXPECT_NEAR(angle(step(p, ez)), 90, 1e-12);
  EXPECT_NEAR(p.scale, 1, 0);
  EXPECT_NEAR(make("isometric:foreshortened=false", a_box()).scale, std::sqrt(1.5), 1e-15);
}

TEST(axonometric, dimetric_has_the_angles_and_scales_of_the_standard) {
  const projection::Projection p = make("dimetric:foreshortened=false", a_box());
  EXPECT_NEAR(angle(step(p, ex)), -degrees(std::asin(1.0 / 8)), 1e-12);
  EXPECT_NEAR(angle(step(p, ey)), degrees(std::acos(0.75)), 1e-12);
  EXPECT_NEAR(angle(step(p, ez)), 90, 1e-12);
  EXPECT_NEAR(p.scale * glm::length(step(p, ex)), 1, 1e-14);
  EXPECT_NEAR(p.scale * glm::length(step(p, ey)), 0.5, 1e-14);
  EXPECT_NEAR(p.scale * glm::length(step(p, ez)), 1, 1e-14);
  EXPECT_NEAR(glm::length(step(p, ex)), 2 * std::sqrt(2.0) / 3, 1e-14);
}

TEST(axonometric, trimetric_draws_its_axes_at_the_angles_asked_for) {
  for (const auto& [x, y] : {std::pair{15.0, 35.0}, std::pair{7.0, 42.0}, std::pair{60.0, 20.0}}) {
    const projection::Projection p =
        make("trimetric:foreshortened=false:x-angle=" + std::to_string(x) + ":y-angle=" + std::to_string(y), a_box());
    EXPECT_NEAR(angle(step(p, ex)), -x, 1e-12);
    EXPECT_NEAR(angle(step(p, ey)), y, 1e-12);
    EXPECT_NEAR(angle(step(p, ez)), 90, 1e-12);
    double longest = 0, squares = 0;
    for (const Vec3& axis : {ex, ey, ez}) {
      longest = std::max(longest, p.scale * glm::length(step(p, axis)));
      squares += glm::dot(step(p, axis), step(p, axis));
    }
    EXPECT_NEAR(longest, 1, 1e-14);
    EXPECT_NEAR(squares, 2, 1e-14);  // Gauss, for every orthographic axonometry
  }
}

/// Between projector and normal.
double slant(const projection::Projection& p) { return degrees(std::acos(glm::dot(p.projector, p.n))); }

TEST(oblique, cavalier_keeps_the_front_and_the_length_of_depth) {
  for (const double paper : {45.0, 30.0, 135.0}) {
    const projection::Projection p = make("cavalier:angle=" + std::to_string(paper), a_box());
    EXPECT_NEAR(glm::length(step(p, ex) - Vec2(1, 0)), 0, 1e-15);
    EXPECT_NEAR(glm::length(step(p, ez) - Vec2(0, 1)), 0, 1e-15);
    EXPECT_NEAR(glm::length(step(p, ey)), 1, 1e-14);
    EXPECT_NEAR(angle(step(p, ey)), paper, 1e-12);
    EXPECT_NEAR(slant(p), 45, 1e-12);
  }
}

TEST(oblique, cabinet_halves_depth_at_63_435_degrees_to_the_plane) {
  const projection::Projection p = make("cabinet", a_box());
  EXPECT_NEAR(glm::length(step(p, ey)), 0.5, 1e-14);
  EXPECT_NEAR(angle(step(p, ey)), 45, 1e-12);
  EXPECT_NEAR(90 - slant(p), degrees(std::atan(2.0)), 1e-12);
  EXPECT_NEAR(90 - slant(p), 63.435, 5e-4);
}

TEST(axonometric, corners_are_seen_from_their_sides_with_the_same_angles) {
  const std::vector<std::pair<std::string, Vec3>> corners{{"right-front", {1, -1, 1}},
                                                          {"left-front", {-1, -1, 1}},
                                                          {"left-back", {-1, 1, 1}},
                                                          {"right-back", {1, 1, 1}},
                                                          {"right-front:below=true", {1, -1, -1}},
                                                          {"left-front:below=true", {-1, -1, -1}},
                                                          {"left-back:below=true", {-1, 1, -1}},
                                                          {"right-back:below=true", {1, 1, -1}}};
  for (const char* name : {"isometric", "dimetric", "trimetric"}) {
    const Vec3 usual = make(name, a_box()).projector;
    for (const auto& [corner, signs] : corners) {
      const projection::Projection p = make(name + (":from=" + corner), a_box());
      EXPECT_EQ(p.projector, signs * glm::abs(usual)) << name << " " << corner;
      EXPECT_NEAR(angle(step(p, ez)), 90, 1e-12);
    }
  }
}

TEST(oblique, general_one_takes_angle_and_ratio) {
  const projection::Projection p = make("oblique:angle=20:ratio=0.8", a_box());
  EXPECT_NEAR(glm::length(step(p, ey)), 0.8, 1e-14);
  EXPECT_NEAR(angle(step(p, ey)), 20, 1e-12);
}

TEST(oblique, planometric_turns_the_true_plan_and_raises_heights) {
  const projection::Projection p = make("planometric:angle=30:height=0.6667", a_box());
  EXPECT_NEAR(glm::length(step(p, ex)), 1, 1e-14);
  EXPECT_NEAR(glm::length(step(p, ey)), 1, 1e-14);
  EXPECT_NEAR(angle(step(p, ex)), -30, 1e-12);
  EXPECT_NEAR(angle(step(p, ey)), 60, 1e-12);
  expect_near<2>(step(p, ez), {0, 0.6667}, 1e-14);
}

TEST(pictorial, views_look_from_the_right_the_front_and_above) {
  for (const char* name :
       {"isometric", "dimetric", "trimetric", "cavalier", "cabinet", "planometric", "oblique", "one-point", "two-point",
        "three-point", "look-at", "frustum", "observer", "phigs", "vanishing-points"}) {
    const projection::Projection p = make(name, a_box());
    const Vec3 centre = a_box().centre();
    for (const Vec3& towards : {ex, -ey, ez})
      EXPECT_GT(glm::dot(p.central ? p.projector - centre : p.projector, towards), 0) << name;
  }
}

std::array<bool, 3> vanishing(const projection::Projection& p) {
  const auto points = projection::vanishing_points(p);
  return {points[0].has_value(), points[1].has_value(), points[2].has_value()};
}

TEST(perspective, one_two_and_three_point_have_that_many_over_their_whole_range) {
  const auto text = [](double v) { return std::to_string(v); };
  for (const double distance : {0.6, 2.5, 1e6})
    for (const double offset : {-1e3, 0.0, 0.2, 1e3})
      EXPECT_EQ(vanishing(make("one-point:distance=" + text(distance) + ":right=" + text(offset), a_box())),
                (std::array{false, true, false}));
  for (double azimuth = -360; azimuth <= 360; azimuth += 0.5) {
    const std::string two = "two-point:azimuth=" + text(azimuth), three = "three-point:azimuth=" + text(azimuth);
    const double to_quarter = std::abs(azimuth - 90 * std::round(azimuth / 90));
    if (to_quarter < 0.9) {
      EXPECT_EQ(error_of([&] { make(two, a_box()); }).kind(), ErrorKind::input);
    } else if (to_quarter > 1.1) {
      EXPECT_EQ(vanishing(make(two, a_box())), (std::array{true, true, false})) << azimuth;
      for (const char* elevation : {"-89", "-1", "1", "40", "89"})
        EXPECT_EQ(vanishing(make(three + ":elevation=" + elevation, a_box())), (std::array{true, true, true}));
    }
  }
  EXPECT_EQ(error_of([] { make("three-point:elevation=0.5", a_box()); }).kind(), ErrorKind::input);
}

TEST(perspective, two_point_keeps_verticals_vertical) {
  const projection::Projection p = make("two-point:azimuth=25:above=-0.4", a_box());
  for (const Vec3& foot : {Vec3(-1, -2, 0.5), Vec3(3, 1, 0.5)})
    EXPECT_NEAR(place(p, foot).x, place(p, foot + 3.0 * ez).x, 1e-13);
}

// At the height of the eye, whatever lies before it is drawn on the horizon: with the same y.
TEST(perspective, the_eye_has_the_given_height) {
  for (const char* name : {"one-point", "two-point:azimuth=25", "two-point:azimuth=25:above=7"}) {
    const projection::Projection p = make(std::string(name) + ":eye-height=1.6", a_box());
    EXPECT_NEAR(place(p, Vec3(-1, -2, 1.6)).y, place(p, Vec3(3, 1, 1.6)).y, 1e-12) << name;
    EXPECT_NEAR(place(p, Vec3(-1, 2, 1.6)).y, place(p, Vec3(3, -1, 1.6)).y, 1e-12) << name;
    EXPECT_GT(std::abs(place(p, Vec3(-1, -2, 2)).y - place(p, Vec3(3, 1, 2)).y), 1e-3) << name;
  }
}

TEST(perspective, one_point_keeps_the_front_true) {
  const projection::Projection p = make("one-point", a_box());
  const Vec3 corner = a_box().min;
  expect_near<2>(place(p, corner + 2.0 * ex) - place(p, corner), {2, 0}, 1e-13);
  expect_near<2>(place(p, corner + 3.0 * ez) - place(p, corner), {0, 3}, 1e-13);
}

TEST(perspective, any_model_lies_in_a_calm_cone_unless_told_otherwise) {
  const Box boxes[] = {a_box(),
                       {{0, 0, 0}, {1e9, 1, 1}},
                       {{0, 0, 0}, {0, 1e-9, 0}},
                       {{5, 5, 0}, {7, 9, 0}},
                       {{0, 0, 0}, {0, 0, 80}},
                       {{1e6, 1e6, 1e6}, {1e6 + 1, 1e6 + 2, 1e6 + 1}}};
  for (const char* name :
       {"one-point", "two-point", "three-point", "look-at", "frustum", "observer", "phigs", "vanishing-points"})
    for (const Box& box : boxes) {
      const projection::Projection p = make(name, box);
      for (int i = 0; i < 8; ++i) {
        const Vec3 corner{i & 1 ? box.max.x : box.min.x, i & 2 ? box.max.y : box.min.y, i & 4 ? box.max.z : box.min.z};
        const Vec3 sight = glm::normalize(corner - p.projector);
        const Vec3 middle = glm::normalize(box.centre() - p.projector);
        EXPECT_LE(degrees(std::acos(glm::dot(sight, middle))), 20) << name << ", box " << &box - boxes;
        EXPECT_LE(degrees(std::acos(-glm::dot(sight, p.n))), 30) << name << ", box " << &box - boxes;
        if (p.window) {
          const Vec2 at = place(p, corner);
          EXPECT_TRUE(glm::all(glm::greaterThan(at, p.window->min)) && glm::all(glm::lessThan(at, p.window->max)));
        }
        const double height = glm::dot(corner - p.point, p.n);
        EXPECT_TRUE(height <= p.front + 1e-9 && height >= p.back - 1e-9) << name;
      }
    }
}

class vanishing_points_plugin : public testing::Test {
 protected:
  const Box box = a_box();
  void expect_places(const std::string& request, const std::array<std::optional<Vec2>, 3>& places) {
    const projection::Projection p = make("vanishing-points:" + request, box);
    const auto found = projection::vanishing_points(p);
    for (std::size_t i = 0; i < 3; ++i) {
      ASSERT_EQ(found[i].has_value(), places[i].has_value()) << request << ", axis " << i;
      if (found[i]) expect_near<2>(*found[i], *places[i], 1e-9);
    }
    expect_near<2>(place(p, box.centre()), {0, 0}, 1e-12);
    EXPECT_GT(depth(p, p.point + 0.1 * p.n), 0);
  }
};

TEST_F(vanishing_points_plugin, puts_three_where_they_were_asked_for) {
  expect_places("x=-30,12:y=25,10:z=2,-40", {Vec2(-30, 12), Vec2(25, 10), Vec2(2, -40)});
  expect_places("x=30,-12:y=-25,-10:z=2,40", {Vec2(30, -12), Vec2(-25, -10), Vec2(2, 40)});
}

TEST_F(vanishing_points_plugin, has_the_eye_over_the_orthocentre) {
  const projection::Projection p = make("vanishing-points:x=-30,12:y=25,10:z=2,-40", box);
  const Vec3 eye = p.projector - p.point;
  const Vec2 h{glm::dot(eye, p.u), glm::dot(eye, p.v)}, x{-30, 12}, y{25, 10}, z{2, -40};
  EXPECT_NEAR(glm::dot(h - x, y - z), 0, 1e-10);
  EXPECT_NEAR(glm::dot(h - y, x - z), 0, 1e-10);
  EXPECT_NEAR(std::pow(glm::dot(eye, p.n), 2), -glm::dot(x - h, y - h), 1e-9);
}

TEST_F(vanishing_points_plugin, puts_two_where_they_were_asked_for) {
  expect_places("x=-30,4:y=25,4", {Vec2(-30, 4), Vec2(25, 4), std::nullopt});
  expect_places("x=-30,4:y=25,9", {Vec2(-30, 4), Vec2(25, 9), std::nullopt});
  expect_places("x=-30,4:z=5,-25", {Vec2(-30, 4), std::nullopt, Vec2(5, -25)});
  expect_places("y=2,30:z=0,-25", {std::nullopt, Vec2(2, 30), Vec2(0, -25)});
  expect_places("x=2,4:y=60,4:centre=20,4", {Vec2(2, 4), Vec2(60, 4), std::nullopt});
}

TEST_F(vanishing_points_plugin, puts_one_where_it_was_asked_for_and_leaves_the_face_upright) {
  expect_places("x=-3,4", {Vec2(-3, 4), std::nullopt, std::nullopt});
  expect_places("y=3,4:distance=30", {std::nullopt, Vec2(3, 4), std::nullopt});
  expect_places("z=1,-2", {std::nullopt, std::nullopt, Vec2(1, -2)});
  const projection::Projection front = make("vanishing-points:y=3,4", box), top = make("vanishing-points:z=3,4", box);
  EXPECT_EQ(front.u, ex);
  EXPECT_EQ(front.v, ez);
  EXPECT_EQ(top.v, ey);
  EXPECT_EQ(make("vanishing-points:x=3,4", box).u, ey);
}

TEST_F(vanishing_points_plugin, keeps_the_model_upright_and_x_to_the_right) {
  for (const char* request : {"x=-30,12:y=25,10:z=2,-40", "x=30,-12:y=-25,-10:z=2,40", "x=40,1:y=-25,1"}) {
    const projection::Projection p = make(std::string("vanishing-points:") + request, box);
    const Vec3 centre = box.centre();
    EXPECT_GT(place(p, centre + 0.01 * ez).y, 0) << request;
    EXPECT_GT(place(p, centre + 0.01 * ex).x, 0) << request;
  }
}

TEST_F(vanishing_points_plugin, refuses_what_no_eye_can_see) {
  const auto reason = [&](const char* request) {
    return std::string(error_of([&] { make(std::string("vanishing-points:") + request, box); }).what());
  };
  EXPECT_TRUE(contains(reason("x=-30,0:y=30,0:z=0,-5"), "acute"));
  EXPECT_TRUE(contains(reason("x=-30,0:y=30,0:z=9,0"), "one line"));
  EXPECT_TRUE(contains(reason("x=20,0:y=60,0"), "between"));
  EXPECT_TRUE(contains(reason("x=20,0:y=20,0"), "between"));
  EXPECT_TRUE(contains(reason("x=-1,0:y=1,0"), "inside"));
  EXPECT_TRUE(contains(reason("y=0,0:centre=1,1"), "centre"));
  EXPECT_TRUE(contains(reason("x=-30,0:y=30,0:distance=9"), "distance"));
}

}  // namespace
}  // namespace epura::test::families_test
