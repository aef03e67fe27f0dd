// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <array>
#include <optional>
#include <string>

#include "errors.hpp"
#include "pipeline/within_error.hpp"
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

// Facets are made finer only as long as what does not come from them leaves room for it.
TEST(FinerFacets, NotForAnErrorThatDoesNotComeFromThem) {
  const pipeline::Messages silent{[](const std::string&) {}, [](std::string_view) {}};
  const auto attempts = [&](double max_error, double hiding) {
    int count = 0;
    const auto draw = [&](double facets, const pipeline::Messages&) {
      report::ViewError error{"front"};
      error[report::ErrorTerm::surface] = facets;
      error[report::ErrorTerm::hiding] = hiding;
      ++count;
      pipeline::expect_within(max_error, false, std::array{error}, {1000, true});
      return pipeline::DrawnScene{};
    };
    try {
      pipeline::draw_within_error(max_error, 0, silent, draw);
    } catch (const Error& error) {
      EXPECT_TRUE(contains(error.what(), "lines of view 'front' may be off by")) << error.what();
    }
    return count;
  };
  EXPECT_EQ(attempts(1e-4, 2e-4), 1);
  EXPECT_GT(attempts(1e-4, 0.9e-4), 3);
}

}  // namespace
}  // namespace epura::test::finer_facets_test
