// SPDX-License-Identifier: Apache-2.0
// Texts of any kind: their place, and what they must not break.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <pugixml.hpp>

#include "base/text.hpp"
#include "folder.hpp"
#include "output/write.hpp"
#include "pdf_reader.hpp"
#include "sheet/lettering.hpp"
#include "svg_reader.hpp"

namespace epura::texts_test {
namespace {

sheet::Sheet sheet_of(std::vector<sheet::Text> texts) {
  sheet::Sheet sheet{297, 210, "texts", {}};
  sheet::Layer& layer = sheet.layers.emplace_back();
  layer.name = "sheet/grid";
  layer.style = {"grid", 0.35};
  layer.strokes.push_back({{{5, 5}, {290, 5}}});
  layer.texts = std::move(texts);
  return sheet;
}

class TextAtAngle : public testing::TestWithParam<std::tuple<double, sheet::Align>> {};

TEST_P(TextAtAngle, KeepsCoordinates) {
  const auto [angle, align] = GetParam();
  const sheet::Text text{"HZI \xC3\x98 8g", {150, 100}, 7, angle, align, "label"};
  const pugi::xml_document document = parse_svg(output::to_svg(sheet_of({text}), {}));
  const pugi::xml_node g = document.select_node("//g[@aria-label]").node();
  EXPECT_STREQ(g.attribute("class").value(), (prefix_of(document) + "-text-label").c_str());
  const std::vector<Ink> read = ink_of(std::string_view(g.child("path").attribute("d").value()), 210);

  const sheet::Lettering lettering;
  const double radians = angle * std::atan(1) / 45, c = std::cos(radians), s = std::sin(radians);
  const double before = lettering.width(text.text, 7) * (align == sheet::Align::left     ? 0
                                                         : align == sheet::Align::middle ? 0.5
                                                                                         : 1);
  const auto place = [&](const Vec2& p) {
    return text.at + Vec2((p.x - before) * c - p.y * s, (p.x - before) * s + p.y * c);
  };
  const std::vector<sheet::GlyphOutline> outlines = lettering.outlines(text.text, 7);
  ASSERT_EQ(read.size(), outlines.size());
  for (std::size_t i = 0; i < read.size(); ++i) {
    const std::vector<sheet::GlyphOutline::Curve>& curves = outlines[i].curves;
    EXPECT_TRUE(read[i].closed);
    // It begins where it ends; a straight last piece is left to Z.
    EXPECT_LT(glm::distance(read[i].points.at(0), place(curves.back().end)), 1e-4);
    EXPECT_GE(read[i].points.size(), curves.size());
    for (std::size_t k = 1; k < read[i].points.size(); ++k)
      EXPECT_LT(glm::distance(read[i].points[k], place(curves.at(k - 1).end)), 1e-4);
  }
}

INSTANTIATE_TEST_SUITE_P(Angles, TextAtAngle,
                         testing::Combine(testing::Values(0.0, 90.0, 30.0),
                                          testing::Values(sheet::Align::left, sheet::Align::middle,
                                                          sheet::Align::right)));

class TextFiles : public testing::Test {
 protected:
  void write(const std::string& name, const std::string& bytes) const { write_file(folder_ / name, bytes); }
  void expect_run(const std::string& command) const {
    EXPECT_EQ(std::system(("cd '" + (folder_ / "").string() + "' && " + command).c_str()), 0) << command;
  }
  [[nodiscard]] std::string read(const std::string& name) const { return read_file(folder_ / name); }

