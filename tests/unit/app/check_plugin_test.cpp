// SPDX-License-Identifier: Apache-2.0
// `epura plugins check`, and plugins that hang or crash.
#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <thread>

#include "errors.hpp"
#include "folder.hpp"
#include "program.hpp"

namespace epura::test::check_plugin_test {
namespace {

std::string built(const std::string& name) { return EPURA_TEST_PLUGINS "/" + name + ".so"; }
std::string bad(const std::string& folder) { return EPURA_TEST_BAD_PLUGINS "/" + folder; }

Outcome check(const std::string& file) {
  const Folder folder;
  return epura({"plugins", "check", file, "--time-limit", "1"}, folder / "");
}

TEST(CheckPlugin, PrintsATableOfWhatHolds) {
  const Outcome run = check(built("two-point"));
  EXPECT_EQ(run.code, 0) << run.out;
  EXPECT_EQ(run.err, "");
  EXPECT_TRUE(run.out.starts_with("two-point (perspective)\n  answers     passed   the defaults")) << run.out;
  EXPECT_TRUE(contains(run.out, "\n  vanishing   passed   parallels meet"));
  EXPECT_FALSE(contains(run.out, "FAILED"));
}

TEST(CheckPlugin, NamesWhatFails) {
  const Outcome run = check(bad("ignores") + "/plain.so");
  EXPECT_EQ(run.code, 1);
  EXPECT_TRUE(contains(run.out, "\n  parameters  FAILED   each parameter matters\n")) << run.out;
  EXPECT_TRUE(contains(run.out, "  scale changes nothing\n")) << run.out;
  EXPECT_TRUE(contains(run.out, "\n  bounds      passed")) << run.out;
}

TEST(CheckPlugin, RefusesWhatCannotBeLoaded) {
  const Folder folder;
  const std::vector<std::pair<std::string, std::string>> refused{
      {folder.file("junk.so", "this is not a library"), "file too short"},
      {(folder / "none.so").string(), "No such file"},
      {bad("other-abi") + "/plain.so", "is built for plugin ABI 9, this program has 1"},
      {bad("crashes") + "/plain.so", "crashes (Aborted) while loading"},
      {bad("exits") + "/plain.so", "exits while loading"},
      {bad("hangs") + "/plain.so", "takes more than 1 s while loading"}};
  for (const auto& [file, reason] : refused) {
    const Outcome run = check(file);
    EXPECT_EQ(run.code, 3) << file;
    EXPECT_EQ(run.out, "") << file;
    EXPECT_TRUE(contains(run.err, file + ": ") && contains(run.err, reason)) << run.err;
  }
}

TEST(CheckPlugin, OutlivesWhatAPluginDoes) {
  const std::vector<std::pair<std::string, std::string>> deeds{{"crashes-when-asked", "crashes (Aborted)"},
                                                               {"exits-when-asked", "exits"},
                                                               {"hangs-when-asked", "takes more than 1 s"},
                                                               {"rounds-up", "leaves another rounding mode"}};
  for (const auto& [folder, deed] : deeds) {
    const Outcome run = check(bad(folder) + "/plain.so");
    EXPECT_EQ(run.code, 1) << folder;
    EXPECT_TRUE(run.out.starts_with("plain (test)\n  answers     FAILED ")) << run.out;
    EXPECT_TRUE(contains(run.out, "plain.so: 'plain' " + deed)) << run.out;
  }
}

TEST(CheckPlugin, DoesNotWaitForTheEndOfAPlugin) {
  const auto start = std::chrono::steady_clock::now();
  EXPECT_EQ(check(bad("hangs-at-its-end") + "/plain.so").code, 0);
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(5));
}

Outcome draw_by(const std::string& folder) {
  const Folder here;
  return epura({"draw", sample("bracket.obj"), "--projection", "plain", "--plugin-path", bad(folder), "-o", "-",
                "--format", "svg"},
               here / "");
}

TEST(DrawingByAPlugin, IsTheSameWhateverElseThePluginDoes) {
  const Outcome good = draw_by("good");
  ASSERT_EQ(good.code, 0) << good.err;
  for (const char* folder : {"rounds-up-when-loaded", "hangs-at-its-end", "prints", "escapes"}) {
    const Outcome run = draw_by(folder);
    EXPECT_EQ(run.code, 0) << folder << run.err;
    EXPECT_EQ(run.out, good.out) << folder;
  }
}

TEST(DrawingByAPlugin, NeverEndsWellWithoutADrawing) {
  for (const char* folder :
       {"exits", "exits-when-asked", "crashes", "crashes-when-asked", "garbage-name", "rounds-up"}) {
    const Outcome run = draw_by(folder);
    EXPECT_EQ(run.code, 3) << folder;
    EXPECT_EQ(run.out, "") << folder;
    EXPECT_TRUE(contains(run.err, bad(folder) + "/plain.so: ")) << run.err;
  }
}

TEST(WordsOfAPlugin, AreFitForTerminalsEverywhere) {
  const Folder folder;
  const std::vector<std::vector<std::string>> commands{
      {"plugins", "--plugin-path", bad("escapes")},
      {"plugins", "plain", "--plugin-path", bad("escapes")},
      {"manual", "--plugin-path", bad("escapes")},
      {"completion", "words", "--", "draw", "--plugin-path", bad("escapes"), "--projection", "pl"},
      {"draw", sample("bracket.obj"), "--plugin-path", bad("escapes"), "--projection", "plain:scale=2", "-o", "x.svg"}};
  for (const std::vector<std::string>& command : commands) {
    const Outcome run = epura(command, folder / "");
    const std::string said = run.out + run.err;
    EXPECT_TRUE(contains(said, "[2Jb")) << command[0] << said;
    EXPECT_EQ(said.find('\x1b'), std::string::npos) << command[0];
    EXPECT_FALSE(contains(said, "\xC2\x9B") || contains(said, "\xE2\x80\xAE") || contains(said, "\nepura: e")) << said;
  }
}

TEST(CrashingPlugin, IsNamedInTheListAndHidesNoOther) {
  const Folder folder;
  const Outcome run = epura({"plugins", "--plugin-path", bad("crashes")}, folder / "");
  EXPECT_EQ(run.code, 0);
  EXPECT_TRUE(contains(run.err, "plain.so: crashes (Aborted) while loading")) << run.err;
  EXPECT_TRUE(contains(run.out, "isometric"));
}

TEST(PluginOfTheCurrentFolder, IsNotFound) {
  const Outcome run =
      epura({"draw", sample("bracket.obj"), "--projection", "plain", "-o", "-", "--format", "svg"}, bad("good"));
  EXPECT_EQ(run.code, 2);
  EXPECT_EQ(run.out, "");
  EXPECT_TRUE(contains(run.err, "plain: no such projection")) << run.err;
}

TEST(HangingPlugin, IsLeftByCtrlC) {
  const std::vector<std::vector<std::string>> commands{
      {"plugins", "plain"}, {"draw", sample("bracket.obj"), "--projection", "plain", "-o", "x.svg"}};
  for (std::vector<std::string> command : commands) {
    const Folder folder;
    command.insert(command.end(), {"--plugin-path", bad("hangs")});
    Running run(command, folder / "");
    std::this_thread::sleep_for(std::chrono::milliseconds(300));
    const auto start = std::chrono::steady_clock::now();
    run.signal(SIGINT);
    EXPECT_EQ(run.wait().code, 130) << command[0];
    EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(2)) << command[0];
    EXPECT_TRUE(folder.names().empty());
  }
}

TEST(NewProjection, RefusesNamesThatAreNone) {
  const Folder folder;
  for (const char* name : {"Two Points", "../outside", "", "a_b"}) {
    const Outcome run = epura({"new-projection", name}, folder / "");
    EXPECT_EQ(run.code, 2) << name;
    EXPECT_TRUE(contains(run.err, "is not a valid projection name")) << run.err;
  }
  EXPECT_TRUE(folder.names().empty());
}

}  // namespace
}  // namespace epura::test::check_plugin_test
