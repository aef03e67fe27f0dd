// SPDX-License-Identifier: Apache-2.0
// Expected deviations are those printed in the tables of ISO 286-2, which the program does not have.
#include "sizes/tolerance.hpp"

#include <gtest/gtest.h>

#include "dimensions_support.hpp"
#include "errors.hpp"

namespace epura::test::tolerance_test {
namespace {

struct Printed {
  const char* tolerance;
  double size, upper, lower;  // mm, micrometres
};

TEST(Tolerances, AgreeWithPrintedTables) {
  const std::vector<Printed> table{
      {"H7", 20, 21, 0},    {"g6", 20, -7, -20},   {"h6", 500, 0, -40},       {"js6", 20, 6.5, -6.5},
      {"k6", 20, 15, 2},    {"m6", 20, 21, 8},     {"n6", 20, 28, 15},        {"p6", 20, 35, 22},
      {"r6", 20, 41, 28},   {"s6", 20, 48, 35},    {"u6", 20, 54, 41},        {"t6", 28, 54, 41},
      {"f7", 20, -20, -41}, {"e8", 20, -40, -73},  {"d9", 20, -65, -117},     {"c11", 50, -130, -290},
      {"K7", 20, 6, -15},   {"M7", 20, 0, -21},    {"N7", 20, -7, -28},       {"P7", 20, -14, -35},
      {"R7", 20, -20, -41}, {"S7", 20, -27, -48},  {"N9", 20, 0, -52},        {"P9", 20, -22, -74},
      {"J7", 20, 12, -9},   {"j6", 20, 9, -4},     {"JS7", 100, 17.5, -17.5}, {"M6", 300, -9, -41},
      {"H11", 50, 160, 0},  {"H13", 4, 180, 0},    {"D10", 30, 149, 65},      {"F8", 60, 76, 30},
      {"k8", 20, 33, 0},    {"H7", 30, 21, 0},     {"H7", 30.001, 25, 0},     {"H7", 3, 10, 0},
      {"K7", 3, 0, -10},    {"P6", 250, -41, -70}, {"s6", 130, 117, 92}};
  for (const Printed& row : table) {
    const sheet::Deviations found =
        sheet::deviations_of(sheet::parse_tolerance_class(row.tolerance, "here"), row.size, "here");
    EXPECT_NEAR(found.upper * 1000, row.upper, 1e-9) << row.tolerance << " at " << row.size;
    EXPECT_NEAR(found.lower * 1000, row.lower, 1e-9) << row.tolerance << " at " << row.size;
  }
}

std::string written(double value, const char* tolerance, bool limits = false, const sheet::Notation& notation = {}) {
  sheet::Tolerance parsed = sheet::parse_tolerance(tolerance, "scene.toml:7:13");
  parsed.limits = limits;
  return sheet::text_of({value, notation.diameter}, parsed, notation).line();
}

TEST(Tolerances, Written) {
  EXPECT_EQ(written(20, "±0.1"), "20 ±0.1");
  EXPECT_EQ(written(20, "+/- 0.10"), "20 ±0.10");
  EXPECT_EQ(written(20, "+0.2 -0.15"), "20 +0.20/-0.15");
  EXPECT_EQ(written(20, "0 −0.1"), "20 0/-0.1");
  EXPECT_EQ(written(20, "H7"), "20 H7");
  EXPECT_EQ(written(20, "H7/g6"), "20 H7/g6");
}

TEST(Tolerances, LimitsOfSize) {
  EXPECT_EQ(written(20, "+0.2 -0.15", true), "20.20/19.85");
  EXPECT_EQ(written(12.345, "±0.1", true), "12.45/12.25") << "limits of the value as written";
  EXPECT_EQ(written(20, "H7", true, {.diameter = "⌀"}), "⌀20 H7 (20.021/20.000)");
  EXPECT_EQ(written(20, "H7/g6", true), "20 H7 (20.021/20.000) / g6 (19.993/19.980)");
  EXPECT_EQ(written(20, "JS7", true), "20 JS7 (20.0105/19.9895)");
  EXPECT_EQ(written(20, "±0.1", true, {.sign = DecimalSign::comma}), "20,1/19,9");
  // 0.5 in is 12.7 mm: H7 is 18 micrometres, 0.00071 in.
  EXPECT_EQ(written(12.7, "H7", true, {.decimals = 3, .unit = Unit::in}), ".500 H7 (.50071/.50000)");
}

TEST(Tolerances, Refused) {
  const auto reason = [](double value, const char* tolerance) {
    const Error error = error_of([&] { written(value, tolerance, true); });
    EXPECT_EQ(error.where(), "scene.toml:7:13");
    return std::string(error.what()) + " " + error.hint();
  };
  EXPECT_TRUE(contains(reason(20, "H99"), "grades of ISO 286-1 are 1 to 18"));
  EXPECT_TRUE(contains(reason(20, "Q7"), "known are C to H"));
  EXPECT_TRUE(contains(reason(20, "hH7"), "known are C to H"));
  EXPECT_TRUE(contains(reason(501, "H7"), "up to 500 mm"));
  EXPECT_TRUE(contains(reason(20, "t6"), "defines no t6 for a size of 20 mm"));
  EXPECT_TRUE(contains(reason(20, "j9"), "defines no j9"));
  EXPECT_TRUE(contains(reason(20, "g6/H7"), "hole comes first"));
  EXPECT_TRUE(contains(reason(20, "0.1"), "is not a tolerance"));
  EXPECT_TRUE(contains(reason(20, "±"), "is not a tolerance"));
  EXPECT_TRUE(contains(reason(20, "-0.1 +0.2"), "permits no size"));
  EXPECT_TRUE(contains(reason(1, "±2"), "is not positive"));
}

scene::DimensionDescription with_tolerance(scene::DimensionDescription dimension, const std::string& tolerance,
                                           const std::string& text = "") {
  dimension.tolerance = {tolerance, "scene.toml:9:13"};
  if (!text.empty()) dimension.text = {text, "scene.toml:10:8"};
  return dimension;
}

TEST(Tolerances, OfDimensions) {
  const world::World world = placed(wedge());
  const drawing::ViewDrawing front = drawing_of(world, orthographic(from_front));
  const auto width = dimension("overall", {}, "width");
  EXPECT_EQ(text_of(world, front, with_tolerance(width, "h7", "2× <> long")), "2× 40 h7 long");
  EXPECT_EQ(text_of(world, front, with_tolerance(dimension("angular", {1, 2, 0}), "±0.5")), "90° ±0.5°");
  const auto refusal = [&](const scene::DimensionDescription& one) {
    return std::string(error_of([&] { text_of(world, front, one); }).what());
  };
  EXPECT_TRUE(contains(refusal(with_tolerance(dimension("angular", {1, 2, 0}), "H7")), "for diameters and widths"));
  EXPECT_TRUE(contains(refusal(with_tolerance(width, "H7", "40")), "no value for the tolerance"));
  auto limits = width;
  limits.limits = {true, "scene.toml:9:10"};
  EXPECT_TRUE(contains(refusal(limits), "has no limits"));
}

// ISO 129-1: both deviations after the value, the upper one above, decimal signs one above the other.
TEST(Tolerances, Stacked) {
  const world::World world = placed(wedge());
  const drawing::ViewDrawing front = drawing_of(world, orthographic(from_front));
  const sheet::Layer layer = layer_of(world, front, {with_tolerance(dimension("overall", {}, "width"), "+0.2 -0.1")});
  ASSERT_EQ(layer.texts.size(), 3U);
  EXPECT_EQ(layer.texts[0].text, "40 ");
  EXPECT_EQ(layer.texts[1].text, "+0.2");
  EXPECT_EQ(layer.texts[2].text, "-0.1");
  EXPECT_EQ(layer.texts[1].height, 2.5);
  EXPECT_NEAR(layer.texts[1].at.y - layer.texts[2].at.y, 1.4 * 2.5, 1e-9);
  const sheet::Lettering lettering;
  EXPECT_NEAR(layer.texts[1].at.x + lettering.width("+0", 2.5), layer.texts[2].at.x + lettering.width("-0", 2.5), 1e-9);
}

}  // namespace
}  // namespace epura::test::tolerance_test
