// SPDX-License-Identifier: Apache-2.0
// A projection from its matrix makes the same picture.
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>

#include "base/error.hpp"
#include "projection/matrices.hpp"

namespace epura::test::projection_of_matrix_test {
namespace {

using namespace projection;

Vec2 seen(const Mat4& matrix, const Vec3& point) {
  const Vec4 at = matrix * Vec4(point, 1);
  return Vec2(at) / at.w;
}

Vec2 seen(const Projection& projection, const Vec3& point) {
  return projection.scale * seen(view_matrix(projection), point);
}

double nearness(const Mat4& matrix, const Vec3& point) {
  const Vec4 at = matrix * Vec4(point, 1);
  return at.z / at.w;
}

class MatrixProjections : public testing::Test {
 protected:
  double number(double most) { return std::uniform_real_distribution(-most, most)(random_); }
  Vec3 vector(double most) { return {number(most), number(most), number(most)}; }

  void expect_same_picture(const Mat4& matrix, double most) {
    const Projection projection = projection_of_matrix(matrix);
    EXPECT_NEAR(glm::dot(projection.u, projection.v), 0, 1e-14);
    EXPECT_NEAR(glm::dot(glm::cross(projection.u, projection.v), projection.n), 1, 1e-14);
    for (int i = 0; i < 20; ++i) {
      const Vec3 point = vector(most);
      if ((matrix * Vec4(point, 1)).w < 0.1 * most) continue;
      const Vec2 there = seen(matrix, point);
      EXPECT_NEAR(glm::distance(seen(projection, point), there), 0, 1e-11 * (glm::length(there) + most));
    }
  }

  std::mt19937 random_{7};
};

TEST_F(MatrixProjections, ParallelOnesOfAnyKind) {
  for (int i = 0; i < 200; ++i) {
    const Vec3 x = vector(2), y = vector(2), depth = glm::cross(x, y);
    const Mat4 matrix = rows(Vec4(x, number(50)), Vec4(y, number(50)), Vec4(depth, 1), {0, 0, 0, 1});
    expect_same_picture(matrix, 100);
    const Projection projection = projection_of_matrix(matrix);
    const Vec3 point = vector(10);
    EXPECT_GT(nearness(matrix, point + projection.projector), nearness(matrix, point));
  }
}

TEST_F(MatrixProjections, CentralOnes) {
  for (int i = 0; i < 200; ++i) {
    Projection given;
    given.central = true;
    given.n = glm::normalize(vector(1));
    given.u = glm::normalize(glm::cross(vector(1), given.n));
    given.v = glm::cross(given.n, given.u);
    given.point = vector(10);
    given.projector = given.point + (1 + std::abs(number(40))) * given.n + number(5) * given.u + number(5) * given.v;
    const Mat4 matrix = view_matrix(given);
    expect_same_picture(matrix, 10);
    expect_same_picture(3.0 * matrix, 10);
    EXPECT_NEAR(glm::distance(projection_of_matrix(matrix).projector, given.projector), 0, 1e-10);
  }
}

TEST_F(MatrixProjections, AreThoseOfThePlaneTheyWereMadeFor) {
  const Projection projection = projection_of_matrix(rows({2, 0, 0, 5}, {0, 0, 2, 7}, {0, -1, 0, 0}, {0, 0, 0, 1}));
  EXPECT_FALSE(projection.central);
  EXPECT_NEAR(projection.scale, 2, 1e-15);
  EXPECT_NEAR(glm::distance(projection.n, Vec3(0, -1, 0)), 0, 1e-7);
  EXPECT_NEAR(glm::distance(projection.point, Vec3(-2.5, 0, -3.5)), 0, 1e-15);
}

void expect_refused(const Mat4& matrix, const std::string& reason) {
  try {
    projection_of_matrix(matrix);
    FAIL() << "is taken";
  } catch (const Error& error) {
    EXPECT_EQ(error.where(), "matrix");
    EXPECT_NE(std::string(error.what()).find(reason), std::string::npos) << error.what();
  }
}

TEST_F(MatrixProjections, ThatMakeNoPictureAreRefused) {
  expect_refused(rows({1, 0, 0, 0}, {2, 0, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}), "flat");
  expect_refused(rows({1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, -1, 0}, {0, 0, 0, 1}), "mirrors");
  expect_refused(rows({1, 0, 0, 0}, {0, 1, 0, 0}, {1, 0, 0, 0}, {0, 0, 0, 1}), "side");
  expect_refused(rows({1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 0}), "zeros");
  expect_refused(rows({1, 0, 0, 0}, {0, std::nan(""), 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}), "finite");
  expect_refused(rows({1, 0, 0, 0}, {0, 2, 0, 0}, {0, 0, 1, 0}, {0, 0, -1, 9}), "stretches");
  expect_refused(rows({-1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, -1, 9}), "mirrors");
  expect_refused(rows({1, 0, 0, 0}, {0, 0, 1, 0}, {0, 0, 1, 0}, {0, 0, -1, 9}), "flat");
}

}  // namespace
}  // namespace epura::test::projection_of_matrix_test
