// SPDX-License-Identifier: Apache-2.0
// What would break if this were wrong: tangent edges of free forms drawn as sharp ones.
#include "surfaces/free_normals.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "shapes.hpp"

namespace epura::free_normals_test {
namespace {

using namespace test;

double height(double x, double y) { return 0.1 * x * x - 0.07 * y * y + 0.02 * x * y + 0.01 * x * x * x; }
Vec3 normal_of(const Vec3& p) {
  return glm::normalize(Vec3(-0.2 * p.x - 0.02 * p.y - 0.03 * p.x * p.x, 0.14 * p.y - 0.02 * p.x, 1));
}

TEST(FreeNormals, AreThoseOfTheSurfaceWhereFacetsTilt) {
  const Part part = coarsely_bordered(height);
  const mesh::Mesh mesh = part.mesh();
  const surfaces::Facets facets = surfaces::make_facets(mesh);
  std::vector<surfaces::Region> regions(1);
  regions[0].facets.resize(facets.facets.size());
  std::iota(regions[0].facets.begin(), regions[0].facets.end(), 0);
  const std::vector<int> region_of(facets.facets.size(), 0);
  const surfaces::FreeNormals normals(facets, region_of, regions);
  const auto angle = [](const Vec3& a, const Vec3& b) {
    return std::atan2(glm::length(glm::cross(a, b)), std::abs(glm::dot(a, b))) * 180 / pi;
  };
  double most = 0, max_of_facets = 0;
  for (int f = 0; f < static_cast<int>(facets.facets.size()); ++f)
    for (const int v : facets.vertices_of(f)) {
      const auto normal = normals.at(f, v);
      ASSERT_TRUE(normal);
      const double wrong = angle(normal->direction, normal_of(mesh.point(v)));
      most = std::max(most, wrong);
      max_of_facets = std::max(max_of_facets, angle(facets.facets[f].normal, normal_of(mesh.point(v))));
      EXPECT_GT(glm::dot(normal->direction, facets.facets[f].normal), 0);
    }
  EXPECT_LT(most, 1.5);
  EXPECT_GT(max_of_facets, 10);
}

TEST(FreeNormals, FewVerticesTellNone) {
  const Part part{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0.1}, {0, 1, 0}, {2, 0, 0.3}}, {{0, 1, 2}, {0, 2, 3}, {1, 4, 2}}};
  const surfaces::Facets facets = surfaces::make_facets(part.mesh());
  std::vector<surfaces::Region> regions(1);
  regions[0].facets = {0, 1, 2};
  const std::vector<int> region_of(facets.facets.size(), 0);
  EXPECT_FALSE(surfaces::FreeNormals(facets, region_of, regions).at(0, 0));
}

}  // namespace
}  // namespace epura::free_normals_test
