// SPDX-License-Identifier: Apache-2.0
#include "cut/cut_mesh.hpp"

#include <gtest/gtest.h>

#include <array>
#include <utility>
#include <vector>

namespace epura::test::cut_mesh_test {
namespace {

TEST(CuttingPlane, DirectionsAreThoseOfTheAxisClosestToThePlane) {
  for (const auto& [normal, axis] : {std::pair(Vec3(1, 2, 3), 0), std::pair(Vec3(-3, 1, 2), 1),
                                     std::pair(Vec3(2, 3, -1), 2), std::pair(Vec3(30, 10, 20), 1)}) {
    const scene::CuttingPlane plane = scene::make_cutting_plane({{"A", "--section"}, Vec3(0), normal});
    EXPECT_EQ(plane.right[axis], 0) << axis;
    EXPECT_NEAR(glm::length(plane.right), 1, 1e-15);
    EXPECT_NEAR(glm::dot(plane.right, plane.normal), 0, 1e-15);
    EXPECT_NEAR(glm::length(glm::cross(plane.normal, plane.right) - plane.up), 0, 1e-15);
  }
}

// Two faces and a third one between the same two vertices are an outline of one of them.
TEST(CutSegments, OfAnOddNumberHaveTheSenseOfMost) {
  for (const std::array<int, 3>& senses : {std::array{-1, 1, 1}, {1, -1, 1}, {1, 1, -1}, {1, 1, 1}}) {
    std::vector<cut::CutSegment> segments;
    for (const int sense : senses) segments.push_back({0, {3, 5}, sense, 7 + sense});
    segments.push_back({0, {1, 3}, 1, 2});
    segments.push_back({0, {1, 3}, -1, 4});
    cut::keep_odd(segments);
    ASSERT_EQ(segments.size(), 1U) << "what is there twice is none";
    EXPECT_EQ(segments[0].vertex, (std::array{3, 5}));
    EXPECT_EQ(segments[0].sense, 1);
  }
}

}  // namespace
}  // namespace epura::test::cut_mesh_test
