// SPDX-License-Identifier: Apache-2.0
// The drawings of tests/golden. What comes is left as golden/CASE.json and .svg in the folder of the test. ACCEPT=1 in
// the environment makes it the expectation; with CI set that is refused.
#include "golden.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>

#include "base/text.hpp"
#include "errors.hpp"
#include "program.hpp"
#include "projection/catalogue.hpp"

namespace epura::test::golden_test {
namespace {

namespace fs = std::filesystem;

// The first line that differs, as in a unified diff; empty when none does.
std::string first_difference(const std::string& expected, const std::string& actual) {
  const auto old_lines = split(expected, '\n');
  const auto new_lines = split(actual, '\n');
  const auto [a, b] = std::mismatch(old_lines.begin(), old_lines.end(), new_lines.begin(), new_lines.end());
  if (a == old_lines.end() && b == new_lines.end()) return {};
  std::string text = "@@ line " + std::to_string(a - old_lines.begin() + 1) + " @@\n";
  if (a != old_lines.end()) text += "-" + std::string(*a) + "\n";
  if (b != new_lines.end()) text += "+" + std::string(*b) + "\n";
  return text;
}

class Golden : public testing::TestWithParam<std::string> {};

bool accepts() {
  const char* accept = std::getenv("ACCEPT");
  return accept != nullptr && std::string_view(accept) == "1";
}

void expect_or_accept(const fs::path& expected, const fs::path& actual) {
  if (accepts()) {
    ASSERT_EQ(std::getenv("CI"), nullptr) << "expectations are accepted by people, not in CI";
    return write_file(expected, read_file(actual));
  }
  ASSERT_TRUE(fs::exists(expected)) << "accept " << actual << " with ACCEPT=1";
  const std::string difference = first_difference(read_file(expected), read_file(actual));
  EXPECT_TRUE(difference.empty()) << "--- " << expected.string() << "\n+++ " << actual.string() << "\n" << difference;
}

TEST_P(Golden, ViewDrawing) {
  const fs::path folder = golden_folder(GetParam());
  const fs::path actual = fs::absolute("golden") / GetParam();
  fs::create_directories(actual.parent_path());

  std::vector<std::string> arguments = golden_arguments(GetParam());
  arguments.insert(arguments.end(), {"-o", actual.string() + ".json", "-o", actual.string() + ".svg"});
  const Outcome run = epura(arguments, root());
  ASSERT_EQ(run.code, 0) << run.err;
  expect_or_accept(folder / "expected.json", actual.string() + ".json");
  // Sheets show more than the lines of their drawing.
  if (fs::exists(folder / "expected.svg")) expect_or_accept(folder / "expected.svg", actual.string() + ".svg");
}

TEST_P(Golden, IsFoundRight) {
  const Folder folder;
  std::vector<std::string> arguments = golden_arguments(GetParam());
  arguments.insert(arguments.end(), {"--verify", "-o", (folder / "drawing.svg").string()});
  const Outcome run = epura(arguments, root());
  if (contains(run.err, "cannot test a wireframe")) GTEST_SKIP();
  EXPECT_EQ(run.code, 0) << run.err;
}

INSTANTIATE_TEST_SUITE_P(Cases, Golden, testing::ValuesIn(golden_cases()),
                         [](const auto& of) { return test_name(of.param); });

// What sheets say of themselves: features, threads, an assembly in German, tables, sections and details.
class GoldenDescription : public testing::TestWithParam<std::string> {};

TEST_P(GoldenDescription, IsTold) {
  const Folder folder;
  const fs::path actual = folder / "description.txt";
  std::vector<std::string> arguments = golden_arguments(GetParam());
  arguments.front() = "describe";
  const Outcome run = epura(arguments, root(), actual.string());
  ASSERT_EQ(run.code, 0) << run.err;
  expect_or_accept(golden_folder(GetParam()) / "description.txt", actual);
}

INSTANTIATE_TEST_SUITE_P(Cases, GoldenDescription,
                         testing::Values("sheet-automatic", "sheet-details", "sheet-hole-table", "sheet-parts-list",
                                         "sheet-sections", "sheet-threads"),
                         [](const auto& of) { return test_name(of.param); });

// The pictures of docs/projections.md: all projections seen from outside, and a plugin with a mistake.
class GoldenPicture : public testing::TestWithParam<std::string> {};

std::vector<std::string> pictures() {
  std::vector<std::string> names{"wrong-centre"};
  for (const projection::ProjectionEntry& entry : projection::load_catalogue({EPURA_TEST_PLUGINS}).entries)
    names.push_back(entry.name);
  return names;
}

TEST_P(GoldenPicture, IsDrawn) {
  const Folder folder;
  const std::string file = GetParam() + ".svg", actual = (folder / file).string();
  std::vector<std::string> command{"picture", GetParam(), "samples/models/bracket.obj", "--plain", "--decimals", "2",
                                   "-o",      actual};
  if (GetParam() == "wrong-centre")
    command = {"plugins", "check", EPURA_TEST_BAD_PLUGINS "/wrong-centre/wrong-centre.so", "--picture", actual};
  const Outcome run = epura(command, root());
  ASSERT_EQ(run.code, 0) << run.err;
  expect_or_accept(root() / "docs/projections" / file, actual);
}

INSTANTIATE_TEST_SUITE_P(Projections, GoldenPicture, testing::ValuesIn(pictures()),
                         [](const auto& of) { return test_name(of.param); });

// A run for which the C library takes no instructions that processors before 2013 lack.
Outcome epura_on_an_old_processor(const std::vector<std::string>& arguments) {
  ::setenv("GLIBC_TUNABLES", "glibc.cpu.hwcaps=-AVX2,-FMA,-FMA4,-AVX2_Usable,-FMA_Usable", 1);
  Outcome run = epura(arguments, root());
  ::unsetenv("GLIBC_TUNABLES");
  return run;
}

TEST_P(Golden, OnAnOldProcessor) {
  const Folder folder;
  const std::string actual = (folder / "drawing.json").string();
  std::vector<std::string> arguments = golden_arguments(GetParam());
  arguments.insert(arguments.end(), {"-o", actual});
  const Outcome run = epura_on_an_old_processor(arguments);
  ASSERT_EQ(run.code, 0) << run.err;
  EXPECT_EQ(first_difference(read_file(golden_folder(GetParam()) / "expected.json"), read_file(actual)), "");
}

// The sines or cosines of these angles that glibc 2.36 computes with FMA and without differ in the last bit.
TEST(OldProcessors, DrawTheSameAtAllAngles) {
  std::vector<std::string> arguments{"draw", "tests/golden/models/cube.obj", "-o", "-", "--format", "json"};
  for (const char* angle : {"21.72", "22.79", "26.2", "29.37", "30.69", "31.56", "47.56", "48", "67.84", "73.07"}) {
    arguments.push_back(std::string("--projection=planometric:angle=") + angle);
    arguments.push_back(std::string("--projection=cavalier:angle=") + angle);
  }
  const Outcome here = epura(arguments, root());
  ASSERT_EQ(here.code, 0) << here.err;
  EXPECT_EQ(first_difference(here.out, epura_on_an_old_processor(arguments).out), "");
}

TEST(GoldenDifference, IsTheFirstLineThatDiffers) {
  EXPECT_EQ(first_difference("a\nb\n", "a\nb\n"), "");
  EXPECT_EQ(first_difference("a\nb\nc\n", "a\nx\ny\n"), "@@ line 2 @@\n-b\n+x\n");
  EXPECT_EQ(first_difference("a", "a\nb"), "@@ line 2 @@\n+b\n");
}

}  // namespace
}  // namespace epura::test::golden_test
