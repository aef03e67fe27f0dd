// SPDX-License-Identifier: Apache-2.0
#include "output/json_text.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "base/text.hpp"

namespace epura::test::json_text_test {
namespace {

using output::json_lines;
using output::json_list;
using output::json_number;
using output::json_string;

TEST(JsonText, NumbersKeepAllDigits) {
  EXPECT_EQ(json_number(0.1), "0.1");
  EXPECT_EQ(parse_number(json_number(1.0 / 3)), 1.0 / 3);
}

TEST(JsonText, WhatIsNoNumberIsNull) {
  EXPECT_EQ(json_number(HUGE_VAL), "null");
  EXPECT_EQ(json_number(-HUGE_VAL), "null");
  EXPECT_EQ(json_number(std::nan("")), "null");
}

TEST(JsonText, ListsHaveCommasBetweenTheirItems) {
  EXPECT_EQ(json_list(std::vector<double>{}, json_number), "[]");
  EXPECT_EQ(json_list(std::vector{0.5}, json_number), "[0.5]");
  EXPECT_EQ(json_list(std::vector{0.5, 2.0, HUGE_VAL}, json_number), "[0.5, 2, null]");
  EXPECT_EQ(json_list(std::vector{"a\"", "b"}, json_string, ",", " "), "[ \"a\\\"\",\"b\"]");
}

TEST(JsonText, LinesAreIndentedWhereThereAreAny) {
  EXPECT_EQ(json_lines(std::vector<double>{}, json_number, "\n  "), "[]");
  EXPECT_EQ(json_lines(std::vector{1.0, 2.0}, json_number, "\n  "), "[\n  1,\n  2]");
}

}  // namespace
}  // namespace epura::test::json_text_test
