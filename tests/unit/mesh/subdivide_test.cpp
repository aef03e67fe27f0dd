// SPDX-License-Identifier: Apache-2.0
// Loop's scheme against its masks and against what sharp edges keep.
#include "mesh/subdivide.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "mesh/build.hpp"

namespace epura::test::subdivide_test {
namespace {

mesh::Mesh made_of(mesh::Points points, const std::vector<std::vector<int>>& faces) {
  mesh::Soup soup;
  soup.points = std::move(points);
  for (const std::vector<int>& face : faces) {
    soup.corners.insert(soup.corners.end(), face.begin(), face.end());
    soup.end_face();
  }
  return mesh::build_mesh(std::move(soup), "part");
}

mesh::Mesh octahedron() {
  return made_of({{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}},
                 {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}});
}

mesh::Mesh cube() {
  return made_of({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}},
                 {{3, 2, 1, 0}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}});
}

double volume_of(const mesh::Mesh& mesh) {
  double volume = 0;
  for (int t = 0; t < mesh.triangle_count(); ++t) {
    const auto [a, b, c] = mesh.triangle(t);
    volume += glm::dot(mesh.point(a), glm::cross(mesh.point(b), mesh.point(c))) / 6;
  }
  return volume;
}

// Around a vertex of four edges, whose neighbours have the mean 0, the share of the vertex is
// 1 - (5/8 - (3/8)²) = 33/64; a point on an edge is 3/8 of both ends and 1/8 of both opposite corners, which cancel.
TEST(Subdivide, FollowsTheMasksOfLoop) {
  const mesh::Mesh once = mesh::subdivide(octahedron(), 1, 180);
  EXPECT_EQ(once.triangle_count(), 32);
  EXPECT_NEAR(once.point(4).z, 33.0 / 64, 1e-15);
  int on_edges = 0;
  for (int v = 6; v < static_cast<int>(once.points.size()); ++v) {
    const Vec3 p = glm::abs(once.point(v));
    EXPECT_NEAR(p.x + p.y + p.z, 0.75, 1e-15);
    on_edges += std::abs(std::max({p.x, p.y, p.z}) - 0.375) < 1e-15 ? 1 : 0;
  }
  EXPECT_EQ(on_edges, 12);
}

TEST(Subdivide, KeepsSharpEdges) {
  const mesh::Mesh sharp = mesh::subdivide(cube(), 3, 45);
  EXPECT_EQ(sharp.triangle_count(), 12 * 64);
  EXPECT_NEAR(volume_of(sharp), 1, 1e-12);
  for (const auto& [x, y, z] : sharp.points)
    EXPECT_NEAR(std::max({std::abs(x - 0.5), std::abs(y - 0.5), std::abs(z - 0.5)}), 0.5, 1e-12);
  EXPECT_LT(volume_of(mesh::subdivide(cube(), 3, 180)), 0.7) << "without them it is round";
}

// A boundary becomes a curve of its own: the corner of a square moves by an eighth of the way to each neighbour.
TEST(Subdivide, RoundsBoundariesInTheirPlane) {
  const mesh::Mesh square = made_of({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2, 3}});
  const mesh::Mesh once = mesh::subdivide(square, 1, 180);
  EXPECT_EQ(once.points[0], (std::array<double, 3>{0.125, 0.125, 0}));
  EXPECT_EQ(once.report.open_edges, 8);
}

TEST(Subdivide, KeepsBodiesApart) {
  mesh::Mesh two = octahedron();
  for (std::size_t t = 4; t < two.body.size(); ++t) two.body[t] = 1;
  const mesh::Mesh once = mesh::subdivide(two, 1, 180);
  for (int v : {0, 1, 2, 3}) EXPECT_EQ(glm::length(once.point(v)), 0.75) << "the border of both is sharp";
  EXPECT_EQ(std::count(once.body.begin(), once.body.end(), 1), 16);
}

}  // namespace
}  // namespace epura::test::subdivide_test
