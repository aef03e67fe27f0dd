// SPDX-License-Identifier: Apache-2.0
// `epura study paper`.
#include <gtest/gtest.h>

#include "base/file.hpp"
#include "base/text.hpp"
#include "program.hpp"

namespace epura::test::paper_command_test {
namespace {

TEST(PaperCommand, FilesHaveTheSameNumbers) {
  const Folder folder;
  const Outcome outcome = epura({"study", "paper", "--body", "cone", "--finest", "48", "--runs", "2", "-o", "p.csv",
                                 "-o", "p.json", "-o", "p.html", "-o", "p.pdf", "-o", "p.svg"},
                                folder / "");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const std::string csv = read_file(folder / "p.csv"), json = read_file(folder / "p.json");
  const std::vector<std::string_view> lines = split(csv, '\n');
  ASSERT_GE(lines.size(), 10U);
  const std::vector<std::string_view> names = split(lines[0], ',');
  int rows = 0;
  for (std::size_t i = 1; i < lines.size() && !lines[i].empty(); ++i, ++rows) {
    const std::vector<std::string_view> cells = split(lines[i], ',');
    EXPECT_EQ(cells[0], "cone");
    // 12, 24, 48 facets in three ways; none is farther off than stated.
    EXPECT_EQ(cells[2], std::to_string(12 << (rows % 3)));
    EXPECT_LE(parse_number(cells[4]), parse_number(cells[7])) << lines[i];
    EXPECT_EQ(cells[9], "0") << "no line is missed";
    EXPECT_NE(json.find("\"" + std::string(names[4]) + "\": " + std::string(cells[4])), std::string::npos);
    EXPECT_NE(read_file(folder / "p.html").find(std::string(cells[4]) + "</text>"), std::string::npos);
  }
  EXPECT_EQ(rows, 9);
  EXPECT_TRUE(read_file(folder / "p.pdf").starts_with("%PDF"));
  EXPECT_NE(read_file(folder / "p.svg").find("triangles alone"), std::string::npos);
}

TEST(PaperCommand, AnUnknownBodyIsRefused) {
  const Folder folder;
  const Outcome outcome = epura({"study", "paper", "--body", "dodecahedron", "-o", "p.csv"}, folder / "");
  EXPECT_EQ(outcome.code, 2);
  EXPECT_NE(outcome.err.find("dodecahedron"), std::string::npos);
  EXPECT_NE(outcome.err.find("sphere"), std::string::npos) << "the known ones are told: " << outcome.err;
}

}  // namespace
}  // namespace epura::test::paper_command_test
