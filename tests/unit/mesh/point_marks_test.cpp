// SPDX-License-Identifier: Apache-2.0
// What would break if this were wrong: points that are missing, or that make the part larger than it is.
#include "mesh/point_marks.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "errors.hpp"
#include "mesh/read.hpp"

namespace epura::test::point_marks_test {
namespace {

mesh::Mesh read(const std::string& bytes, const std::string& name) { return mesh::read_mesh(bytes, name); }

Box box_of(const mesh::Mesh& mesh) {
  Box box;
  for (std::size_t v = 0; v < mesh.points.size(); ++v) box.add(mesh.point(static_cast<int>(v)));
  return box;
}

TEST(PointMarks, AreCrossesInTheBox) {
  const mesh::Mesh mesh = read("v 0 0 0\nv 4 0 0\nv 4 3 0\nv 2 1 5\nv 2 1 2\nf 1 2 3\np 4 5 -1\n", "m.obj");
  EXPECT_EQ(mesh.report.points, 2) << "one of them is named twice";
  EXPECT_EQ(mesh.report.vertices, 5);
  EXPECT_EQ(mesh.report.wires, 6);
  EXPECT_EQ(mesh.report.point_arms, 6);
  EXPECT_EQ(box_of(mesh).min, Vec3(0));
  EXPECT_EQ(box_of(mesh).max, Vec3(4, 3, 5));
  const double half = 0.008 * std::sqrt(16 + 9 + 25);
  EXPECT_EQ(mesh.point(5), Vec3(2 - half, 1, 5));
  EXPECT_EQ(mesh.point(6), Vec3(2 + half, 1, 5));
  EXPECT_EQ(mesh.point(10), Vec3(2, 1, 5)) << "at the end of the box";
  EXPECT_TRUE(mesh.edge_between({5, 6})->wire);
}

TEST(PointMarks, AreForAllPointsOfAFileWithoutAnythingElse) {
  const std::string cloud =
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
      "property float z\nend_header\n0 0 0\n1 0 0\n0 2 0\n";
  EXPECT_EQ(read(cloud, "m.ply").report.points, 3);
  EXPECT_EQ(read(cloud, "m.ply").report.notes,
            std::vector<std::string>{"has no faces and no lines: its points are drawn as crosses"});
  EXPECT_EQ(read(cloud, "m.ply").report.point_arms, 6) << "a flat cloud has no third direction";
  EXPECT_EQ(read("OFF 3 0 0\n0 0 0\n1 0 0\n0 1 0\n", "m.off").report.points, 3);
  EXPECT_EQ(read("v 0 0 0\nv 1 0 0\nv 0 1 0\nv nan 0 0\nv 5 5 5\n", "m.obj").report.points, 4);
  EXPECT_EQ(read("v 0 0 0\nv 1 0 0\nv 0 1 0\nv 7 7 7\nf 1 2 3\n", "m.obj").report.points, 0);
}

TEST(PointMarks, AreFacesOfOneCornerInOff) {
  const mesh::Mesh mesh = read("OFF 4 2 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n1 3\n3 0 1 2\n", "m.off");
  EXPECT_EQ(mesh.report.points, 1);
  EXPECT_EQ(mesh.report.dropped_degenerate, 0);
  EXPECT_EQ(mesh.polygon, std::vector<int>{1});
}

TEST(PointMarks, AreNotMoreThanCanBeDrawn) {
  mesh::Soup soup;
  soup.points.resize(mesh::max_marks + 1);
  for (std::size_t i = 0; i < soup.points.size(); ++i) soup.points[i][0] = static_cast<double>(i);
  mesh::mark_lone_points(soup);
  EXPECT_EQ(error_of([&] { mesh::add_crosses(soup, "m"); }).where(), "m");
}

TEST(PointMarks, RefuseNumbersOutOfRange) {
  EXPECT_EQ(error_of([] { read("v 0 0 0\np 2\n", "m.obj"); }).where(), "m.obj:2");
}

}  // namespace
}  // namespace epura::test::point_marks_test
