// SPDX-License-Identifier: Apache-2.0
// What `epura draw` says of the condition of its views.
#include <gtest/gtest.h>

#include "../output/json_reader.hpp"
#include "errors.hpp"
#include "folder.hpp"
#include "program.hpp"

namespace epura::test::condition_test {
namespace {

using Words = std::vector<std::string>;

struct DrawnCube : Outcome {
  std::string json;
};

// A cube of 2 at the origin.
DrawnCube draw_cube(const Words& options) {
  const Folder folder;
  folder.file("cube.obj",
              "v -1 -1 -1\nv 1 -1 -1\nv -1 1 -1\nv 1 1 -1\nv -1 -1 1\nv 1 -1 1\nv -1 1 1\nv 1 1 1\n"
              "f 1 3 4 2\nf 5 6 8 7\nf 1 2 6 5\nf 3 7 8 4\nf 1 5 7 3\nf 2 4 8 6\n");
  Words arguments{"draw", "cube.obj", "-o", "x.json"};
  arguments.insert(arguments.end(), options.begin(), options.end());
  const Outcome run = epura(arguments, folder / "");
  return {run, run.code == 0 ? read_file(folder / "x.json") : ""};
}

TEST(ConditionOfViews, IsToldWhereItIsAskedFor) {
  const DrawnCube run = draw_cube({"--views", "front,isometric", "--explain"});
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_TRUE(contains(run.out, "view 'front': condition ")) << run.out;
  EXPECT_TRUE(contains(run.out, " 15 digits left")) << run.out;
  const Json json = JsonReader(run.json).read();
  const Json& conditions = json["report"]["condition"];
  ASSERT_EQ(conditions.items.size(), 2U);
  EXPECT_EQ(conditions.items[1].keys(), "view number digits_left why");
  EXPECT_GE(conditions.items[0]["number"].number(), 1);
  EXPECT_GT(conditions.items[0]["digits_left"].number(), 14);
  EXPECT_EQ(draw_cube({}).err, "");
}

TEST(ConditionOfViews, IsAWarningWhereEightDigitsAreLost) {
  const Words far{"--transform", "translate:1e10,0,0"}, near{"--transform", "translate:1e6,0,0"};
  const Outcome warned = draw_cube(far);
  EXPECT_EQ(warned.code, 0);
  EXPECT_TRUE(contains(warned.err, "loses many digits")) << warned.err;
  EXPECT_TRUE(contains(warned.err, "the model is small for its distance from the origin")) << warned.err;
  EXPECT_TRUE(contains(warned.err, "hint: ")) << warned.err;
  EXPECT_EQ(draw_cube(near).err, "");
}

}  // namespace
}  // namespace epura::test::condition_test
