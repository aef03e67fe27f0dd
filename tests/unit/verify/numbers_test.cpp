// SPDX-License-Identifier: Apache-2.0
#include "verify/numbers.hpp"

#include <gtest/gtest.h>

#include <random>

namespace epura::test::numbers_test {
namespace {

// The same formula in both kinds of numbers: the bound must hold, and be worth something.
template <class N>
N formula(const std::array<double, 4>& x) {
  const N a(x[0]), b(x[1]), c(x[2]), d(x[3]);
  return (a * b - c) / (d + a) + (b - a) * (c - d);
}

TEST(Bounded, HoldsTheExactResult) {
  std::mt19937_64 random(1);
  for (int i = 0; i < 1000; ++i) {
    std::array<double, 4> x{};
    for (double& value : x) value = 1 + std::ldexp(static_cast<double>(random() >> 11), -53);
    const verify::Bounded bounded = formula<verify::Bounded>(x);
    const verify::Exact error = abs(formula<verify::Exact>(x) - verify::Exact(bounded.value));
    EXPECT_LE(error, verify::Exact(bounded.error));
    EXPECT_LT(bounded.error, 1e-14);
  }
}

TEST(Bounded, CancellationKeepsTheBound) {
  const verify::Bounded third = verify::Bounded(1) / verify::Bounded(3);
  const verify::Bounded rest = third * verify::Bounded(3) - verify::Bounded(1);
  EXPECT_LE(std::abs(rest.value), rest.error);
  EXPECT_GT(rest.error, 1e-17);
}

TEST(Bounded, DividingByWhatMayBeZeroIsUnknown) {
  const verify::Bounded perhaps_zero(1e-20, 1e-19);
  EXPECT_TRUE(std::isinf((verify::Bounded(1) / perhaps_zero).error));
}

}  // namespace
}  // namespace epura::test::numbers_test
