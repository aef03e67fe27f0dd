// SPDX-License-Identifier: Apache-2.0
// What the program, its workers and the plugins that it tests can open. The projection `mark` creates a file when it is
// loaded, in whichever process that is.
#include "foreign/sandbox.hpp"

#include <gtest/gtest.h>

#include <cstdlib>

#include "base/file.hpp"
#include "folder.hpp"
#include "program.hpp"

namespace epura::test::sandbox_test {
namespace {

namespace fs = std::filesystem;

const std::string mark_folder = EPURA_TEST_BAD_PLUGINS "/mark";
const std::string cube =
    "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\n"
    "f 1 4 3 2\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n";

class Sandbox : public testing::Test {
 protected:
  void SetUp() override {
    if (const std::string reason = foreign::reason_for_no_sandbox(); !reason.empty()) GTEST_SKIP() << reason;
    fs::create_directory(folder_ / "parts");
    folder_.file("parts/cube.obj", cube);
    fs::create_directory(folder_ / "out");
    fs::create_directory(folder_ / "elsewhere");
    ::setenv("EPURA_TEST_MARK", (folder_ / "elsewhere/mark").c_str(), 1);
  }
  void TearDown() override { ::unsetenv("EPURA_TEST_MARK"); }

  /// Runs the program on the cube, with the projection.
  [[nodiscard]] Outcome run(std::vector<std::string> words) const {
    words.insert(words.end(), {"--plugin-path", mark_folder, "--projection", "plain"});
    return epura(words, folder_ / "");
  }
  [[nodiscard]] bool has_mark() const { return fs::exists(folder_ / "elsewhere/mark"); }

  const Folder folder_;
};

TEST_F(Sandbox, ProgramOpensOnlyWhatItIsGivenIfAsked) {
  const Outcome free = run({"draw", "parts/cube.obj", "-o", "out/free.svg"});
  EXPECT_EQ(free.code, 0) << free.err;
  EXPECT_TRUE(has_mark());
  fs::remove(folder_ / "elsewhere/mark");
  const Outcome confined = run({"draw", "parts/cube.obj", "-o", "out/confined.svg", "--sandbox", "on"});
  EXPECT_EQ(confined.code, 0) << confined.err;
  EXPECT_FALSE(has_mark());
  EXPECT_EQ(read_file(folder_ / "out/free.svg"), read_file(folder_ / "out/confined.svg"));
}

TEST_F(Sandbox, SeveralDrawingsHaveTheFoldersOfAll) {
  folder_.file("elsewhere/other.obj", cube);
  const Outcome outcome =
      epura({"draw", "parts/cube.obj", "elsewhere/other.obj", "-o", "out/{name}.svg", "--sandbox", "on"}, folder_ / "");
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(read_file(folder_ / "out/cube.svg").empty(), false);
  EXPECT_EQ(read_file(folder_ / "out/other.svg").empty(), false);
}

TEST_F(Sandbox, WorkersOfABatchAreConfined) {
  const std::vector<std::string> batch{"batch", "parts/cube.obj", "-o", "out/a/{name}.svg", "--report", "report.html"};
  const Outcome confined = run(batch);
  EXPECT_EQ(confined.code, 0) << confined.out << confined.err;
  EXPECT_TRUE(fs::exists(folder_ / "out/a/cube.svg"));
  EXPECT_FALSE(has_mark());
  std::vector<std::string> without = batch;
  without.insert(without.end(), {"--sandbox", "off", "--again"});
  EXPECT_EQ(run(without).code, 0);
  EXPECT_TRUE(has_mark());
}

TEST_F(Sandbox, PluginsThatAreTestedAreConfined) {
  const Outcome outcome = epura({"plugins", "check", mark_folder + "/plain.so"}, folder_ / "");
  EXPECT_EQ(outcome.code, 0) << outcome.out << outcome.err;
  EXPECT_FALSE(has_mark());
}

/// What drawings need of the system is there: importers, fonts in other scripts, libraries of output formats.
TEST_F(Sandbox, DrawsEverythingAllTheSame) {
  fs::copy(root() / "samples/step/clamp.step", folder_ / "parts/clamp.step");
  const std::vector<std::string> formats{"pdf", "png", "html", "dxf", "json"};
  for (const std::string name : {"cube.obj", "clamp.step"}) {
    const auto draw = [&](const std::string& output, const std::string& sandbox) {
      std::vector<std::string> words{"draw",    "parts/" + name, "--views",   "front,top,isometric",
                                     "--title", "軸受 محور",     "--sandbox", sandbox};
      for (const std::string& format : formats) words.insert(words.end(), {"-o", output + "." + format});
      const Outcome outcome = epura(words, folder_ / "");
      EXPECT_EQ(outcome.code, 0) << outcome.err;
    };
    draw("free", "off");
    draw("confined", "on");
    for (const std::string& format : formats)
      EXPECT_EQ(read_file(folder_ / ("free." + format)), read_file(folder_ / ("confined." + format))) << name << format;
  }
}

class FilesOfScenes : public testing::Test {
 protected:
  void SetUp() override {
    folder_.file("secret.obj", cube);
    fs::create_directory(folder_ / "scenes");
  }

