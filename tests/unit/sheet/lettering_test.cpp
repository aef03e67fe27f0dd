#include "sheet/lettering.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "base/error.hpp"

namespace epura {
namespace {

struct Extent {
  Vec2 least{HUGE_VAL}, most{-HUGE_VAL};
};

Extent extent_of(const std::vector<GlyphOutline>& outlines) {
  Extent extent;
  for (const GlyphOutline& outline : outlines) {
    for (const GlyphOutline::Curve& curve : outline.curves) {
      extent.least = glm::min(extent.least, curve.end);
      extent.most = glm::max(extent.most, curve.end);
    }
  }
  return extent;
}

TEST(Lettering, CapitalsAreAsHighAsWanted) {
  const Lettering lettering;
  const Extent extent = extent_of(lettering.outlines("H", 3.5));
  EXPECT_NEAR(extent.most.y, 3.5, 1e-9);
  EXPECT_NEAR(extent.least.y, 0, 0.02);
}

TEST(Lettering, WidthsAddUpAndScale) {
  const Lettering lettering;
  EXPECT_GT(lettering.width("H", 3.5), 1.5);
  EXPECT_NEAR(lettering.width("HH", 3.5), 2 * lettering.width("H", 3.5), 1e-12);
  EXPECT_NEAR(lettering.width("Bore", 7), 2 * lettering.width("Bore", 3.5), 1e-12);
  EXPECT_EQ(lettering.width("", 3.5), 0);
  // The second letter begins where the first one ends.
  const double step = lettering.width("H", 5);
  EXPECT_NEAR(extent_of(lettering.outlines("HH", 5)).most.x - extent_of(lettering.outlines("H", 5)).most.x, step, 1e-9);
}

// ISO 3098 type B: lines are a tenth of the height wide. The foot of an I is a vertical bar.
TEST(Lettering, LinesAreATenthOfTheHeight) {
  const Lettering lettering;
  const Extent extent = extent_of(lettering.outlines("I", 10));
  EXPECT_NEAR(extent.most.x - extent.least.x, 1, 0.25);
}

TEST(Lettering, OutlinesAreClosedCurves) {
  const Lettering lettering;
  for (const GlyphOutline& outline : lettering.outlines("Bog8 \xC3\x98", 3.5)) {
    EXPECT_GE(outline.curves.size(), 2u);
    for (const GlyphOutline::Curve& curve : outline.curves)
      EXPECT_TRUE(std::isfinite(curve.control.x) && std::isfinite(curve.end.y));
  }
  EXPECT_EQ(lettering.outlines("B", 3.5).size(), 3u);
  EXPECT_TRUE(lettering.outlines(" ", 3.5).empty());
}

TEST(Lettering, KnowsWhatItCannotWrite) {
  const Lettering lettering;
  EXPECT_TRUE(lettering.missing("Gehäuse ø12 ±0,1 °").empty());
  EXPECT_EQ(lettering.missing("a\xE2\x98\x83"
                              "b\xE2\x98\x83"),
            (std::vector<std::string>{"\xE2\x98\x83"}));
  EXPECT_GT(lettering.width("\xE2\x98\x83", 3.5), 0);  // a box stands for it
  EXPECT_FALSE(lettering.missing(std::string("\0\xFF", 2)).empty());
}

TEST(Lettering, AMissingFontIsSaid) {
  try {
    const Lettering lettering("/nowhere/font.ttf");
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.trouble(), Trouble::input);
    EXPECT_NE(error.hint().find("fonts-osifont"), std::string::npos);
  }
  EXPECT_THROW(Lettering("/dev/null"), Error);
}

}  // namespace
}  // namespace epura
