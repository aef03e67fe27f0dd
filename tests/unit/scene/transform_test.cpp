// SPDX-License-Identifier: Apache-2.0
#include "scene/transform.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "errors.hpp"

namespace epura::test::transform_test {
namespace {

Vec3 moved(const Mat4& matrix, const Vec3& p) { return Vec3(matrix * Vec4(p, 1)); }
Vec3 moved(const char* steps, const Vec3& p) { return moved(scene::parse_transform(steps), p); }

TEST(Transform, NothingMovesNothing) {
  EXPECT_EQ(scene::parse_transform(""), Mat4(1.0));
  EXPECT_EQ(scene::parse_transform("  "), Mat4(1.0));
}

TEST(Transform, QuarterTurnsAreExactAndRightHanded) {
  const Vec3 p(2, 3, 5);
  EXPECT_EQ(moved("rotate:x,90", p), Vec3(2, -5, 3));
  EXPECT_EQ(moved("rotate:y,90", p), Vec3(5, 3, -2));
  EXPECT_EQ(moved("rotate:z,90", p), Vec3(-3, 2, 5));
  EXPECT_EQ(moved("rotate:z,180", p), Vec3(-2, -3, 5));
  EXPECT_EQ(moved("rotate:z,-90", p), Vec3(3, -2, 5));
  for (const char* same : {"rotate:z,90", "rotate:z,450", "rotate:z,-270", "rotate:z,3600090"})
    EXPECT_EQ(scene::parse_transform(same), scene::parse_transform("rotate:z,90")) << same;
  EXPECT_EQ(scene::parse_transform("rotate:y,720"), Mat4(1.0));
  for (const char* axis : {"x", "y", "z"}) {
    const std::string quarter = std::string("rotate:") + axis + ",90";
    EXPECT_EQ(scene::parse_transform(quarter + " " + quarter + " " + quarter + " " + quarter), Mat4(1.0)) << axis;
  }
}

TEST(Transform, OtherAnglesAreDegrees) {
  const Vec3 p = moved("rotate:x,30", {0, 2, 0});
  EXPECT_NEAR(p.y, std::sqrt(3.0), 1e-15);
  EXPECT_NEAR(p.z, 1, 1e-15);
}

TEST(Transform, StepsGoFromLeftToRight) {
  EXPECT_EQ(moved("translate:1,0,0 rotate:z,90", {0, 0, 0}), Vec3(0, 1, 0));
  EXPECT_EQ(moved("rotate:z,90 translate:1,0,0", {0, 0, 0}), Vec3(1, 0, 0));
  EXPECT_EQ(moved("translate:1,2,3 scale:2", {1, 1, 1}), Vec3(4, 6, 8));
  EXPECT_EQ(moved("scale:2,3,4   translate:+1,0,-1", {1, 1, 1}), Vec3(3, 3, 3));
}

TEST(Transform, AMatrixIsRowMajor) {
  EXPECT_EQ(moved("matrix:1,2,3,4,0,1,0,5,0,0,1,6,0,0,0,1", {1, 1, 1}), Vec3(10, 6, 7));
}

TEST(Transform, MirrorsAreAllowed) { EXPECT_EQ(moved("scale:-1,1,1", {1, 2, 3}), Vec3(-1, 2, 3)); }

TEST(Transform, TinyAndHugeScalesAreNotFlat) {
  EXPECT_EQ(moved("scale:1e-200", {1, 1, 1}), Vec3(1e-200));
  EXPECT_EQ(moved("scale:1e50", {1, 1, 1}), Vec3(1e50));
  EXPECT_EQ(moved("scale:1,1,1e-300", {1, 1, 1}), Vec3(1, 1, 1e-300));
}

TEST(Transform, WrongStepsAreNamed) {
  struct Case {
    const char *text, *step, *reason;
  };
  for (const auto& [text, step, reason] : std::vector<Case>{
           {"turn:z,90", "turn:z,90", "not a known step"},
           {"scale", "scale", "numbers"},
           {"scale:", "scale:", "numbers"},
           {"scale:2,3", "scale:2,3", "wrong number of values"},
           {"scale:1 translate:1,2", "translate:1,2", "wrong number of values"},
           {"translate:1,2,x", "translate:1,2,x", "numbers"},
           {"translate:1, 2,3", "translate:1,", "numbers"},
           {"translate:nan,0,0", "translate:nan,0,0", "not finite"},
           {"scale:inf", "scale:inf", "not finite"},
           {"rotate:w,90", "rotate:w,90", "unknown axis 'w'"},
           {"rotate:90", "rotate:90", "axis and an angle"},
           {"rotate:z,inf", "rotate:z,inf", "axis and an angle"},
           {"rotate:z,90,1", "rotate:z,90,1", "axis and an angle"},
           {"scale:0", "scale:0", "flattens"},
           {"scale:1,0,1", "scale:1,0,1", "flattens"},
           {"matrix:1,0,0,0,0,1,0,0,0,0,1,0,0,0,1,1", "matrix:", "not affine"},
           {"matrix:1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,2", "matrix:", "not affine"},
       }) {
    const Error error = error_of([text = text] { scene::parse_transform(text); });
    EXPECT_EQ(error.kind(), ErrorKind::input);
    EXPECT_TRUE(contains(error.where(), step)) << error.where();
    EXPECT_TRUE(contains(error.what(), reason)) << error.what();
    EXPECT_FALSE(error.hint().empty());
  }
}

TEST(Transform, YUpBecomesZUp) {
  EXPECT_EQ(moved(scene::y_up_to_z_up(), {0, 1, 0}), Vec3(0, 0, 1));
  EXPECT_EQ(moved(scene::y_up_to_z_up(), {0, 0, 1}), Vec3(0, -1, 0));
  EXPECT_EQ(moved(scene::y_up_to_z_up(), {1, 0, 0}), Vec3(1, 0, 0));
}

}  // namespace
}  // namespace epura::test::transform_test
