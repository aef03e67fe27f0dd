// SPDX-License-Identifier: Apache-2.0
#include "cut/cut_region.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace epura::test::cut_region_test {
namespace {

// A square that runs counterclockwise, cut in halves: what is drawn of either runs as it did.
TEST(CutRegion, KeepsTheSenseOfOutlines) {
  const std::vector<Vec3> file{{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}};
  const std::vector<cut::CutSegment> square{
      {0, {0, 1}, 1, 0}, {0, {0, 3}, -1, 1}, {0, {1, 2}, 1, 2}, {0, {2, 3}, 1, 3}};
  for (const double kept : {-1.0, 1.0}) {
    cut::CutMesh mesh;
    const cut::GrowingCut growing{file, mesh};
    const cut::RegionOutlines half = cut::clip_outlines(square, {{Vec3(1, 0, 0), Vec3(-kept, 0, 0)}}, growing, 1e-9);
    EXPECT_EQ(half.drawn.size(), 3U);
    EXPECT_EQ(half.closed.size(), 4U);
    const cut::CutPlaces places = growing.places();
    for (const cut::CutSegment& segment : half.drawn) {
      const Vec3 from = places[segment.vertex[0]], to = places[segment.vertex[1]];
      const Vec3 way = static_cast<double>(segment.sense) * (to - from), middle = (from + to) / 2.0 - Vec3(1, 1, 0);
      EXPECT_GT(middle.x * way.y - middle.y * way.x, 0) << "counterclockwise around the middle";
      EXPECT_EQ(std::abs(from.x - to.x) + std::abs(from.y - to.y), std::abs(middle.x) == 1 ? 2 : 1);
    }
  }
}

}  // namespace
}  // namespace epura::test::cut_region_test
