// SPDX-License-Identifier: Apache-2.0
#include "sheet/form.hpp"

#include <gtest/gtest.h>

#include "base/error.hpp"
#include "base/file.hpp"
#include "folder.hpp"

namespace epura::form_test {
namespace {

// Two cells of 40 and 60 mm above each other's width, in the lower right corner of A4.
const std::string frame =
    "<svg width=\"297mm\" height=\"210mm\" viewBox=\"0 0 297 210\">\n"
    "<rect id=\"drawing-area\" x=\"20\" y=\"10\" width=\"267\" height=\"190\" fill=\"none\" stroke=\"#000\"/>\n"
    "<g id=\"title-block\"><rect x=\"187\" y=\"180\" width=\"100\" height=\"20\" fill=\"#eee\" stroke=\"#036\"/>\n"
    "<path d=\"M227 180V200\" stroke=\"#036\"/></g>\n"
    "<text x=\"190\" y=\"195\" font-size=\"5\" id=\"title\">a title</text>\n"
    "<text x=\"230\" y=\"195\" font-size=\"5\" id=\"number\">0</text>\n"
    "<text x=\"188\" y=\"184\" font-size=\"3\">Title</text></svg>\n";

class Forms : public testing::Test {
 protected:
  scene::LocatedText file(const std::string& content, const std::string& name = "frame.svg") {
    write_file(folder_ / name, content);
    return {folder_ / name, "--template"};
  }

  std::shared_ptr<const sheet::Form> form(const std::string& content = frame) {
    return sheet::read_form(file(content));
  }

