// SPDX-License-Identifier: Apache-2.0
// Every certificate can be taken away, and the drawing stays the same to the byte. `epura explain` tells the plan.
#include <gtest/gtest.h>

#include <algorithm>
#include <ostream>

#include "base/file.hpp"
#include "base/text.hpp"
#include "program.hpp"

namespace epura::test::leave_out_test {
namespace {

struct Case {
  std::string name;
  std::vector<std::string> arguments;
  std::string left_out;  ///< stages

  friend void PrintTo(const Case& one, std::ostream* out) { *out << one.name; }
};

// A rough surface of 12 x 12 squares that hides nothing from above.
std::string terrain() {
  std::string text;
  for (int j = 0; j <= 12; ++j)
    for (int i = 0; i <= 12; ++i)
      text +=
          "v " + std::to_string(i) + " " + std::to_string(j) + " 0." + std::to_string(7 * (i * i + 3 * j) % 4) + "\n";
  for (int j = 0; j < 12; ++j)
    for (int i = 1; i <= 12; ++i) {
      const int at = 13 * j + i;
      for (const auto& [b, c] : {std::pair(at + 1, at + 14), std::pair(at + 14, at + 13)})
        text += "f " + std::to_string(at) + " " + std::to_string(b) + " " + std::to_string(c) + "\n";
    }
  return text;
}

std::string cube() {
  return "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\n"
         "f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n";
}

std::vector<Case> cases() {
  const std::string eye = "look-at:eye=300,-400,250:ref=0,0,20";
  return {{"Cube", {"cube.obj", "--hidden", "dashed"}, "clip intersections text"},
          {"ConvexBodies",
           {"cube.obj", "cube.obj", "cube.obj", "--hidden", "dashed", "--transform", "scale:1", "--transform",
            "rotate:x,20 translate:3,0,0", "--transform", "translate:0,5,0"},
           "clip intersections text"},
          {"Terrain",
           {"terrain.obj", "--edges", "crease,boundary,smooth", "--hidden", "dashed"},
           "clip intersections visibility text"},
          {"VisibleOnly", {sample("flange.obj"), "--hidden", "none"}, "clip hidden text"},
          {"VisibleOfBodiesThatCross", {sample("stairs.obj"), "--hidden", "none"}, "clip hidden text"},
          {"Perspective", {sample("bearing.obj"), "--projection", eye, "--hidden", "none"}, "clip hidden text"},
          {"Clipped", {sample("bearing.obj"), "--projection", eye, "--far", "560", "--hidden", "dashed"}, "text"},
          {"Section", {sample("bearing.obj"), "--section", "0,0,0:0,-1,0", "--hidden", "dashed"}, "clip text"},
          {"Wireframe", {sample("gear.stl"), "--visibility", "none", "--hidden", "dashed"}, "clip visibility text"},
          {"SheetOfViews",
           {sample("bracket.obj"), "--views", "front,top,left,isometric", "--frame", "full", "--hidden", "dashed"},
           "clip"}};
}

class LeavingOut : public testing::TestWithParam<Case> {
 protected:
  void SetUp() override {
    write_file(folder_ / "cube.obj", cube());
    write_file(folder_ / "terrain.obj", terrain());
  }

  Outcome run(const std::string& command, const std::vector<std::string>& more) {
    std::vector<std::string> arguments{command};
    arguments.insert(arguments.end(), GetParam().arguments.begin(), GetParam().arguments.end());
    arguments.insert(arguments.end(), more.begin(), more.end());
    return epura(arguments, folder_ / "");
  }

  // The SVG, and the JSON without its plan.
  std::string drawn_by(const std::string& plan) {
    const Outcome outcome = run("draw", {"--plan", plan, "-o", "x.svg", "-o", "x.json"});
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    const std::string json = read_file(folder_ / "x.json");
    return read_file(folder_ / "x.svg") + json.substr(0, json.find("\"plan\""));
  }

  Folder folder_;
};

TEST_P(LeavingOut, ChangesNothing) {
  const std::string expected = drawn_by("none");
  EXPECT_NE(expected.find("<path"), std::string::npos);
  for (const char* plan : {"all", "clip", "intersections", "visibility", "hidden", "text", "clip,hidden"})
    EXPECT_TRUE(drawn_by(plan) == expected) << plan;
}

TEST_P(LeavingOut, IsExplained) {
  const Outcome outcome = run("explain", {});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  std::string left_out;
  for (const std::string stage : {"clip", "intersections", "visibility", "hidden", "text"}) {
    const auto lines = split(outcome.out, '\n');
    if (std::any_of(lines.begin(), lines.end(), [&](std::string_view line) {
          return line.starts_with(stage + " ") && line.find(" skipped ") != std::string_view::npos;
        }))
      left_out += (left_out.empty() ? "" : " ") + stage;
  }
  EXPECT_EQ(left_out, GetParam().left_out) << outcome.out;
}

INSTANTIATE_TEST_SUITE_P(Plan, LeavingOut, testing::ValuesIn(cases()), [](const auto& one) { return one.param.name; });

TEST(Explain, MeasuresWhatIsSaved) {
  const Folder folder;
  write_file(folder / "cube.obj", cube());
  const Outcome outcome = epura({"explain", "cube.obj", "--measure", "-o", "x.json"}, folder / "");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_TRUE(outcome.out.starts_with("times in ms\nstage ")) << outcome.out;
  EXPECT_NE(outcome.out.find(" saved "), std::string::npos) << outcome.out;
  const std::string json = read_file(folder / "x.json");
  EXPECT_NE(json.find("\"saved_measured\": "), std::string::npos);
  EXPECT_NE(json.find("\"saved_estimated\": "), std::string::npos);
}

TEST(Explain, LeavesSecondsOutOfFiles) {
  const Folder folder;
  write_file(folder / "cube.obj", cube());
  ASSERT_EQ(epura({"explain", "cube.obj", "-o", "x.json"}, folder / "").code, 0);
  ASSERT_EQ(epura({"draw", "cube.obj", "--explain", "-o", "y.json"}, folder / "").code, 0);
  EXPECT_EQ(read_file(folder / "x.json"), read_file(folder / "y.json"));
}

TEST(Explain, RefusesWhatItCannotDo) {
  const Folder folder;
  write_file(folder / "cube.obj", cube());
  const Outcome unknown = epura({"explain", "cube.obj", "--plan", "clip,intersection"}, folder / "");
  EXPECT_EQ(unknown.code, 2);
  EXPECT_NE(unknown.err.find("--plan: unknown value 'intersection'"), std::string::npos) << unknown.err;
  EXPECT_NE(unknown.err.find("did you mean 'intersections'"), std::string::npos) << unknown.err;
  EXPECT_EQ(epura({"explain", "cube.obj", "-o", "-", "--format", "svg"}, folder / "").code, 2);
}

}  // namespace
}  // namespace epura::test::leave_out_test
