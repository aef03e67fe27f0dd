// SPDX-License-Identifier: Apache-2.0
// The manual page says all that the help and the plugins say. tests/manual.sh lets man and mandoc read it.
#include <gtest/gtest.h>

#include <set>
#include <sstream>

#include "errors.hpp"
#include "folder.hpp"
#include "program.hpp"
#include "projection/catalogue.hpp"

namespace epura::test::manual_test {
namespace {

std::string manual() {
  const Folder folder;
  const Outcome run = epura({"manual"}, folder / "");
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_EQ(run.err, "");
  return run.out;
}

std::string in_roff(const std::string& text) {
  std::string roff;
  for (const char c : text) roff += c == '-' ? "\\-" : std::string(1, c);
  return roff;
}

TEST(Manual, HasEveryOptionOfEveryCommand) {
  const std::string page = manual();
  const Folder folder;
  int found = 0;
  for (const std::vector<std::string>& command : std::vector<std::vector<std::string>>{{"draw"},
                                                                                       {"explain"},
                                                                                       {"info"},
                                                                                       {"compare"},
                                                                                       {"snapshot"},
                                                                                       {"plugins"},
                                                                                       {"plugins", "check"},
                                                                                       {"new-projection"},
                                                                                       {"new-scene"},
                                                                                       {"manual"},
                                                                                       {"completion"}}) {
    std::vector<std::string> arguments = command;
    arguments.emplace_back("--help");
    std::istringstream help(epura(arguments, folder / "").out);
    for (std::string line; std::getline(help, line);) {
      const std::size_t at = line.find("--");
      if (!line.starts_with("  -") || line.find("--help") != std::string::npos) continue;
      const std::string name = line.substr(at, line.find_first_of(" {[", at) - at);
      EXPECT_TRUE(contains(page, "\\fB" + in_roff(name) + "\\fR")) << command.back() << " " << name;
      ++found;
    }
    std::string title = "epura";
    for (const std::string& word : command) title += " " + word;
    EXPECT_TRUE(contains(page, ".SS \\fB" + in_roff(title))) << title;
  }
  EXPECT_GE(found, 60);
}

TEST(Manual, HasEveryProjectionWithItsParameters) {
  const std::string page = manual();
  const projection::Catalogue catalogue = projection::load_catalogue({EPURA_TEST_PLUGINS});
  EXPECT_GE(catalogue.entries.size(), 22U);
  for (const projection::ProjectionEntry& entry : catalogue.entries) {
    const std::size_t at = page.find("\n\\fB" + in_roff(entry.name) + "\\fR (");
    ASSERT_NE(at, std::string::npos) << entry.name;
    for (const projection::Parameter& parameter : entry.parameters)
      EXPECT_NE(page.find("\\fB" + in_roff(parameter.name) + "\\fR", at), std::string::npos) << parameter.name;
  }
}

TEST(Manual, TextIsNeverTakenForAMacro) {
  const std::set<std::string> macros{".TH", ".SH", ".SS", ".TP", ".PP", ".RS", ".RE"};
  std::istringstream page(manual());
  int count = 0;
  for (std::string line; std::getline(page, line); ++count) {
    EXPECT_FALSE(line.starts_with('\'') || line.empty()) << count;
    EXPECT_TRUE(!line.starts_with('.') || macros.count(line.substr(0, line.find(' '))) == 1) << line;
  }
  EXPECT_GE(count, 300);
}

}  // namespace
}  // namespace epura::test::manual_test
