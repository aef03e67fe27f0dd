// SPDX-License-Identifier: Apache-2.0
// What a cutting plane leaves of wires.
#include <gtest/gtest.h>

#include <algorithm>

#include "cut/cut_world.hpp"
#include "errors.hpp"
#include "shapes.hpp"

namespace epura::test::cut_wires_test {
namespace {

cut::CutWorld cut(const world::World& world, const Vec3& point, const Vec3& normal) {
  return cut::cut_world(world, scene::make_cutting_plane({{"A", "--section"}, point, normal}));
}

TEST(CutWires, TakesTheWiresInFrontOfThePlane) {
  Shape shape = box({0, 0, 0}, {4, 4, 4});
  // Behind the plane y = 2, in front of it, through it from the front, in it, and one that ends at it from the front.
  shape.points.insert(shape.points.end(), {{9, 3, 1}, {9, 5, 1}, {9, 1, 1}, {9, -1, 1}, {8, 2, 1}, {7, 2, 1}});
  shape.wires = {{8, 9}, {10, 11}, {10, 9}, {12, 13}, {11, 12}};
  const world::World whole = world_of(shape);
  EXPECT_EQ(whole.wires.size(), 5u);
  EXPECT_EQ(whole.box.max, Vec3(9, 5, 4));
  const world::World world = cut(whole, {0, 2, 0}, {0, -1, 0}).world;
  std::vector<std::array<Vec3, 2>> ends;
  for (const auto& [a, b] : world.wires) ends.push_back({world.points[a], world.points[b]});
  const Vec3 made(9, 2, 1);
  EXPECT_EQ(ends, (std::vector<std::array<Vec3, 2>>{
                      {Vec3(9, 3, 1), Vec3(9, 5, 1)}, {Vec3(9, 5, 1), made}, {Vec3(8, 2, 1), Vec3(7, 2, 1)}}));
  const mesh::Mesh& mesh = *world.models[0].mesh;
  const auto piece = std::find_if(mesh.edges.begin(), mesh.edges.end(),
                                  [](const mesh::MeshEdge& e) { return e.count == 0 && e.vertex[1] > 13; });
  ASSERT_NE(piece, mesh.edges.end());
  EXPECT_EQ(mesh.origin_of(*piece).vertex, (std::array<int, 2>{9, 10}));
  EXPECT_EQ(mesh.origin_of(*piece).t, (std::array<double, 2>{0, 0.75}));
}

TEST(CutWires, CutsModelsOfWiresOnly) {
  const Shape line{{{0, 0, 0}, {0, 4, 0}}, {}, {}, {{0, 1}}};
  const cut::CutWorld through = cut(world_of(line), {0, 1, 0}, {0, -1, 0});
  ASSERT_EQ(through.world.wires.size(), 1u);
  EXPECT_TRUE(through.faces.empty());
  EXPECT_TRUE(contains(error_of([&] { cut(world_of(line), {0, 5, 0}, {0, -1, 0}); }).what(), "removes everything"));
  EXPECT_TRUE(contains(error_of([&] { cut(world_of(line), {0, -1, 0}, {0, -1, 0}); }).what(), "cuts nothing"));
}

}  // namespace
}  // namespace epura::test::cut_wires_test
