// SPDX-License-Identifier: Apache-2.0
// What users are told of meshes that stand for smooth surfaces.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "errors.hpp"
#include "folder.hpp"
#include "known_parts.hpp"
#include "program.hpp"

namespace epura::test::coarse_meshes_test {
namespace {

// A pebble, which is no surface of a part, of rings x 2 rings quadrangles.
std::string pebble(int rings) {
  const int around = 2 * rings;
  std::string obj = "v 0 0 -20\nv 0 0 30\n";
  for (int i = 1; i < rings; ++i)
    for (int j = 0; j < around; ++j) {
      const double a = std::numbers::pi * i / rings, b = 2 * std::numbers::pi * j / around;
      const double r = 40 * std::sin(a) * (1 + 0.15 * std::sin(2 * b) + 0.1 * std::cos(3 * a));
      obj += "v " + std::to_string(r * std::cos(b)) + " " + std::to_string(r * std::sin(b)) + " " +
             std::to_string(a < std::numbers::pi / 2 ? -20 * std::cos(a) : -30 * std::cos(a)) + "\n";
    }
  const auto at = [&](int i, int j) { return std::to_string(3 + (i - 1) * around + j % around); };
  for (int j = 0; j < around; ++j) obj += "f 1 " + at(1, j + 1) + " " + at(1, j) + "\n";
  for (int i = 1; i + 1 < rings; ++i)
    for (int j = 0; j < around; ++j)
      obj += "f " + at(i, j) + " " + at(i, j + 1) + " " + at(i + 1, j + 1) + " " + at(i + 1, j) + "\n";
  for (int j = 0; j < around; ++j) obj += "f 2 " + at(rings - 1, j) + " " + at(rings - 1, j + 1) + "\n";
  return obj;
}

class CoarseMeshes : public testing::Test {
 protected:
  Folder folder;

  std::string said_of(const std::string& model, const std::string& edges, std::vector<std::string> more = {}) {
    std::vector<std::string> arguments{"draw", model, "--projection", "isometric", "--sheet", "A4", "-o", "x.svg"};
    if (!edges.empty()) arguments.insert(arguments.end(), {"--edges", edges});
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Outcome run = epura(arguments, folder / "");
    EXPECT_EQ(run.code, 0) << run.err;
    return run.err;
  }
};

const std::string angular = "the outlines of 'part.obj' are angular", remedy = "round the mesh by part.obj:subdivide=2",
                  all = "of the kind 'smooth'";

TEST_F(CoarseMeshes, AreToldWithTheRemedy) {
  const std::string part = folder.file("part.obj", pebble(12));
  for (const char* edges : {"", "contour", "contour,smooth"}) {
    const std::string said = said_of(part, edges);
    EXPECT_TRUE(contains(said, angular) && contains(said, remedy)) << edges << ": " << said;
    EXPECT_EQ(contains(said, all), std::string(edges) == "contour,smooth") << said;
  }
  EXPECT_EQ(said_of(part + ":subdivide=2", "contour,boundary"), "") << "the remedy";
}

TEST_F(CoarseMeshes, AreThoseThatLookCoarse) {
  const std::string part = folder.file("part.obj", pebble(12));
  EXPECT_FALSE(contains(said_of(part, "contour", {"--scale", "1:20"}), angular)) << "small on paper";
  EXPECT_EQ(said_of(folder.file("part.obj", pebble(80)), "contour"), "") << "fine";
  EXPECT_TRUE(contains(said_of(folder / "part.obj", "contour,smooth"), "if they are angular, " + remedy));
  for (const char* edges : {"contour,crease,smooth", "contour,boundary,smooth"})
    EXPECT_EQ(said_of(folder.file("part.obj", pebble(12)), edges), "") << "facets are wanted: " << edges;
}

// However coarse, their outlines are those of their faces.
TEST_F(CoarseMeshes, AreNotParts) {
  for (const auto& parts : {plates(), round_parts(), blocks()})
    for (const KnownPart& part : parts)
      for (const char* edges : {"", "contour", "contour,smooth"})
        EXPECT_FALSE(contains(said_of(folder.file("part.obj", part.obj), edges), "subdivide")) << part.name << edges;
  for (const char* model : {"flange.obj", "elbow.obj", "gear.stl", "house.obj", "stairs.obj", "shaft.obj"})
    for (const char* edges : {"", "contour", "contour,smooth"})
      EXPECT_FALSE(contains(said_of(sample(model), edges), "subdivide")) << model << edges;
}

TEST_F(CoarseMeshes, AreToldOnceForAllViews) {
  const std::string part = folder.file("part.obj", pebble(8));
  const Outcome run =
      epura({"draw", part, "--views", "front,top,isometric", "--sheet", "A3", "-o", "x.svg"}, folder / "");
  const std::size_t first = run.err.find(angular);
  ASSERT_NE(first, std::string::npos) << run.err;
  EXPECT_EQ(run.err.find(angular, first + 1), std::string::npos) << run.err;
}

// Angular in one of its views, and small in the other.
TEST_F(CoarseMeshes, AreToldOnceForViewsThatDiffer) {
  folder.file("part.obj", pebble(12));
  folder.file("two.toml",
              "model = [{file = \"part.obj\"}]\nsheet = {size = \"A3\"}\n"
              "[[view]]\nprojection = \"front\"\nedges = [\"contour\", \"smooth\"]\nscale = \"1:20\"\n"
              "[[view]]\nprojection = \"isometric\"\nedges = [\"contour\", \"smooth\"]\nscale = \"1:1\"\n");
  const Outcome run = epura({"draw", "two.toml", "-o", "x.svg"}, folder / "");
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_TRUE(contains(run.err, angular)) << run.err;
  EXPECT_FALSE(contains(run.err, "if they are angular")) << run.err;
}

}  // namespace
}  // namespace epura::test::coarse_meshes_test
