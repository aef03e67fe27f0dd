// SPDX-License-Identifier: Apache-2.0
// `epura study stability`, and what there is of both studies in help, completion and manual.
#include <gtest/gtest.h>

#include "../output/json_reader.hpp"
#include "errors.hpp"
#include "folder.hpp"
#include "program.hpp"

namespace epura::test::stability_command_test {
namespace {

using Words = std::vector<std::string>;

Outcome study(const Words& options, const std::filesystem::path& folder) {
  Words arguments{"study", "stability"};
  arguments.insert(arguments.end(), options.begin(), options.end());
  return epura(arguments, folder);
}

TEST(StabilityCommand, PrintsATableAndWritesFilesByTheirExtensions) {
  const Folder folder;
  const Outcome run = study(
      {"--cases", "P12,M23", "-o", "x.html", "-o", "x.json", "-o", "x.csv", "-o", "x.svg", "-o", "x.pdf", "--timings"},
      folder / "");
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_EQ(folder.names(), (Words{"x.csv", "x.html", "x.json", "x.pdf", "x.svg"}));
  EXPECT_TRUE(contains(run.out, "\nP12 ")) << run.out;
  EXPECT_TRUE(contains(run.out, "\nM23 ")) << run.out;
  EXPECT_TRUE(contains(run.err, "P12 ")) << "timings are told on standard error";
  const Json json = JsonReader(read_file(folder / "x.json")).read();
  ASSERT_EQ(json["cases"].items.size(), 2U);
  EXPECT_EQ(json["cases"].items[0]["verdict"]["epura"].text, "right");
  EXPECT_EQ(json["cases"].items[0]["verdict"]["float32"].text, "broken");
}

TEST(StabilityCommand, PrintsTheTableOfTheDocumentation) {
  const Folder folder;
  const Outcome run = study({}, folder / "");
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_TRUE(contains(read_file(root() / "docs/numerics.md"), "$ epura study stability\n" + run.out + "```\n"));
}

TEST(StabilityCommand, ContinuesBeyondTheStepsOnRequest) {
  const Folder folder;
  const Outcome run = study({"--beyond", "300", "--cases", "R2,S1,D2"}, folder / "");
  EXPECT_EQ(run.code, 0) << run.err;
  for (const char* row :
       {"0.001       0.0001  wrong: radius", "1e-12       1e-13   refused: study: the plane cuts nothing",
        "0.01        0.001   refused: dimension: its legs"})
    EXPECT_TRUE(contains(run.out, row)) << run.out;
}

TEST(StabilityCommand, GivesTheSameBytesForAnyNumberOfThreads) {
  const Folder folder;
  const auto json = [&](const std::string& threads) {
    return study({"--cases", "P1,V1,M8,M16,M29", "-o", "-", "--format", "json", "--threads", threads}, folder / "").out;
  };
  const std::string one = json("1");
  EXPECT_TRUE(one.starts_with("{\"epura_stability\": 1"));
  EXPECT_EQ(json("5"), one);
}

TEST(StabilityCommand, WrongUsageIsRefused) {
  const Folder folder;
  const auto refused = [&](const Words& options, const std::string& part) {
    const Outcome run = study(options, folder / "");
    EXPECT_EQ(run.code, 2);
    EXPECT_TRUE(contains(run.err, part)) << run.err;
  };
  refused({"--cases", "P17"}, "--cases");
  refused({"-o", "x.docx"}, "x.docx");
  refused({"-o", "-"}, "--format");
  refused({"--size", "0"}, "--size");
  refused({"--beyond", "1", "-o", "x.csv"}, "--beyond");
  refused({"--sizes", "1"}, "did you mean '--size'?");
  EXPECT_TRUE(folder.names().empty());
  EXPECT_EQ(epura({"study"}, folder / "").code, 2);
  EXPECT_TRUE(contains(epura({"study", "stability", "--help"}, folder / "").out, "--cases"));
}

std::string manual() {
  const Folder folder;
  return epura({"study", "manual"}, folder / "").out;
}

TEST(StudyManual, HasEveryOptionOfTheHelp) {
  const Folder folder;
  const std::string page = manual();
  EXPECT_TRUE(page.starts_with(".TH EPURA-STUDY 1")) << page.substr(0, 100);
  int found = 0;
  for (const char* command : {"accuracy", "stability"}) {
    std::istringstream help(epura({"study", command, "--help"}, folder / "").out);
    for (std::string line; std::getline(help, line);) {
      const std::size_t at = line.find("--");
      if (!line.starts_with("  -") || contains(line, "--help")) continue;
      std::string name = line.substr(at, line.find_first_of(" {[=", at) - at);
      for (std::size_t dash = 0; (dash = name.find('-', dash)) != std::string::npos; dash += 2) name.insert(dash, "\\");
      EXPECT_TRUE(contains(page, "\\fB" + name + "\\fR")) << command << " " << name;
      ++found;
    }
  }
  EXPECT_GE(found, 14);
}

TEST(StudyCompletion, IsAskedOfItThroughEpura) {
  const Folder folder;
  const auto answer = [&](Words words) {
    words.insert(words.begin(), {"completion", "words", "--"});
    return epura(words, folder / "").out;
  };
  EXPECT_TRUE(answer({"study", "acc"}).starts_with("accuracy\t"));
  EXPECT_TRUE(answer({"study", "stability", "--ca"}).starts_with("--cases\t"));
  EXPECT_TRUE(contains(answer({"study", "accuracy", "--visibility", ""}), "sampled:density=\t"));
  EXPECT_EQ(answer({"study", "accuracy", ""}), ":files\n");
}

}  // namespace
}  // namespace epura::test::stability_command_test
