// SPDX-License-Identifier: Apache-2.0
// Each plugin that makes one mistake fails the check for that mistake, and this one alone.
#include "projection/check_projection.hpp"

#include "support.hpp"

namespace epura::test::check_projection_test {
namespace {

std::filesystem::path bad(const std::string& folder) { return std::filesystem::path(EPURA_TEST_BAD_PLUGINS) / folder; }

std::vector<projection::CheckResult> checks_of(const std::string& folder, const std::string& name) {
  return projection::check_projection(projection::find_projection(name, {bad(folder)}));
}

struct Mistake {
  const char* folder;
  const char* check;
  const char* fault;
};
void PrintTo(const Mistake& mistake, std::ostream* out) { *out << mistake.folder; }

class mistake : public testing::TestWithParam<Mistake> {};
INSTANTIATE_TEST_SUITE_P(bad_plugins, mistake,
                         testing::Values(Mistake{"sentence", "answers", "they are rejected: not today"},
                                         Mistake{"crosses", "answers", "threw an exception"},
                                         Mistake{"nan", "finite", "the normal of the plane is not finite"},
                                         Mistake{"no-normal", "plane", "the normal of the plane is zero"},
                                         Mistake{"up-along-normal", "plane", "parallel to the normal"},
                                         Mistake{"plane-holds-projector", "plane", "contains the direction"},
                                         Mistake{"no-scale", "picture", "the scale is not"},
                                         Mistake{"empty-window", "picture", "the window is empty"},
                                         Mistake{"front-behind-back", "picture", "front plane must lie"},
                                         Mistake{"forgets", "repeats", "the second answer"},
                                         Mistake{"far-away", "lines", "too far"},
                                         Mistake{"ignores", "parameters", "scale changes nothing"},
                                         Mistake{"nan-at-an-end", "bounds", "scale=2: the scale is not finite"},
                                         Mistake{"flat-model", "models", "without a model: the scale is not finite"}));

TEST_P(mistake, fails_its_check) {
  for (const projection::CheckResult& result : checks_of(GetParam().folder, "plain")) {
    if (result.name != GetParam().check) continue;
    EXPECT_EQ(result.verdict, projection::Verdict::failed);
    EXPECT_TRUE(contains(result.fault, GetParam().fault)) << result.fault;
  }
}

TEST_P(mistake, is_the_first_that_is_found) {
  std::string first;
  for (const projection::CheckResult& result : checks_of(GetParam().folder, "plain"))
    if (result.verdict == projection::Verdict::failed && first.empty()) first = result.name;
  EXPECT_EQ(first, GetParam().check);
}

TEST(a_projection_without_an_answer, is_not_looked_at_further) {
  const std::vector<projection::CheckResult> results = checks_of("nan", "plain");
  for (std::size_t i = 2; i < results.size(); ++i)
    EXPECT_EQ(results[i].verdict, projection::Verdict::skipped) << results[i].name;
}

TEST(good_plugins, pass_every_check) {
  for (const auto& [folder, name] : {std::pair("good", "plain"), std::pair("good", "every-type"),
                                     std::pair("manual", "slanted"), std::pair("manual", "military")})
    for (const projection::CheckResult& result : checks_of(folder, name))
      EXPECT_EQ(result.verdict, projection::Verdict::passed) << name << ", " << result.name << ": " << result.fault;
}

}  // namespace
}  // namespace epura::test::check_projection_test
