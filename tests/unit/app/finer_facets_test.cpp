// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <optional>

#include "views/view_error.hpp"

namespace epura::test::finer_facets_test {
namespace {

pipeline::TooFar attempt(double least, double triangles, bool is_imported = true) {
  return {{"front"}, least, {triangles, is_imported}};
}

TEST(FinerFacets, AsFarAsTheyAreMadeInAboutAMinute) {
  constexpr double factor = 4;
  EXPECT_EQ(pipeline::finer_by(attempt(1, 1000), std::nullopt, factor), factor);
  EXPECT_EQ(pipeline::finer_by(attempt(0.3, 60'000), attempt(1, 20'000), factor), factor);
  EXPECT_EQ(pipeline::finer_by(attempt(0.3, 120'000), attempt(1, 40'000), factor), 2);
  EXPECT_EQ(pipeline::finer_by(attempt(0.3, 200'000), attempt(1, 70'000), factor), 1);
}

TEST(FinerFacets, OnlyWhereTheyHelp) {
  EXPECT_EQ(pipeline::finer_by(attempt(0.95, 1000), attempt(1, 300), 4), 1);
  EXPECT_EQ(pipeline::finer_by(attempt(1, 1000, false), std::nullopt, 4), 1);
}

}  // namespace
}  // namespace epura::test::finer_facets_test
