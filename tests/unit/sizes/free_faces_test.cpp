// SPDX-License-Identifier: Apache-2.0
// What the dimensions of a sheet leave free, whatever features the faces form.
#include "sizes/free_faces.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "dimensioned_part.hpp"
#include "grooved_parts.hpp"
#include "sloped_parts.hpp"
#include "turned_parts.hpp"

namespace epura::test::free_faces_test {
namespace {

std::string told(const sheet::FreeFaces& free) {
  std::string text;
  for (const sheet::FreeFace& one : free.free) text += one.sentence + "\n";
  for (const std::string& sentence : free.undecided) text += sentence + "\n";
  return text;
}

}  // namespace

TEST(FreeFaces, AreNoneIfAllAreHeld) {
  const DimensionedPart sheet(sloped_block);
  ASSERT_EQ(sheet.texts.size(), 5U);
  EXPECT_EQ(told(sheet.free()), "");
  EXPECT_EQ(sheet.free().count.given, 7);
  EXPECT_EQ(sheet.free().count.all, 7);
}

TEST(FreeFaces, AreToldForEachDimensionThatIsMissing) {
  const DimensionedPart sheet(sloped_block);
  for (std::size_t i = 0; i < sheet.texts.size(); ++i) {
    const Said free = sheet.free_without(i);
    ASSERT_EQ(free.free.size(), 1U) << i;
    EXPECT_NE(free.free[0].sentence.find("; add a"), std::string::npos) << told(free);
    EXPECT_NE(free.free[0].sentence.find(" in view '"), std::string::npos) << told(free);
    EXPECT_LT(free.count.given, free.count.all);
  }
}

// 60 mm are 2.362 in.
TEST(FreeFaces, ReadTextsInTheUnitOfTheSheet) {
  DimensionedPart sheet(sloped_block);
  sheet.notation.unit = Unit::in;
  EXPECT_TRUE(sheet.with_text(0, "2.362", false).untrue.empty());
  const Said changed = sheet.with_text(0, "2.372", false);
  ASSERT_EQ(changed.untrue.size(), 1U);
  EXPECT_NE(changed.untrue[0].find("the part has 2.3622"), std::string::npos) << changed.untrue[0];
}

TEST(FreeFaces, AreOfNoConcernToTextsThatAreUntrue) {
  const DimensionedPart sheet(sloped_block);
  for (std::size_t i = 0; i < sheet.texts.size(); ++i) {
    const Said changed = sheet.with_text(i, "71", false);
    EXPECT_EQ(told(changed), "") << i;
    EXPECT_EQ(changed.untrue.size(), 1U) << i;
    EXPECT_TRUE(changed.contradictory.empty()) << i;
    const Said doubled = sheet.with_text(i, "71", true);
    EXPECT_EQ(doubled.untrue.size(), 1U) << i;
    ASSERT_EQ(doubled.contradictory.size(), 1U) << i;
    EXPECT_NE(doubled.contradictory[0].find("cannot all be true"), std::string::npos) << doubled.contradictory[0];
    const Said repeated = sheet.with_text(i, "<>", true);
    EXPECT_TRUE(repeated.contradictory.empty()) << i;
    EXPECT_TRUE(repeated.untrue.empty()) << i;
  }
  EXPECT_TRUE(sheet.with_text(0, "60 ±0.1", true).contradictory.empty());
  EXPECT_EQ(sheet.with_text(0, "60.5", true).contradictory.size(), 1U);
}

namespace {

/// Parts whose sizes are all known. How a tube or a block as a whole lies in the world is no size of theirs.
struct Family {
  std::vector<KnownPart> parts;
  std::size_t of_place = 0;
};

std::vector<Family> families() {
  return {{v_notches()},
          {planes_between_slopes()},
          {slopes_to_rounded_corners()},
          {rounded_trapezia()},
          {slopes_of_45_degrees()},
          {round_ends()},
          {tongues()},
          {links()},
          {tubes_with_radial_holes(), 1},
          {wedges_with_holes()},
          {wedges_with_pairs()},
          {uneven_pitch_circles()},
          {plates_with_conical_bosses()},
          {conical_tubes()},
          {channels()},
          {plates_with_turned_holes()},
          {chamfered_hexagons()},
          {plates_with_dimples()},
          {blocks_with_grooves()},
          {bases_with_ribs()},
          {plates_with_pockets()},
          {bosses_over_bores()},
          {parted_round_tops()},
          {bosses_with_ring_grooves()},
          {blocks_with_open_slots()},
          {bases_with_lugs()},
          {shafts_with_open_keyways()},
          {plates_with_ring_grooves()},
          {turned_blocks(), 1}};
}

}  // namespace

// Automatic dimensions define all families of parts with known sizes, one less does not.
TEST(FreeFaces, AreThoseOfPartsWithOneDimensionLess) {
  std::size_t parts = 0;
  for (const Family& family : families())
    for (std::size_t i = 0; i < family.parts.size(); i += 4, ++parts) {
      const DimensionedPart sheet(family.parts[i].obj);
      const std::string_view name = family.parts[i].name;
      EXPECT_EQ(told(sheet.free()), "") << name;
      EXPECT_EQ(sheet.free().count.given, sheet.free().count.all) << name;
      std::size_t of_place = 0;
      for (std::size_t k = 0; k < sheet.texts.size(); ++k) {
        const Said less = sheet.free_without(k);
        // An auxiliary dimension holds nothing.
        if (sheet.texts[k].starts_with("(")) {
          EXPECT_EQ(told(less), "") << name << " without " << sheet.texts[k];
        } else if (less.count.given == less.count.all) {
          ++of_place;
        } else {
          EXPECT_FALSE(less.free.empty()) << name << " without " << k << ": " << told(less);
          EXPECT_TRUE(less.undecided.empty()) << name << " without " << k << ": " << told(less);
        }
      }
      EXPECT_EQ(of_place, family.of_place) << name;
    }
  EXPECT_GE(parts, 150U);
}

// Of each part one dimension is removed by plan, one doubled, and one changed. Where slopes are at right angles by
// chance, an angle says what is drawn.
TEST(FreeFaces, AreFoundInPartsThatAreDefinedTooLittleOrTooMuch) {
  const std::string square = "a plane between slopes 5";
  std::size_t parts = 0, removed = 0;
  for (const Family& family : families())
    for (const KnownPart& one : family.parts) {
      const DimensionedPart sheet(one.obj);
      SCOPED_TRACE(one.name);
      const Said whole = sheet.free();
      const std::size_t number = 7 * ++parts % sheet.texts.size();
      EXPECT_EQ(told(whole), "");
      EXPECT_TRUE(whole.contradictory.empty() && whole.untrue.empty());
      EXPECT_EQ(whole.repeated.size(), one.name == square ? 1U : 0U);
      if (sheet.texts[number].starts_with("(") || one.name == square) continue;
      const bool is_found = !sheet.free_without(number).free.empty();
      EXPECT_TRUE(is_found || family.of_place > 0) << "without " << number;
      if (!is_found) continue;
      ++removed;
      EXPECT_EQ(sheet.with_text(number, sheet.texts[number], true).repeated.size(), 1U) << number << " twice";
      EXPECT_EQ(sheet.with_text(number, "997", false).untrue.size(), 1U) << number << " changed";
    }
  EXPECT_GE(parts, 600U);
  EXPECT_GE(removed, 560U);
}

namespace {

/// A plate with rows of square pockets of one depth, all in line: its places are those of 2 planes for each row and
/// column, and its sizes a depth and those of the plate.
std::string plate_with_pockets(int columns, int rows) {
  std::vector<int> xs{0}, ys{0};
  for (int i = 0; i < columns; ++i) xs.insert(xs.end(), {20 * i + 4, 20 * i + 16});
  for (int j = 0; j < rows; ++j) ys.insert(ys.end(), {20 * j + 4, 20 * j + 16});
  xs.push_back(20 * columns);
  ys.push_back(20 * rows);
  std::string vertices, faces;
  int count = 0;
  const auto quad = [&](const std::array<std::array<int, 3>, 4>& corners) {
    faces += "f";
    for (const auto& [x, y, z] : corners) {
      vertices += "v " + std::to_string(x) + " " + std::to_string(y) + " " + std::to_string(z) + "\n";
      faces += " " + std::to_string(++count);
    }
    faces += "\n";
  };
  for (std::size_t i = 0; i + 1 < xs.size(); ++i)
    for (std::size_t j = 0; j + 1 < ys.size(); ++j) {
      const int a = xs[i], b = xs[i + 1], c = ys[j], d = ys[j + 1];
      const bool is_pocket = i % 2 == 1 && j % 2 == 1;
      const int z = is_pocket ? 5 : 10;
      quad({{{a, c, 0}, {a, d, 0}, {b, d, 0}, {b, c, 0}}});
      quad({{{a, c, z}, {b, c, z}, {b, d, z}, {a, d, z}}});
      if (!is_pocket) continue;
      quad({{{a, c, 10}, {b, c, 10}, {b, c, 5}, {a, c, 5}}});
      quad({{{b, c, 10}, {b, d, 10}, {b, d, 5}, {b, c, 5}}});
      quad({{{b, d, 10}, {a, d, 10}, {a, d, 5}, {b, d, 5}}});
      quad({{{a, d, 10}, {a, c, 10}, {a, c, 5}, {a, d, 5}}});
    }
  for (std::size_t i = 0; i + 1 < xs.size(); ++i) {
    quad({{{xs[i], 0, 0}, {xs[i + 1], 0, 0}, {xs[i + 1], 0, 10}, {xs[i], 0, 10}}});
    quad({{{xs[i + 1], ys.back(), 0}, {xs[i], ys.back(), 0}, {xs[i], ys.back(), 10}, {xs[i + 1], ys.back(), 10}}});
  }
  for (std::size_t j = 0; j + 1 < ys.size(); ++j) {
    quad({{{0, ys[j + 1], 0}, {0, ys[j], 0}, {0, ys[j], 10}, {0, ys[j + 1], 10}}});
    quad({{{xs.back(), ys[j], 0}, {xs.back(), ys[j + 1], 0}, {xs.back(), ys[j + 1], 10}, {xs.back(), ys[j], 10}}});
  }
  return vertices + faces;
}

}  // namespace

TEST(FreeFaces, AreFoundAmongThousands) {
  const int columns = 21, rows = 20;
  const world::World world = world_of(plate_with_pockets(columns, rows));
  const sheet::FreeFaces free = sheet::find_free_faces({}, world, features::true_extents(world), {},
                                                       definition::rules_of(definition::Standard::iso));
  EXPECT_EQ(free.count.all, 5 * columns * rows + 6);
  EXPECT_TRUE(free.undecided.empty());
  EXPECT_EQ(free.free.size(), 3U + 1 + 2 * columns + 2 * rows);
}

}  // namespace epura::test::free_faces_test
