// SPDX-License-Identifier: Apache-2.0
// epura snapshot, as users run it.
#include <gtest/gtest.h>
#include <sys/stat.h>

#include "errors.hpp"
#include "folder.hpp"
#include "golden.hpp"
#include "program.hpp"
#include "variable.hpp"

namespace epura::test::snapshot_test {
namespace {

namespace fs = std::filesystem;

/// Copies of golden cases, to be broken.
struct Suite {
  Folder folder;

  explicit Suite(const std::vector<std::string>& cases) {
    fs::create_directory(folder / "cases");
    fs::copy(fs::path(EPURA_TEST_GOLDEN) / "models", folder / "cases/models");
    for (const std::string& name : cases)
      fs::copy(golden_folder(name), folder / "cases" / name, fs::copy_options::recursive);
  }

  [[nodiscard]] Outcome run(std::vector<std::string> options = {}) const {
    options.insert(options.begin(), {"snapshot", "cases"});
    return epura(options, folder / "");
  }
  [[nodiscard]] std::string read(const std::string& name) const { return read_file(folder / name); }
  void write(const std::string& name, const std::string& text) const { write_file(folder / name, text); }

  /// Takes the line that begins with `begin` out of a file.
  void drop_line(const std::string& name, const std::string& begin) const {
    std::string text = read(name);
    const std::size_t from = text.find(begin);
    ASSERT_NE(from, std::string::npos);
    write(name, text.erase(from, text.find('\n', from) + 1 - from));
  }
};

constexpr const char* edge_1_5 = "    {\"from\": [153.5, 64.1751709536137], \"to\": [153.5, 105]";

TEST(SnapshotCommand, ReportsTheLineThatDiffers) {
  const Suite suite({"cube-isometric", "cube-cavalier"});
  suite.drop_line("cases/cube-isometric/expected.json", edge_1_5);
  const Outcome run = suite.run({"--report", "r.html", "--junit", "r.xml"});
  EXPECT_EQ(run.code, 1);
  EXPECT_EQ(run.out,
            "ok        cube-cavalier/expected.json\n"
            "DIFFERENT cube-isometric/expected.json\n"
            "  added      isometric: visible line, 40.825 mm, (153.5, 64.175) to (153.5, 105), edge 0:1-5\n"
            "  1 difference above 0.001 mm: 1 added\n"
            "1 of 2 as expected\n");
  const std::string html = suite.read("r.html"), xml = suite.read("r.xml");
  EXPECT_TRUE(contains(html, "added      isometric: visible line, 40.825 mm"));
  EXPECT_TRUE(contains(html, "<figcaption>overlay</figcaption><img"));
  EXPECT_TRUE(contains(xml, "tests=\"2\" failures=\"1\" errors=\"0\"")) << xml;
  EXPECT_TRUE(contains(xml, "<failure message=\"added      isometric")) << xml;
  EXPECT_TRUE(contains(xml, "name=\"cube-cavalier/expected.json\"/>")) << xml;
}

TEST(SnapshotCommand, AcceptsWhatDiffersAndWhatIsNew) {
  const Variable no_ci("CI", nullptr);
  const Suite suite({"cube-isometric", "cube-cavalier"});
  const std::string old = suite.read("cases/cube-cavalier/expected.json");
  suite.drop_line("cases/cube-isometric/expected.json", edge_1_5);
  fs::create_directory(suite.folder / "cases/new");
  suite.write("cases/new/scene.toml", "[[model]]\nfile = \"../models/cube.obj\"\n");
  EXPECT_TRUE(contains(suite.run().out, "NEW       new/expected.svg"));
  const Outcome run = suite.run({"--accept"});
  EXPECT_EQ(run.code, 0) << run.out;
  EXPECT_TRUE(contains(run.out, "accepted  cube-isometric/expected.json"));
  EXPECT_TRUE(contains(run.out, "3 of 3 as expected"));
  EXPECT_TRUE(contains(suite.read("cases/new/expected.svg"), "<svg"));
  EXPECT_EQ(suite.read("cases/cube-cavalier/expected.json"), old);
  EXPECT_EQ(suite.run().code, 0);
}

TEST(SnapshotCommand, AcceptsNothingInCi) {
  const Variable ci("CI", "true");
  const Suite suite({"cube-isometric"});
  suite.drop_line("cases/cube-isometric/expected.json", edge_1_5);
  const std::string before = suite.read("cases/cube-isometric/expected.json");
  const Outcome run = suite.run({"--accept"});
  EXPECT_EQ(run.code, 2);
  EXPECT_TRUE(contains(run.err, "CI is set")) << run.err;
  EXPECT_EQ(suite.read("cases/cube-isometric/expected.json"), before);
}

TEST(SnapshotCommand, TellsWhyACaseIsNotDrawn) {
  const Suite suite({"cube-isometric", "cube-cavalier"});
  suite.write("cases/cube-isometric/scene.toml", "[[model]]\nfile = \"missing.obj\"\n");
  suite.write("cases/cube-cavalier/options", "--no-such-option\n");
  const Outcome run = suite.run({"--junit", "r.xml"});
  EXPECT_EQ(run.code, 1);
  EXPECT_TRUE(contains(run.out, "FAILED    cube-cavalier/expected.json\n  unknown option '--no-such-option'\n"))
      << run.out;
  EXPECT_TRUE(contains(run.out, "missing.obj")) << run.out;
  EXPECT_TRUE(contains(suite.read("r.xml"), "failures=\"0\" errors=\"2\"")) << suite.read("r.xml");
}

// One of each nature that is none of a drawing, and ways to say it.
const std::vector<std::string>& options_of_strangers() {
  static const std::vector<std::string> options{"-o ../outside.svg",  "-o../outside.svg",    "--output=../outside.svg",
                                                "--plugin-path .",    "../../../secret.obj", "-- ../secret.obj",
                                                "--title a -o b.svg", "--format pdf",        "--time-limit 1",
                                                "--why @1,1",         "--dump spans",        "--verify --threads 3",
                                                "--progress=always",  "--explain",           "--help"};
  return options;
}

TEST(SnapshotOfAStranger, TakesOptionsOfTheDrawingAlone) {
  const Suite suite({"cube-isometric"});
  fs::copy(std::string(EPURA_TEST_BAD_PLUGINS) + "/mark/plain.so", suite.folder / "cases/cube-isometric/plain.so");
  const Variable mark("EPURA_TEST_MARK", (suite.folder / "mark").c_str());
  const auto names = suite.folder.names();
  for (const std::string& options : options_of_strangers()) {
    suite.write("cases/cube-isometric/options", options + "\n");
    const Outcome run = suite.run();
    EXPECT_EQ(run.code, 1) << options;
    EXPECT_TRUE(contains(run.out, "FAILED    cube-isometric/expected.json\n")) << run.out;
    EXPECT_TRUE(contains(run.out, "not an option") || contains(run.out, "unknown option")) << run.out;
    EXPECT_EQ(suite.folder.names(), names) << options;
  }
  suite.write("cases/cube-isometric/options", "--projection plain --plugin-path cases/cube-isometric");
  EXPECT_EQ(suite.run().code, 1);
  EXPECT_FALSE(fs::exists(suite.folder / "mark"));
}

TEST(SnapshotOfAStranger, MaySayEverythingOfTheDrawing) {
  const Suite suite({"cube-isometric"});
  suite.write("cases/cube-isometric/options", "--hidden none --sheet A3\n--title T --decimals 2\t--arcs --scale=1:1");
  EXPECT_TRUE(contains(suite.run().out, "DIFFERENT cube-isometric/expected.json")) << suite.run().out;
}

/// Replaces a file by a link to a copy that lies outside.
void lead_outside(const Suite& suite, const std::string& name) {
  fs::copy(suite.folder / name, suite.folder / "outside");
  fs::remove(suite.folder / name);
  fs::create_symlink(suite.folder / "outside", suite.folder / name);
}

TEST(SnapshotOfAStranger, FollowsNoLinkThatLeadsOut) {
  const Variable no_ci("CI", nullptr);
  for (const char* name : {"cases/cube-isometric/scene.toml", "cases/cube-isometric/options",
                           "cases/cube-isometric/expected.json", "cases/models/cube.obj"}) {
    const Suite suite({"cube-isometric"});
    suite.write("cases/cube-isometric/options", "--hidden none");
    lead_outside(suite, name);
    const std::string before = suite.read("outside");
    const Outcome run = suite.run({"--accept"});
    EXPECT_EQ(run.code, 1) << name;
    EXPECT_TRUE(contains(run.out, fs::path(name).filename().string() + ": is a link that leaves ")) << run.out;
    EXPECT_EQ(suite.read("outside"), before) << name;
  }
}

// Not only models: everything that a scene or the options of a case name.
TEST(SnapshotOfAStranger, FollowsNoLinkOfASheetThatLeadsOut) {
  const std::string scene = "[[model]]\nfile = \"../models/cube.obj\"\n[[view]]\nprojection = \"isometric\"\n";
  for (const char* key : {"style", "template", "logo", "font"}) {
    const Suite suite({"cube-isometric"});
    suite.write("outside", "");
    fs::create_symlink("../../outside", suite.folder / "cases/cube-isometric/link.ttf");
    suite.write("cases/cube-isometric/scene.toml", scene + "[[sheet]]\n" + key + " = \"link.ttf\"\n");
    EXPECT_TRUE(contains(suite.run().out, "link.ttf: is a link that leaves ")) << key << suite.run().out;
    suite.write("cases/cube-isometric/scene.toml", scene);
    for (const char* between : {" ", "="}) {
      suite.write("cases/cube-isometric/options",
                  std::string("--") + key + between + "cases/cube-isometric/link.ttf\n");
      EXPECT_TRUE(contains(suite.run().out, "link.ttf: is a link that leaves ")) << key << suite.run().out;
    }
  }
}

TEST(SnapshotCommand, TakesPluginsOfTheUser) {
  const Suite suite({"cube-isometric"});
  suite.write("cases/cube-isometric/scene.toml",
              "[[model]]\nfile = \"../models/cube.obj\"\n[[view]]\nprojection = \"plain\"\n");
  const std::string plugins = std::string(EPURA_TEST_BAD_PLUGINS) + "/good";
  EXPECT_TRUE(contains(suite.run().out, "plain: no such projection")) << suite.run().out;
  EXPECT_TRUE(contains(suite.run({"--plugin-path", plugins}).out, "DIFFERENT cube-isometric/expected.json"))
      << suite.run({"--plugin-path", plugins}).out;
}

TEST(SnapshotOfAStranger, WritesNothingThroughLinksThatLeadOut) {
  const Variable no_ci("CI", nullptr);
  const Suite suite({"cube-isometric"});
  fs::remove(suite.folder / "cases/cube-isometric/expected.json");
  fs::create_symlink("../../outside.svg", suite.folder / "cases/cube-isometric/expected.svg");
  EXPECT_EQ(suite.run({"--accept"}).code, 1);
  EXPECT_FALSE(fs::exists(suite.folder / "outside.svg"));
  fs::create_directory(suite.folder / "elsewhere");
  fs::rename(suite.folder / "cases/cube-isometric", suite.folder / "elsewhere/case");
  fs::create_symlink("../elsewhere/case", suite.folder / "cases/case");
  EXPECT_TRUE(contains(suite.run().out, "cases/case: is a link that leaves ")) << suite.run().out;
}

TEST(SnapshotOfAStranger, MayHaveLinksWithinItsFolder) {
  const Suite suite({"cube-isometric"});
  fs::rename(suite.folder / "cases/models/cube.obj", suite.folder / "cases/models/body.obj");
  fs::create_symlink("body.obj", suite.folder / "cases/models/cube.obj");
  fs::create_directory_symlink("cases", suite.folder / "link");
  EXPECT_EQ(suite.run().code, 0) << suite.run().out;
  EXPECT_EQ(epura({"snapshot", "link"}, suite.folder / "").code, 0);
}

TEST(SnapshotOfAStranger, SaysNothingThatTerminalsObey) {
  const Suite suite({"cube-isometric"});
  fs::rename(suite.folder / "cases/cube-isometric", suite.folder / "cases/\x1b[2Jcube");
  const Outcome run = suite.run();
  EXPECT_TRUE(contains(run.out, "ok        \xEF\xBF\xBD[2Jcube/expected.json")) << run.out;
}

TEST(SnapshotCommand, OverwritesNoFileOfACase) {
  const Suite suite({"cube-isometric"});
  fs::create_symlink("cases/models/cube.obj", suite.folder / "r.html");
  for (const std::vector<std::string>& options :
       {std::vector<std::string>{"--report", "cases/cube-isometric/scene.toml"},
        {"--report", "r.html"},
        {"--junit", "./cases/cube-isometric/../cube-isometric/expected.json"},
        {"--report", "new", "--junit", "./new"}}) {
    const Outcome run = suite.run(options);
    EXPECT_EQ(run.code, 2) << run.out;
    EXPECT_TRUE(contains(run.err, "write to another file")) << run.err;
  }
  EXPECT_EQ(suite.run().code, 0);
}

TEST(SnapshotCommand, SaysTheSameForAnyNumberOfThreads) {
  const Suite suite({"cube-isometric", "cube-cavalier", "house-one-point", "section-hollow"});
  suite.drop_line("cases/cube-isometric/expected.json", edge_1_5);
  const Outcome one = suite.run({"--threads", "1", "--report", "one.html"});
  const Outcome many = suite.run({"--threads", "4", "--report", "many.html"});
  EXPECT_EQ(one.out, many.out);
  EXPECT_EQ(suite.read("one.html"), suite.read("many.html"));
}

TEST(SnapshotCommand, RefusesFoldersWithoutCases) {
  const Suite suite({"cube-isometric"});
  const auto refusal = [&](const std::string& folder) {
    const Outcome run = epura({"snapshot", folder}, suite.folder / "");
    EXPECT_EQ(run.code, 2);
    return run.err;
  };
  EXPECT_TRUE(contains(refusal("cases/models"), "contains no case"));
  EXPECT_TRUE(contains(refusal("missing"), "is not a folder"));
  EXPECT_TRUE(contains(refusal(std::string(300, 'a')), "is not a folder"));
  EXPECT_EQ(epura({"snapshot", "cases/cube-isometric"}, suite.folder / "").code, 0);
}

TEST(SnapshotCommand, FindsCasesInFoldersAndBehindLinks) {
  const Suite suite({"cube-isometric"});
  fs::create_directories(suite.folder / "cases/deep/deeper");
  fs::rename(suite.folder / "cases/cube-isometric", suite.folder / "cases/deep/deeper/cube");
  fs::copy(suite.folder / "cases/models", suite.folder / "cases/deep/deeper/models");
  fs::create_directory_symlink("deep/deeper/cube", suite.folder / "cases/another");
  fs::create_directory_symlink("..", suite.folder / "cases/deep/up");
  const Outcome run = suite.run();
  EXPECT_EQ(run.out,
            "ok        another/expected.json\n"
            "ok        deep/deeper/cube/expected.json\n"
            "2 of 2 as expected\n")
      << run.err;
}

TEST(SnapshotCommand, DoesNotWaitForWhatIsNoRegularFile) {
  for (const char* name : {"options", "expected.svg"}) {
    const Suite suite({"cube-isometric"});
    const fs::path pipe = suite.folder / "cases/cube-isometric" / name;
    ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
    const Outcome run = suite.run();
    EXPECT_NE(run.code, 0);
    EXPECT_TRUE(contains(run.out + run.err, std::string(name) + ": is not a regular file")) << run.out << run.err;
  }
}

}  // namespace
}  // namespace epura::test::snapshot_test
