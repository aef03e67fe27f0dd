// SPDX-License-Identifier: Apache-2.0
#include "sheet/standard_scale.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>

namespace epura::standard_scale_test {
namespace {

TEST(StandardScale, IsTheLargestOfIso5455ThatFits) {
  // As the standard lists them.
  constexpr std::array<double, 18> listed = {50,   20,   10,   5,     2,     1,     0.5,    0.2,    0.1,
                                             0.05, 0.02, 0.01, 0.005, 0.002, 0.001, 0.0005, 0.0002, 0.0001};
  for (std::size_t i = 0; i < listed.size(); ++i) {
    EXPECT_EQ(sheet::standard_scale_up_to(listed[i]), listed[i]);
    const double below = i > 0 ? listed[i - 1] * 0.999 : 99;
    EXPECT_EQ(sheet::standard_scale_up_to(below), listed[i]);
  }
}

TEST(StandardScale, NearestInProportion) {
  EXPECT_EQ(sheet::nearest_standard_scale(3), 2);  // 3 / 2 < 5 / 3
  EXPECT_EQ(sheet::nearest_standard_scale(4), 5);
  EXPECT_EQ(sheet::nearest_standard_scale(7), 5);  // 7 / 5 < 10 / 7
  EXPECT_EQ(sheet::nearest_standard_scale(8), 10);
  EXPECT_EQ(sheet::nearest_standard_scale(0.25), 0.2);
  EXPECT_EQ(sheet::nearest_standard_scale(1.3), 1);
  EXPECT_EQ(sheet::nearest_standard_scale(0.02), 0.02);
}

TEST(StandardScale, GoesOnByTens) {
  EXPECT_EQ(sheet::standard_scale_up_to(999), 500);
  EXPECT_EQ(sheet::standard_scale_up_to(3e-7), 2e-7);
  EXPECT_EQ(sheet::standard_scale_up_to(7e200), 5e200);
  EXPECT_GT(sheet::standard_scale_up_to(5e-324), 0);
  EXPECT_TRUE(std::isfinite(sheet::standard_scale_up_to(1.7e308)));
  EXPECT_TRUE(std::isfinite(sheet::standard_scale_up_to(HUGE_VAL)));
}

TEST(StandardScale, ForgivesRounding) {
  for (int power = -20; power <= 20; ++power) {
    const double exact = std::pow(10, power);
    EXPECT_NEAR(sheet::standard_scale_up_to(std::nextafter(exact, 0)) / exact, 1, 1e-12) << power;
  }
}

TEST(RatioText, OfSimpleRatiosOnly) {
  EXPECT_EQ(sheet::ratio_text(0.5), "1:2");
  EXPECT_EQ(sheet::ratio_text(5), "5:1");
  EXPECT_EQ(sheet::ratio_text(1), "1:1");
  EXPECT_EQ(sheet::ratio_text(0.4), "1:2.5");
  EXPECT_EQ(sheet::ratio_text(1.0 / 3), "1:3");
  EXPECT_EQ(sheet::ratio_text(1.0 / 20000), "1:20000");
  EXPECT_EQ(sheet::ratio_text(2.54), "2.54:1");
  EXPECT_EQ(sheet::ratio_text(0.734), "");
  EXPECT_EQ(sheet::ratio_text(1.2345), "");
  EXPECT_EQ(sheet::ratio_text(1e-12), "");
  EXPECT_EQ(sheet::ratio_text(HUGE_VAL), "");
}

}  // namespace
}  // namespace epura::standard_scale_test
