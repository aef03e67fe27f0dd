// SPDX-License-Identifier: Apache-2.0
#include "world/world.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "errors.hpp"
#include "scene/transform.hpp"
#include "shapes.hpp"

namespace epura::test::world_test {
namespace {

world::Placed placed(const Shape& shape, const char* steps = "") {
  return {std::make_shared<const mesh::Mesh>(mesh_of(shape)), scene::parse_transform(steps)};
}

TEST(Scene, ModelsShareOneNumbering) {
  const world::World world =
      world::make_world({placed(triangulated_cube()), placed(plate(0, 0, 1, 1, 5)), placed(triangulated_cube())});
  EXPECT_EQ(world.first_vertex, (std::vector<int>{0, 8, 12, 20}));
  EXPECT_EQ(world.first_triangle, (std::vector<int>{0, 12, 14, 26}));
  ASSERT_EQ(world.points.size(), 20U);
  ASSERT_EQ(world.triangles.size(), 26U);
  for (int t = 0; t < 26; ++t) {
    const int model = world.model_of_triangle(t);
    EXPECT_EQ(model, t < 12 ? 0 : t < 14 ? 1 : 2);
    for (const int v : world.triangles[t]) {
      EXPECT_GE(v, world.first_vertex[model]);
      EXPECT_LT(v, world.first_vertex[model + 1]);
    }
  }
  EXPECT_EQ(world.box.max, Vec3(1, 1, 5));
}

TEST(Scene, ModelsStandWhereTheirTransformsPutThem) {
  const world::World world =
      world::make_world({placed(triangulated_cube(), "scale:2 translate:10,0,0"), placed(triangulated_cube())});
  EXPECT_EQ(world.points[0], Vec3(10, 0, 0));
  EXPECT_EQ(world.points[7], Vec3(12, 2, 2));
  EXPECT_EQ(world.points[8], Vec3(0, 0, 0));
  EXPECT_EQ(world.box.max, Vec3(12, 2, 2));
}

TEST(Scene, VerticesWithoutFacesDoNotCount) {
  Shape cube = triangulated_cube();
  cube.points.push_back({100, 100, 100});
  EXPECT_EQ(world_of(cube).box.max, Vec3(1));
}

TEST(Scene, AnUnmovedModelKeepsItsBits) {
  Shape cube = triangulated_cube();
  cube.points[1] = {0x1.fffffffffffffp1023, -0.0, 0x1p-1074};
  const world::World world = world_of(cube);
  EXPECT_EQ(world.points[1].x, 0x1.fffffffffffffp1023);
  EXPECT_TRUE(std::signbit(world.points[1].y));
  EXPECT_EQ(world.points[1].z, 0x1p-1074);
}

TEST(Scene, ATransformOutOfTheDoublesIsRefused) {
  const std::string often = "scale:1e50 scale:1e50 scale:1e50 scale:1e50 scale:1e50 scale:1e50";
  for (const std::string& steps : {often + " scale:1e50", "translate:1e50,0,0 " + often}) {
    const Error error = error_of([&] { world::make_world({placed(triangulated_cube(), steps.c_str())}); });
    EXPECT_EQ(error.kind(), ErrorKind::input);
    EXPECT_EQ(error.where(), "shape");
    EXPECT_TRUE(contains(error.what(), "range")) << error.what();
  }
}

TEST(Scene, TheLeastPreciseModelCounts) {
  const world::World exact = world_of(triangulated_cube());
  EXPECT_EQ(exact.rounding, 0);
  mesh::Mesh mesh = mesh_of(triangulated_cube());
  mesh.report.single_precision = true;
  const auto coarse = std::make_shared<const mesh::Mesh>(std::move(mesh));
  EXPECT_EQ(world::make_world({placed(plate(0, 0, 1, 1, 0)), {coarse, Mat4(1.0)}}).rounding, 0x1p-22);
  EXPECT_EQ(world::make_world({{coarse, scene::parse_transform("translate:7,0,0")}}).rounding, 8 * 0x1p-22);
}

// Moving a model to the origin gives no digits back that its file has not.
TEST(Scene, RoundingIsThatOfTheFileWhereverTheModelStands) {
  mesh::Mesh floats = mesh_of(triangulated_cube().moved(99, 0, 0));
  floats.report.single_precision = true;
  const auto shared = std::make_shared<const mesh::Mesh>(std::move(floats));
  for (const char* steps : {"", "translate:-99,0,0", "translate:0,1e7,0"}) {
    const world::World world = world::make_world({{shared, scene::parse_transform(steps)}});
    EXPECT_GE(world.rounding, 100 * 0x1p-22) << steps;
    EXPECT_EQ(world.one_rounding, Vec3(100, 1, 1) * 0x1p-24) << steps;
  }
  const world::World turned = world::make_world({{shared, scene::parse_transform("scale:10 rotate:z,90")}});
  EXPECT_NEAR(turned.one_rounding.y, 1000 * 0x1p-24, 1e-12);
  EXPECT_EQ(world::make_world({placed(triangulated_cube())}).one_rounding, Vec3(0));
}

}  // namespace
}  // namespace epura::test::world_test
