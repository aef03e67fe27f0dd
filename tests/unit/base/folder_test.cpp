// SPDX-License-Identifier: Apache-2.0
#include "base/folder.hpp"

#include <gtest/gtest.h>

#include "folder.hpp"

namespace epura::test {
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

}  // namespace
}  // namespace epura::test
