// SPDX-License-Identifier: Apache-2.0
// The contract with plugins that were built long ago, or with later headers.
#include <cstddef>
#include <epura/projection_plugin.hpp>

#include "../../plugins/abi_layout.h"
#include "support.hpp"

namespace epura::test::abi_test {
namespace {

#define AT(structure, member, offset) EXPECT_EQ(offsetof(structure, member), std::size_t{offset}) << #member;
#define SIZE(structure, bytes) EXPECT_EQ(sizeof(structure), std::size_t{bytes}) << #structure;
#define VALUE(name, number) EXPECT_EQ(static_cast<int>(name), number) << #name;

// The same list holds for C: tests/plugins/abi_layout.c.
TEST(the_abi, has_the_layout_that_was_promised){EPURA_LAYOUT(AT, SIZE, VALUE)}

TEST(the_abi, has_its_version_in_the_name_of_the_entry_point) {
  EXPECT_STREQ(EPURA_ENTRY_POINT, ("epura_projections_v" + std::to_string(EPURA_ABI_VERSION)).c_str());
}

TEST(a_newer_plugin, is_read_as_far_as_this_program_knows_it) {
  const std::vector<std::filesystem::path> folders{std::filesystem::path(EPURA_TEST_BAD_PLUGINS) / "newer"};
  const projection::Catalogue found = projection::load_catalogue(folders);
  EXPECT_TRUE(found.bad.empty());
  ASSERT_EQ(found.entries.size(), 2U);
  EXPECT_EQ(found.entries[1].name, "newest");
  ASSERT_EQ(found.entries[1].parameters.size(), 2U);
  EXPECT_EQ(found.entries[1].parameters[1].name, "scale");
  const projection::Projection p =
      projection::make_projection(found.entries[1], scene::parse_request("newest:scale=4"), a_box());
  EXPECT_EQ(p.scale, 4);
  expect_near<2>(step(p, {0, 1, 0}), {0.5, 0}, 1e-15);
}

struct Plan {
  static constexpr auto name = "plan";
  static constexpr auto family = "test";
  static constexpr auto summary = "from above";
  static constexpr const char* reference = nullptr;
  static constexpr auto parameters = plugin::no_parameters;

  static plugin::View project(const plugin::Scene&) {
    plugin::View view;
    view.normal = view.projector = {0, 0, 1};
    view.up = {0, 1, 0};
    view.window = {1, 2, 3, 4};
    return view;
  }
};

TEST(an_older_program, gets_no_more_of_the_view_than_it_knows) {
  constexpr epura_scene scene{sizeof(epura_scene), {0, 0, 0}, {1, 1, 1}};
  epura_view view{};
  view.size = offsetof(epura_view, window);  // as if the window had been appended later
  view.window[0] = view.back = -7;
  EXPECT_EQ(plugin::detail::list<Plan>()->projections[0].project(nullptr, &scene, &view), nullptr);
  EXPECT_EQ(view.size, offsetof(epura_view, window));
  EXPECT_EQ(view.normal[2], 1);
  EXPECT_EQ(view.scale, 1);
  EXPECT_EQ(view.window[0], -7);
  EXPECT_EQ(view.back, -7);
}

}  // namespace
}  // namespace epura::test::abi_test
