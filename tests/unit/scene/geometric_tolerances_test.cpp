// SPDX-License-Identifier: Apache-2.0
// What would break if this were wrong: frames that no reader of ISO 1101 understands.
#include "scene/geometric_tolerances.hpp"

#include <gtest/gtest.h>

#include "errors.hpp"

namespace epura::test::geometric_tolerances_test {
namespace {

using scene::DatumRule;

TEST(Characteristics, AreThoseOfIso1101) {
  ASSERT_EQ(scene::characteristics.size(), 14U);
  std::size_t form = 0, orientation_location_and_run_out = 0;
  for (std::size_t i = 0; i < scene::characteristics.size(); ++i) {
    const scene::CharacteristicRow& row = scene::characteristics[i];
    EXPECT_EQ(static_cast<std::size_t>(row.characteristic), i) << row.name;
    form += row.datums == DatumRule::none ? 1 : 0;
    orientation_location_and_run_out += row.datums == DatumRule::required ? 1 : 0;
  }
  EXPECT_EQ(form, 4U) << "straightness, flatness, roundness, cylindricity";
  EXPECT_EQ(orientation_location_and_run_out, 7U) << "all but profiles and position, which may have datums";
}

TEST(ToleranceZones, HaveAWidthOrDiameterAndModifiers) {
  using Cell = scene::FrameCell;
  EXPECT_EQ(scene::parse_zone("0.05", ""), (Cell{{"0.05", false}}));
  EXPECT_EQ(scene::parse_zone("Ø0.1 M", ""), (Cell{{"⌀0.1", false}, {"M", true}}));
  EXPECT_EQ(scene::parse_zone("S⌀0.2", ""), (Cell{{"S⌀0.2", false}}));
  EXPECT_EQ(scene::parse_zone(" 0.1   CZ ", ""), (Cell{{"0.1", false}, {"CZ", false}}));
  EXPECT_EQ(scene::parse_zone("Ø0 M P 20", ""), (Cell{{"⌀0", false}, {"M", true}, {"P", true}, {"20", false}}));
}

TEST(ToleranceZones, RefuseOthers) {
  for (const char* zone : {"", "x", "-0.1", "Ø", "0.1 Q", "0.1 20", "0", "Ø0", "0,1", "inf", "0.1 M 20"})
    EXPECT_THROW(scene::parse_zone(zone, "scene.toml:3:8"), Error) << zone;
}

TEST(Datums, AreLettersWithModifiers) {
  std::vector<std::string> letters;
  EXPECT_EQ(scene::parse_datum("A", "", letters), (scene::FrameCell{{"A", false}}));
  EXPECT_EQ(scene::parse_datum("B M", "", letters), (scene::FrameCell{{"B", false}, {"M", true}}));
  EXPECT_EQ(scene::parse_datum("C-D", "", letters), (scene::FrameCell{{"C-D", false}}));
  EXPECT_EQ(letters, (std::vector<std::string>{"A", "B", "C", "D"}));
  for (const char* datum : {"", "a", "I", "O", "Q", "ABC", "A-", "A P", "1"})
    EXPECT_THROW(scene::parse_datum(datum, "scene.toml:3:8", letters), Error) << datum;
}

}  // namespace
}  // namespace epura::test::geometric_tolerances_test
