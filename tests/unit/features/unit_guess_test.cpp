// SPDX-License-Identifier: Apache-2.0
// The unit that a file does not state.
#include "features/unit_guess.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace epura::test::unit_guess_test {
namespace {

// `doubts`: by which vertices of the last ones are beside them.
std::optional<Unit> guessed(double size, const std::vector<double>& diameters, const std::vector<double>& doubts = {}) {
  Box box;
  box.add(Vec3(0));
  box.add(Vec3(size, size / 2, size / 3));
  surfaces::PartFaces part;
  part.faces.resize(1 + diameters.size());
  for (std::size_t i = 0; i < diameters.size(); ++i) {
    part.faces[i].surface.kind = surfaces::SurfaceKind::cylinder;
    part.faces[i].surface.radius = diameters[i] / 2;
    part.faces[i].sweep = 360;
    if (i + doubts.size() >= diameters.size()) part.faces[i].residual = doubts[i + doubts.size() - diameters.size()];
  }
  return features::guess_unit(box, part);
}

TEST(UnitGuess, IsTheUnitInWhichDiametersAreRound) {
  EXPECT_EQ(guessed(120, {6.5, 12, 40}), Unit::mm);
  EXPECT_EQ(guessed(0.12, {0.0065, 0.012, 0.04}), Unit::m);
  EXPECT_EQ(guessed(4.75, {0.25, 0.5, 1.125}), Unit::in);
}

// Every thousandth of an inch would be a round number of half millimetres in metres.
TEST(UnitGuess, TriesInchesBeforeMetres) {
  EXPECT_EQ(guessed(5, {0.266, 0.438, 0.25, 1}), Unit::in) << "17/64 and 7/16, to three decimals";
  EXPECT_EQ(guessed(9, {0.3, 0.36}), Unit::m) << "columns of a house";
}

// Rounded to three decimals, sixty-fourths below a sixteenth are near any size of a small part in metres.
TEST(UnitGuess, TakesMillimetresInMetresForNoSixtyFourths) {
  EXPECT_EQ(guessed(0.195, {0.016, 0.016, 0.016}), Unit::m);
  EXPECT_EQ(guessed(0.3, {0.031, 0.047}), Unit::m);
  EXPECT_EQ(guessed(1, {0.03125, 0.046875}), Unit::in);
}

// Whole numbers are round in any unit; a few odd ones that are near a sixty-fourth prove nothing.
TEST(UnitGuess, StaysWithMillimetresWhenMostAreRoundInThem) {
  EXPECT_EQ(guessed(164, {8, 12, 16, 17, 80, 4.328125, 3.7, 11.3, 9.9}), Unit::mm);
}

// A connecting rod whose eye meets fillets that its mesh has only about.
TEST(UnitGuess, LeavesOutDiametersThatFacetsTellOnlyAbout) {
  EXPECT_EQ(guessed(188, {40, 18, 35.9994}, {0.0069}), Unit::mm);
  EXPECT_EQ(guessed(188, {40, 18, 35.9994}), Unit::in) << "each is near a sixty-fourth";
  EXPECT_EQ(guessed(4.75, {0.25, 0.5, 1.125}, {1e-6, 1e-6}), Unit::in);
}

TEST(UnitGuess, WithoutRoundDiametersIsMillimetresForUsualSizes) {
  EXPECT_EQ(guessed(80, {}), Unit::mm);
  EXPECT_EQ(guessed(0.4, {}), std::nullopt);
}

}  // namespace
}  // namespace epura::test::unit_guess_test
