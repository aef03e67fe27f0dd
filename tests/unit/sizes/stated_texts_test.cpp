// SPDX-License-Identifier: Apache-2.0
// What texts say against what the part has, and what they leave open.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include "crossed_parts.hpp"
#include "dimensioned_part.hpp"
#include "turned_parts.hpp"

namespace epura::test::stated_texts_test {
namespace {

/// What is said of a part whose dimension with one text has another.
Said said(const DimensionedPart& part, const std::string& text, const std::string& by) {
  const auto at = std::find(part.texts.begin(), part.texts.end(), text);
  EXPECT_NE(at, part.texts.end()) << text << " of " << testing::PrintToString(part.texts);
  return part.with_text(static_cast<std::size_t>(at - part.texts.begin()), by, false);
}

/// The untrue texts, without the view of each.
std::string untrue(const Said& faces) {
  std::string text;
  for (const std::string& one : faces.untrue) text += one.substr(0, one.find(" in view")) + one.substr(one.find(':'));
  return text;
}

/// A block of 60 x 40 x 20 with a blind hole of 8 at (20, 15), 12 deep, whose point has an angle; 0: flat.
std::string block_with_point(double angle) {
  Loop profile{{4, 20}, {4, 8}};
  if (angle > 0) profile.emplace_back(0, 8 - 4 / (sine(angle / 2) / cosine(angle / 2)));
  return plate_with_round({60, 40}, 20, {20, 15}, profile);
}

/// A plate with two rows of blind holes of 8, those in the second row one deeper.
std::string plate_with_two_depths() {
  return plate({30, 30}, 3, 2, 20, [](const Vec2& centre) {
    return stepped_hole({{4, 20}, {4, centre.y < 30 ? 12 : 9}, {0, centre.y < 30 ? 12 : 9}})(centre);
  });
}

/// A disc of 40 with one of 20 on it, whose centre is elsewhere.
std::string eccentric_disc(const Vec2& centre) {
  const Loop outside = circle({0, 0}, 20, 0), boss = circle(centre, 10, 0);
  Model model;
  model.fan(boss, 50, true);
  model.fan(outside, 0, false);
  for (std::size_t i = 0; i < boss.size(); ++i) {
    const std::size_t j = (i + 1) % boss.size();
    model.face({Vec3(boss[j], 50), Vec3(boss[i], 50), Vec3(boss[i], 20), Vec3(boss[j], 20)});
    model.face({Vec3(outside[i], 20), Vec3(outside[j], 20), Vec3(boss[j], 20), Vec3(boss[i], 20)});
    model.face({Vec3(outside[j], 20), Vec3(outside[i], 20), Vec3(outside[i], 0), Vec3(outside[j], 0)});
  }
  return model.obj();
}

std::string told(const sheet::FreeFaces& faces) {
  std::string text;
  for (const sheet::FreeFace& one : faces.free) text += one.sentence + "\n";
  for (const std::string& one : faces.undecided) text += one + "\n";
  return text;
}

}  // namespace

TEST(StatedTexts, AreJudgedByTheirFirstSizeWhateverFollows) {
  const DimensionedPart part(sloped_block);
  for (const char* text : {"60", "60.0", "60,00", "60 ±0.1", "60 +0.2 -0.1", "60.2-59.9", "60.1/59.9", "60 H7",
                           "60 (2.36)", "2 off 60", "60 MAX", "<> H7"}) {
    const Said faces = part.with_text(0, text, false);
    EXPECT_EQ(untrue(faces) + told(faces), "") << text;
  }
  for (const char* text : {"60.1", "61 +0.2 -0.1", "61.2-61.1", "61.2 / 61.1", "61 H7", "59.9 (2.36)", "60.01 [2.36]"})
    EXPECT_EQ(untrue(part.with_text(0, text, false)), "'" + std::string(text) + "': the part has 60");
}

TEST(StatedTexts, OfNoSizeLeaveItOpen) {
  const DimensionedPart part(sloped_block);
  for (const char* text : {"see note", "A", "L1", "1/2"}) {
    const Said faces = part.with_text(0, text, false);
    ASSERT_EQ(faces.undecided.size(), 1U) << text;
    EXPECT_NE(faces.undecided[0].find("nobody can tell what this says"), std::string::npos) << faces.undecided[0];
  }
  for (const char* text : {"(60)", "60 REF"}) EXPECT_EQ(part.with_text(0, text, false).free.size(), 1U) << text;
}

TEST(StatedTexts, SayTheKindTheUnitAndTheCount) {
  const DimensionedPart part(sloped_block);
  for (const char* text :
       {"60 cm", "10 ±1 cm", "60 in", "60°", "R60", "⌀60", "SR60", "M60", "60 THRU", "60 ↧3", "60 (2.5 in)", "60 (61)",
        "□60", "60 H7 (60.04/60)", "59 H7 (+0.03/0)", "3 3/8 in", "(61)", "50 = 61", "6×10=61"})
    EXPECT_EQ(part.with_text(0, text, false).untrue.size(), 1U) << text;
  EXPECT_EQ(untrue(part.with_text(0, "2× 60", false)), "'2× 60': the part has 1 of these");
  for (const char* text : {"60 (2.362 in)", "6 cm", "(60)", "[60]", "60 ±0.1 mm", "60 H7 (60.03/60)", "60 H7 (+0.03/0)",
                           "59.5 +1/0", "ca. 60", "60 LONG", "L=60", "Tiefe 60", "2 23/64 in"})
    EXPECT_EQ(untrue(part.with_text(0, text, false)), "") << text;
}

TEST(StatedTexts, ThatNobodyUnderstandsAreTold) {
  const DimensionedPart part(sloped_block);
  EXPECT_TRUE(part.free().unjudged.empty()) << testing::PrintToString(part.free().unjudged);
  for (const char* text : {"60-70", "6O", "sixty", "EQ SP 60", "60x2", "60 H77", "see note"}) {
    const Said faces = part.with_text(0, text, false);
    EXPECT_EQ(untrue(faces), "") << text;
    EXPECT_EQ(faces.unjudged.size(), 1U) << text;
  }
}

TEST(StatedTexts, OfAnglesHaveMinutes) {
  const DimensionedPart part(ring_with_holes({10, 90, 200}, 35, 4));
  const auto is_angle_of_10 = [&](const std::string& text) {
    bool any = false;
    for (std::size_t i = 0; i < part.texts.size(); ++i)
      any = any || (part.texts[i].empty() && part.with_text(i, text, false).untrue.empty());
    return any;
  };
  for (const char* text : {"10°", "10°0'", "9°60'", "9°59'60\"", "10° ±30'"}) EXPECT_TRUE(is_angle_of_10(text)) << text;
  for (const char* text : {"10°1'", "10°30'", "10°0'1\""}) EXPECT_FALSE(is_angle_of_10(text)) << text;
}

TEST(StatedTexts, OfNotesAreThoseOfTheHole) {
  const DimensionedPart part(block_with_point(118));
  EXPECT_EQ(told(part.free()), "");
  EXPECT_EQ(untrue(said(part, "<> ↧12", "⌀8 ↧12")), "");
  EXPECT_EQ(untrue(said(part, "<> ↧12", "⌀9 ↧12")), "'⌀9 ↧12': the part has 8");
  EXPECT_EQ(untrue(said(part, "<> ↧12", "⌀8 ↧10")), "'⌀8 ↧10': the part has ↧12 there");
  EXPECT_EQ(untrue(said(part, "<> ↧12", "<> ↧12 ⌵⌀12×90°")),
            "'⌀8 ↧12 ⌵⌀12×90°': the part has no countersink of ⌀12 there");
  EXPECT_EQ(untrue(said(part, "<> ↧12", "⌀8 ON ⌀56 BC ↧12")), "");
  EXPECT_EQ(untrue(said(part, "<> ↧12", "M8 ↧10")), "") << "the thread may be shorter than the hole";
}

// In a plate of 10: 6 is what is left below the recess.
TEST(StatedTexts, OfRecessesAreThoseOfTheWallsAboutTheAxis) {
  const DimensionedPart part(plate({30, 30}, 2, 2, 10, stepped_hole({{5, 10}, {5, 6}, {3, 6}, {3, 0}})));
  const std::string own = "4× <> ⌴⌀10 ↧4";
  for (const char* text : {"4× <> ⌴⌀10 ↧4", "4 HOLES ⌀6 C BORE ⌀10 X 4 DEEP", "4X ⌀6 CBORE ⌀10 DEPTH 4", "4× R3 ⌴R5 ↧4",
                           "4× ⌀6 THRU ALL ⌴⌀10 ↧4"})
    EXPECT_EQ(untrue(said(part, own, text)), "") << text;
  const auto has = [&](const std::string& text) {
    const std::string all = untrue(said(part, own, text));
    return all.substr(std::min(all.size(), all.find("': the part has ")));
  };
  const std::string there = "': the part has ";
  EXPECT_EQ(has("4× ⌀6 ⌴⌀10 ↧6"), there + "↧4 there");
  EXPECT_EQ(has("4× ⌀6 C BORE ⌀10 X 6 DEEP"), there + "↧4 there");
  EXPECT_EQ(has("4× ⌀6 ⌵⌀10×90°"), there + "a counterbore there");
  EXPECT_EQ(has("4× ⌀6 ⌴⌀12 ↧4"), there + "no counterbore of ⌀12 there");
  EXPECT_EQ(has("4× ⌀6 ↧6 ⌴⌀10 ↧4"), there + "a through hole there");
  EXPECT_EQ(has("4× ⌀6 BLIND ⌴⌀10 ↧4"), there + "a through hole there");
  EXPECT_EQ(has("5× ⌀6 ⌴⌀10 ↧4"), there + "4 of these");
  EXPECT_EQ(untrue(said(DimensionedPart(block_with_point(118)), "<> ↧12", "⌀8 THRU")),
            "'⌀8 THRU': the part has a blind hole there");
}

TEST(StatedTexts, OfCountersinksAreThoseOfTheirCone) {
  const DimensionedPart part(plate({30, 30}, 2, 1, 10, stepped_hole({{6, 10}, {3, 7}, {3, 0}})));
  const auto own = std::find_if(part.texts.begin(), part.texts.end(),
                                [](const std::string& text) { return text.find("⌵") != std::string::npos; });
  ASSERT_NE(own, part.texts.end()) << testing::PrintToString(part.texts);
  for (const char* text : {"2× ⌀6 ⌵⌀12×90°", "2x Ø6 CSK Ø12 X 90°", "2× ⌀6 ⌵⌀12 ↧3"})
    EXPECT_EQ(untrue(said(part, *own, text)), "") << text;
  for (const char* text : {"2× ⌀6 ⌵⌀12×60°", "2× ⌀6 ⌵⌀13×90°", "2× ⌀6 ⌴⌀12 ↧3", "3× ⌀6 ⌵⌀12×90°", "2× ⌀6 ↧7 ⌵⌀12×90°"})
    EXPECT_EQ(said(part, *own, text).untrue.size(), 1U) << text;
}

TEST(StatedTexts, SayTheSameInWordsOfWorkshops) {
  const DimensionedPart blind(block_with_point(118));
  for (const char* text : {"⌀8 Tiefe 12", "⌀8, 12 tief", "8 DIA X 12 DEEP", "Ø8 prof. 12 mm", "D8 profondità 12",
                           "⌀8 x 12", "⌀8 H7 ↧12 ±0.2", "⌀8 SACKLOCH ↧12", "DRILL 8 DEPTH 12", "Φ8 ↧12 flat bottom"})
    EXPECT_EQ(testing::PrintToString(said(blind, "<> ↧12", text).untrue) +
                  testing::PrintToString(said(blind, "<> ↧12", text).unjudged),
              "{}{}")
        << text;
  for (const char* text : {"⌀8 Tiefe 11", "⌀8, 13 tief", "⌀8 durch", "⌀8 débouchant", "⌀8 x 13", "⌀8 x 45°",
                           "⌀8 passante ↧12", "⌀8 ↧12, Senkung 90° ⌀12", "⌀8 ↧12 lamage ⌀12 prof. 2"})
    EXPECT_EQ(said(blind, "<> ↧12", text).untrue.size(), 1U) << text;
  const DimensionedPart recess(plate({30, 30}, 2, 2, 10, stepped_hole({{5, 10}, {5, 6}, {3, 6}, {3, 0}})));
  for (const char* text : {"4 Bohrungen ⌀6 durch, Senkung ⌀10 Tiefe 4", "4 trous ⌀6 débouchants lamage ⌀10 prof. 4",
                           "⌀6 THRU ⌴⌀10 ↧4 4 PLACES", "⌀6 ⌴⌀10 ↧4 (4×)"})
    EXPECT_EQ(testing::PrintToString(said(recess, "4× <> ⌴⌀10 ↧4", text).untrue) +
                  testing::PrintToString(said(recess, "4× <> ⌴⌀10 ↧4", text).unjudged),
              "{}{}")
        << text;
  for (const char* text : {"5 trous ⌀6 lamage ⌀10 prof. 4", "⌀6 ⌴⌀10 ↧4 6 PLACES", "4× ⌀6, Senkung ⌀10×90°"})
    EXPECT_EQ(said(recess, "4× <> ⌴⌀10 ↧4", text).untrue.size(), 1U) << text;
}

// A hole of 8, 12 deep, in whatever series its thread is.
TEST(StatedTexts, OfThreadsHaveTheirDrill) {
  const DimensionedPart part(block_with_point(118));
  for (const char* text :
       {"M10 ↧9/⌀8 ↧12", "⌀8 ↧12 / M9×1 ↧10", "M9×1 - 6H x 10 deep", "3/8-16 UNC-2B ↧10", "UNC 3/8-16"})
    EXPECT_EQ(testing::PrintToString(said(part, "<> ↧12", text).unjudged), "{}") << text;
  for (const char* text : {"⌀8 ↧12 / M9×1 ↧10", "M9×1 - 6H x 10 deep", "M9×1 ↧9/⌀8 ↧12", "3/8-16 UNC-2B ↧10"})
    EXPECT_EQ(untrue(said(part, "<> ↧12", text)), "") << text;
  for (const char* text : {"M9×1 ↧9/⌀7 ↧12", "M9×1 ↧9/⌀8 ↧11", "M9×1 ↧13/⌀8 ↧12", "M10", "G1/4", "1/4-20 UNC"})
    EXPECT_EQ(said(part, "<> ↧12", text).untrue.size(), 1U) << text;
}

TEST(StatedTexts, OfHolesOnACircleAreJudged) {
  const DimensionedPart even(ring_with_holes({0, 90, 180, 270}, 35, 4)), uneven(ring_with_holes({10, 90, 200}, 35, 4));
  for (const char* text : {"4× ⌀8 ON ⌀70 BC", "4× ⌀8 EQ SP ON 70 PCD", "4× ⌀8 auf Lochkreis ⌀70", "4× ⌀8 (90°)",
                           "4× ⌀8 gleichmäßig verteilt"})
    EXPECT_EQ(testing::PrintToString(said(even, "4× <>", text).untrue) +
                  testing::PrintToString(said(even, "4× <>", text).unjudged),
              "{}{}")
        << text;
  for (const char* text : {"4× ⌀8 ON ⌀68 BC", "5× ⌀8 ON ⌀70 BC", "4× ⌀8 (60°)"})
    EXPECT_EQ(said(even, "4× <>", text).untrue.size(), 1U) << text;
  EXPECT_EQ(untrue(said(uneven, "3× <>", "3× ⌀8 ON ⌀70 BC")), "");
  EXPECT_EQ(untrue(said(uneven, "3× <>", "3× ⌀8 EQ SP ON ⌀70 BC")),
            "'3× ⌀8 EQ SP ON ⌀70 BC': the part has no circle of ⌀70 with 3 of these at equal angles");
}

// A washer of 40 x 20 with a chamfer of 2 x 45 degrees, and a bore of 10.
TEST(StatedTexts, OfLeadersAreThoseOfTheFacesThere) {
  const DimensionedPart part(shaft({{0, 5}, {0, 20}, {18, 20}, {20, 18}, {20, 5}, {0, 5}}));
  const Said free = part.free();
  const Vec3 rim(0, 20, 0), slope(19, 19, 0), bore(20, 5, 0);
  const auto found = [&](const char* text, const Vec3& at) {
    const Said all = part.with_note(text, at);
    return std::to_string(all.untrue.size() - free.untrue.size()) +
           std::to_string(all.unjudged.size() - free.unjudged.size());
  };
  for (const char* text : {"⌀40×18", "⌀40 x 18 long", "⌀40 t=18"}) EXPECT_EQ(found(text, rim), "00") << text;
  for (const char* text : {"⌀40×17", "⌀40 ↧18", "⌀38×18"}) EXPECT_EQ(found(text, rim), "10") << text;
  for (const char* text : {"2×45°", "C2", "Fase 2×45°", "chanfrein 2 à 45°", "45°×2", "2x2"})
    EXPECT_EQ(found(text, slope), "00") << text;
  for (const char* text : {"3×45°", "C1", "2×30°", "2x3"}) EXPECT_EQ(found(text, slope), "10") << text;
  for (const char* text : {"⌀10×20", "⌀10 THRU", "R5"}) EXPECT_EQ(found(text, bore), "00") << text;
  for (const char* text : {"⌀10×19", "⌀10 ↧20", "2× R5"}) EXPECT_EQ(found(text, bore), "10") << text;
}

TEST(StatedTexts, OfNotesDefineAsThoseOfDimensions) {
  const DimensionedPart blind(block_with_point(118));
  const auto number_of = [](const DimensionedPart& part, const std::string& text) {
    return static_cast<std::size_t>(std::find(part.texts.begin(), part.texts.end(), text) - part.texts.begin());
  };
  const std::size_t depth = number_of(blind, "<> ↧12");
  ASSERT_LT(depth, blind.texts.size());
  EXPECT_NE(told(blind.free_without(depth)), "");
  EXPECT_EQ(told(blind.noted_instead(depth, "⌀8 Tiefe 12", {24, 15, 20})), "");
  EXPECT_NE(told(blind.noted_instead(depth, "⌀8", {24, 15, 20})), "") << "its depth is missing";
  const DimensionedPart ring(ring_with_holes({0, 90, 180, 270}, 35, 4));
  const std::size_t holes = number_of(ring, "4× <>");
  ASSERT_LT(holes, ring.texts.size());
  EXPECT_NE(told(ring.free_without(holes)), "");
  EXPECT_EQ(told(ring.said_instead(holes, "ALL HOLES ⌀8 THRU")), "");
}

// A bush of 40 x 50 with two rounded edges, and a bore of their radius.
TEST(StatedTexts, OfRadiiCountNoBores) {
  std::vector<Vec2> profile{{0, 4}};
  for (int i = 0; i <= k; ++i) profile.emplace_back(4 - 4 * cosine(90.0 * i / k), 16 + 4 * sine(90.0 * i / k));
  for (int i = 0; i <= k; ++i) profile.emplace_back(46 + 4 * sine(90.0 * i / k), 16 + 4 * cosine(90.0 * i / k));
  profile.insert(profile.end(), {{50, 4}, {0, 4}});
  const DimensionedPart part{shaft(profile)};
  EXPECT_EQ(untrue(said(part, "2× <>", "2× R4")), "");
  EXPECT_EQ(untrue(said(part, "2× <>", "3× R4")), "'3× R4': the part has 2 of these");
}

TEST(StatedTexts, OfAllOfAKindAreJudged) {
  const DimensionedPart blind(block_with_point(118)),
      chamfered(shaft({{0, 1e-9}, {0, 20}, {18, 20}, {20, 18}, {20, 1e-9}}));
  const auto told_of = [](const Said& faces) { return faces.untrue.empty() ? std::string() : faces.untrue.front(); };
  EXPECT_EQ(told_of(blind.with_general("ALL HOLES THRU")), "") << "its depth is given";
  for (const char* text : {"all holes ⌀8", "RAW EDGES BROKEN 0.3", "MATERIAL 1.4301", "ISO 2768-mK"})
    EXPECT_EQ(told_of(blind.with_general(text)), "") << text;
  EXPECT_EQ(told_of(blind.with_general("all fillets R2")), "'all fillets R2': the part has no fillet of R2");
  EXPECT_EQ(told_of(blind.with_general("alle Fasen 1×45°")), "'alle Fasen 1×45°': the part has no chamfer of 1");
  EXPECT_EQ(told_of(chamfered.with_general("ALL CHAMFERS 2×45°")), "");
  EXPECT_EQ(told_of(chamfered.with_general("all holes through")), "'all holes through': the part has no such hole");
}

TEST(StatedTexts, CountWhatThereIs) {
  const DimensionedPart part(ring_with_holes({0, 90, 180, 270}, 35, 4));
  for (const char* text : {"4× <>", "4x <>", "4X ⌀8", "4 × <>"})
    EXPECT_EQ(untrue(said(part, "4× <>", text)) + told(said(part, "4× <>", text)), "") << text;
  EXPECT_EQ(untrue(said(part, "4× <>", "5× <>")), "'5× ⌀8': the part has 4 of these");
  EXPECT_NE(told(said(part, "4× <>", "3× <>")), "");
}

// Readers who do not apply the rule for equal features take "4× ⌀8" for one hole, beside what lies on its surface.
TEST(StatedTexts, CountByARule) {
  DimensionedPart part(ring_with_holes({0, 90, 180, 270}, 35, 4));
  EXPECT_EQ(told(part.free()), "");
  for (std::size_t i = 0; i < definition::rule_count; ++i)
    if (std::string(definition::all_rules()[i].name) == "equal") part.rules.reset(i);
  EXPECT_EQ(part.free().free.size(), 3U) << told(part.free());
  const auto rebuilt = part.rebuilt();
  ASSERT_TRUE(rebuilt.has_value());
  EXPECT_FALSE(rebuilt->is_defined());
}

TEST(StatedTexts, AreNoContradictionToThemselves) {
  const DimensionedPart part(ring_with_holes({0, 90, 180, 270}, 35, 4));
  const Said faces = said(part, "4× <>", "4× ⌀9");
  EXPECT_EQ(untrue(faces), "'4× ⌀9': the part has 8");
  EXPECT_TRUE(faces.contradictory.empty()) << testing::PrintToString(faces.contradictory);
}

// Three holes have one depth, and three another one.
TEST(StatedTexts, MeanTheHolesThatHaveAllOfTheirNumbers) {
  const DimensionedPart part(plate_with_two_depths());
  EXPECT_EQ(told(part.free()), "") << testing::PrintToString(part.texts);
  EXPECT_EQ(told(said(part, "3× <> ↧11", "3× <> ↧11")), "");
  EXPECT_NE(told(said(part, "3× <> ↧11", "2× <> ↧11")), "");
}

// Four counterbored holes in a table.
TEST(StatedTexts, OfTablesAreThoseOfTheirHoles) {
  const DimensionedPart part(plate({30, 30}, 2, 2, 10, stepped_hole({{5, 10}, {5, 6}, {3, 6}, {3, 0}})),
                             HoleDimensions::table);
  EXPECT_EQ(told(part.free()) + untrue(part.free()), "") << testing::PrintToString(part.texts);
  EXPECT_EQ(untrue(part.with_row("A2", "⌀6 ⌴⌀10 ↧5")), "'A2': the part has ↧4 there");
  EXPECT_NE(told(part.with_row("A2", "⌀6")), "");
}

// A drill has 118 degrees, and is drawn with 120; any other angle has to be said.
TEST(StatedTexts, OfPointsThatAreNotThoseOfDrillsHaveAnAngle) {
  for (const double angle : {118.0, 120.0})
    EXPECT_EQ(DimensionedPart(block_with_point(angle)).texts.size(), 6U) << angle;
  for (const double angle : {60.0, 90.0, 140.0}) {
    const DimensionedPart part(block_with_point(angle));
    EXPECT_EQ(told(part.free()), "") << angle;
    ASSERT_EQ(part.texts.size(), 7U) << testing::PrintToString(part.texts);
    std::size_t without_angle = 0;
    for (std::size_t i = 0; i < part.texts.size(); ++i)
      for (const sheet::FreeFace& one : part.free_without(i).free)
        without_angle += one.sentence.find("its angle") == std::string::npos ? 0 : 1;
    EXPECT_GE(without_angle, 1U) << angle;
  }
}

// One step of a shaft could be anywhere beside the other.
TEST(StatedTexts, SayNothingOfAxesWithoutCentreLines) {
  const DimensionedPart part(shaft({{0, 0}, {0, 10}, {20, 10}, {20, 6}, {50, 6}, {50, 0}}));
  EXPECT_EQ(told(part.free()), "");
  const Said without = part.without_centre_lines();
  ASSERT_FALSE(without.free.empty());
  for (const sheet::FreeFace& one : without.free)
    EXPECT_TRUE(one.sentence.ends_with(", or centre lines")) << one.sentence;
}

// Nothing of a round part turns with the axes of the views, along which the places of its boss are given.
TEST(StatedTexts, GivePlacesAmongRoundThings) {
  const DimensionedPart part(eccentric_disc({2, 3}));
  EXPECT_EQ(told(part.free()), "") << testing::PrintToString(part.texts);
  for (std::size_t i = 0; i < part.texts.size(); ++i) EXPECT_NE(told(part.free_without(i)), "") << i;
}

}  // namespace epura::test::stated_texts_test
