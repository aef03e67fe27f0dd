// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>

#include "output/write.hpp"
#include "pdf_reader.hpp"
#include "support.hpp"

namespace epura::pdf_test {
namespace {

constexpr double millimetre = 72 / 25.4;

std::vector<std::string_view> tokens_of(std::string_view text) {
  std::vector<std::string_view> tokens;
  while (true) {
    const std::size_t begin = text.find_first_not_of(" \n[]");
    if (begin == std::string_view::npos) return tokens;
    text.remove_prefix(begin);
    const std::size_t end = std::min(text.find_first_of(" \n[]"), text.size());
    tokens.push_back(text.substr(0, end));
    text.remove_prefix(end);
  }
}

// Scale and shift of the first "cm": matrices here neither turn nor skew.
struct Map {
  Vec2 scale, shift;
  [[nodiscard]] Vec2 operator()(const Vec2& p) const { return p * scale + shift; }
};

Map map_of(const std::vector<std::string_view>& tokens) {
  std::size_t cm = 0;
  while (tokens.at(cm) != "cm") ++cm;
  const auto number = [&](std::size_t i) { return number_in(tokens[cm - 6 + i]); };
  EXPECT_EQ(number(1), 0);
  EXPECT_EQ(number(2), 0);
  return {{number(0), number(3)}, {number(4), number(5)}};
}

std::vector<Ink> ink_of(const std::string& content, const Map& to_page) {
  const auto tokens = tokens_of(content);
  const Map to_form = map_of(tokens);
  std::vector<Ink> lines;
  bool open = false;
  for (std::size_t i = 2; i < tokens.size(); ++i) {
    if (tokens[i] == "S") open = false;
    if (tokens[i] == "h") lines.back().closed = true;
    if (tokens[i] != "m" && tokens[i] != "l") continue;
    if (tokens[i] == "m") {
      if (open) continue;  // Cairo moves back to the start after closing
      lines.emplace_back();
      open = true;
    }
    const Vec2 p(number_in(tokens[i - 2]), number_in(tokens[i - 1]));
    lines.back().points.push_back(to_page(to_form(p)) / millimetre);
  }
  return lines;
}

class PdfOfSize : public testing::TestWithParam<Vec2> {};

TEST_P(PdfOfSize, KeepsCoordinatesAndLayers) {
  const sheet::Sheet sheet = random_sheet(GetParam().x, GetParam().y);
  const std::string bytes = output::to_pdf({&sheet});
  const PdfReader pdf(bytes);
  const PdfObject page = pdf.page();
  EXPECT_EQ(pdf.pages(), 1);
  const PdfObject box = page["/MediaBox"];
  EXPECT_NEAR(box[2].number(), GetParam().x * millimetre, 1e-9 * GetParam().x);
  EXPECT_NEAR(box[3].number(), GetParam().y * millimetre, 1e-9 * GetParam().x);

  const Map to_page = map_of(tokens_of(page["/Contents"][0].stream()));
  const PdfObject resources = page["/Resources"];
  for (std::size_t i = 0; i < sheet.layers.size(); ++i) {
    const std::string name = "/layer" + std::to_string(i);
    const PdfObject group = resources["/Properties"][name.c_str()];
    EXPECT_EQ(group["/Type"].name(), "/OCG");
    EXPECT_EQ(group["/Name"].text(), sheet.layers[i].name);
    const PdfObject layer = page["/Contents"][2 * static_cast<int>(i) + 1];
    EXPECT_TRUE(layer.has("/Filter"));
    EXPECT_LT(largest_error(sheet.layers[i].strokes, ink_of(layer.stream(), to_page)), 1e-4);
  }
  EXPECT_FALSE(pdf.has_trouble());
}

INSTANTIATE_TEST_SUITE_P(Sizes, PdfOfSize,
                         testing::Values(Vec2(297, 210), Vec2(1189, 841), Vec2(123.4567, 33.3333), Vec2(12000, 3000),
                                         Vec2(20000, 20000)));

TEST(Pdf, EveryLayerIsOptionalContent) {
  const sheet::Sheet sheet = random_sheet(100, 100);
  const std::string bytes = output::to_pdf({&sheet});
  EXPECT_GE(bytes.substr(0, 8), "%PDF-1.5");
  const PdfReader pdf(bytes);
  const PdfObject properties = pdf.root()["/OCProperties"];
  ASSERT_EQ(properties["/OCGs"].size(), 2);
  EXPECT_EQ(properties["/OCGs"][0]["/Name"].text(), "a view/hidden");
  EXPECT_EQ(properties["/D"]["/Order"].size(), 2);
  // What is drawn of a layer stands between its marks.
  const PdfObject page = pdf.page();
  ASSERT_EQ(page["/Contents"].size(), 5);
  EXPECT_TRUE(page["/Contents"][0].stream().ends_with("cm\n/OC /layer0 BDC\n"));
  EXPECT_TRUE(page["/Contents"][2].stream().starts_with("EMC\nQ\n"));
  EXPECT_TRUE(page["/Contents"][2].stream().ends_with("cm\n/OC /layer1 BDC\n"));
  EXPECT_EQ(page["/Contents"][4].stream(), "EMC\nQ\n");
}

TEST(Pdf, WidthsAndDashesAreInMillimetres) {
  sheet::Sheet sheet = random_sheet(100, 100, 0);
  sheet.layers[0].strokes.push_back({{{10, 10}, {60, 10}}, false, {2.9, 0.75}});
  const std::string bytes = output::to_pdf({&sheet});
  const PdfReader pdf(bytes);
  const PdfObject page = pdf.page();
  const double scale = map_of(tokens_of(page["/Contents"][0].stream())).scale.x / millimetre;
  const std::string form = page["/Contents"][1].stream();
  const auto tokens = tokens_of(form);
  const auto before = [&](std::string_view name, std::size_t back) {
    const auto found = std::find(tokens.begin(), tokens.end(), name);
    return scale * number_in(*(found - static_cast<std::ptrdiff_t>(back)));
  };
  EXPECT_NEAR(before("w", 1), 0.25, 1e-6);
  EXPECT_NEAR(before("d", 3), 2.9, 1e-6);
  EXPECT_NEAR(before("d", 2), 0.75, 1e-6);
}

TEST(Pdf, SheetsBecomePages) {
  sheet::Sheet first = random_sheet(100, 50, 3), second = random_sheet(200, 100, 4);
  second.layers.push_back({"notes", {"visible", 0.5}, {}});
  const std::string bytes = output::to_pdf({&first, &second});
  const PdfReader pdf(bytes);
  ASSERT_EQ(pdf.pages(), 2);
  EXPECT_NEAR(pdf.page(1)["/MediaBox"][2].number(), 200 * millimetre, 1e-9);
  const Map to_page = map_of(tokens_of(pdf.page(1)["/Contents"][0].stream()));
  const std::string form = pdf.page(1)["/Contents"][3].stream();
  EXPECT_LT(largest_error(second.layers[1].strokes, ink_of(form, to_page)), 1e-4);
  const PdfObject optional = pdf.root()["/OCProperties"];
  std::vector<std::string> names;
  for (int i = 0; i < optional["/OCGs"].size(); ++i) names.push_back(optional["/OCGs"][i]["/Name"].text());
  EXPECT_EQ(names, (std::vector<std::string>{"a view/hidden", "a view/visible", "a view/hidden (2)",
                                             "a view/visible (2)", "notes"}));
  const PdfObject order = optional["/D"]["/Order"];
  ASSERT_EQ(order.size(), 2);
  EXPECT_EQ(order[1].size(), 4);
  EXPECT_EQ(order[1][0].text(), "Sheet 2: random");
  EXPECT_EQ(order[1][3]["/Name"].text(), "notes");
  EXPECT_FALSE(pdf.has_trouble());
}

TEST(Pdf, BookmarksLeadToViews) {
  sheet::Sheet sheet = random_sheet(100, 100, 1);
  sheet.views = {{"front", "front", "1:2", {10, 20}, {40, 50}}, {"top", "top", "", {50, 20}, {80, 50}}};
  sheet::Sheet bare = random_sheet(50, 50, 1);
  bare.title = "";
  const std::string bytes = output::to_pdf({&sheet, &bare});
  const PdfReader pdf(bytes);
  const PdfObject outlines = pdf.root()["/Outlines"];
  EXPECT_EQ(outlines["/Count"].number(), 4);
  const PdfObject first = outlines["/First"], second = outlines["/Last"];
  EXPECT_EQ(first["/Title"].text(), "Sheet 1: random");
  EXPECT_EQ(first["/Next"]["/Title"].text(), "Sheet 2");
  EXPECT_EQ(second["/Prev"]["/Title"].text(), "Sheet 1: random");
  EXPECT_EQ(second["/Dest"][1].name(), "/Fit");
  EXPECT_FALSE(second.has("/First"));
  const PdfObject front = first["/First"];
  EXPECT_EQ(front["/Title"].text(), "front");
  EXPECT_EQ(front["/Next"]["/Title"].text(), "top");
  EXPECT_EQ(front["/Parent"]["/Title"].text(), "Sheet 1: random");
  EXPECT_EQ(front["/Dest"][0]["/Type"].name(), "/Page");
  EXPECT_EQ(front["/Dest"][1].name(), "/FitR");
  EXPECT_NEAR(front["/Dest"][2].number(), 5 * millimetre, 1e-9);
  EXPECT_NEAR(front["/Dest"][5].number(), 55 * millimetre, 1e-9);
}

TEST(Pdf, SaysWhoDrewWhat) {
  sheet::Sheet sheet = random_sheet(100, 100, 1);
  sheet.views = {{"front", "front", "1:2", {10, 20}, {40, 50}}, {"round", "isometric", "", {50, 20}, {80, 50}}};
  sheet.facts = {{"author", "N\xC3\xA4. <&)"}};
  const std::string bytes = output::to_pdf({&sheet});
  const PdfReader pdf(bytes);
  const PdfObject information = pdf.trailer()["/Info"];
  EXPECT_EQ(information["/Author"].text(), "N\xC3\xA4. <&)");
  EXPECT_EQ(information["/Subject"].text(), "front 1:2, round (isometric)");
  EXPECT_EQ(information["/Producer"].text(), "epura");
}

TEST(Pdf, TitleIsKeptAndNoDateIsWritten) {
  sheet::Sheet sheet = random_sheet(100, 100, 1);
  sheet.title = "<script>&\"') W\xC3\xBCrfel \xE2\x82\xAC";
  const std::string bytes = output::to_pdf({&sheet});
  const PdfReader pdf(bytes);
  const PdfObject information = pdf.trailer()["/Info"];
  EXPECT_EQ(information["/Title"].text(), sheet.title);
  EXPECT_FALSE(information.has("/CreationDate"));
}

}  // namespace
}  // namespace epura::pdf_test
