// SPDX-License-Identifier: Apache-2.0
// Rows of the tables of plugins: as long as the plugin says, and all alike.
#include <gtest/gtest.h>

#include <array>
#include <cstdint>

#include "errors.hpp"
#include "foreign/parameters.hpp"

namespace epura::test::rows_test {
namespace {

/// A row as this program knows it.
struct Row {
  std::uint32_t size, value;
};
/// The same of a later version.
struct LongRow {
  std::uint32_t size, value, more, most;
};

TEST(Rows, OfALaterVersionAreReadAsFarAsTheyAreKnown) {
  const std::array<LongRow, 3> rows{
      {{sizeof(LongRow), 4, 0, 0}, {sizeof(LongRow), 5, 0, 0}, {sizeof(LongRow), 6, 0, 0}}};
  for (std::size_t i = 0; i < rows.size(); ++i)
    EXPECT_EQ(foreign::row_of(reinterpret_cast<const Row*>(rows.data()), i, "it").value, 4 + i);
}

TEST(Rows, OfDifferentSizesAreRefused) {
  const std::array<Row, 3> rows{{{sizeof(Row), 4}, {sizeof(Row), 5}, {sizeof(LongRow), 6}}};
  EXPECT_EQ(foreign::row_of(rows.data(), 1, "its list").value, 5U);
  const Error error = error_of([&] { foreign::row_of(rows.data(), 2, "its list"); });
  EXPECT_EQ(error.kind(), ErrorKind::plugin);
  EXPECT_TRUE(contains(error.what(), "its list has rows of different sizes")) << error.what();
}

TEST(Rows, ThatAreTooShortOrCrookedAreRefused) {
  for (const std::uint32_t size : {0U, 4U, 7U, 9U, 10U}) {
    const std::array<Row, 2> rows{{{size, 4}, {size, 5}}};
    EXPECT_EQ(error_of([&] { foreign::row_of(rows.data(), 0, "its list"); }).kind(), ErrorKind::plugin) << size;
  }
}

}  // namespace
}  // namespace epura::test::rows_test
