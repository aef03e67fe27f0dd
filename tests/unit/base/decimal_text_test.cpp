// SPDX-License-Identifier: Apache-2.0
#include "base/decimal_text.hpp"

#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "base/text.hpp"

namespace epura::decimal_text_test {
namespace {

std::string written(long long scaled, int decimals, LeadingZero zero) {
  std::array<char, longest_decimal> buffer{};
  return {buffer.data(), write_scaled(buffer.data(), scaled, decimals, zero)};
}

// Long division as on paper, independent of the code.
std::string on_paper(long long scaled, int decimals, bool leading_zero) {
  std::string digits = std::to_string(scaled);
  const bool negative = digits.front() == '-';
  if (negative) digits.erase(0, 1);
  const auto places = static_cast<std::size_t>(decimals);
  if (digits.size() <= places) digits.insert(0, places + 1 - digits.size(), '0');
  std::string whole = digits.substr(0, digits.size() - places), rest = digits.substr(digits.size() - places);
  while (!rest.empty() && rest.back() == '0') rest.pop_back();
  if (whole == "0" && !rest.empty() && !leading_zero) whole.clear();
  return (negative ? "-" : "") + whole + (rest.empty() ? "" : "." + rest);
}

TEST(DecimalText, DividesByPowersOfTen) {
  std::vector<long long> numbers{0, std::numeric_limits<long long>::max(), std::numeric_limits<long long>::min() + 1};
  for (long long power = 1; power < 1'000'000'000'000'000'000 / 7; power *= 10)
    for (const long long near : {power - 1, power, power + 1, 7 * power + 3, 4294967295 % power, 4294967295 + power})
      for (const long long number : {near, -near}) numbers.push_back(number);
  for (int i = 0; i < 20'000; ++i) numbers.push_back(i * 7919LL % 123'457);
  for (const long long number : numbers)
    for (int decimals = 0; decimals <= 6; ++decimals) {
      EXPECT_EQ(written(number, decimals, LeadingZero::written), on_paper(number, decimals, true));
      EXPECT_EQ(written(number, decimals, LeadingZero::omitted), on_paper(number, decimals, false));
    }
}

TEST(DecimalText, FitsItsRoom) {
  for (const long long number : {std::numeric_limits<long long>::min(), 4294967295LL, -4294967295LL}) {
    std::array<char, longest_decimal + 8> buffer{};
    write_scaled(buffer.data(), number, 6, LeadingZero::written);
    for (std::size_t i = longest_decimal; i < buffer.size(); ++i) EXPECT_EQ(buffer[i], 0);
  }
}

TEST(DecimalText, WritesWholeNumbers) {
  std::array<char, longest_decimal> buffer{};
  EXPECT_EQ(std::string(buffer.data(), write_whole(buffer.data(), 0)), "0");
  EXPECT_EQ(std::string(buffer.data(), write_whole(buffer.data(), -1200)), "-1200");
  EXPECT_EQ(std::string(buffer.data(), write_whole(buffer.data(), std::numeric_limits<long long>::min())),
            "-9223372036854775808");
}

// What is read is what parse_number makes of the whole word; what it refuses is not read.
TEST(DecimalText, ReadsWholeWords) {
  for (const std::string word : {"1", "-2.5", "1e-3", "1e999", "+1", "7/1", "1#", "nan", "-inf", "1,5", "", "-", "0x1"})
    for (const std::string behind : {"", " 7", "\t", "\r\n", "\n", "\\\n", "#"}) {
      const std::string text = word + behind;
      double value = 0;
      const char* const end = read_number(text.data(), text.data() + text.size(), value);
      const bool is_word = behind.empty() || behind[0] <= ' ';
      const auto expected = word.starts_with('+') || !is_word ? std::nullopt : parse_number(word);
      ASSERT_EQ(end != nullptr, expected.has_value()) << text;
      if (end == nullptr) continue;
      EXPECT_EQ(end, text.data() + word.size());
      EXPECT_EQ(std::bit_cast<std::uint64_t>(value), std::bit_cast<std::uint64_t>(*expected));
    }
  const std::string whole = "12 1.5";
  long long value = 0;
  EXPECT_EQ(read_number(whole.data(), whole.data() + whole.size(), value), whole.data() + 2);
  EXPECT_EQ(value, 12);
  EXPECT_EQ(read_number(whole.data() + 3, whole.data() + whole.size(), value), nullptr);
}

}  // namespace
}  // namespace epura::decimal_text_test
