// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "dimensions/obstacles.hpp"
#include "drawing/drawing.hpp"

namespace epura::ink_index_test {
namespace {

// Lines of all lengths, among them points, and boxes at any angle, in and beside the drawing.
TEST(InkIndex, CountsWhatASearchOfAllLinesCounts) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> unit(0, 1);
  const auto place = [&](double size) { return Vec2(size * unit(random), size * unit(random)); };
  drawing::ViewDrawing drawing;
  for (int i = 0; i < 500; ++i) {
    const Vec2 from = place(200), way = std::pow(10, 3 * unit(random) - 1) * (place(2) - Vec2(1));
    drawing::Segment& segment = drawing.segments.emplace_back();
    segment.from = from;
    segment.to = i % 50 == 0 ? from : from + way;
  }
  const sheet::InkIndex index(drawing);
  int met = 0;
  for (int i = 0; i < 2000; ++i) {
    const double angle = i % 3 == 0 ? 0 : 7 * unit(random);
    const Vec2 half = i % 4 == 0 ? Vec2(40 * unit(random), 0) : place(i % 5 == 0 ? 60 : 3);
    const sheet::TurnedBox box{place(300) - Vec2(50), {std::cos(angle), std::sin(angle)}, half};
    const int count = sheet::ink_in(box, drawing);
    ASSERT_EQ(index.in(box), count) << i;
    met += count > 0 ? 1 : 0;
  }
  EXPECT_GT(met, 500);
  EXPECT_LT(met, 1900);
}

}  // namespace
}  // namespace epura::ink_index_test
