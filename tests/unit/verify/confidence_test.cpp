// SPDX-License-Identifier: Apache-2.0
#include "verify/confidence.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace epura::test::confidence_test {
namespace {

// P(X <= 0) = (1 - p)^n and P(X <= n - 1) = 1 - p^n have closed forms.
TEST(Confidence, ClosedForms) {
  for (const int n : {1, 10, 2000}) {
    EXPECT_NEAR(verify::greatest_share(0, n, 0.95), 1 - std::pow(0.05, 1.0 / n), 1e-12) << n;
    EXPECT_NEAR(verify::greatest_share(n - 1, n, 0.95), std::pow(0.95, 1.0 / n), 1e-12) << n;
  }
  EXPECT_EQ(verify::greatest_share(5, 5, 0.95), 1);
}

TEST(Confidence, RuleOfThree) { EXPECT_NEAR(verify::greatest_share(0, 10000, 0.95), 3e-4, 1e-6); }

TEST(Confidence, GrowsWithFailures) {
  double before = 0;
  for (int failures = 0; failures <= 50; ++failures) {
    const double share = verify::greatest_share(failures, 50, 0.95);
    EXPECT_GT(share, before);
    before = share;
  }
}

}  // namespace
}  // namespace epura::test::confidence_test
