// SPDX-License-Identifier: Apache-2.0
#include "sheet/notation.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace epura::test::notation_test {
namespace {

using sheet::Notation;

TEST(Notation, Millimetres) {
  EXPECT_EQ(sheet::length_text(12.5, {}), "12.5");
  EXPECT_EQ(sheet::length_text(0.25, {}), "0.25");
  EXPECT_EQ(sheet::length_text(12.5, {.decimals = 2, .unit = Unit::mm, .sign = DecimalSign::comma}), "12,5");
  EXPECT_EQ(sheet::length_text(40, {.decimals = 2, .unit = Unit::mm, .sign = DecimalSign::comma}), "40");
}

// Eighths of an inch have ties that no double represents.
TEST(Notation, TiesAreEven) {
  EXPECT_EQ(sheet::length_text(3.175, {}), "3.18");
  EXPECT_EQ(sheet::length_text(34.925, {}), "34.92");
  EXPECT_EQ(sheet::length_text(std::nextafter(34.925, 35), {}), "34.92");
  EXPECT_EQ(sheet::length_text(34.92501, {}), "34.93");
  EXPECT_EQ(sheet::length_text(0.25, {.decimals = 1}), "0.2");
}

// ASME Y14.5: no zero before the decimal point; as many decimals as the tolerance.
TEST(Notation, Inches) {
  const auto inches = [](double value, int decimals) {
    return sheet::length_text(value * 25.4, {.decimals = decimals, .unit = Unit::in});
  };
  EXPECT_EQ(inches(0.5, 3), ".500");
  EXPECT_EQ(inches(1.25, 3), "1.250");
  EXPECT_EQ(inches(10, 3), "10.000");
  EXPECT_EQ(inches(0.0004, 3), ".000");
  EXPECT_EQ(inches(0.9996, 3), "1.000");
  EXPECT_EQ(inches(1.375, 4), "1.3750");
  EXPECT_EQ(inches(12, 0), "12");
  EXPECT_EQ(inches(0.4, 0), "0");
  EXPECT_EQ(sheet::length_text(12.7, {.decimals = 3, .unit = Unit::in, .sign = DecimalSign::comma}), ",500");
}

TEST(Notation, Metres) { EXPECT_EQ(sheet::length_text(12345, {.decimals = 5, .unit = Unit::m}), "12.345"); }

TEST(Notation, Angles) {
  EXPECT_EQ(sheet::angle_text(36.8699, {}), "36.87°");
  EXPECT_EQ(sheet::angle_text(36.8699, {.decimals = 0, .unit = Unit::mm, .sign = DecimalSign::comma}), "36,87°");
}

TEST(Notation, MassesOfOneListHaveOneUnit) {
  EXPECT_EQ(sheet::mass_text(1234.56, DecimalSign::point), "1235 kg");
  EXPECT_EQ(sheet::mass_text(12.345, DecimalSign::comma), "12,3 kg");
  EXPECT_EQ(sheet::mass_text(0.012345, DecimalSign::point), "12.3 g");
  EXPECT_EQ(sheet::mass_text(0.012345, DecimalSign::point, 7.5), "0.0123 kg");
  EXPECT_EQ(sheet::mass_text(1.5e-6, DecimalSign::point, 0.05), "0.0015 g");
  EXPECT_EQ(sheet::mass_text(0, DecimalSign::point), "0 g");
}

TEST(Notation, UsualDecimals) {
  EXPECT_EQ(sheet::usual_decimals(100, Unit::mm), 2);
  EXPECT_EQ(sheet::usual_decimals(9.9, Unit::mm), 3);
  EXPECT_EQ(sheet::usual_decimals(100, Unit::in), 3);
  EXPECT_EQ(sheet::usual_decimals(100, Unit::m), 5);
  EXPECT_EQ(sheet::usual_decimals(1e-9, Unit::mm), 8);
}

}  // namespace
}  // namespace epura::test::notation_test
