// Each folder of tests/golden is a drawing as text: `arguments` holds what follows `epura draw`, with paths from the
// root of the repository, `expected.json` what must come of it, to the byte. What comes is left in golden/CASE.json in
// the folder of the test. ACCEPT=1 in the environment makes it the expectation; with CI set that is refused.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <sstream>

#include "base/file.hpp"
#include "base/text.hpp"
#include "program.hpp"

namespace epura::test {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> cases() {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(EPURA_TEST_GOLDEN))
    if (fs::exists(entry.path() / "arguments")) names.push_back(entry.path().filename());
  std::sort(names.begin(), names.end());
  return names;
}

std::vector<std::string> words_of(const fs::path& path) {
  std::istringstream text(read_file(path));
  std::vector<std::string> words;
  for (std::string word; text >> word;) words.push_back(word);
  return words;
}

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

TEST_P(Golden, Drawing) {
  const fs::path folder = fs::path(EPURA_TEST_GOLDEN) / GetParam();
  const fs::path actual_path = fs::absolute("golden") / (GetParam() + ".json");
  fs::create_directories(actual_path.parent_path());

  std::vector<std::string> arguments = words_of(folder / "arguments");
  arguments.insert(arguments.begin(), "draw");
  arguments.insert(arguments.end(), {"-o", actual_path.string()});
  const Outcome run = epura(arguments, root());
  ASSERT_EQ(run.code, 0) << run.err;
  const std::string actual = read_file(actual_path);

  const char* accept = std::getenv("ACCEPT");
  if (accept != nullptr && std::string_view(accept) == "1") {
    ASSERT_EQ(std::getenv("CI"), nullptr) << "expectations are accepted by people, not in CI";
    return write_file(folder / "expected.json", actual);
  }
  ASSERT_TRUE(fs::exists(folder / "expected.json")) << "accept " << actual_path << " with ACCEPT=1";
  const std::string difference = first_difference(read_file(folder / "expected.json"), actual);
  EXPECT_TRUE(difference.empty()) << "--- " << (folder / "expected.json").string() << "\n+++ " << actual_path.string()
                                  << "\n"
                                  << difference;
}

INSTANTIATE_TEST_SUITE_P(Cases, Golden, testing::ValuesIn(cases()), [](const auto& of) {
  std::string name = of.param;
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
});

TEST(GoldenDifference, IsTheFirstLineThatDiffers) {
  EXPECT_EQ(first_difference("a\nb\n", "a\nb\n"), "");
  EXPECT_EQ(first_difference("a\nb\nc\n", "a\nx\ny\n"), "@@ line 2 @@\n-b\n+x\n");
  EXPECT_EQ(first_difference("a", "a\nb"), "@@ line 2 @@\n+b\n");
}

}  // namespace
}  // namespace epura::test
