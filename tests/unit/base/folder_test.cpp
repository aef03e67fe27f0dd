// SPDX-License-Identifier: Apache-2.0
#include "base/folder.hpp"

#include <gtest/gtest.h>

#include "folder.hpp"

namespace epura::test::folder_test {
namespace {

using Names = std::vector<std::string>;

TEST(Folders, ListAllNamesInTheOrderOfTheirBytes) {
  const Folder folder;
  for (const char* name : {"b", "a.obj", ".hidden", "B", "...", "\xC3\xA9", "a"}) folder.file(name, "");
  std::filesystem::create_directory(folder / "c");
  folder.file("c/inner", "");
  std::filesystem::create_symlink("nowhere", folder / "link");
  std::error_code failure;
  EXPECT_EQ(names_in(folder / "", failure), (Names{"...", ".hidden", "B", "a", "a.obj", "b", "c", "link", "\xC3\xA9"}));
  EXPECT_FALSE(failure) << failure.message();
}

TEST(Folders, TellWhyTheyCannotBeListed) {
  const Folder folder;
  std::error_code failure;
  EXPECT_EQ(names_in(folder / "missing", failure), Names{});
  EXPECT_EQ(failure, std::errc::no_such_file_or_directory);
  EXPECT_EQ(names_in(folder.file("file", ""), failure), Names{});
  EXPECT_EQ(failure, std::errc::not_a_directory);
  EXPECT_EQ(names_in(folder / "", failure), Names{"file"});
  EXPECT_FALSE(failure) << "an old failure is forgotten";
}

TEST(Folders, TellWhatLiesBelow) {
  namespace fs = std::filesystem;
  const Folder folder;
  fs::create_directories(folder / "in/deep");
  folder.file("in/a", "");
  folder.file("out", "");
  fs::create_symlink("../out", folder / "in/leads-out");
  fs::create_symlink("../absent", folder / "in/leads-out-to-nothing");
  fs::create_directory_symlink("..", folder / "in/up");
  fs::create_symlink("a", folder / "in/stays");
  for (const char* name : {"a", "absent", "deep/../a", "deep/absent", "stays", "."})
    EXPECT_TRUE(lies_below(folder / "in" / name, folder / "in")) << name;
  for (const char* name : {"..", "../out", "../in2/a", "leads-out", "leads-out-to-nothing", "up/out", "/etc/passwd"})
    EXPECT_FALSE(lies_below(folder / "in" / name, folder / "in")) << name;
  const std::string long_name(3000, 'a');
  EXPECT_TRUE(lies_below(folder / "in" / long_name, folder / "in"));
  EXPECT_FALSE(lies_below(folder / "in/.." / long_name, folder / "in"));
  EXPECT_TRUE(lies_below("absent", ""));
  EXPECT_FALSE(lies_below("../absent", ""));
}

}  // namespace
}  // namespace epura::test::folder_test
