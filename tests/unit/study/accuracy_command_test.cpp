// SPDX-License-Identifier: Apache-2.0
// `epura study accuracy`.
#include <gtest/gtest.h>

#include <cstdlib>
#include <regex>

#include "base/file.hpp"
#include "base/text.hpp"
#include "program.hpp"

namespace epura::test::accuracy_command_test {
namespace {

using Rows = std::vector<std::vector<std::string>>;

// Cells without commas and quotes.
Rows rows_of_csv(const std::string& text) {
  Rows rows;
  for (const std::string_view line : split(text, '\n')) {
    if (line.empty()) continue;
    std::vector<std::string>& row = rows.emplace_back();
    for (const std::string_view cell : split(line.substr(0, line.size() - 1), ',')) row.emplace_back(cell);
  }
  return rows;
}

std::size_t count(const std::string& text, const std::string& what) {
  std::size_t found = 0;
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + 1)) ++found;
  return found;
}

class Accuracy : public testing::Test {
 protected:
  [[nodiscard]] Outcome study(std::vector<std::string> more) const {
    std::vector<std::string> arguments{"study", "accuracy", sample("bracket.obj")};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return epura(arguments, folder_ / "");
  }
  [[nodiscard]] std::string read(const char* name) const { return read_file(folder_ / name); }

  Folder folder_;
};

TEST_F(Accuracy, EveryFormatHasTheSameNumbers) {
  const Outcome outcome = study({"--visibility", "exact", "--visibility", "sampled:density=0.2", "--runs", "2", "-o",
                                 "a.html", "-o", "a.csv", "-o", "a.json", "-o", "a.pdf"});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const Rows csv = rows_of_csv(read("a.csv"));
  ASSERT_EQ(csv.size(), 3U);
  const std::string page = read("a.html");
  for (const auto& row : csv)
    for (const std::string& cell : row)
      EXPECT_TRUE(cell.empty() || page.find(">" + cell + "</text>") != std::string::npos) << cell;
  const std::string json = read("a.json");
  for (std::size_t row = 1; row < csv.size(); ++row)
    for (std::size_t i = 4; i < csv[row].size(); ++i)
      EXPECT_NE(json.find("\"" + csv[0][i] + "\": " + csv[row][i]), std::string::npos) << csv[0][i];
  EXPECT_EQ(csv[1][2], "exact");
  EXPECT_EQ(csv[1][4], "0") << "E_max of the exact method";
  EXPECT_GT(parse_number(csv[2][4]), 0.05) << "of the sampled one";
  EXPECT_TRUE(read("a.pdf").starts_with("%PDF"));
}

TEST_F(Accuracy, HtmlFetchesNothing) {
  ASSERT_EQ(study({"--runs", "1", "--visibility", "exact", "-o", "a.html"}).code, 0);
  const std::string html = read("a.html");
  for (const char* link : {" src=", " href=", "@import", "url(", "<link"})
    EXPECT_EQ(html.find(link), std::string::npos) << link;
  EXPECT_NE(html.find("default-src 'none'"), std::string::npos);
  EXPECT_EQ(count(html, "<svg"), 2U) << "of the view and of the maps";
}

TEST_F(Accuracy, ABrowserShowsTheReport) {
  if (std::system("command -v chromium >/dev/null") != 0) GTEST_SKIP() << "chromium is not installed";
  ASSERT_EQ(study({"--runs", "1", "--visibility", "float", "--visibility", "none", "-o", "a.html"}).code, 0);
  const std::string command = "cd '" + (folder_ / "").string() +
                              "' && HOME=$PWD timeout 120 chromium --headless --no-sandbox --disable-gpu --dump-dom "
                              "file://$PWD/a.html >dom.html 2>chromium.log";
  ASSERT_EQ(std::system(command.c_str()), 0) << read("chromium.log");
  const std::string html = read("a.html"), dom = read("dom.html");
  EXPECT_EQ(count(dom, "<text"), count(html, "<text"));
  EXPECT_GT(count(dom, "<path"), 20U);
  EXPECT_EQ(count(dom, "<option"), 2U) << "of the view and of the maps";
  EXPECT_TRUE(std::regex_search(dom, std::regex("<body[^>]*class=\"[^\"]*ready"))) << "its script has run";
}

TEST_F(Accuracy, SaysWhatIsWrong) {
  const auto refused = [&](const std::vector<std::string>& arguments, const char* reason) {
    const Outcome outcome = study(arguments);
    EXPECT_EQ(outcome.code, 2);
    EXPECT_NE(outcome.err.find(reason), std::string::npos) << outcome.err;
  };
  refused({"-o", "a.htm"}, "did you mean 'html'?");
  refused({}, "--output is required");
  refused({"-o", "a.csv", "--visibility", "samples"}, "did you mean 'sampled'?");
  refused({"-o", "a.csv", "--runs", "0"}, "--runs: is 0");
  refused({"-o", "a.csv", "missing.obj"}, "missing.obj");
  refused({"-o", "a.csv", "--no-map"}, "did you mean '--no-maps'?");
}

TEST_F(Accuracy, ScenesWithSeveralViewsHaveARowForEach) {
  const Outcome outcome = epura({"study", "accuracy", EPURA_TEST_SAMPLES "/bracket.toml", "--visibility", "exact",
                                 "--runs", "1", "--truth", "1", "-o", "a.csv"},
                                folder_ / "");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_GT(rows_of_csv(read("a.csv")).size(), 3U);
}

}  // namespace
}  // namespace epura::test::accuracy_command_test
