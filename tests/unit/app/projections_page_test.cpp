// SPDX-License-Identifier: Apache-2.0
// docs/projections.md: what it says that the program prints, the program prints; but for the place of the plugin, which
// differs from machine to machine. ACCEPT=1 in the environment renews the page. Its pictures are golden drawings.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <sstream>
#include <string>
#include <vector>

#include "base/file.hpp"
#include "errors.hpp"
#include "program.hpp"
#include "projection/catalogue.hpp"

namespace epura::test::projections_page_test {
namespace {

std::filesystem::path page_file() { return root() / "docs/projections.md"; }

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

std::string output_of(const std::string& command) {
  std::vector<std::string> words;
  std::istringstream stream(command);
  for (std::string word; stream >> word;) words.push_back(word);
  const Outcome run = epura(std::vector<std::string>(words.begin() + 2, words.end()), root());
  EXPECT_EQ(run.code, 0) << command << "\n" << run.err;
  std::string text;
  for (std::string line : lines_of(run.out))
    if (!line.starts_with("plugin: ")) text += line.substr(0, line.find_last_not_of(' ') + 1) + "\n";
  return text;
}

// The page with every block that begins with a command as the program prints it now.
std::string renewed(const std::string& page) {
  std::string text;
  bool is_printed = false;
  for (const std::string& line : lines_of(page)) {
    if (line == "```") is_printed = false;
    if (!is_printed) text += line + "\n";
    if (!line.starts_with("$ epura ")) continue;
    is_printed = true;
    text += output_of(line);
  }
  return text;
}

TEST(ProjectionsPage, ShowsWhatTheProgramPrints) {
  const std::string page = read_file(page_file()), now = renewed(page);
  if (const char* accept = std::getenv("ACCEPT"); accept != nullptr && std::string(accept) == "1") {
    ASSERT_EQ(std::getenv("CI"), nullptr) << "expectations are accepted by people, not in CI";
    write_file(page_file(), now);
    return;
  }
  EXPECT_EQ(lines_of(page), lines_of(now)) << "renew it with ACCEPT=1";
}

TEST(ProjectionsPage, HasASectionWithAPictureOfEachProjection) {
  const std::string page = read_file(page_file());
  const auto entries = projection::load_catalogue({EPURA_TEST_PLUGINS}).entries;
  ASSERT_GE(entries.size(), 22U);
  for (const projection::ProjectionEntry& entry : entries) {
    const std::string picture = "projections/" + entry.name + ".svg";
    EXPECT_TRUE(contains(page, "\n### " + entry.name + "\n\n![" + entry.name + "](" + picture + ")\n")) << entry.name;
    EXPECT_TRUE(contains(page, "\n$ epura plugins " + entry.name + "\n")) << entry.name;
  }
}

}  // namespace
}  // namespace epura::test::projections_page_test
