// SPDX-License-Identifier: Apache-2.0
// What would break if this were wrong: bodies in colours of others, or in such as nobody sees on paper.
#include "scene/body_styles.hpp"

#include <gtest/gtest.h>

namespace epura::test::body_styles_test {
namespace {

using Colours = std::vector<std::optional<Colour>>;

mesh::Mesh mesh_with(std::vector<std::string> names, Colours colours) {
  mesh::Mesh mesh;
  mesh.report.body_names = std::move(names);
  mesh.report.body_colours = std::move(colours);
  return mesh;
}

TEST(ColourOfBody, IsThatOfTheFileUnlessItIsLight) {
  const mesh::Mesh mesh = mesh_with({"dark", "none", "white", "yellow"},
                                    {Colour{200, 0, 30}, std::nullopt, Colour{255, 255, 255}, Colour{255, 255, 0}});
  EXPECT_EQ(scene::colour_of_body(mesh, 0), (Colour{200, 0, 30}));
  EXPECT_EQ(scene::colour_of_body(mesh, 1), std::nullopt);
  EXPECT_EQ(scene::colour_of_body(mesh, 2), (Colour{139, 139, 139})) << "255 times the root of 0.3";
  const Colour yellow = scene::colour_of_body(mesh, 3).value();
  EXPECT_EQ(yellow.red, yellow.green);
  EXPECT_EQ(yellow.blue, 0);
  EXPECT_LT(yellow.red, 150);
}

TEST(ColourOfBody, IsThatOfTheOnlyNameForAllParts) {
  EXPECT_EQ(scene::colour_of_body(mesh_with({}, {Colour{1, 2, 3}}), 5), (Colour{1, 2, 3}));
  EXPECT_EQ(scene::colour_of_body(mesh_with({}, {}), 0), std::nullopt);
}

}  // namespace
}  // namespace epura::test::body_styles_test
