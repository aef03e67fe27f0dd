// SPDX-License-Identifier: Apache-2.0
// Time is over in each stage in turn, by a clock that strikes there: what is drawn then is marked and right, and no
// stage goes on for long without a look at the clock.
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <map>
#include <mutex>
#include <set>

#include "../output/json_reader.hpp"
#include "app/draw_files.hpp"
#include "base/error.hpp"
#include "base/file.hpp"
#include "base/text.hpp"
#include "base/vec.hpp"
#include "errors.hpp"
#include "long_model.hpp"
#include "program.hpp"
#include "words.hpp"

namespace epura::test::stages_in_time_test {
namespace {

constexpr double limit = 1;  // seconds

struct Drawn {
  std::vector<std::string> stages;  ///< that were cut
  std::string error;                ///< what ended it
  ErrorKind kind{};
  std::map<std::string, int> looks;  ///< at the clock, by stage
};

// Seconds at a look at the clock, of which this is the n-th one in a stage, from 1 on.
using Clock = std::function<double(const std::string& stage, int look)>;

Drawn draw_by(const Clock& clock, const std::vector<std::string>& arguments) {
  const DrawOptions options = draw_options_of(arguments);
  Drawn run;
  std::mutex mutex;
  ProgressBoard board([&] {
    const std::string now = board.standing().stage;
    const std::lock_guard lock(mutex);
    return clock(now, ++run.looks[now]);
  });
  const pipeline::Messages silent{[](const std::string&) {}, [](std::string_view) {}};
  try {
    run.stages = draw_files(options, silent, Progress(board, limit)).report.partial.stages;
  } catch (const Error& error) {
    run.error = error.what();
    run.kind = error.kind();
  }
  return run;
}

// The clock stands still until the stage that is to be cut looks at it; then the limit is reached.
Drawn draw_struck_at(const std::string& stage, const std::vector<std::string>& arguments) {
  bool struck = false;
  const auto clock = [&](const std::string& now, int) {
    struck = struck || now == stage;
    return struck ? limit : 0;
  };
  return draw_by(clock, arguments);
}

std::set<std::string> segments_of(const std::string& json) {
  std::set<std::string> lines;
  for (std::string_view line : split(json, '\n'))
    if (line.starts_with("    {\"from\"")) lines.emplace(line.substr(0, line.find("}", line.find("\"t\""))));
  return lines;
}

class BeforeAnyLine : public testing::TestWithParam<const char*> {};

TEST_P(BeforeAnyLine, NothingIsWrittenAndTheStageIsNamed) {
  const Folder folder;
  const std::string old = folder.file("x.svg", "old");
  const Drawn run = draw_struck_at(
      GetParam(), {(root() / "samples/bracket.toml").string(), "-o", old, "-o", (folder / "x.json").string()});
  EXPECT_EQ(run.kind, ErrorKind::time);
  EXPECT_TRUE(contains(run.error, "'" + std::string(GetParam()) + "'")) << run.error;
  EXPECT_TRUE(contains(run.error, "nothing was written")) << run.error;
  EXPECT_EQ(folder.names().size(), 1U);
  EXPECT_EQ(read_file(old), "old");
}

INSTANTIATE_TEST_SUITE_P(Stages, BeforeAnyLine,
                         testing::Values("reading", "cutting sections", "mapping", "finding edges"));

class StageOfLines : public testing::TestWithParam<const char*> {};

TEST_P(StageOfLines, WhatIsShownIsAPartOfTheWholeDrawing) {
  const Folder folder;
  const std::string model = folder.file("tangle.obj", tangle(400));
  const std::string json = (folder / "x.json").string(), svg = (folder / "x.svg").string();
  const std::vector<std::string> arguments{model, "-o", json, "-o", svg, "--arcs", "--join-within", "0"};
  EXPECT_EQ(draw_struck_at("", arguments).stages, std::vector<std::string>());
  const std::set<std::string> whole = segments_of(read_file(json));
  const std::string whole_svg = read_file(svg);
  EXPECT_FALSE(contains(whole_svg, "sheet-partial"));

  const Drawn run = draw_struck_at(GetParam(), arguments);
  EXPECT_EQ(run.error, "");
  ASSERT_FALSE(run.stages.empty());
  EXPECT_EQ(run.stages.front(), GetParam());
  EXPECT_TRUE(contains(read_file(svg), "-sheet-partial\" inkscape:groupmode"));
  EXPECT_LT(read_file(svg).size(), whole_svg.size());
  EXPECT_EQ(JsonReader(read_file(json)).read()["partial"]["stages"].items.at(0).text, GetParam());
  const std::set<std::string> shown = segments_of(read_file(json));
  EXPECT_FALSE(shown.empty());
  EXPECT_LT(shown.size(), whole.size());
  for (const std::string& segment : shown) EXPECT_TRUE(whole.contains(segment)) << segment;
}

INSTANTIATE_TEST_SUITE_P(Stages, StageOfLines,
                         testing::Values("finding intersections", "finding occluders", "hiding lines", "merging lines",
                                         "joining lines", "finding arcs", "fitting dashes", "writing"));

// Each look takes so long that the search is over time again with fewer lines.
TEST(StagesInTime, WithoutTimeForTheSearchTheLongestLinesAreTriedOnAllFaces) {
  const Folder folder;
  const std::string model = folder.file("tangle.obj", tangle(400)), json = (folder / "x.json").string();
  const std::vector<std::string> arguments{model, "-o", json, "--join-within", "0"};
  draw_struck_at("", arguments);
  const std::set<std::string> whole = segments_of(read_file(json));
  double now = 0;
  const auto clock = [&](const std::string& stage, int) {
    if (stage == "finding occluders") now = std::min(now + 0.3, 0.95);
    return now;
  };
  const Drawn run = draw_by(clock, arguments);
  EXPECT_EQ(run.error, "");
  ASSERT_FALSE(run.stages.empty());
  EXPECT_EQ(run.stages.front(), "finding occluders");
  const std::set<std::string> shown = segments_of(read_file(json));
  EXPECT_FALSE(shown.empty());
  for (const std::string& segment : shown) EXPECT_TRUE(whole.contains(segment)) << segment;
}

// The stages before hiding took all of the time, and more: a few lines take hardly any.
TEST(StagesInTime, WithoutAnyTimeForHidingTheLongestLinesAreShown) {
  const Folder folder;
  const std::string model = folder.file("tangle.obj", tangle(400)), json = (folder / "x.json").string();
  const std::vector<std::string> arguments{model, "-o", json, "--join-within", "0"};
  draw_struck_at("", arguments);
  const std::set<std::string> whole = segments_of(read_file(json));
  bool struck = false;
  const auto clock = [&](const std::string& stage, int) {
    struck = struck || stage == "finding occluders";
    return struck ? 1.06 * limit : 0;
  };
  const Drawn run = draw_by(clock, arguments);
  EXPECT_EQ(run.error, "");
  const std::set<std::string> shown = segments_of(read_file(json));
  EXPECT_GE(shown.size(), 20U);
  EXPECT_LT(shown.size(), whole.size());
  for (const std::string& segment : shown) EXPECT_TRUE(whole.contains(segment)) << segment;
}

// No line is missing, but those of a part without its faces are others.
TEST(StagesInTime, WithoutTimeForFacesTheSheetIsMarked) {
  const Folder folder;
  const std::string svg = (folder / "x.svg").string();
  double now = 0.02 * limit;  // when it is read: lines get 2.5 times that for each view, and a part for the rest
  const auto clock = [&](const std::string& stage, int look) {
    if (stage == "recognising faces" && look > 1) now = 0.876 * limit;  // the first look is for what it may take
    return now;
  };
  const Drawn run = draw_by(clock, {sample("shaft.obj"), "--views", "front,top", "-o", svg});
  EXPECT_EQ(run.error, "");
  EXPECT_EQ(run.stages, std::vector<std::string>{"recognising faces"});
  EXPECT_TRUE(contains(read_file(svg), "-sheet-partial\" inkscape:groupmode"));
}

// Recognition takes most of the time, and hiding lines two thirds of the rest: nothing is cut, and no byte differs.
TEST(StagesInTime, WhatFitsIsNotCut) {
  const Folder folder;
  const std::string svg = (folder / "x.svg").string(), json = (folder / "x.json").string();
  const std::vector<std::string> arguments{sample("shaft.obj"), "-o", svg, "-o", json, "--projection", "dimetric"};
  const Drawn whole = draw_struck_at("", arguments);
  const std::string whole_svg = read_file(svg), whole_json = read_file(json);
  double now = 0.02 * limit;  // when it is read
  const auto clock = [&](const std::string& stage, int look) {
    const auto part = [&] { return std::min(1.0, look / static_cast<double>(whole.looks.at(stage))); };
    if (stage == "recognising faces") now = std::max(now, (0.02 + 0.83 * part()) * limit);
    if (stage == "hiding lines") now = std::max(now, (0.85 + 0.095 * part()) * limit);
    return now;
  };
  const Drawn run = draw_by(clock, arguments);
  EXPECT_EQ(run.error, "");
  EXPECT_EQ(run.stages, std::vector<std::string>());
  EXPECT_GE(now, 0.94 * limit);
  EXPECT_EQ(read_file(svg), whole_svg);
  EXPECT_EQ(read_file(json), whole_json);
}

// Reading took so long that recognition would leave no time for lines: it is not begun, and all lines are there. Seen
// so, contours of the part lie between the corners of its mesh.
TEST(StagesInTime, FacesAreNotRecognisedAtTheExpenseOfLines) {
  const Folder folder;
  const std::string json = (folder / "x.json").string();
  const std::vector<std::string> arguments{sample("shaft.obj"), "-o", json, "--projection", "dimetric"};
  const auto drawn = [&](double read) {
    return draw_by([&](const std::string&, int) { return read * limit; }, arguments);
  };
  EXPECT_EQ(drawn(0.15).stages, std::vector<std::string>());
  const std::set<std::string> of_part = segments_of(read_file(json));
  const Drawn run = drawn(0.2);
  EXPECT_EQ(run.error, "");
  EXPECT_EQ(run.stages, std::vector<std::string>{"recognising faces"});
  EXPECT_LE(run.looks.at("recognising faces"), 8);
  const std::set<std::string> shown = segments_of(read_file(json));
  std::vector<std::string> of_mesh = arguments;
  of_mesh.insert(of_mesh.end(), {"--surfaces", "mesh"});
  draw_struck_at("", of_mesh);
  EXPECT_EQ(shown, segments_of(read_file(json)));
  EXPECT_NE(shown, of_part);
}

std::string box(const Vec3& min, const Vec3& max) {
  std::string obj;
  for (int i = 0; i < 8; ++i)
    obj += "v " + std::to_string(i % 2 == 0 ? min.x : max.x) + " " + std::to_string(i / 2 % 2 == 0 ? min.y : max.y) +
           " " + std::to_string(i / 4 == 0 ? min.z : max.z) + "\n";
  return obj + "f -8 -6 -5 -7\nf -4 -3 -1 -2\nf -8 -7 -3 -4\nf -6 -2 -1 -5\nf -8 -4 -2 -6\nf -7 -5 -1 -3\n";
}

// The longest edges are rods behind a wall of bricks.
TEST(StagesInTime, OfLinesForWhichThereIsTimeThoseInSightAreShown) {
  const Folder folder;
  std::string obj;
  for (int x = 0; x < 5; ++x)
    for (int z = 0; z < 5; ++z) {
      const double front = (x + z) % 2 == 0 ? 0 : 3;
      obj += box({3.0 * x, front, 3.0 * z}, {3.0 * x + 3.2, front + 2, 3.0 * z + 3.2});
    }
  for (int i = 0; i < 100; ++i) obj += box({1, 10.0 + i, 1 + 0.1 * i}, {14, 10.5 + i, 1.05 + 0.1 * i});
  const std::string model = folder.file("wall.obj", obj), json = (folder / "x.json").string();
  const std::vector<std::string> arguments{model, "-o", json, "--projection", "front", "--join-within", "0"};
  draw_struck_at("", arguments);
  const std::set<std::string> whole = segments_of(read_file(json));
  bool struck = false;
  const auto clock = [&](const std::string& stage, int) {
    struck = struck || stage == "finding occluders";
    return struck ? 1.06 * limit : 0;
  };
  const Drawn run = draw_by(clock, arguments);
  EXPECT_EQ(run.error, "");
  const std::set<std::string> shown = segments_of(read_file(json));
  int visible = 0;
  for (const std::string& segment : shown) {
    if (!contains(segment, "\"visible\": true")) continue;  // hidden ones may be on lines that are left out
    ++visible;
    EXPECT_TRUE(whole.contains(segment)) << segment;
  }
  EXPECT_GE(visible, 10);
}

// The model is there, though the line at which a leader ends may be one of those that are left out.
TEST(StagesInTime, NoNoteIsRefusedBecauseItsLineIsLeftOut) {
  const Folder folder;
  folder.file("tangle.obj", tangle(150));
  std::string scene = "[[model]]\nfile = \"tangle.obj\"\n[[view]]\nprojection = \"front\"\n";
  for (int vertex = 0; vertex < 40; ++vertex)
    scene += "[[note]]\ntext = \"n\"\nto = [\"tangle\", " + std::to_string(vertex) + "]\n";
  const std::string file = folder.file("scene.toml", scene), svg = (folder / "x.svg").string();
  EXPECT_EQ(draw_struck_at("", {file, "-o", svg}).error, "");
  const Drawn run = draw_struck_at("hiding lines", {file, "-o", svg});
  EXPECT_EQ(run.error, "");
  EXPECT_FALSE(run.stages.empty());
}

class StageBesideLines : public testing::TestWithParam<const char*> {};

// Hatching, dimensions, tests and answers that there is no time for are left out; no line is.
TEST_P(StageBesideLines, IsLeftOut) {
  const Folder folder;
  const std::string json = (folder / "x.json").string(), pdf = (folder / "x.pdf").string();
  const Drawn run = draw_struck_at(GetParam(), {(root() / "samples/bracket.toml").string(), "-o", json, "-o", pdf,
                                                "--centre-lines", "--verify", "--dump", "edges"});
  EXPECT_EQ(run.error, "");
  ASSERT_FALSE(run.stages.empty());
  EXPECT_EQ(run.stages.front(), GetParam());
  EXPECT_FALSE(segments_of(read_file(json)).empty());
  EXPECT_TRUE(read_file(pdf).starts_with("%PDF"));
}

INSTANTIATE_TEST_SUITE_P(Stages, StageBesideLines,
                         testing::Values("verifying", "finding axes", "answering", "placing dimensions", "hatching",
                                         "drawing centre lines"));

TEST(StagesInTime, EveryFormatIsWholeWhenWritingIsCut) {
  const Folder folder;
  const std::string model = folder.file("tangle.obj", tangle(200));
  for (const char* name : {"x.svg", "x.pdf", "x.ps", "x.eps", "x.png", "x.dxf"}) {
    const std::string path = (folder / name).string();
    draw_struck_at("", {model, "-o", path, "--dpi", "50"});
    const std::size_t whole = read_file(path).size();
    const Drawn run = draw_struck_at("writing", {model, "-o", path, "--dpi", "50"});
    EXPECT_EQ(run.stages, std::vector<std::string>{"writing"}) << name;
    EXPECT_NE(read_file(path).size(), whole) << name;
    EXPECT_GT(read_file(path).size(), 1000U) << name;
  }
}

// Four times the triangles: at least twice the looks, where a stage looks once for each of its pieces.
TEST(StagesInTime, BetweenTwoLooksLiesABoundedAmountOfWork) {
  const Folder folder;
  const auto looks = [&](int triangles) {
    const std::string model = folder.file("tangle.obj", tangle(triangles));
    return draw_struck_at("", {model, "-o", (folder / "x.json").string(), "-o", (folder / "x.svg").string(), "--arcs",
                               "--hidden", "dashed", "--dump", "edges"})
        .looks;
  };
  const std::map<std::string, int> few = looks(100), many = looks(400);
  for (const char* stage : {"finding intersections", "hiding lines", "merging lines", "joining lines", "finding arcs",
                            "fitting dashes", "answering", "writing"})
    EXPECT_GE(many.at(stage), 2 * few.at(stage)) << stage;
}

TEST(StagesInTime, ReadingLooksAtTheClockAlongTheFile) {
  const Folder folder;
  std::string stl = "solid s\n", ply = "ply\nformat ascii 1.0\nelement vertex 60000\n", off = "OFF\n60000 20000 0\n";
  ply += "property double x\nproperty double y\nproperty double z\nelement face 20000\n";
  ply += "property list uchar int vertex_indices\nend_header\n";
  std::string vertices, faces;
  for (int f = 0; f < 20000; ++f) {
    const std::string at = std::to_string(f);
    stl += "facet normal 0 0 1\nouter loop\nvertex " + at + " 0 0\nvertex " + at + " 1 0\nvertex 0 0 " + at +
           "\nendloop\nendfacet\n";
    vertices += at + " 0 0\n" + at + " 1 0\n0 0 " + at + "\n";
    faces += "3 " + std::to_string(3 * f) + " " + std::to_string(3 * f + 1) + " " + std::to_string(3 * f + 2) + "\n";
  }
  const std::map<std::string, std::string> files{
      {"m.stl", stl + "endsolid\n"}, {"m.ply", ply + vertices + faces}, {"m.off", off + vertices + faces}};
  for (const auto& [name, text] : files) {
    const std::string model = folder.file(name, text);
    const Drawn run = draw_struck_at("", {model, "-o", (folder / "x.svg").string(), "--edges", "contour"});
    EXPECT_EQ(run.error, "");
    EXPECT_GE(run.looks.at("reading"), 60) << name;
  }
}

}  // namespace
}  // namespace epura::test::stages_in_time_test
