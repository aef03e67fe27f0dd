// SPDX-License-Identifier: Apache-2.0
#include "study/methods/method.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "base/error.hpp"
#include "base/parallel.hpp"
#include "shapes.hpp"

namespace epura::test::method_test {
namespace {

study::Method method(const char* text) { return study::parse_method(text, "--visibility"); }

// A tilted slab over bars in many directions: each bar's border is hidden in part.
world::World bars() {
  Shape shape = box({-1, -0.7, 1}, {1, 0.7, 1.3});
  for (int i = -9; i <= 9; ++i) shape.add(box({-3, i * 0.31 - 0.05, -1 - 0.01 * i}, {3, i * 0.31 + 0.06, -0.5}));
  return world_of(shape);
}

Result seen() { return draw(bars(), orthographic({0.31, -0.42, 1})); }

visibility::HiddenSpans by(const Result& r, const study::Method& method, double mm = 10) {
  return study::find_hidden(r.world, r.view, r.drawn, method, mm);
}

double length_of(const Result& r, std::size_t e) {
  const auto& [p, q] = r.drawn.edges[e].vertex;
  return std::hypot(r.view.vertices[p].x - r.view.vertices[q].x, r.view.vertices[p].y - r.view.vertices[q].y);
}

double hidden_length(const Result& r, const visibility::HiddenSpans& hidden) {
  double sum = 0;
  for (std::size_t e = 0; e < r.drawn.edges.size(); ++e)
    for (std::size_t i = hidden.first[e]; i < hidden.first[e + 1]; ++i)
      sum += (hidden.spans[i][1] - hidden.spans[i][0]) * length_of(r, e);
  return sum;
}

TEST(Method, IsReadAsItIsWritten) {
  for (const char* text : {"exact", "exact:bits=24", "float", "sampled:density=0.5", "sampled:density=4:halvings=0",
                           "item-buffer:dpi=1200", "none"})
    EXPECT_EQ(study::text_of(method(text)), text);
  EXPECT_EQ(study::text_of(method("sampled")), "sampled:density=4");
  EXPECT_EQ(method("exact:bits=30"), study::Method());
}

void expect_refused(const char* text, const char* reason) {
  try {
    method(text);
    ADD_FAILURE() << text << " is taken";
  } catch (const Error& error) {
    EXPECT_NE((error.what() + error.hint()).find(reason), std::string::npos) << error.what() << error.hint();
  }
}

TEST(Method, IsRefusedWithARemedy) {
  expect_refused("sample", "did you mean 'sampled'?");
  expect_refused("sampled:densty=3", "did you mean 'density'?");
  expect_refused("sampled:density", "'density' is not possible");
  expect_refused("sampled:density=0", "number from 1e-06 to 1e+06");
  expect_refused("sampled:density=nan", "is not possible");
  expect_refused("exact:bits=24.5", "whole number from 4 to 30");
  expect_refused("float:bits=24", "has no parameter 'bits'");
  expect_refused("exact:", "has no parameter ''");
}

TEST(Method, NoneHidesNothing) {
  const Result r = seen();
  EXPECT_TRUE(by(r, method("none")).spans.empty());
  EXPECT_EQ(by(r, method("none")).first.size(), r.drawn.edges.size() + 1);
}

TEST(Method, AllHideNearlyTheSame) {
  const Result r = seen();
  const double hidden = hidden_length(r, r.hidden);
  ASSERT_GT(hidden, 10);
  for (const char* text : {"exact:bits=20", "float", "sampled:density=50", "item-buffer:dpi=1200"})
    EXPECT_NEAR(hidden_length(r, by(r, method(text), 20)), hidden, 0.01 * hidden) << text;
}

TEST(Method, ExactWithAllBitsIsTheExactMethod) {
  const Result r = seen();
  EXPECT_EQ(by(r, method("exact")).spans, r.hidden.spans);
  EXPECT_NE(by(r, method("exact:bits=8")).spans, r.hidden.spans);
}

TEST(Method, BisectedChangesAreThoseOfTheExactMethod) {
  const Result r = seen();
  const visibility::HiddenSpans sampled = by(r, method("sampled:density=10000"));
  ASSERT_EQ(sampled.first, r.hidden.first);
  for (std::size_t i = 0; i < sampled.spans.size(); ++i)
    for (std::size_t k = 0; k < 2; ++k) EXPECT_NEAR(sampled.spans[i][k], r.hidden.spans[i][k], 1e-9);
}

TEST(Method, DoesNotDependOnThreads) {
  const Result r = seen();
  for (const char* text : {"sampled:density=3", "item-buffer:dpi=300"}) {
    visibility::HiddenSpans alone;
    {
      const ThreadLimit one(1);
      alone = by(r, method(text));
    }
    const visibility::HiddenSpans together = by(r, method(text));
    EXPECT_EQ(alone.first, together.first);
    EXPECT_EQ(alone.spans, together.spans);
  }
}

TEST(Method, EdgesShorterThanAStepAreLookedAtOnce) {
  const visibility::HiddenSpans found = by(seen(), method("sampled:density=0.001"), 0.01);
  EXPECT_FALSE(found.spans.empty());
  for (const auto& span : found.spans) EXPECT_EQ(span, (std::array<double, 2>{0, 1}));
}

TEST(Method, BuffersAndSamplesWithoutMeasureAreRefused) {
  const Result r = seen();
  EXPECT_THROW(by(r, method("item-buffer:dpi=100000"), 1e5), Error);
  EXPECT_THROW(by(r, method("sampled:density=1000000"), 1e5), Error);
}

// A face that is nearer than contact hides an edge that begins at its corner. Its copies, which touch the edge, do not.
TEST(Method, SamplesSeeThirdCopies) {
  const Shape shape{{{0, 0, 0}, {1, -1, 1e-9}, {1, 1, 1e-9}, {0.9, 0, 0}, {0.5, 0.2, -1}}, {{0, 1, 2}, {0, 3, 4}}, {}};
  const Result r = draw(world_of(std::vector<Shape>(4, shape)), from_above());
  EXPECT_EQ(by(r, method("sampled:density=1:halvings=0")).spans, r.hidden.spans);
}

TEST(Method, NothingToDrawIsNothingHidden) {
  Result r = seen();
  r.drawn.edges.clear();
  for (const char* text : {"exact:bits=24", "float", "sampled", "item-buffer"})
    EXPECT_EQ(by(r, method(text)).first, std::vector<std::size_t>{0}) << text;
}

}  // namespace
}  // namespace epura::test::method_test
