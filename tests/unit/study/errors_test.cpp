// SPDX-License-Identifier: Apache-2.0
#include "study/accuracy/errors.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "oracle/span_sets.hpp"
#include "study/accuracy/ink_distance.hpp"

namespace epura::test::errors_test {
namespace {

// 100 mm along x at a height.
study::JudgedEdge edge(const visibility::Spans& shown, const visibility::Spans& right, double y = 0) {
  return {{0, y}, {100, y}, shown, right};
}

TEST(SpanSets, AreSets) {
  const visibility::Spans a{{0.1, 0.4}, {0.5, 0.9}}, b{{0.0, 0.2}, {0.3, 0.6}, {0.8, 1.0}};
  EXPECT_EQ(common(a, b), (visibility::Spans{{0.1, 0.2}, {0.3, 0.4}, {0.5, 0.6}, {0.8, 0.9}}));
  EXPECT_EQ(without(a, b), (visibility::Spans{{0.2, 0.3}, {0.6, 0.8}}));
  EXPECT_EQ(without(b, a), (visibility::Spans{{0.0, 0.1}, {0.4, 0.5}, {0.9, 1.0}}));
  EXPECT_EQ(united(a, b), (visibility::Spans{{0.0, 1.0}}));
  EXPECT_EQ(complement(a), (visibility::Spans{{0.0, 0.1}, {0.4, 0.5}, {0.9, 1.0}}));
  EXPECT_TRUE(without({}, a).empty());
  EXPECT_EQ(without(a, {}), a);
}

TEST(Errors, NoneWhereAllIsRight) {
  const study::Errors errors = study::measure_errors({edge({{0.2, 0.5}}, {{0.2, 0.5}}), edge({}, {}, 5)});
  EXPECT_EQ(errors.longest, 0);
  EXPECT_EQ(errors.sum, 0);
  EXPECT_EQ(errors.ink, 0);
  EXPECT_EQ(errors.end_point, 0);
  EXPECT_EQ(errors.missed + errors.phantom + errors.cracks + errors.edges, 0);
  EXPECT_EQ(errors.judged, 2);
}

TEST(Errors, AShiftedEnd) {
  const study::Errors errors = study::measure_errors({edge({{0.2, 0.53}}, {{0.2, 0.5}})});
  EXPECT_NEAR(errors.longest, 3, 1e-12);
  EXPECT_NEAR(errors.sum, 3, 1e-12);
  EXPECT_NEAR(errors.end_point, 3, 1e-12);
  EXPECT_NEAR(errors.ink, 3, 3e-3) << "the end of the right ink lies 3 mm from the ink shown";
  EXPECT_EQ(errors.missed + errors.phantom + errors.cracks, 0);
  EXPECT_EQ(errors.edges, 1);
}

TEST(Errors, AFlippedSpanIsFoundWithItsLength) {
  const study::Errors phantom = study::measure_errors({edge({{0.0, 0.3}, {0.5, 1.0}}, {{0.0, 1.0}}), edge({}, {}, 7)});
  EXPECT_NEAR(phantom.longest, 20, 1e-12);
  EXPECT_EQ(phantom.phantom, 1);
  EXPECT_NEAR(phantom.ink, 7, 7e-3) << "to the next line";
  const study::Errors missed = study::measure_errors({edge({{0.0, 1.0}}, {{0.0, 0.3}, {0.5, 1.0}}), edge({}, {}, 7)});
  EXPECT_NEAR(missed.longest, 20, 1e-12);
  EXPECT_EQ(missed.missed, 1);
  EXPECT_EQ(missed.cracks, 0);
}

TEST(Errors, ALineThatIsBroken) {
  const study::Errors errors = study::measure_errors({edge({{0.40, 0.41}, {0.6, 0.605}}, {})});
  EXPECT_EQ(errors.cracks, 2);
  EXPECT_NEAR(errors.longest, 1, 1e-12);
  EXPECT_NEAR(errors.sum, 1.5, 1e-12);
  EXPECT_NEAR(errors.ink, 0.5, 1e-3) << "the middle of the gap";
  EXPECT_EQ(errors.end_point, 0) << "the ends of the whole line are where they belong";
}

TEST(Errors, WrongOneWayAndThenTheOtherIsOneSpan) {
  EXPECT_NEAR(study::measure_errors({edge({{0.2, 0.3}}, {{0.3, 0.45}})}).longest, 25, 1e-12);
}

TEST(Errors, NoInkAtAll) { EXPECT_EQ(study::measure_errors({edge({{0, 1}}, {})}).ink, HUGE_VAL); }

TEST(InkDistance, IsTheFarthest) {
  const std::vector<study::InkLine> ink{{{0, 0}, {10, 0}}, {{0, 8}, {10, 8}}};
  EXPECT_NEAR(study::farthest_from_ink({{{2, 1}, {9, 3}}}, ink), 3, 3e-3);
  EXPECT_NEAR(study::farthest_from_ink({{{5, 0}, {5, 8}}}, ink), 4, 4e-3) << "in the middle, not at an end";
  EXPECT_NEAR(study::farthest_from_ink({{{10, 0}, {13, 4}}}, ink), std::hypot(3, 4), 5e-3);
  EXPECT_EQ(study::farthest_from_ink({}, ink), 0);
}

TEST(InkDistance, InkOnInkEnds) {
  std::vector<study::InkLine> ink;
  for (int i = 0; i < 1000; ++i) ink.push_back({{i / 7.0, i / 3.0}, {(i + 1) / 7.0, (i + 1) / 3.0}});
  EXPECT_LT(study::farthest_from_ink({{{0, 0}, {1000 / 7.0, 1000 / 3.0}}}, ink), 1e-9);
}

}  // namespace
}  // namespace epura::test::errors_test
