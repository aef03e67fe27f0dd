// SPDX-License-Identifier: Apache-2.0
#include "scene/role_styles.hpp"

#include <gtest/gtest.h>

#include "base/error.hpp"
#include "base/file.hpp"
#include "folder.hpp"

namespace epura::role_styles_test {
namespace {

std::vector<scene::RoleStyle> read(const std::string& text) {
  const test::Folder folder;
  write_file(folder / "s.toml", text);
  return scene::read_role_styles({folder / "s.toml", "--style"});
}

TEST(RoleStyles, HaveWidthColourAndDashes) {
  const auto styles = read("[visible]\nwidth = 0.7\ncolour = \"#036\"\n[hidden]\ndashes = \"continuous\"\n");
  ASSERT_EQ(styles.size(), 2U);
  EXPECT_EQ(styles[0].line, scene::SheetLine::visible);
  EXPECT_EQ(styles[0].width, 0.7);
  EXPECT_EQ(styles[0].colour, (Colour{0, 0x33, 0x66}));
  EXPECT_FALSE(styles[0].dashes);
  EXPECT_EQ(styles[1].line, scene::SheetLine::hidden);
  ASSERT_TRUE(styles[1].dashes);
  EXPECT_FALSE(styles[1].dashes->is_broken());
}

TEST(RoleStyles, AllIsForTheRest) {
  const auto styles = read("[all]\nwidth = 0.3\n[visible]\nwidth = 0.7\n");
  EXPECT_EQ(styles.size(), scene::sheet_lines.size());
  for (const scene::RoleStyle& style : styles)
    EXPECT_EQ(style.width, style.line == scene::SheetLine::visible ? 0.7 : 0.3);
}

struct Refused {
  const char* text;
  const char* line;
  const char* words;
};

class RoleStylesRefuse : public testing::TestWithParam<Refused> {};

TEST_P(RoleStylesRefuse, WithLineAndHint) {
  try {
    (void)read(GetParam().text);
    FAIL() << GetParam().text;
  } catch (const Error& error) {
    EXPECT_NE(error.where().find(GetParam().line), std::string::npos) << error.where();
    EXPECT_NE((error.what() + error.hint()).find(GetParam().words), std::string::npos) << error.what() << error.hint();
  }
}

INSTANTIATE_TEST_SUITE_P(All, RoleStylesRefuse,
                         testing::Values(Refused{"[visible]\n[visble2]\n", "s.toml:2", "visible"},
                                         Refused{"[visible]\nwidht = 1\n", "s.toml:2", "width"},
                                         Refused{"[visible]\nwidth = 0\n", "s.toml:2", "0.01"},
                                         Refused{"[hidden]\ncolour = \"file\"\n", "s.toml:2", "bodies"},
                                         Refused{"[hidden]\ncolour = \"reddish\"\n", "s.toml:2", "reddish"},
                                         Refused{"[hidden]\ndashes = \"dotty\"\n", "s.toml:2", "dashed"},
                                         Refused{"visible = 3\n", "s.toml:1", "visible"}));

}  // namespace
}  // namespace epura::role_styles_test
