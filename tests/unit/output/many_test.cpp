// SPDX-License-Identifier: Apache-2.0
// Large drawings: time grows with the number of strokes, not with its square.
#include <gtest/gtest.h>

#include <ctime>
#include <random>

#include "output/write.hpp"
#include "support.hpp"

namespace epura::many_test {
namespace {

// Short lines here and there: the area they cover is not a simple one.
sheet::Sheet scattered(int strokes) {
  std::mt19937 random(1);
  sheet::Sheet sheet{1000, 1000, "scattered", {{"view/visible", {"visible", 0.25}, {}}}};
  for (int i = 0; i < strokes; ++i) {
    const Vec2 place(static_cast<double>(random() % 1000), static_cast<double>(random() % 1000));
    sheet.layers[0].strokes.push_back({{place, place + Vec2(5.3, 2.7)}, false});
  }
  return sheet;
}

template <class Write>
double seconds_for(int strokes, const Write& write) {
  const sheet::Sheet sheet = scattered(strokes);
  const std::clock_t begin = std::clock();
  write(sheet);
  return static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
}

template <class Write>
void expect_linear(const Write& write) {
  const double few = seconds_for(2'000, write), many = seconds_for(16'000, write);
  EXPECT_LT(many, 24 * few + 0.1);  // 8 times as many strokes; their square is 64 times as much
}

TEST(ManyStrokes, TakeLinearTime) {
  expect_linear([](const sheet::Sheet& sheet) { return output::to_svg(sheet, {}); });
  expect_linear([](const sheet::Sheet& sheet) { return output::to_svg(sheet, {true}); });
  expect_linear([](const sheet::Sheet& sheet) { return output::to_pdf({&sheet}); });
  expect_linear([](const sheet::Sheet& sheet) { return output::to_eps(sheet); });
}

}  // namespace
}  // namespace epura::many_test