  [[nodiscard]] Outcome draw(const std::string& model, const std::vector<std::string>& more = {}) const {
    folder_.file("scenes/a.toml", "[[model]]\nfile = \"" + model + "\"\n[[view]]\nprojection = \"front\"\n");
    std::vector<std::string> words{"draw", "scenes/a.toml", "-o", "a.svg"};
    words.insert(words.end(), more.begin(), more.end());
    return epura(words, folder_ / "");
  }

  const Folder folder_;
};

TEST_F(FilesOfScenes, LieBelowTheFolderOfTheScene) {
  const Outcome outcome = draw("../secret.obj");
  EXPECT_EQ(outcome.code, 2);
  EXPECT_NE(outcome.err.find("scenes/a.toml:2:8: '../secret.obj' lies outside the folder of the scene file"),
            std::string::npos)
      << outcome.err;
  EXPECT_NE(outcome.err.find("--allow-outside"), std::string::npos) << outcome.err;
  EXPECT_FALSE(fs::exists(folder_ / "a.svg"));
}

TEST_F(FilesOfScenes, AbsolutePathsAndLinksLeadOutside) {
  EXPECT_EQ(draw((folder_ / "secret.obj").string()).code, 2);
  fs::create_symlink(folder_ / "secret.obj", folder_ / "scenes/link.obj");
  EXPECT_EQ(draw("link.obj").code, 2);
}

TEST_F(FilesOfScenes, LieAnywhereIfAllowed) {
  EXPECT_EQ(draw("../secret.obj", {"--allow-outside"}).code, 0);
  folder_.file("scenes/inside.obj", cube);
  EXPECT_EQ(draw("inside.obj").code, 0);
}

TEST(FoldersOfPlugins, EveryoneCanWriteToAreRefused) {
  const Folder folder;
  fs::create_directory(folder / "open");
  fs::permissions(folder / "open", fs::perms::all);
  const Outcome outcome = epura({"plugins", "--plugin-path", "open"}, folder / "");
  EXPECT_EQ(outcome.code, 3);
  EXPECT_NE(outcome.err.find("open: everyone can put plugins into this folder"), std::string::npos) << outcome.err;
  fs::permissions(folder / "open", fs::perms::owner_all);
  EXPECT_EQ(epura({"plugins", "--plugin-path", "open"}, folder / "").code, 0);
}

TEST(FoldersOfPlugins, WithAPluginThatEveryoneCanChangeAreRefused) {
  const Folder folder;
  fs::create_directory(folder / "mine");
  fs::copy(mark_folder + "/plain.so", folder / "mine");
  const auto list = [&] { return epura({"plugins", "--plugin-path", "mine"}, folder / ""); };
  EXPECT_EQ(list().code, 0);
  fs::permissions(folder / "mine/plain.so", fs::perms::others_write, fs::perm_options::add);
  const Outcome outcome = list();
  EXPECT_EQ(outcome.code, 3);
  EXPECT_NE(outcome.err.find("mine/plain.so: everyone can change this plugin"), std::string::npos) << outcome.err;
}

TEST(FoldersOfPlugins, WithALinkToAPluginThatEveryoneCanReplaceAreRefused) {
  const Folder folder;
  for (const char* name : {"mine", "open"}) fs::create_directory(folder / name);
  fs::copy(mark_folder + "/plain.so", folder / "open");
  fs::create_symlink("../open/plain.so", folder / "mine/plain.so");
  const auto list = [&] { return epura({"plugins", "--plugin-path", "mine"}, folder / ""); };
  EXPECT_EQ(list().code, 0);
  fs::permissions(folder / "open", fs::perms::all);
  const Outcome outcome = list();
  EXPECT_EQ(outcome.code, 3);
  EXPECT_NE(outcome.err.find("mine/plain.so: everyone can replace"), std::string::npos) << outcome.err;
}

}  // namespace
}  // namespace epura::test::sandbox_test
