// SPDX-License-Identifier: Apache-2.0
#include "sheet/lettering.hpp"

#include <ft2build.h>
#include <gtest/gtest.h>
#include FT_FREETYPE_H

#include <algorithm>
#include <cmath>

#include "base/error.hpp"

namespace epura {
namespace {

struct Extent {
  Vec2 min{HUGE_VAL}, max{-HUGE_VAL};
};

Extent extent_of(const std::vector<sheet::GlyphOutline>& outlines) {
  Extent extent;
  for (const sheet::GlyphOutline& outline : outlines) {
    for (const sheet::GlyphOutline::Curve& curve : outline.curves) {
      extent.min = glm::min(extent.min, curve.end);
      extent.max = glm::max(extent.max, curve.end);
    }
  }
  return extent;
}

TEST(Lettering, CapitalsAreAsHighAsWanted) {
  const sheet::Lettering lettering;
  const Extent extent = extent_of(lettering.outlines("H", 3.5));
  EXPECT_NEAR(extent.max.y, 3.5, 1e-9);
  EXPECT_NEAR(extent.min.y, 0, 0.02);
}

TEST(Lettering, WidthsAddUpAndScale) {
  const sheet::Lettering lettering;
  EXPECT_GT(lettering.width("H", 3.5), 1.5);
  EXPECT_NEAR(lettering.width("HH", 3.5), 2 * lettering.width("H", 3.5), 1e-12);
  EXPECT_NEAR(lettering.width("Bore", 7), 2 * lettering.width("Bore", 3.5), 1e-12);
  EXPECT_EQ(lettering.width("", 3.5), 0);
  // The second letter begins where the first one ends.
  const double step = lettering.width("H", 5);
  EXPECT_NEAR(extent_of(lettering.outlines("HH", 5)).max.x - extent_of(lettering.outlines("H", 5)).max.x, step, 1e-9);
}

TEST(Lettering, WidthsAreTheFontsOwn) {
  const sheet::Lettering lettering;
  FT_Library library = nullptr;
  FT_Face face = nullptr;
  ASSERT_EQ(FT_Init_FreeType(&library), 0);
  ASSERT_EQ(FT_New_Face(library, lettering.file().c_str(), 0, &face), 0);
  const std::string text = "Wellenlager 0123 (2:1)";
  double advance = 0;
  for (const char c : text) {
    ASSERT_EQ(FT_Load_Char(face, static_cast<FT_ULong>(c), FT_LOAD_NO_SCALE), 0);
    advance += static_cast<double>(face->glyph->metrics.horiAdvance);
  }
  ASSERT_EQ(FT_Load_Char(face, 'H', FT_LOAD_NO_SCALE), 0);
  const double capital = static_cast<double>(face->glyph->metrics.horiBearingY);
  EXPECT_NEAR(lettering.width(text, 3.5), 3.5 * advance / capital, 1e-9);
  EXPECT_NEAR(lettering.em(), face->units_per_EM / capital, 1e-12);
  FT_Done_Face(face);
  FT_Done_FreeType(library);
}

// ISO 3098 type B: lines are a tenth of the height wide, small letters seven tenths high. An I is a vertical bar.
TEST(Lettering, LooksLikeIso3098) {
  const sheet::Lettering lettering;
  const Extent extent = extent_of(lettering.outlines("I", 10));
  EXPECT_NEAR(extent.max.x - extent.min.x, 1, 0.02);
  EXPECT_NEAR(extent_of(lettering.outlines("x", 10)).max.y, 7, 0.05);
}

TEST(Lettering, OutlinesAreClosedCurves) {
  const sheet::Lettering lettering;
  for (const sheet::GlyphOutline& outline : lettering.outlines("Bog8 \xC3\x98", 3.5)) {
    EXPECT_GE(outline.curves.size(), 2u);
    for (const sheet::GlyphOutline::Curve& curve : outline.curves)
      EXPECT_TRUE(std::isfinite(curve.control.x) && std::isfinite(curve.end.y));
  }
  EXPECT_EQ(lettering.outlines("B", 3.5).size(), 3u);
  EXPECT_TRUE(lettering.outlines(" ", 3.5).empty());
}

TEST(Lettering, KnowsWhatItCannotWrite) {
  const sheet::Lettering lettering;
  EXPECT_TRUE(lettering.missing("Gehäuse ø12 ±0,1 °").empty());
  EXPECT_EQ(lettering.missing("a\xE2\x98\x83"
                              "b\xE2\x98\x83"),
            (std::vector<std::string>{"\xE2\x98\x83"}));
  EXPECT_GT(lettering.width("\xE2\x98\x83", 3.5), 0);  // a box stands for it
  EXPECT_FALSE(lettering.missing(std::string("\0\xFF", 2)).empty());
}

TEST(Lettering, ControlCharactersAreSpacesAndInvisibleOnesNothing) {
  const sheet::Lettering lettering;
  EXPECT_EQ(sheet::written(std::string("a\0b\nc\x7F\xC2\x85", 8)), "a b c  ");
  EXPECT_EQ(sheet::written("a\xE2\x80\xAE\xEF\xBB\xBF-\xFF"), "a-\xEF\xBF\xBD");
  EXPECT_EQ(lettering.width(std::string("a\0b\n", 4), 5), lettering.width("a b ", 5));
  EXPECT_EQ(lettering.width("a\xE2\x80\xAE", 5), lettering.width("a", 5));
  EXPECT_TRUE(lettering.missing("\xE2\x80\xAE\x01").empty());
}

TEST(MissingCharacters, AreToldOnceWithTheirText) {
  sheet::Sheet sheet{100, 100, "", {{"sheet/text", {"text", 0.35}, {}}}};
  EXPECT_TRUE(sheet::missing_characters(sheet).empty());
  for (const char* role : {"title", "label"}) sheet.layers[0].texts.push_back({"a\xE6\xBC\xA2", {}, 5, 0, {}, role});
  const std::vector<sheet::MissingCharacter> missing = sheet::missing_characters(sheet);
  ASSERT_EQ(missing.size(), 1u);
  EXPECT_EQ(missing[0].character, "\xE6\xBC\xA2");
  EXPECT_EQ(missing[0].role, "title");
}

TEST(Lettering, AMissingFontIsSaid) {
  try {
    const sheet::Lettering lettering("/nowhere/font.ttf");
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::input);
    EXPECT_NE(error.hint().find("fonts-osifont"), std::string::npos);
  }
  EXPECT_THROW(sheet::Lettering("/dev/null"), Error);
}

}  // namespace
}  // namespace epura