  test::Folder folder_;
};

// Widths of words are those that the sheet was laid out with, but for the widths of letters in PDF, which Cairo cuts to
// thousandths of the em. Tall letters would be too many units high for FreeType at the usual enlargement.
TEST_F(TextFiles, PdfHasTheWidthsOfTheFont) {
  for (const double height : {1.8, 20.0, 70.0}) {
    const sheet::Sheet sheet = sheet_of({{"HOME", {10, 20}, height}});
    write("a.pdf", output::to_pdf({&sheet}));
    expect_run("pdftotext -bbox a.pdf a.html");
    const std::string words = read("a.html");
    const auto value = [&](const std::string& name) {
      const std::size_t begin = words.find(name + "=\"", words.find("<word")) + name.size() + 2;
      return parse_number(words.substr(begin, words.find('"', begin) - begin)).value() * 25.4 / 72;
    };
    EXPECT_NEAR(value("xMin"), 10, 1e-3);
    const sheet::Lettering lettering;
    EXPECT_NEAR(value("xMax") - value("xMin"), lettering.width("HOME", height), 4e-3 * lettering.em() * height);
  }
}

TEST_F(TextFiles, RolesMayHaveTheNamesOfLineStyles) {
  for (const char* role : {"grid", "other"}) {
    write(std::string(role) + ".svg",
          output::to_svg(sheet_of({{"Grid", {20, 100}, 20, 0, sheet::Align::left, role}}), {}));
    expect_run(std::string("rsvg-convert -o ") + role + ".png " + role + ".svg");
  }
  EXPECT_EQ(read("grid.png"), read("other.png"));
}

std::string long_text() {
  std::string text;
  for (int i = 0; i < 1000; ++i) text += "Wellenlag ";
  return text;
}

const std::vector<std::string>& hostile_texts() {
  static const std::vector<std::string> texts{
      std::string("a\0b\x01\x1b\n\t\x7f", 8),
      "<script>&\"')( \\ ]]>-->",
      "\xFF\xFE bad \xED\xA0\x80 \xEF\xBF\xBF",
      "\xE2\x80\xAE\xD7\x90\xD7\x91 \xE2\x80\x8F",
      "e\xCC\x81 A\xCC\x8A",
      "\xF0\x9F\x98\x80 \xE6\xBC\xA2 \xC2\x85",
      "\xF4\x8F\xBF\xBF \xEF\xB7\x90 \xF0\x9F\xBF\xBE",
      "",
      " ",
      long_text(),
  };
  return texts;
}

TEST_F(TextFiles, NothingBreaksThem) {
  std::vector<sheet::Text> texts;
  for (const std::string& text : hostile_texts()) {
    const double y = 20 + 10 * static_cast<double>(texts.size());
    texts.push_back({text, {20, y}, 3.5, 0, sheet::Align::left, text.substr(0, 50)});
  }
  texts.push_back({"no height", {20, 20}, 0});
  const sheet::Sheet sheet = sheet_of(std::move(texts));
  output::VectorOptions as_text;
  as_text.text = SvgText::text;
  for (const output::VectorOptions& options : {output::VectorOptions{}, as_text}) {
    write("a.svg", output::to_svg(sheet, options));
    expect_run("xmllint --noout a.svg");
    expect_run("rsvg-convert -o a.png a.svg");
    EXPECT_EQ(read("a.svg").find("<script"), std::string::npos);
  }
  const std::string bytes = output::to_pdf({&sheet});
  EXPECT_FALSE(PdfReader(bytes).has_trouble());
  write("a.pdf", bytes);
  expect_run("qpdf --check a.pdf >/dev/null");
  expect_run("pdftotext a.pdf a.txt");
  EXPECT_NE(read("a.txt").find("<script>&\"')( \\ ]]>-->"), std::string::npos);
  for (const std::string& page : {output::to_ps({&sheet}), output::to_eps(sheet)}) {
    EXPECT_TRUE(page.starts_with("%!PS-Adobe"));
    EXPECT_EQ(page.find('\0'), std::string::npos);
  }
  EXPECT_FALSE(output::to_png(sheet, 50).empty());
}

TEST_F(TextFiles, LongOutlinesAreSeveralPathsOfWholeLetters) {
  pugi::xml_document document;
  ASSERT_TRUE(document.load_string(output::to_svg(sheet_of({{std::string(5000, '8'), {20, 20}, 3.5}}), {}).c_str()));
  int paths = 0;
  for (const pugi::xml_node path : document.select_node("//g[@aria-label]").node().children("path")) {
    const std::string_view d = path.attribute("d").value();
    EXPECT_LT(d.size(), 200'000u);
    EXPECT_EQ(std::count(d.begin(), d.end(), 'Z') % 3, 0);  // an 8 has two holes
    ++paths;
  }
  EXPECT_GT(paths, 10);
}

}  // namespace
}  // namespace epura::texts_test
