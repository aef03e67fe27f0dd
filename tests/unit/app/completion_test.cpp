// SPDX-License-Identifier: Apache-2.0
// Completion: what the program answers to the scripts of the shells. tests/completion.sh runs those in their shells.
#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

#include "errors.hpp"
#include "folder.hpp"
#include "program.hpp"

namespace epura::test::completion_test {
namespace {

using Words = std::vector<std::string>;

std::string answer(const Words& words) {
  Words arguments{"completion", "words", "--"};
  arguments.insert(arguments.end(), words.begin(), words.end());
  const Folder folder;
  const Outcome run = epura(arguments, folder / "");
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_EQ(run.err, "");
  return run.out;
}

Words candidates(const Words& words) {
  std::istringstream lines(answer(words));
  Words found;
  for (std::string line; std::getline(lines, line);) found.push_back(line.substr(0, line.find('\t')));
  return found;
}

bool has(const Words& words, const std::string& word) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

TEST(Completion, OfCommands) {
  const Words all = candidates({""});
  for (const char* name :
       {"draw", "explain", "info", "compare", "snapshot", "plugins", "serve", "study", "manual", "completion"})
    EXPECT_TRUE(has(all, name)) << name;
  EXPECT_EQ(candidates({"dr"}), Words{"draw"});
  EXPECT_EQ(candidates({"study", "acc"}), Words{"accuracy"});
  EXPECT_EQ(candidates({"completion", ""}), (Words{"bash", "zsh", "fish"})) << "what scripts ask is hidden";
}

TEST(Completion, OfOptionsHasThoseOfTheHelp) {
  const Folder folder;
  for (const char* command : {"draw", "info", "compare", "snapshot", "plugins", "serve"}) {
    std::istringstream help(epura({command, "--help"}, folder / "").out);
    const Words all = candidates({command, "--"});
    std::size_t named = 0;
    for (std::string line; std::getline(help, line);) {
      // "  -o,--output FILE   ...": names stand first.
      const std::size_t begin = line.find_first_not_of(' ');
      if (begin == std::string::npos || line[begin] != '-') continue;
      const std::size_t option = line.find("--", begin);
      const std::string name = line.substr(option, line.find_first_of(" {[=,", option) - option);
      EXPECT_TRUE(has(all, name)) << command << " " << name;
      ++named;
    }
    EXPECT_EQ(named, all.size()) << command;
  }
  EXPECT_EQ(candidates({"draw", "part.stl", "--crease"}), Words{"--crease-angle"});
  EXPECT_TRUE(has(candidates({"draw", "-"}), "-o"));
}

TEST(Completion, TellsTheHelpBehindATab) {
  EXPECT_TRUE(contains(answer({"draw", "--hid"}), "--hidden\tstyle of hidden lines")) << answer({"draw", "--hid"});
}

TEST(Completion, OfFilesAndFoldersIsLeftToTheShell) {
  EXPECT_EQ(answer({"draw", ""}), ":files\n");
  EXPECT_EQ(answer({"draw", "part.stl", "oth"}), ":files\n");
  EXPECT_EQ(answer({"draw", "-o", ""}), ":files\n");
  EXPECT_EQ(answer({"draw", "--output=pa"}), ":files\n");
  EXPECT_EQ(answer({"compare", "a.svg", ""}), ":files\n");
  EXPECT_EQ(answer({"draw", "--plugin-path", ""}), ":folders\n");
  EXPECT_EQ(answer({"snapshot", ""}), ":folders\n");
  EXPECT_EQ(answer({"compare", "a.svg", "b.svg", ""}), "") << "it takes two";
  EXPECT_EQ(answer({"draw", "--dpi", ""}), "") << "any number will do";
}

TEST(Completion, OfProjectionsAndTheirParametersAsksThePlugins) {
  EXPECT_EQ(candidates({"draw", "--projection", "cab"}), Words{"cabinet"});
  EXPECT_EQ(candidates({"draw", "--projection=cab"}), Words{"--projection=cabinet"});
  EXPECT_EQ(candidates({"plugins", "two"}), Words{"two-point"});
  EXPECT_EQ(candidates({"draw", "--views", "front,to"}), Words{"front,top"});
  EXPECT_FALSE(has(candidates({"draw", "--views", "front,"}), "front,front"));
  const Words keys = candidates({"draw", "--projection", "cabinet:"});
  ASSERT_TRUE(has(keys, "cabinet:angle="));
  EXPECT_EQ(candidates({"draw", "--projection", "cabinet:angle="}), Words{"cabinet:angle=45"});
  EXPECT_EQ(candidates({"draw", "--projection", "cabinet:angle=30:"}).size(), keys.size() - 1);
  EXPECT_EQ(answer({"draw", "--projection", "nothing:"}), "");
}

TEST(Completion, BehindTwoDashesAreArguments) {
  EXPECT_EQ(answer({"draw", "--", "--pro"}), ":files\n");
  EXPECT_EQ(answer({"draw", "--projection", "--"}), "") << "that is the value";
}

TEST(Completion, OddWordsDoNoHarm) {
  for (const char* odd : {"{}", "[a,b]", "%%", "--", "---", "-", "=", ":", "--=", "--projection=", "\\", "\xff\xfe"}) {
    answer({odd, odd});
    answer({"draw", odd, ""});
    answer({"draw", "--projection", odd});
  }
  answer({});
  answer({"draw", "--projection", std::string(20000, ':')});
}

TEST(Completion, WordsOfOptionsAreTaken) {
  const Folder folder;
  int tried = 0;
  for (const char* option : {"--unit", "--up", "--hidden", "--edges", "--dimensions", "--visibility", "--sheet",
                             "--scale", "--frame", "--svg-text", "--progress", "--dump", "--plan", "--format"})
    for (const std::string& word : candidates({"draw", option, ""})) {
      if (word.ends_with('=')) continue;
      Words arguments{
          "draw", sample("bracket.obj"), option, word, "-o", option == std::string("--format") ? "-" : "x.svg"};
      arguments.insert(arguments.end(), {"--projection", "front"});
      if (option == std::string("--sheet") && word == "auto") arguments.insert(arguments.end(), {"--scale", "1:1"});
      const Outcome run = epura(arguments, folder / "");
      EXPECT_FALSE(contains(run.err, "unknown value")) << run.err;
      const bool is_too_large = contains(run.err, "the drawing is larger than the sheet");
      EXPECT_EQ(run.code, is_too_large ? 1 : 0) << option << " " << word << ": " << run.err;
      ++tried;
    }
  EXPECT_GE(tried, 50);
}

TEST(Completion, OfAShellThatHasNoScriptIsRefused) {
  const Folder folder;
  const Outcome run = epura({"completion", "tcsh"}, folder / "");
  EXPECT_EQ(run.code, 2);
  EXPECT_TRUE(contains(run.err, "unknown value 'tcsh'") && contains(run.err, "did you mean 'bash'")) << run.err;
  EXPECT_EQ(epura({"completion"}, folder / "").code, 2);
}

}  // namespace
}  // namespace epura::test::completion_test
