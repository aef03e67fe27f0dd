// SPDX-License-Identifier: Apache-2.0
#include "sheet/lettering.hpp"

#include <ft2build.h>
#include <gtest/gtest.h>
#include FT_FREETYPE_H

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>

#include "base/error.hpp"
#include "folder.hpp"
#include "sheet/font_file.hpp"

namespace epura::lettering_test {
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

// Other fonts of the computer are not used: only those of the package fonts-dejavu-core.
class OnlyDejaVu {
 public:
  OnlyDejaVu() {
    folder_.file("fonts.conf", "<fontconfig><dir>/usr/share/fonts/truetype/dejavu</dir><cachedir>" +
                                   (folder_ / "cache").string() +
                                   "</cachedir><alias><family>sans-serif</family><prefer><family>DejaVu "
                                   "Sans</family></prefer></alias></fontconfig>");
    setenv("FONTCONFIG_FILE", (folder_ / "fonts.conf").c_str(), 1);
  }
  OnlyDejaVu(const OnlyDejaVu&) = delete;
  OnlyDejaVu& operator=(const OnlyDejaVu&) = delete;
  ~OnlyDejaVu() { unsetenv("FONTCONFIG_FILE"); }

 private:
  test::Folder folder_;
};

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

// Of all letters, whether a table has them or not.
TEST(Lettering, ThePenMovesAsFarAsTheGlyphSays) {
  const sheet::FontFile font(sheet::Lettering::usual_font());
  int known = 0;
  for (char32_t c = 0; c < 0x2400; ++c) {
    const auto advance = font.advance(c);
    ASSERT_EQ(advance.has_value(), font.has(c)) << std::uint32_t(c);
    if (!advance) continue;
    ++known;
    ASSERT_EQ(*advance, font.glyph(font.index_of(c)).advance) << std::uint32_t(c);
  }
  EXPECT_GT(known, 300);
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
  const std::string private_use = "\xF4\x8F\xBF\xBD";
  EXPECT_EQ(lettering.missing("a" + private_use + "b" + private_use), (std::vector<std::string>{private_use}));
  EXPECT_GT(lettering.width(private_use, 3.5), 0);  // a box stands for it
  EXPECT_FALSE(lettering.covers(std::string("\0\xFF", 2)));
}

TEST(Lettering, ControlCharactersAreSpacesAndInvisibleOnesNothing) {
  const sheet::Lettering lettering;
  EXPECT_EQ(sheet::written(std::string("a\0b\nc\x7F\xC2\x85", 8)), "a b c  ");
  EXPECT_EQ(sheet::written("a\xE2\x80\xAE\xEF\xBB\xBF-\xFF"), "a-\xEF\xBF\xBD");
  EXPECT_EQ(lettering.width(std::string("a\0b\n", 4), 5), lettering.width("a b ", 5));
  EXPECT_EQ(lettering.width("a\xE2\x80\xAE", 5), lettering.width("a", 5));
  EXPECT_TRUE(lettering.missing("\xE2\x80\xAE\x01").empty());
}

TEST(FontNotes, NameEachCharacterOnceWithItsFont) {
  const OnlyDejaVu fonts;
  sheet::Sheet sheet{100, 100, "", {{"sheet/text", {"text", 0.35}, {}}}};
  EXPECT_TRUE(sheet::font_notes(sheet).missing.empty());
  for (const char* role : {"title", "label"})
    sheet.layers[0].texts.push_back({"a\xE6\xBC\xA2☃אב☃", {}, 5, 0, {}, role});
  const sheet::FontNotes notes = sheet::font_notes(sheet);
  EXPECT_EQ(notes.missing, (std::vector<std::string>{"\xE6\xBC\xA2"}));
  EXPECT_EQ(notes.role, "title");
  ASSERT_EQ(notes.borrowed.size(), 1u);
  EXPECT_EQ(notes.borrowed[0].first, "DejaVu Sans");
  EXPECT_EQ(notes.borrowed[0].second.size(), 3u);
}

// Sizes of letters from other fonts match: capitals have the same height.
TEST(BorrowedLetters, AreAsHighAsTheOthers) {
  const OnlyDejaVu fonts;
  const sheet::Lettering lettering;
  EXPECT_FALSE(lettering.covers("Ա"));
  FT_Library library = nullptr;
  FT_Face face = nullptr;
  ASSERT_EQ(FT_Init_FreeType(&library), 0);
  ASSERT_EQ(FT_New_Face(library, "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf", 0, &face), 0);
  ASSERT_EQ(FT_Load_Char(face, 'H', FT_LOAD_NO_SCALE), 0);
  const double capital = static_cast<double>(face->glyph->metrics.horiBearingY);
  ASSERT_EQ(FT_Load_Char(face, U'☃', FT_LOAD_NO_SCALE), 0);
  const double width = 3.5 * static_cast<double>(face->glyph->metrics.horiAdvance) / capital;
  const double top = 3.5 * static_cast<double>(face->glyph->metrics.horiBearingY) / capital;
  EXPECT_NEAR(lettering.width("☃", 3.5), width, 1e-9);
  EXPECT_NEAR(extent_of(lettering.outlines("☃", 3.5)).max.y, top, 0.05);
  EXPECT_NEAR(lettering.width("H☃", 3.5), width + lettering.width("H", 3.5), 1e-9);
  EXPECT_NEAR(extent_of(lettering.outlines("☃☃", 3.5)).max.x - extent_of(lettering.outlines("☃", 3.5)).max.x, width,
              1e-9);
  FT_Done_Face(face);
  FT_Done_FreeType(library);
}

// The order on paper of the characters of a line.
std::u32string on_paper(const std::vector<sheet::GlyphRun>& runs) {
  std::u32string line;
  for (const sheet::GlyphRun& run : runs)
    for (const sheet::ShapedGlyph& glyph : run.glyphs) line += run.characters[glyph.cluster];
  return line;
}

// By hand after Unicode Annex 9: digits keep their order within Hebrew, brackets are mirrored as glyphs.
TEST(BorrowedLetters, RunFromRightToLeft) {
  const OnlyDejaVu fonts;
  const sheet::Lettering lettering;
  EXPECT_EQ(on_paper(lettering.runs("אבג", 5)), U"גבא");
  EXPECT_EQ(on_paper(lettering.runs("M8 אבג x", 5)), U"M8 גבא x");
  EXPECT_EQ(on_paper(lettering.runs("אב 12 ג", 5)), U"ג 12 בא");
  EXPECT_EQ(on_paper(lettering.runs("\xE2\x80\xAE"
                                    "ab☃",
                                    5)),
            U"☃ba")
      << "U+202E";
}

TEST(BorrowedLetters, AreJoinedInArabic) {
  const OnlyDejaVu fonts;
  const sheet::Lettering lettering;
  const std::vector<sheet::GlyphRun> runs = lettering.runs("ببب", 5);
  ASSERT_EQ(runs.size(), 1u);
  ASSERT_EQ(runs[0].glyphs.size(), 3u);
  EXPECT_NE(runs[0].glyphs[0].index, runs[0].glyphs[1].index) << "final and medial form";
  EXPECT_NE(runs[0].glyphs[1].index, runs[0].glyphs[2].index) << "medial and initial form";
}

TEST(BorrowedLetters, HaveTheirMarksFromTheSameFont) {
  const OnlyDejaVu fonts;
  const sheet::Lettering lettering;
  ASSERT_TRUE(lettering.covers("x"));
  const std::vector<sheet::GlyphRun> runs = lettering.runs("ax\u0323", 5);
  ASSERT_EQ(runs.size(), 2u);
  EXPECT_EQ(runs[0].characters, U"a");
  EXPECT_EQ(runs[1].characters, U"x\u0323");
}

// U+1A17, a mark of Buginese.
TEST(BorrowedLetters, StayThoseOfTheirFontUnderAMarkThatNoFontHas) {
  const OnlyDejaVu fonts;
  const sheet::Lettering lettering;
  ASSERT_EQ(lettering.missing("\u1A17").size(), 1U);
  const std::vector<sheet::GlyphRun> plain = lettering.runs("☃", 5), marked = lettering.runs("☃\u1A17", 5);
  ASSERT_EQ(plain.size(), 1U);
  ASSERT_EQ(marked.size(), 1U);
  EXPECT_EQ(marked[0].scale, plain[0].scale);
  EXPECT_EQ(marked[0].glyphs.at(0).index, plain[0].glyphs.at(0).index);
}

TEST(Fonts, AreFoundByFamilyOrFile) {
  const sheet::Font family = sheet::find_font("OSIFont", "--font");
  EXPECT_EQ(family.file.filename(), "osifont.ttf");
  EXPECT_EQ(family.family, "osifont");
  const sheet::Font file = sheet::find_font(family.file.string(), "--font");
  EXPECT_EQ(file.file, family.file);
  EXPECT_EQ(file.family, "osifont");
  EXPECT_EQ(sheet::Lettering(file).width("A-A", 5), sheet::Lettering().width("A-A", 5));
}

TEST(Fonts, UnknownOnesAreRefused) {
  const auto refusal = [](const std::string& font) {
    try {
      sheet::find_font(font, "scene.toml:3:8");
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::input);
      EXPECT_EQ(error.where(), "scene.toml:3:8");
      return std::string(error.what()) + "; " + error.hint();
    }
    return std::string("none");
  };
  EXPECT_NE(refusal("osifnt").find("no installed font family is called 'osifnt'; did you mean 'osifont'?"),
            std::string::npos)
      << refusal("osifnt");
  EXPECT_NE(refusal("/nowhere/font.ttf").find("there is no font file '/nowhere/font.ttf'"), std::string::npos);
  const test::Folder folder;
  EXPECT_NE(refusal(folder.file("text.ttf", "no font")).find("is not an outline font"), std::string::npos);
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
}  // namespace epura::lettering_test
