// SPDX-License-Identifier: Apache-2.0
// Texts and filled areas in every format.
#include "sheet/lettering.hpp"

#include <gtest/gtest.h>

#include "output/write.hpp"
#include "rasters.hpp"

namespace epura::lettering_test {
namespace {

sheet::Sheet lettered() {
  sheet::Sheet sheet{120, 80, "lettered", {}};
  sheet::Layer layer{"sheet/text", {"frame", 0.35}, {}};
  layer.strokes.push_back({{{5, 5}, {115, 5}, {115, 75}, {5, 75}}, true});
  layer.fills.push_back({{{{80, 20}, {110, 20}, {110, 40}, {80, 40}}, {{90, 25}, {100, 25}, {100, 35}, {90, 35}}}});
  layer.texts = {{"Gehäuse Ø12 <&>", {10, 65}, 5, 0, sheet::Align::left, "title"},
                 {"middle", {60, 52}, 3.5, 0, sheet::Align::middle, "label"},
                 {"right", {110, 52}, 3.5, 0, sheet::Align::right, "label"},
                 {"upright", {10, 10}, 7, 90, sheet::Align::left, "label"},
                 {"aslant 30", {25, 10}, 3.5, 30, sheet::Align::left, "label"}};
  sheet.layers.push_back(std::move(layer));
  return sheet;
}

class LetteredRasters : public Rasters {
 protected:
  static constexpr double dpi = 203.2;  // 8 pixels a millimetre
};

// Cairo moves the glyphs of the PDF to whole pixels, by half a pixel at most: no pixel turns from black to white.
TEST_F(LetteredRasters, SvgAndPdfLookTheSame) {
  const sheet::Sheet sheet = lettered();
  const GreyPicture pdf = of_pdf(sheet, dpi);
  ASSERT_GT(pdf.width, 900);
  EXPECT_LT(difference(pdf, of_svg(sheet, dpi)), 1e-4);
  sheet::Sheet shifted = sheet;
  for (sheet::Text& text : shifted.layers[0].texts) text.at.x += 0.2;
  EXPECT_GT(difference(pdf, of_svg(shifted, dpi)), 2e-3);
}

TEST_F(LetteredRasters, PdfKeepsTextAsText) {
  const sheet::Sheet sheet = lettered();
  write("sheet.pdf", output::to_pdf({&sheet}));
  const std::string text = run("pdftotext -layout " + path("sheet.pdf") + " -");
  EXPECT_NE(text.find("Gehäuse Ø12 <&>"), std::string::npos) << text;
  EXPECT_NE(text.find("upright"), std::string::npos) << text;
  EXPECT_NE(run("pdffonts " + path("sheet.pdf")).find("osifont"), std::string::npos);
}

// Letters that the lettering font lacks, from whatever fonts there are.
TEST_F(LetteredRasters, BorrowedLettersAreTheSameInSvgAndPdf) {
  sheet::Sheet sheet = lettered();
  sheet.layers[0].texts = {{"M8 אבג x ☃", {10, 65}, 5, 0, sheet::Align::left, "title"},
                           {"ببب ☂", {110, 52}, 3.5, 0, sheet::Align::right, "label"},
                           {"x\u0323 aslant", {25, 10}, 7, 30, sheet::Align::left, "label"}};
  const GreyPicture pdf = of_pdf(sheet, dpi);
  EXPECT_LT(difference(pdf, of_svg(sheet, dpi)), 1e-4);
  write("sheet.pdf", output::to_pdf({&sheet}));
  EXPECT_EQ(output::to_pdf({&sheet}), output::to_pdf({&sheet}));
  const std::string text = run("pdftotext -layout " + path("sheet.pdf") + " -");
  for (const char* found : {"אבג", "ببب", "☃", "☂", "x\u0323"}) EXPECT_NE(text.find(found), std::string::npos) << found;
  const std::string fonts = run("pdffonts " + path("sheet.pdf"));
  EXPECT_EQ(fonts.find(" no "), fonts.rfind(" no ")) << "every font is embedded:\n" << fonts;
}

TEST(Lettered, TheSameBytesEachTime) {
  const sheet::Sheet sheet = lettered();
  EXPECT_EQ(output::to_pdf({&sheet}), output::to_pdf({&sheet}));
  EXPECT_EQ(output::to_ps({&sheet}), output::to_ps({&sheet}));
  EXPECT_EQ(output::to_svg(sheet, {}), output::to_svg(sheet, {}));
}

TEST(Lettered, SvgHasOutlinesOrText) {
  const std::string outlines = output::to_svg(lettered(), {});
  EXPECT_NE(outlines.find("aria-label=\"Gehäuse Ø12 &lt;&amp;&gt;\""), std::string::npos);
  EXPECT_EQ(outlines.find("<text"), std::string::npos);
  output::VectorOptions options;
  options.text = SvgText::text;
  const std::string text = output::to_svg(lettered(), options);
  EXPECT_NE(text.find(">Gehäuse Ø12 &lt;&amp;&gt;</text>"), std::string::npos);
  EXPECT_NE(text.find("transform=\"rotate(-30 25 70)\""), std::string::npos);
}

}  // namespace
}  // namespace epura::lettering_test