  test::Folder folder_;
  sheet::Lettering lettering_;
};

void expect_near(const sheet::Rectangle& a, const sheet::Rectangle& b) {
  EXPECT_LT(glm::distance(a.min, b.min), 1e-9);
  EXPECT_LT(glm::distance(a.max, b.max), 1e-9);
}

std::vector<sheet::Text> texts_of(const sheet::DrawnForm& drawn) {
  std::vector<sheet::Text> texts;
  for (const sheet::Layer& layer : drawn.layers) texts.insert(texts.end(), layer.texts.begin(), layer.texts.end());
  return texts;
}

TEST_F(Forms, HaveAreas) {
  const auto read = form();
  expect_near(read->drawing_area, {{20, 10}, {287, 200}});
  ASSERT_TRUE(read->title_block);
  expect_near(*read->title_block, {{187, 10}, {287, 30}});
}

TEST_F(Forms, FieldsGetTheirValuesAndOtherTextsStay) {
  const auto drawn = sheet::draw_form(*form(), {{{"title", "Flange"}, {"number", "7-11"}}}, lettering_);
  const auto texts = texts_of(drawn);
  ASSERT_EQ(texts.size(), 3U);
  EXPECT_EQ(texts[0].text, "Flange");
  EXPECT_LT(glm::distance(texts[0].at, Vec2(190, 15)), 1e-9);
  EXPECT_NEAR(texts[0].height, 5 / lettering_.em(), 1e-9);
  EXPECT_EQ(texts[1].text, "7-11");
  EXPECT_EQ(texts[2].text, "Title");
  EXPECT_TRUE(drawn.warnings.empty());
}

TEST_F(Forms, FieldsWithoutAValueAreEmpty) {
  const auto texts = texts_of(sheet::draw_form(*form(), {}, lettering_));
  ASSERT_EQ(texts.size(), 1U);
  EXPECT_EQ(texts[0].text, "Title");
}

TEST_F(Forms, LongValuesEndBeforeTheNextLine) {
  const auto drawn =
      sheet::draw_form(*form(), {{{"title", "A rather long title of a flange"}, {"number", "N"}}}, lettering_);
  for (const sheet::Text& text : texts_of(drawn))
    if (text.role == "title") {
      EXPECT_LT(text.at.x + lettering_.width(text.text, text.height), 227) << text.text;
    }
}

TEST_F(Forms, ValuesWithoutAFieldAreNamed) {
  const auto drawn = sheet::draw_form(*form(), {{{"title", "T"}, {"mass", "3 kg"}}}, lettering_);
  ASSERT_EQ(drawn.warnings.size(), 1U);
  EXPECT_NE(drawn.warnings[0].find("'mass'"), std::string::npos);
}

TEST_F(Forms, FreeFieldsAreFieldsToo) {
  const std::string with_free = frame.substr(0, frame.rfind("</svg>")) +
                                "<text id=\"Surface-treatment\" x=\"30\" y=\"30\" font-size=\"4\">x</text></svg>";
  const auto texts = texts_of(sheet::draw_form(*form(with_free), {{{"surface treatment", "zinc"}}}, lettering_));
  ASSERT_EQ(texts.size(), 2U);
  EXPECT_EQ(texts[1].text, "zinc");
}

TEST_F(Forms, LooksShareLayersInPaintingOrder) {
  const auto drawn = sheet::draw_form(*form(), {}, lettering_);
  ASSERT_GE(drawn.layers.size(), 3U);
  EXPECT_EQ(drawn.layers[0].name, "sheet/template");
  EXPECT_EQ(drawn.layers[1].style.colour, (Colour{0xee, 0xee, 0xee}));
  EXPECT_EQ(drawn.layers[1].fills.size(), 1U);
  EXPECT_EQ(drawn.layers[2].style.colour, (Colour{0, 0x33, 0x66}));
  EXPECT_EQ(drawn.layers[2].strokes.size(), 2U);
}

TEST_F(Forms, BlankSheetsHaveNoTitleBlock) {
  const auto read = form("<svg width=\"297mm\" height=\"210mm\"><rect width=\"9\" height=\"9\"/></svg>");
  expect_near(*read->title_block, {{287, 10}, {287, 10}});
  const auto drawn = sheet::draw_form(*read, {{{"title", "Flange"}}}, lettering_);
  EXPECT_TRUE(texts_of(drawn).empty());
  ASSERT_EQ(drawn.warnings.size(), 1U);
  EXPECT_NE(drawn.warnings[0].find("no field 'title'"), std::string::npos);
}

TEST_F(Forms, FieldsOfFreeCadHaveTheirUsualNames) {
  const auto field = [](const std::string& name, int y) {
    return "<text x=\"20\" y=\"" + std::to_string(y) + "\" font-size=\"3.5\" freecad:editable=\"" + name +
           "\">A PLACEHOLDER</text>";
  };
  const auto read = form("<svg xmlns:freecad=\"f\" width=\"297mm\" height=\"210mm\" viewBox=\"0 0 297 210\">" +
                         field("DrawingTitle1", 20) + field("AUTHOR_NAME", 30) + field("FC-SC", 40) + field("DN", 50) +
                         field("Лист", 60) + field("Листов", 70) + field("Surface treatment", 80) +
                         field("COPYRIGHT", 90) + "<text x=\"9\" y=\"9\" font-size=\"3\" id=\"DN\">DN</text></svg>");
  sheet::TitleBlock block{{{"title", "Flange"}, {"creator", "Ada"}, {"number", "7"}, {"surface treatment", "zinc"}}};
  block.scale = "1:2";
  block.sheet = 2;
  block.sheets = 3;
  std::vector<std::string> seen;
  const auto drawn = sheet::draw_form(*read, block, lettering_);
  for (const sheet::Text& text : texts_of(drawn)) seen.push_back(text.text);
  EXPECT_EQ(seen, (std::vector<std::string>{"Flange", "Ada", "1:2", "7", "2", "3", "zinc", "DN"}));
  EXPECT_TRUE(drawn.warnings.empty());
}

TEST_F(Forms, MisspeltFieldsAreTold) {
  try {
    (void)form(
        "<svg width=\"297mm\" height=\"210mm\">\n<text font-size=\"4\">Title</text>\n"
        "<text id=\"titel\" font-size=\"4\"/></svg>");
    FAIL();
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("frame.svg:3: the template has no field: 'titel' is none"),
              std::string::npos)
        << error.what();
    EXPECT_EQ(error.hint(), "did you mean 'title'?");
  }
}

TEST_F(Forms, LogosKeepTheirProportions) {
  const auto logo = sheet::read_logo(
      file("<svg width=\"40mm\" height=\"10mm\"><rect width=\"40mm\" height=\"10mm\" fill=\"#c00\"/></svg>", "l.svg"));
  const auto layers = sheet::draw_logo(*logo, {{0, 0}, {20, 20}});
  ASSERT_EQ(layers.size(), 1U);
  Vec2 min(1e9), max(-1e9);
  for (const Vec2& p : layers[0].fills.at(0).rings.at(0)) {
    min = glm::min(min, p);
    max = glm::max(max, p);
  }
  EXPECT_LT(glm::distance(min, Vec2(0, 7.5)), 1e-9);
  EXPECT_LT(glm::distance(max, Vec2(20, 12.5)), 1e-9);
}

TEST_F(Forms, OtherFilesAreNoLogos) {
  EXPECT_THROW((void)sheet::read_logo(file("GIF89a", "l.gif")), Error);
  EXPECT_THROW((void)sheet::read_logo(file("\x89PNG\r\n\x1a\n", "l.png")), Error);
  EXPECT_THROW((void)sheet::read_logo({"missing.svg", "--logo"}), Error);
}

}  // namespace
}  // namespace epura::form_test
