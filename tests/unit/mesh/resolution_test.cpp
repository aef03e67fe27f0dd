// SPDX-License-Identifier: Apache-2.0
// The decimals of a file, told from its coordinates.
#include "mesh/resolution.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>

#include "base/text.hpp"

namespace epura {
namespace {

mesh::Points circle(int count, double radius, double unit) {
  mesh::Points points;
  for (int i = 0; i < count; ++i) {
    const double x = radius * std::cos(0.1 + i), y = radius * std::sin(0.1 + i);
    // As a number printed with decimals and read again.
    points.push_back({std::round(x / unit) / (1 / unit), std::round(y / unit) / (1 / unit), 10});
  }
  return points;
}

TEST(Resolution, IsTheLastPlaceOfRoundedCoordinates) {
  EXPECT_DOUBLE_EQ(mesh::decimal_resolution(circle(200, 35, 1e-6)), 1e-6);
  EXPECT_DOUBLE_EQ(mesh::decimal_resolution(circle(200, 1e4, 1e-9)), 1e-9);
}

mesh::Points with_digits(mesh::Points points, int digits) {
  for (auto& p : points)
    for (double& c : p) {
      char text[40];
      std::snprintf(text, sizeof text, "%.*e", digits - 1, c);
      c = std::strtod(text, nullptr);
    }
  return points;
}

TEST(Resolution, IsTheLastPlaceOfTheLargestCoordinateWhereDigitsAreAlike) {
  mesh::Points points;
  for (int i = 0; i < 200; ++i) points.push_back({35 * std::cos(i), 0.3 * std::sin(i), 0.001 * i});
  EXPECT_DOUBLE_EQ(mesh::decimal_resolution(with_digits(points, 6)), 1e-4);
  EXPECT_DOUBLE_EQ(mesh::decimal_resolution(with_digits(points, 5)), 1e-3);
  EXPECT_EQ(mesh::decimal_resolution(with_digits(points, 12)), 0);
  EXPECT_EQ(mesh::decimal_resolution(with_digits(points, 3)), 0) << "as likely chosen as rounded";
}

// To the last bit: it is written into files.
TEST(Resolution, IsADecimalNumber) {
  for (int place = -300; place <= 290; ++place) {
    mesh::Points points;
    for (int i = 0; i < 200; ++i) {
      // Five digits each, the largest coordinate with the last one at 10^place.
      const auto number = [&](int digits, int shift) {
        return *parse_number(std::to_string(digits) + "e" + std::to_string(place - shift));
      };
      points.push_back({number(10001 + 439 * i, 0), number(10007 + 431 * i, 1), number(10003 + 433 * i, 2)});
    }
    const int last = place >= -7 && place <= -3 ? place - 2 : place;  // of decimals, where they are 5 to 9
    EXPECT_EQ(mesh::decimal_resolution(points), *parse_number("1e" + std::to_string(last))) << place;
  }
}

TEST(Resolution, OfFewDecimalsIsNoMatterOfDigits) {
  // Of up to five digits, all multiples of a hundredth.
  EXPECT_EQ(mesh::decimal_resolution(circle(200, 400, 1e-2)), 0);
}

TEST(Resolution, IsNothingForFullDoublesFewPointsOrRoundNumbers) {
  mesh::Points exact;
  for (int i = 0; i < 200; ++i) exact.push_back({std::cos(i), std::sin(i), 10});
  EXPECT_EQ(mesh::decimal_resolution(exact), 0);
  EXPECT_EQ(mesh::decimal_resolution(circle(50, 35, 1e-6)), 0);
  mesh::Points grid;
  for (int i = 0; i < 200; ++i) grid.push_back({i * 0.5, i * 0.25, 3.0});
  EXPECT_EQ(mesh::decimal_resolution(grid), 0);
  EXPECT_EQ(mesh::decimal_resolution(circle(200, 35, 1e-3)), 0);
  // One vertex with many digits says nothing of the others.
  grid[7][0] = 1.234567;
  EXPECT_EQ(mesh::decimal_resolution(grid), 0);
}

}  // namespace
}  // namespace epura
