// The drawings of tests/golden. What comes is left in golden/CASE.json in the folder of the test. ACCEPT=1 in the
// environment makes it the expectation; with CI set that is refused.
#include "golden.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>

#include "base/text.hpp"
#include "program.hpp"

namespace epura::test {
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

TEST_P(Golden, Drawing) {
  const fs::path folder = golden_folder(GetParam());
  const fs::path actual_path = fs::absolute("golden") / (GetParam() + ".json");
  fs::create_directories(actual_path.parent_path());

  std::vector<std::string> arguments = golden_arguments(GetParam());
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

INSTANTIATE_TEST_SUITE_P(Cases, Golden, testing::ValuesIn(golden_cases()),
                         [](const auto& of) { return test_name(of.param); });

TEST(GoldenDifference, IsTheFirstLineThatDiffers) {
  EXPECT_EQ(first_difference("a\nb\n", "a\nb\n"), "");
  EXPECT_EQ(first_difference("a\nb\nc\n", "a\nx\ny\n"), "@@ line 2 @@\n-b\n+x\n");
  EXPECT_EQ(first_difference("a", "a\nb"), "@@ line 2 @@\n+b\n");
}

}  // namespace
}  // namespace epura::test
