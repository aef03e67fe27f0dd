// SPDX-License-Identifier: Apache-2.0
// What would break if this were wrong: parts counted twice or not at all, and left-hand parts ordered as right-hand
// ones.
#include "world/items.hpp"

#include <gtest/gtest.h>

#include <initializer_list>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "base/text.hpp"
#include "mesh/read.hpp"
#include "scene/transform.hpp"
#include "world/congruent.hpp"

namespace epura::test::items_test {
namespace {

// A box with a corner cut off unequally: it has no symmetry, and differs from its reflection.
std::string wedge(int first, double x = 0) {
  const std::vector<Vec3> corners{{0, 0, 0},   {30, 0, 0},  {30, 20, 0},  {0, 20, 0},  {0, 0, 10},
                                  {25, 0, 10}, {30, 3, 10}, {30, 20, 10}, {0, 20, 10}, {30, 0, 6}};
  std::string text;
  for (const Vec3& p : corners)
    text += "v " + format_number(x + p.x) + " " + format_number(p.y) + " " + format_number(p.z) + "\n";
  const auto face = [&](std::initializer_list<int> around) {
    text += "f";
    for (const int v : around) text += " " + std::to_string(first + v);
    text += "\n";
  };
  face({3, 2, 1, 0}), face({4, 5, 6, 7, 8}), face({0, 1, 9, 5, 4}), face({1, 2, 7, 6, 9}), face({2, 3, 8, 7});
  face({3, 0, 4, 8}), face({5, 9, 6});
  return text;
}

world::World world_of(const std::vector<std::pair<std::string, std::string>>& models) {
  std::vector<world::Placed> placed;
  for (const auto& [obj, transform] : models) {
    placed.push_back(
        {std::make_shared<const mesh::Mesh>(mesh::read_mesh(obj, "model.obj")), scene::parse_transform(transform)});
  }
  return world::make_world(std::move(placed));
}

std::vector<scene::ModelDescription> descriptions(std::size_t count) {
  std::vector<scene::ModelDescription> models(count);
  for (scene::ModelDescription& model : models) model.file = {"wedge.obj", "wedge.obj"};
  return models;
}

TEST(Items, AreTheSameMeshTurned) {
  const world::World world =
      world_of({{wedge(1), "scale:1"}, {wedge(1), "rotate:z,37 rotate:x,-81 translate:900,-70,3"}});
  const auto items = world::find_items(world, descriptions(2), {{}, {}}).items;
  ASSERT_EQ(items.size(), 1U);
  EXPECT_EQ(items[0].quantity, 2);
  EXPECT_EQ(items[0].name, "wedge");
}

TEST(Items, AreNotReflectionsOrOtherSizes) {
  const world::World world = world_of({{wedge(1), "scale:1"}, {wedge(1), "scale:-1,1,1"}, {wedge(1), "scale:1.001"}});
  const auto items = world::find_items(world, descriptions(3), {{}, {}, {}}).items;
  ASSERT_EQ(items.size(), 3U);
  for (const world::Item& item : items) EXPECT_EQ(item.quantity, 1);
}

TEST(Items, HaveOneNameOrDifferByANumberOnly) {
  const std::string named = "o nut_1\n" + wedge(1) + "o nut_2\n" + wedge(11, 40) + "o bolt\n" + wedge(21, 80);
  const auto items =
      world::find_items(world_of({{named, "scale:1"}, {named, "translate:0,50,0"}}), descriptions(2), {{}, {}}).items;
  ASSERT_EQ(items.size(), 2U) << "a bolt and a nut of one shape are two items";
  EXPECT_EQ(items[0].name, "nut");
  EXPECT_EQ(items[0].quantity, 4);
  EXPECT_EQ(items[1].name, "bolt");
  EXPECT_EQ(items[1].quantity, 2);
}

TEST(Items, MayHaveNumbersWithoutSeparators) {
  const std::string named = "o nut M10\n" + wedge(1) + "o nut M011\n" + wedge(11, 40) + "o nut M012\n" + wedge(21, 80);
  const auto items = world::find_items(world_of({{named, "scale:1"}}), descriptions(1), {{}}).items;
  ASSERT_EQ(items.size(), 1U);
  EXPECT_EQ(items[0].name, "nut M10");
  EXPECT_EQ(items[0].quantity, 3);
  const std::string copied = "o nut\n" + wedge(1) + "o nut001\n" + wedge(11, 40) + "o 7\n" + wedge(21, 80);
  const auto others = world::find_items(world_of({{copied, "scale:1"}}), descriptions(1), {{}}).items;
  ASSERT_EQ(others.size(), 2U) << "a number is a name";
  EXPECT_EQ(others[0].name, "nut");
}

// The file says which part occurs where: names of occurrences do not count.
TEST(Items, HaveTheNamesOfTheirParts) {
  const std::string named = "o left leg\n" + wedge(1) + "o right leg\n" + wedge(11, 40) + "o top\n" + wedge(21, 80);
  const world::World world = world_of({{named, "scale:1"}});
  EXPECT_EQ(world::find_items(world, descriptions(1), {{}}).items.size(), 3U);
  const auto items = world::find_items(world, descriptions(1), {{{"leg", 0}, {"leg", 1}, {"", 2}}}).items;
  ASSERT_EQ(items.size(), 2U);
  EXPECT_EQ(items[0].name, "leg");
  EXPECT_EQ(items[0].quantity, 2);
  EXPECT_EQ(items[1].name, "top") << "a part without a name";
}

TEST(Items, OfOneNameButOtherShapesAreSeveral) {
  const std::string named = "o body\n" + wedge(1) + "o Body\n" + wedge(11, 40);
  const world::World world = world_of({{named, "scale:1"}, {named, "scale:2"}});
  const auto items = world::find_items(world, descriptions(2), {{{"a", 0}, {"a", 1}}, {{"a", 0}, {"b", 1}}}).items;
  ASSERT_EQ(items.size(), 3U);
  EXPECT_EQ(items[0].quantity, 2);
  EXPECT_EQ(items[1].name, "a");
  EXPECT_EQ(items[2].name, "b");
}

// The bodies of one occurrence are one piece unless they have names.
TEST(Items, MayHaveSeveralBodies) {
  const std::string named =
      "o 1\n" + wedge(1) + "o 2\n" + wedge(11, 40) + "o 3\n" + wedge(21, 80) + "o 4\n" + wedge(31, 120);
  const world::World world = world_of({{named, "scale:1"}});
  const auto items =
      world::find_items(world, descriptions(1), {{{"pair", 0}, {"pair", 0}, {"pair", 1}, {"pair", 1}}}).items;
  ASSERT_EQ(items.size(), 1U);
  EXPECT_EQ(items[0].quantity, 2);
  EXPECT_EQ(items[0].bodies, (std::vector<std::array<int, 2>>{{0, 0}, {0, 1}, {0, 2}, {0, 3}}));
}

TEST(Items, AreNotSurfacesBesideSolids) {
  const std::string plane = "v 0 0 50\nv 9 0 50\nv 9 9 50\nf -3 -2 -1\n";
  const world::World world = world_of({{"o part\n" + wedge(1) + "o plane\n" + plane, "scale:1"}});
  const auto list = [&](int occurrence) {
    return world::find_items(world, descriptions(1), {{{"bracket", 0}, {"bracket", occurrence}}});
  };
  ASSERT_EQ(list(0).items.size(), 1U);
  EXPECT_EQ(list(0).items[0].quantity, 1);
  EXPECT_EQ(list(0).surfaces, std::vector<std::string>{"bracket"});
  EXPECT_EQ(list(1).items.size(), 2U) << "a part that is a surface";
}

// A box of 30 x 20 x 10 less the tetrahedron of the corner, 5 x 3 x 4.
TEST(Items, HaveTheVolumeOfTheirShape) {
  const world::World world = world_of({{wedge(1), "rotate:y,20 translate:1000,0,0"}});
  std::vector<int> all;
  for (int t = 0; t < world.first_triangle.back(); ++t) all.push_back(t);
  EXPECT_NEAR(world::shape_of(world, all).volume, 30 * 20 * 10 - 5 * 3 * 4 / 6.0, 1e-6);
}

}  // namespace
}  // namespace epura::test::items_test
