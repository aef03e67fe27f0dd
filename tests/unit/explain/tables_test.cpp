// SPDX-License-Identifier: Apache-2.0
#include "explain/tables.hpp"

#include <gtest/gtest.h>

#include "base/text.hpp"
#include "studied.hpp"

namespace epura::test::tables_test {
namespace {

using Row = std::vector<std::string_view>;

std::vector<Row> rows_of(std::string_view table) {
  std::vector<Row> rows;
  for (const std::string_view line : split(table, '\n')) rows.push_back(split(line, '\t'));
  EXPECT_EQ(rows.back(), Row{""}) << "the last line is ended";
  rows.pop_back();
  return rows;
}

double number(std::string_view text) { return parse_number(text).value(); }

Studied plates() { return study(world_of({plate(0, 0, 4, 2, 0), plate(1, -1, 3, 1, 5)}), from_above()); }

TEST(EdgeTable, HasALineForEveryDrawnEdge) {
  const Studied studied = plates();
  const std::string table = explain::edge_table(studied.view());
  const std::vector<Row> rows = rows_of(table);
  ASSERT_EQ(rows.size(), 1 + studied.result.drawn.edges.size());
  EXPECT_EQ(rows[0], (Row{"edge", "kind", "angle", "faces", "x0", "y0", "x1", "y1", "length"}));
  EXPECT_EQ((Row{rows[1].begin(), rows[1].begin() + 4}), (Row{"0:0-1", "boundary", "-", "0:0"}));
  EXPECT_EQ(number(rows[1][8]), 4);
  for (const Row& row : rows) EXPECT_EQ(row.size(), rows[0].size());
}

TEST(SpanTable, NamesTheNearestHiderOfEachHiddenSpan) {
  const Studied studied = plates();
  const std::string table = explain::span_table(studied.view(), explain::TriangleBoxes(studied.result.view));
  const std::vector<Row> rows = rows_of(table);
  EXPECT_EQ(rows[0],
            (Row{"edge", "kind", "x0", "y0", "x1", "y1", "t0", "t1", "visibility", "hiders", "nearest", "ahead"}));
  ASSERT_GE(rows.size(), 4U);
  EXPECT_EQ(rows[1][8], "visible");
  EXPECT_EQ((Row{rows[2].begin() + 8, rows[2].end()}), (Row{"hidden", "1", "1:0", "5"}));
  EXPECT_NEAR(number(rows[2][6]), 0.25, 1e-9);
  EXPECT_NEAR(number(rows[2][7]), 0.75, 1e-9);
  for (const Row& row : rows) EXPECT_EQ(row.size(), rows[0].size());
}

TEST(SpanTable, CoversEveryEdgeFromEndToEnd) {
  const Studied studied = study(world_of(box({0, 0, 0}, {1, 1, 1})), orthographic({1, -2, 3}));
  const std::string table = explain::span_table(studied.view(), explain::TriangleBoxes(studied.result.view));
  const std::vector<Row> rows = rows_of(table);
  ASSERT_GT(rows.size(), 12U);
  for (std::size_t i = 1; i < rows.size(); ++i) {
    const bool first = rows[i][0] != rows[i - 1][0];
    EXPECT_EQ(rows[i][6], first ? "0" : rows[i - 1][7]);
    if (i + 1 == rows.size() || rows[i + 1][0] != rows[i][0]) {
      EXPECT_EQ(rows[i][7], "1");
    }
  }
}

}  // namespace
}  // namespace epura::test::tables_test
