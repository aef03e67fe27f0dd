// SPDX-License-Identifier: Apache-2.0
// To what the coordinates of a file were rounded, told from themselves.
#include "mesh/resolution.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <string>

#include "base/text.hpp"

namespace epura::resolution_test {
namespace {

double resolved(const mesh::Points& points) { return mesh::resolution_of(points, false); }

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
  EXPECT_DOUBLE_EQ(resolved(circle(200, 35, 1e-6)), 1e-6);
  EXPECT_DOUBLE_EQ(resolved(circle(200, 1e4, 1e-9)), 1e-9);
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
  EXPECT_DOUBLE_EQ(resolved(with_digits(points, 6)), 1e-4);
  EXPECT_DOUBLE_EQ(resolved(with_digits(points, 5)), 1e-3);
  EXPECT_EQ(resolved(with_digits(points, 12)), 0);
  EXPECT_EQ(resolved(with_digits(points, 3)), 0) << "as likely chosen as rounded";
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
    EXPECT_EQ(resolved(points), *parse_number("1e" + std::to_string(place))) << place;
  }
}

TEST(Resolution, OfFewDecimalsIsNoMatterOfDigits) {
  // Of up to five digits, all multiples of a hundredth.
  EXPECT_EQ(resolved(circle(200, 400, 1e-2)), 1e-2);
}

// A bore of 32 sides about the origin, in a box: few numbers, each of them eight times.
mesh::Points plate(double unit) {
  mesh::Points points{{20, 15, 0}, {-20, 15, 0}, {-20, -15, 20}, {20, -15, 20}};
  for (int i = 0; i < 32; ++i) {
    const double a = 2 * 3.14159265358979323846 * i / 32;
    for (const double z : {0.0, 20.0})
      points.push_back(
          {std::round(5 * std::cos(a) / unit) / (1 / unit), std::round(5 * std::sin(a) / unit) / (1 / unit), z});
  }
  return points;
}

TEST(Resolution, OfFewPointsIsToldByTheirLastDecimals) {
  for (const double unit : {1e-2, 1e-3, 1e-4, 1e-5, 1e-6}) EXPECT_EQ(resolved(plate(unit)), unit);
}

TEST(Resolution, SurvivesInFloats) {
  mesh::Points points = plate(1e-3);
  for (auto& p : points)
    for (double& c : p) c = static_cast<double>(static_cast<float>(c));
  EXPECT_EQ(mesh::resolution_of(points, true), 1e-3);
  EXPECT_EQ(resolved(points), 0) << "of doubles that is no rounding";
}

// As "%g" writes a part that is not at the origin: three decimals above 100, four above 10, five below.
TEST(Resolution, OfSixDigitsIsTheLastPlaceOfTheLargestOnes) {
  mesh::Points points;
  for (int i = 0; i < 40; ++i) points.push_back({95 + 35 * std::cos(i), 35 * std::sin(i), 12});
  EXPECT_DOUBLE_EQ(resolved(with_digits(points, 6)), 1e-3);
}

TEST(Resolution, IsNothingForFullDoublesOrChosenNumbers) {
  mesh::Points exact;
  for (int i = 0; i < 200; ++i) exact.push_back({std::cos(i), std::sin(i), 10});
  EXPECT_EQ(resolved(exact), 0);
  mesh::Points grid;
  for (int i = 0; i < 200; ++i) grid.push_back({i * 0.5, i * 0.25, 3.0});
  EXPECT_EQ(resolved(grid), 0);
  mesh::Points inches;  // in millimetres, of sixteenths
  for (int i = 0; i < 200; ++i) inches.push_back({i * 1.5875, (i * i % 97) * 1.5875, 25.4});
  EXPECT_EQ(resolved(inches), 0);
  for (const double unit : {1.5875, 3.175e-3, 1 / 25.4, 1 / 304.8}) {  // houses, and furniture in whole millimetres
    mesh::Points converted;
    for (int i = 0; i < 200; ++i) converted.push_back({i * i % 3001 * unit, i * i * i % 1999 * unit, 7 * i * unit});
    EXPECT_EQ(resolved(converted), 0) << unit;
  }
  mesh::Points voxels;
  for (int i = 0; i < 200; ++i) voxels.push_back({i * 1.0, i * i % 47 * 1.0, i * i % 31 * 1.0});
  EXPECT_EQ(resolved(voxels), 0);
  mesh::Points small;  // one decimal, as people type it
  for (int i = 0; i < 200; ++i) small.push_back({i * 0.1, i * i % 13 * 0.7, 3});
  EXPECT_EQ(resolved(small), 0);
  mesh::Points thin;  // of five digits where it is long, but small ones need fewer
  for (int i = 0; i < 16000; ++i) thin.push_back({i * 0.01, i % 2 * 0.01, i % 3 * 0.002});
  EXPECT_EQ(resolved(thin), 0);
  // One vertex with many digits says nothing of the others.
  grid[7][0] = 1.234567;
  EXPECT_EQ(resolved(grid), 0);
}

// Vertices spaced evenly along the sides of a plate and of its pocket, all in whole millimetres: multiples of a sixth.
TEST(Resolution, IsNothingForLengthsInEqualParts) {
  for (const double size : {1.0, 10.0}) {
    mesh::Points points;
    for (int i = 0; i < 12; ++i) {
      for (const double x : {0.0, 80.0}) points.push_back({x * size, 50 * size * i / 12, 20});
      for (const double y : {0.0, 50.0}) points.push_back({80 * size * i / 12, y * size, 20});
      for (const double x : {11.0, 35.0}) points.push_back({x * size, 9 * size + 14 * size * i / 12, 12});
      for (const double y : {9.0, 23.0}) points.push_back({11 * size + 24 * size * i / 12, y * size, 12});
    }
    EXPECT_EQ(resolved(points), 0) << size;
  }
}

/// Points on a lattice of 2^bits - 1 steps across the largest side, which begins anywhere.
mesh::Points quantised(mesh::Points points, int bits, bool as_floats) {
  const std::array<double, 3> first{-20.3, -15.1, 0.7};
  const double step = 40 / (std::pow(2, bits) - 1);
  for (auto& p : points)
    for (std::size_t k = 0; k < 3; ++k) {
      p[k] = first[k] + std::round((p[k] - first[k]) / step) * step;
      if (as_floats) p[k] = static_cast<double>(static_cast<float>(p[k]));
    }
  return points;
}

TEST(Resolution, IsTheStepOfALatticeWhereverItBegins) {
  mesh::Points ring;
  for (int i = 0; i < 24; ++i) ring.push_back({18 * std::cos(0.3 + i), 13 * std::sin(0.3 + i), 20.0 * (i % 2)});
  for (const int bits : {11, 12, 14})
    for (const bool as_floats : {false, true}) {
      const double step = 40 / (std::pow(2, bits) - 1);
      EXPECT_NEAR(mesh::resolution_of(quantised(ring, bits, as_floats), as_floats), step, 1e-6 * step)
          << bits << as_floats;
      EXPECT_EQ(mesh::resolution_of(quantised(ring, 30, as_floats), as_floats), 0) << "nothing is seen of it";
    }
}

// A quantised mesh that was printed with six decimals.
TEST(Resolution, IsTheCoarserOfTwo) {
  mesh::Points printed = quantised(circle(60, 18, 1e-12), 12, false);
  for (auto& p : printed)
    for (double& c : p) c = std::round(c * 1e6) / 1e6;
  EXPECT_NEAR(resolved(printed), 40.0 / 4095, 1e-6);
}

}  // namespace
}  // namespace epura::resolution_test
