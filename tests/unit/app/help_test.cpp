// SPDX-License-Identifier: Apache-2.0
// Help, version, and the list of projections: answers on standard output.
#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

#include "errors.hpp"
#include "folder.hpp"
#include "program.hpp"

namespace epura::test::help_test {
namespace {

Outcome answer(const std::vector<std::string>& arguments) {
  const Folder folder;
  Outcome run = epura(arguments, folder / "");
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_EQ(run.err, "");
  EXPECT_TRUE(folder.names().empty());
  return run;
}

TEST(Help, IsThereForEverything) {
  for (const char* word : {"draw", "study", "plugins", "--help", "--version", "Exit codes"})
    EXPECT_TRUE(contains(answer({"--help"}).out, word)) << word;
  EXPECT_TRUE(contains(answer({"plugins", "--help"}).out, "--plugin-path"));
  const std::string draw = answer({"draw", "--help"}).out;
  for (const char* option :
       {"--output",    "-o",        "--format",     "--projection", "--plugin-path", "--near",         "--far",
        "--transform", "--unit",    "--up",         "--hidden",     "--edges",       "--crease-angle", "--visibility",
        "--contact",   "--sheet",   "--portrait",   "--landscape",  "--scale",       "--title",        "--plain",
        "--dpi",       "--threads", "--timings",    "--why",        "--dump",        "--progress",     "--time-limit",
        "--svg-text",  "--explain", "--join-within"})
    EXPECT_TRUE(contains(draw, option)) << option;
  EXPECT_EQ(answer({"draw", "-h"}).out, draw);
}

TEST(Help, VersionIsANumberWithTwoDots) {
  const std::string version = answer({"--version"}).out;
  EXPECT_TRUE(version.starts_with("epura "));
  EXPECT_EQ(std::count(version.begin(), version.end(), '.'), 2);
  EXPECT_EQ(version.back(), '\n');
}

TEST(Plugins, ListHasAllProjectionsOfTheProject) {
  const std::string list = answer({"plugins"}).out;
  for (const char* name :
       {"front",       "back",      "left",     "right",    "top",         "bottom",          "auxiliary", "isometric",
        "dimetric",    "trimetric", "cavalier", "cabinet",  "planometric", "oblique",         "one-point", "two-point",
        "three-point", "look-at",   "frustum",  "observer", "phigs",       "vanishing-points"})
    EXPECT_TRUE(contains(list, std::string("\n  ") + name + " ")) << name;
}

TEST(Plugins, EveryOneOfTheListShowsItself) {
  std::istringstream list(answer({"plugins"}).out);
  int shown = 0;
  for (std::string line; std::getline(list, line);) {
    if (!line.starts_with("  ")) continue;
    const std::string name = line.substr(2, line.find(' ', 2) - 2);
    const std::string text = answer({"plugins", name}).out;
    EXPECT_TRUE(text.starts_with(name + " (")) << text;
    EXPECT_TRUE(contains(text, name + ".so")) << text;
    EXPECT_TRUE(contains(text, "M_per") || contains(text, "M_par")) << text;
    EXPECT_TRUE(contains(text, "principal vanishing points: ")) << text;
    ++shown;
  }
  EXPECT_GE(shown, 22);
}

TEST(Plugins, PerspectivesHaveAsManyVanishingPointsAsTheirNamesSay) {
  EXPECT_TRUE(contains(answer({"plugins", "one-point"}).out, "principal vanishing points: 1\n"));
  EXPECT_TRUE(contains(answer({"plugins", "two-point"}).out, "principal vanishing points: 2\n"));
  EXPECT_TRUE(contains(answer({"plugins", "three-point"}).out, "principal vanishing points: 3\n"));
  EXPECT_TRUE(contains(answer({"plugins", "isometric"}).out, "principal vanishing points: 0\n"));
}

TEST(Plugins, TheMatrixIsTheTextbooksOne) {
  // Seen from the front, y is lost: M_par = diag(1, 0, 1, 1), but for the place of the plane.
  std::istringstream text(answer({"plugins", "front"}).out);
  std::vector<std::string> words;
  for (std::string line; std::getline(text, line);)
    if (line.starts_with("    ")) {
      std::istringstream numbers(line);
      for (std::string word; numbers >> word;) words.push_back(word);
    }
  ASSERT_EQ(words.size(), 16U);
  EXPECT_EQ(words[0], words[15]);
  EXPECT_EQ(words[0], words[10]);
  EXPECT_NE(words[0], "0");
  for (const std::size_t zero : {1, 2, 3, 4, 5, 6, 8, 9, 11, 12, 13, 14}) EXPECT_EQ(words[zero], "0") << zero;
}

TEST(Plugins, AFolderOfBadOnesIsToldAndTheRestIsListed) {
  const Folder folder;
  folder.file("junk.so", "this is not a library");
  const Outcome run = epura({"plugins", "--plugin-path", "."}, folder / "");
  EXPECT_EQ(run.code, 0);
  EXPECT_TRUE(contains(run.err, "junk.so")) << run.err;
  EXPECT_TRUE(contains(run.out, "isometric"));
}

}  // namespace
}  // namespace epura::test::help_test
