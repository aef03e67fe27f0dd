// SPDX-License-Identifier: Apache-2.0
// Every plugin that was built, by its own table: nothing here knows their names, so a new one is covered by itself.
#include <map>

#include "projection/check_projection.hpp"
#include "support.hpp"

namespace epura {

/// For GoogleTest, which looks beside the type.
inline void PrintTo(const projection::ProjectionEntry& entry, std::ostream* out) { *out << entry.name; }

}  // namespace epura

namespace epura::test::plugins_test {
namespace {

const projection::Catalogue& catalogue() {
  static const projection::Catalogue all = projection::load_catalogue(built_plugins());
  return all;
}

class every_plugin : public testing::TestWithParam<projection::ProjectionEntry> {
 protected:
  const projection::ProjectionEntry& entry = GetParam();
  const projection::Projection p = projection::make_projection(entry, {entry.name, {}}, a_box());
};
std::string test_name(const testing::TestParamInfo<projection::ProjectionEntry>& info) {
  std::string name = info.param.name;
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
}
INSTANTIATE_TEST_SUITE_P(built, every_plugin, testing::ValuesIn(catalogue().entries), test_name);

TEST(catalogue_of_built_plugins, has_all_families_and_nothing_bad) {
  std::map<std::string, int> families;
  for (const projection::ProjectionEntry& entry : catalogue().entries) ++families[entry.family];
  EXPECT_EQ(families,
            (std::map<std::string, int>{{"axonometric", 3}, {"oblique", 4}, {"orthographic", 7}, {"perspective", 8}}));
  for (const projection::BadPlugin& bad : catalogue().bad) ADD_FAILURE() << bad.path << ": " << bad.reason;
}

TEST_P(every_plugin, lies_in_the_library_of_its_name_and_describes_itself) {
  EXPECT_EQ(entry.plugin.filename(), entry.name + ".so");
  EXPECT_FALSE(entry.summary.empty());
  for (const projection::Parameter& parameter : entry.parameters)
    EXPECT_FALSE(parameter.help.empty()) << parameter.name;
}

TEST_P(every_plugin, has_a_frame_of_the_plane_and_projectors_that_cut_it) {
  EXPECT_NEAR(glm::length(p.n), 1, 1e-15);
  expect_near<3>(glm::cross(p.u, p.v), p.n, 1e-14);
  EXPECT_GT(glm::dot(p.n, p.central ? p.projector - p.point : p.projector), 0.1);
  for (int column = 0; column < 4; ++column)
    for (int row = 0; row < 4; ++row) EXPECT_TRUE(std::isfinite(projection::view_matrix(p)[column][row]));
  EXPECT_NE(glm::determinant(projection::view_matrix(p)), 0);
}

TEST_P(every_plugin, passes_the_checks_for_strangers) {
  for (const projection::CheckResult& result : projection::check_projection(entry))
    EXPECT_EQ(result.verdict, projection::Verdict::passed) << result.name << ": " << result.fault;
}

}  // namespace
}  // namespace epura::test::plugins_test
