// SPDX-License-Identifier: Apache-2.0
#include "sheet/title_block.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "scene/title_fields.hpp"
#include "sheet/fit_text.hpp"
#include "sheet/frame.hpp"
#include "sheet/label_positions.hpp"
#include "sheet/sheet_layers.hpp"

namespace epura::title_block_test {
namespace {

const sheet::Lettering& lettering() {
  static const sheet::Lettering font;
  return font;
}

sheet::Paper paper(const std::string& size, bool portrait = false) {
  return sheet::with_frame_margins(sheet::make_paper(scene::parse_paper_size(size, "--sheet"), portrait));
}

std::vector<std::string> values(const sheet::DrawnTitleBlock& block) {
  std::vector<std::string> texts;
  for (const sheet::Text& text : block.ink.texts)
    if (text.role != "caption") texts.push_back(text.text);
  return texts;
}

bool has(const std::vector<std::string>& texts, const std::string& text) {
  return std::find(texts.begin(), texts.end(), text) != texts.end();
}

// No text reaches out of the block, and none over another one.
void expect_legible(const sheet::DrawnTitleBlock& block, const sheet::Rectangle& box) {
  std::vector<sheet::Rectangle> inks;
  for (const sheet::Text& text : block.ink.texts) {
    const sheet::Rectangle ink{text.at, text.at + Vec2(lettering().width(text.text, text.height), text.height)};
    EXPECT_TRUE(box.holds(ink)) << text.text;
    for (const sheet::Rectangle& other : inks) EXPECT_FALSE(ink.overlaps(other)) << text.text;
    inks.push_back(ink);
    // Nor through a line.
    for (const sheet::Stroke& stroke : block.ink.medium)
      if (stroke.points.size() == 2) {
        const sheet::Rectangle line{glm::min(stroke.points[0], stroke.points[1]),
                                    glm::max(stroke.points[0], stroke.points[1])};
        EXPECT_FALSE(ink.overlaps(line.grown(sheet::medium_line / 2))) << text.text;
      }
  }
}

sheet::TitleBlock filled(const std::string& value) {
  sheet::TitleBlock block;
  for (const scene::TitleField& field : scene::title_fields()) block.fields.emplace_back(field.name, value);
  block.scale = "1:2";
  block.size = "A3";
  block.angle = ProjectionAngle::first;
  return block;
}

TEST(TitleBlock, StandsInTheLowerRightCornerAndIs180Wide) {
  for (const std::string size : {"A4", "A3", "A2", "A1", "A0", "300x200"})
    for (const bool portrait : {false, true}) {
      const sheet::Paper sheet = paper(size, portrait);
      const auto box = sheet::title_block_box(filled("x"), sheet);
      ASSERT_TRUE(box) << size;
      EXPECT_EQ(box->size().x, 180);
      EXPECT_EQ(box->max.x, sheet.width - 10);
      EXPECT_EQ(box->min.y, 10);
      expect_legible(sheet::draw_title_block(filled("Abg"), sheet, lettering()), *box);
    }
  EXPECT_EQ(sheet::title_block_box({}, paper("A4", true))->min.x, 20);  // the whole width
}

TEST(TitleBlock, CaptionsAreInTheLanguageOfTheDocument) {
  for (const auto& [language, scale, number] :
       {std::array{"en", "Scale", "Identification number"}, std::array{"de-AT", "Maßstab", "Identifikationsnummer"},
        std::array{"FR", "Échelle", "Numéro d'identification"}, std::array{"es", "Escala", "Número de identificación"},
        std::array{"pt-BR", "Escala", "Número de identificação"}, std::array{"ja", "尺度", "識別番号"},
        std::array{"xx", "Scale", "Identification number"}}) {
    sheet::TitleBlock block;
    block.fields = {{"language", language}};
    const auto drawn = sheet::draw_title_block(block, paper("A3"), lettering());
    std::vector<std::string> captions;
    for (const sheet::Text& text : drawn.ink.texts)
      if (text.role == "caption") captions.push_back(text.text);
    EXPECT_TRUE(has(captions, scale)) << language;
    EXPECT_TRUE(has(captions, number)) << language;
    for (const std::string& one : captions) EXPECT_FALSE(one.ends_with("...")) << one;
  }
}

TEST(TitleBlock, InventsNothing) {
  EXPECT_EQ(values(sheet::draw_title_block({}, paper("A3"), lettering())), std::vector<std::string>{"1/1"});
}

// Of every combination of optional fields. A cell is at the right of a vertical line, below a horizontal one.
TEST(TitleBlock, HasNoEmptyOptionalCells) {
  const std::vector<std::pair<std::string, std::string>> optional = {{"revision", "Rev."},
                                                                     {"language", "Lang."},
                                                                     {"status", "Document status"},
                                                                     {"material", "Material"},
                                                                     {"mass", "Mass"},
                                                                     {"department", "Responsible department"},
                                                                     {"technical_reference", "Technical reference"}};
  const std::vector<std::string> required = {
      "Created by",  "Approved by",          "Scale",         "Size",
      "Legal owner", "Document type",        "Date of issue", "Title, supplementary title",
      "Sheet",       "Identification number"};
  for (unsigned given = 0; given < 1U << optional.size(); ++given) {
    sheet::TitleBlock block;
    std::vector<std::string> expected = required;
    for (std::size_t i = 0; i < optional.size(); ++i) {
      block.fields.emplace_back(optional[i].first, (given >> i & 1) != 0 ? "en" : "");
      if ((given >> i & 1) != 0) expected.push_back(optional[i].second);
    }
    const sheet::Rectangle box = *sheet::title_block_box(block, paper("A3"));
    EXPECT_EQ(box.size(), Vec2(180, given >> 3 == 0 ? 36 : 45)) << given << ": a row more for the last four";
    const auto drawn = sheet::draw_title_block(block, paper("A3"), lettering());
    expect_legible(drawn, box);
    std::vector<std::string> captions;
    for (const sheet::Text& text : drawn.ink.texts)
      if (text.role == "caption") captions.push_back(text.text);
    std::sort(captions.begin(), captions.end());
    std::sort(expected.begin(), expected.end());
    EXPECT_EQ(captions, expected) << given;
    // Between lines and the border, no cell but that of the symbol is without a caption at its left upper corner.
    std::size_t corners = 0;
    for (const sheet::Stroke& stroke : drawn.ink.medium)
      if (stroke.points[0].x == stroke.points[1].x) ++corners;
    const std::size_t at_border = given >> 3 == 0 ? 2 : 3;
    EXPECT_EQ(corners + at_border, captions.size() + 1) << given;
  }
}

TEST(TitleBlock, ShowsEveryField) {
  sheet::TitleBlock block = filled("");
  for (auto& [name, value] : block.fields) value = name.substr(0, 3);
  block.fields.emplace_back("surface_treatment", "anodised");
  block.sheet = 2;
  block.sheets = 5;
  const auto drawn = sheet::draw_title_block(block, paper("A3"), lettering());
  const auto texts = values(drawn);
  for (const auto& [name, value] : block.fields) EXPECT_TRUE(has(texts, value)) << name;
  EXPECT_TRUE(has(texts, "2/5"));
  EXPECT_TRUE(has(texts, "1:2"));
  EXPECT_TRUE(has(texts, "A3"));
  EXPECT_TRUE(drawn.warnings.empty());
  const auto is_caption = [](const sheet::Text& text) {
    return text.text == "Surface treatment" && text.role == "caption";
  };
  EXPECT_TRUE(std::any_of(drawn.ink.texts.begin(), drawn.ink.texts.end(), is_caption));
}

// In a time that grows with their square, this would not end.
TEST(TitleBlock, LongTextsAreCutAndSaid) {
  for (const std::string& text : {std::string(100000, 'W'), std::string("word ") + std::string(10000, 'w'),
                                  std::string(10000, ' ') + "x", std::string(10000, '\x80')}) {
    const auto drawn = sheet::draw_title_block(filled(text), paper("A3"), lettering());
    expect_legible(drawn, *sheet::title_block_box(filled(text), paper("A3")));
    EXPECT_EQ(drawn.warnings.empty(), text.ends_with(" x")) << text.substr(0, 9);
  }
}

TEST(TitleBlock, AnEmptyFieldLeavesWhatTheProgramKnows) {
  sheet::TitleBlock block;
  block.scale = "1:2";
  block.size = "A3";
  block.fields = {{"scale", ""}, {"size", "odd"}};
  EXPECT_EQ(sheet::value_of(block, "scale"), "1:2");
  EXPECT_EQ(sheet::value_of(block, "size"), "odd");
}

// As many letters as fit, whatever their number of bytes.
TEST(FitText, CutsBehindTheLastLetterThatFits) {
  std::vector<std::string> letters{"A", "ä", "—", "b", "Ж", "€", "ö", "c", "ß",
                                   "→", "d", "é", "—", "Ü", "i", "—", "l", "€"};
  for (; letters.size() > 8; letters.erase(letters.begin())) {
    std::string text;
    for (const std::string& letter : letters) text += letter;
    for (double width = 6; width < lettering().width(text, sheet::min_text_height); width += 0.41) {
      const sheet::FittedText fitted = sheet::fit_text(text, width, 3.5, lettering());
      ASSERT_TRUE(fitted.cut);
      std::string expected, longer;
      for (std::size_t i = 0; lettering().width(longer + "...", fitted.height) <= width; ++i) {
        expected = longer;
        longer += letters.at(i);
      }
      EXPECT_EQ(fitted.lines, std::vector<std::string>{expected + "..."}) << width;
    }
  }
}

// Drawings are found by their numbers.
TEST(TitleBlock, NeverCutsTheNumber) {
  std::string number = "DRW-2026";
  for (int length : {1, 8, 40, 400}) {
    for (int i = 0; i < length; ++i) number += "-" + std::to_string(100000 + 7 * i);
    sheet::TitleBlock block;
    block.fields = {{"number", number}, {"status", "released"}};
    const auto drawn = sheet::draw_title_block(block, paper("A3"), lettering());
    expect_legible(drawn, *sheet::title_block_box(block, paper("A3")));
    std::string all;
    for (const sheet::Text& text : drawn.ink.texts)
      if (text.role == "field" && text.text != "1/1" && text.text != "released") all += text.text;
    EXPECT_EQ(all, number);
    EXPECT_EQ(drawn.warnings.empty(), length < 40) << "small letters are reported";
  }
}

TEST(TitleBlock, KeepsMarkupAndUnicodeAsTheyAre) {
  for (const std::string text : {"<script>", "Größe 5 µm", "Деталь", "a & b"}) {
    const auto drawn = sheet::draw_title_block(filled(text), paper("A0"), lettering());
    EXPECT_TRUE(has(values(drawn), text)) << text;
  }
}

TEST(TitleBlock, ManyFreeFieldsTakeAtMostHalfOfTheHeight) {
  sheet::TitleBlock block = filled("x");
  for (int i = 0; i < 500; ++i) block.fields.emplace_back("field_" + std::to_string(i), "value");
  const auto box = sheet::title_block_box(block, paper("A4"));
  EXPECT_LE(box->size().y, 95);
  const auto drawn = sheet::draw_title_block(block, paper("A4"), lettering());
  expect_legible(drawn, *box);
  ASSERT_EQ(drawn.warnings.size(), 1U);
  EXPECT_NE(drawn.warnings[0].find("no room"), std::string::npos);
}

TEST(TitleBlock, SmallSheetsHaveNone) {
  EXPECT_FALSE(sheet::title_block_box({}, paper("60x40")));
  EXPECT_EQ(sheet::draw_title_block({}, paper("60x40"), lettering()).warnings.size(), 1U);
}

TEST(TitleBlock, BoxDoesNotDependOnTheScale) {
  sheet::TitleBlock block = filled("x");
  const auto before = sheet::title_block_box(block, paper("A3"));
  block.scale = "";
  block.angle.reset();
  EXPECT_EQ(sheet::title_block_box(block, paper("A3"))->max, before->max);
}

TEST(FitText, ShrinksByStandardHeightsThenBreaksThenCuts) {
  const auto fit = [](const std::string& text, double width) { return sheet::fit_text(text, width, 5, lettering()); };
  const double width = lettering().width("two words", 5);
  EXPECT_EQ(fit("two words", width).height, 5);
  EXPECT_EQ(fit("two words", width * 0.99).height, 3.5);
  EXPECT_EQ(fit("two words", width * 0.49).height, 1.8);
  const sheet::FittedText broken = fit("two words", width * 0.3);
  EXPECT_EQ(broken.lines, (std::vector<std::string>{"two", "words"}));
  EXPECT_FALSE(broken.cut);
  const sheet::FittedText cut = fit("two words, and more of them", width * 0.3);
  EXPECT_TRUE(cut.cut);
  EXPECT_EQ(cut.lines.at(0), "two");
  EXPECT_TRUE(cut.lines.at(1).ends_with("..."));
  for (const std::string& line : cut.lines) EXPECT_LE(lettering().width(line, 1.8), width * 0.3);
}

TEST(FitText, CutsBetweenCharactersAndTidiesSpace) {
  std::string text;
  for (int i = 0; i < 100; ++i) text += "ä";
  const std::string line = sheet::fit_text(text, 20, 3.5, lettering()).lines.at(0);
  EXPECT_EQ((line.size() - 3) % 2, 0U);
  EXPECT_EQ(sheet::fit_text(" a \n\t b\x7f", 90, 3.5, lettering()).lines.at(0), "a b");
  EXPECT_TRUE(sheet::fit_text("", 20, 3.5, lettering()).lines.empty());
  EXPECT_TRUE(sheet::fit_text("\n \t", 20, 3.5, lettering()).lines.empty());
}

TEST(FitText, BreaksWholeTextsAfterSigns) {
  const double width = lettering().width("ABCDEF-0123", 1.8) * 1.01;
  const sheet::FittedText broken = sheet::fit_whole_text("ABCDEF-01234567", {width, 6}, 3.5, lettering());
  EXPECT_EQ(broken.lines, (std::vector<std::string>{"ABCDEF-", "01234567"}));
  EXPECT_EQ(broken.height, 1.8);
  const sheet::FittedText without = sheet::fit_whole_text("ABCDEFG0123456", {width, 6}, 3.5, lettering());
  EXPECT_EQ(without.lines.size(), 2U);
  EXPECT_EQ(without.lines[0] + without.lines[1], "ABCDEFG0123456");
  EXPECT_EQ(sheet::fit_whole_text("A-1", {width, 6}, 3.5, lettering()).height, 3.5);
  EXPECT_TRUE(sheet::fit_whole_text("", {width, 6}, 3.5, lettering()).lines.empty());
}

TEST(ViewLabels, ScaleIsWrittenWhereItIsNotTheSheets) {
  EXPECT_EQ(sheet::view_label("A-A", 0.5, 0.5), "A-A");
  EXPECT_EQ(sheet::view_label("A-A", 2.0, 0.5), "A-A (2:1)");
  EXPECT_EQ(sheet::view_label("", 0.2, 0.5), "(1:5)");
  EXPECT_EQ(sheet::view_label("", 0.5, 0.5), "");
  EXPECT_EQ(sheet::view_label("B", std::nullopt, 0.5), "B");
  EXPECT_EQ(sheet::view_label("B", 0.734, 0.5), "B");
  const sheet::Text text = sheet::label_above("A-A", {{10, 10}, {30, 40}});
  EXPECT_EQ(text.at.x, 20);
  EXPECT_GT(text.at.y, 40);
}

TEST(SheetLayers, HaveNamesAndOneWidthEach) {
  const auto [layers, warnings] = sheet::sheet_layers({paper("A3"), FrameKind::full, filled("x")}, lettering());
  std::vector<std::string> names;
  for (const sheet::Layer& layer : layers) names.push_back(layer.name);
  EXPECT_EQ(names, (std::vector<std::string>{"sheet/frame", "sheet/grid", "sheet/title-block", "sheet/centre-lines",
                                             "sheet/text"}));
  EXPECT_EQ(layers[0].style.width, 0.7);
  EXPECT_EQ(layers[1].style.width, 0.35);
  EXPECT_TRUE(warnings.empty());
  EXPECT_TRUE(sheet::sheet_layers({paper("A3")}, lettering()).layers.empty());
}

}  // namespace
}  // namespace epura::title_block_test
