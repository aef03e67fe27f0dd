// SPDX-License-Identifier: Apache-2.0
#include "base/text.hpp"

#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cfloat>
#include <charconv>
#include <clocale>
#include <cmath>
#include <locale>
#include <random>
#include <stdexcept>

#include "base/utf8.hpp"

namespace epura::test::text_test {
namespace {

TEST(Numbers, AreReadWholeOrNotAtAll) {
  EXPECT_EQ(parse_number("1.5"), 1.5);
  EXPECT_EQ(parse_number("+1.5"), 1.5);
  EXPECT_EQ(parse_number("-.5"), -0.5);
  EXPECT_EQ(parse_number("2."), 2.0);
  EXPECT_EQ(parse_number("1e3"), 1000.0);
  EXPECT_EQ(parse_number("1E-2"), 0.01);
  for (const char* junk : {"",   " ",   "+",     "-",  ".",    "e5",    "+-1", "++1", "--1",   " 1",
                           "1 ", "1,5", "1.5mm", "1e", "0x10", "1.2.3", "1\n", "one", "1e400", "-1e400"})
    EXPECT_EQ(parse_number(junk), std::nullopt) << junk;
}

TEST(Numbers, NanAndInfinityAreNumbersForWhoeverChecks) {
  EXPECT_TRUE(std::isnan(parse_number("nan").value()));
  EXPECT_EQ(parse_number("inf"), HUGE_VAL);
  EXPECT_EQ(parse_number("-inf"), -HUGE_VAL);
}

TEST(Numbers, WholeNumbersHaveNoFraction) {
  EXPECT_EQ(parse_integer("+12"), 12);
  EXPECT_EQ(parse_integer("-9223372036854775808"), INT64_MIN);
  for (const char* junk : {"", "1.0", "1e2", "9223372036854775808", "12a", " 1", "+-3"})
    EXPECT_EQ(parse_integer(junk), std::nullopt) << junk;
}

TEST(Numbers, ListsAreAllOrNothing) {
  EXPECT_EQ(parse_numbers("1,-2,+3e1"), (std::vector<double>{1, -2, 30}));
  for (const char* junk : {"", "1,", ",1", "1,,2", "1;2", "1, 2"}) EXPECT_EQ(parse_numbers(junk), std::nullopt) << junk;
}

TEST(Numbers, ComeBackAsTheSameDouble) {
  std::mt19937_64 random(1);
  for (int i = 0; i < 20000; ++i) {
    const double value = std::bit_cast<double>(random());
    if (!std::isfinite(value)) continue;
    ASSERT_EQ(std::bit_cast<std::uint64_t>(parse_number(format_number(value)).value()),
              std::bit_cast<std::uint64_t>(value));
  }
  for (const double value : {DBL_MAX, DBL_MIN, DBL_TRUE_MIN, 0.1, 1.0 / 3, 1e23, -5e-324})
    EXPECT_EQ(parse_number(format_number(value)), value);
}

TEST(Numbers, AreWrittenShort) {
  EXPECT_EQ(format_number(0.1), "0.1");
  EXPECT_EQ(format_number(-0.0), "0");
  EXPECT_EQ(format_number(297), "297");
  EXPECT_EQ(format_number(1e300), "1e+300");
}

TEST(Numbers, FixedDropsZerosAndKnowsNoNegativeZero) {
  EXPECT_EQ(format_fixed(1.5, 3), "1.5");
  EXPECT_EQ(format_fixed(0.1 + 0.2, 5), "0.3");
  EXPECT_EQ(format_fixed(100, 2), "100");
  EXPECT_EQ(format_fixed(100, 0), "100");
  EXPECT_EQ(format_fixed(2.0 / 3, 2), "0.67");
  for (const double tiny : {-0.0, -0.0004, -1e-300, 0.0004}) EXPECT_EQ(format_fixed(tiny, 3), "0") << tiny;
  EXPECT_EQ(format_fixed(-0.4, 0), "0");
  EXPECT_EQ(format_fixed(-0.0006, 3), "-0.001");
  EXPECT_EQ(format_fixed(-DBL_MAX, 6).size(), 310U);
}

// The digits of the value itself, correctly rounded, and zeros dropped.
std::string fixed_by_the_library(double value, int decimals) {
  std::array<char, 400> buffer{};
  std::string text(
      buffer.data(),
      std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, std::chars_format::fixed, decimals).ptr);
  while (decimals > 0 && text.back() == '0') text.pop_back();
  if (text.back() == '.') text.pop_back();
  return text == "-0" ? "0" : text;
}

TEST(Numbers, FixedIsRoundedCorrectlyAlsoHalfway) {
  std::mt19937_64 random(2);
  for (int i = 0; i < 50000; ++i) {
    const int decimals = static_cast<int>(random() % 9);
    // Halves, thousandths that are nearly halves, and anything.
    const double whole = static_cast<double>(static_cast<std::int64_t>(random()) >> (random() % 60));
    const std::array<double, 3> scales = {1.0 / 256, 0.0005, 1e-9};
    const double value = whole * scales[random() % 3];
    ASSERT_EQ(format_fixed(value, decimals), fixed_by_the_library(value, decimals)) << value << ' ' << decimals;
  }
  EXPECT_EQ(format_fixed(HUGE_VAL, 5), "inf");
}

// A locale with decimal commas and dots between thousands, for streams and, where it is installed, for C as well.
class GermanLocale {
 public:
  GermanLocale() : old_(std::locale()), old_c_(std::setlocale(LC_ALL, nullptr)) {
    struct German : std::numpunct<char> {
      char do_decimal_point() const override { return ','; }
      char do_thousands_sep() const override { return '.'; }
      std::string do_grouping() const override { return "\3"; }
    };
    try {
      std::locale::global(std::locale("de_DE.UTF-8"));
    } catch (const std::runtime_error&) {
      std::locale::global(std::locale(std::locale(), new German));
    }
  }
  GermanLocale(const GermanLocale&) = delete;
  GermanLocale& operator=(const GermanLocale&) = delete;
  ~GermanLocale() {
    std::locale::global(old_);
    std::setlocale(LC_ALL, old_c_.c_str());
  }

 private:
  std::locale old_;
  std::string old_c_;
};

TEST(Numbers, RoundedToSignificantDigits) {
  EXPECT_EQ(format_rounded(2.0 / 3, 6), "0.666667");
  EXPECT_EQ(format_rounded(163.49999999999997, 6), "163.5");
  EXPECT_EQ(format_rounded(-0.0, 6), "0");
  EXPECT_EQ(format_rounded(1.25e-9, 6), "1.25e-09");
  EXPECT_EQ(format_rounded(-1e300, 6), "-1e+300");
}

TEST(Numbers, DoNotFollowTheLocale) {
  const GermanLocale german;
  EXPECT_EQ(format_number(1234.5), "1234.5");
  EXPECT_EQ(format_fixed(1234567.25, 2), "1234567.25");
  EXPECT_EQ(parse_number("1.5"), 1.5);
  EXPECT_EQ(parse_number("1,5"), std::nullopt);
  EXPECT_EQ(parse_integer("1.000"), std::nullopt);
}

TEST(Text, SplitKeepsEmptyParts) {
  using Parts = std::vector<std::string_view>;
  EXPECT_EQ(split("", ','), Parts{""});
  EXPECT_EQ(split("a", ','), Parts{"a"});
  EXPECT_EQ(split(",a,,b,", ','), (Parts{"", "a", "", "b", ""}));
}

TEST(Text, LowerCaseLeavesOtherBytesAlone) { EXPECT_EQ(to_lower("A4 \xC3\x9C Z[@"), "a4 \xC3\x9C z[@"); }

TEST(Names, TheNearestIsMeantIfItIsNear) {
  const std::vector<std::string> names{"isometric", "dimetric", "trimetric", "top"};
  EXPECT_EQ(nearest_name("isometrc", names), "isometric");
  EXPECT_EQ(nearest_name("ISOMETRIC", names), "isometric");
  EXPECT_EQ(nearest_name("tpo", names), "top");
  EXPECT_EQ(nearest_name("qqqqqqqqq", names), std::nullopt);
  EXPECT_EQ(did_you_mean("dimetrik", names), "did you mean 'dimetric'?");
  EXPECT_EQ(did_you_mean("qqqqqqqqq", names), "known: isometric, dimetric, trimetric, top");
  EXPECT_EQ(did_you_mean("x", {}), "");
}

TEST(Names, WithNothingInCommonNoneIsMeant) {
  const std::vector<std::string> names{"ps", "svg"};
  EXPECT_EQ(nearest_name("", names), std::nullopt);
  EXPECT_EQ(nearest_name("x", names), std::nullopt);
  EXPECT_EQ(nearest_name("ab", names), std::nullopt);
  EXPECT_EQ(nearest_name("pa", names), "ps");
}

TEST(Names, OfEquallyNearOnesTheFirstIsTaken) {
  const std::vector<std::string> names{"near", "dear", "fear"};
  EXPECT_EQ(nearest_name("rear", names), "near");
}

constexpr const char* u_fffd = "\xEF\xBF\xBD";

TEST(Characters, ThatAreNoneAreReplacedOneByOne) {
  for (const char32_t code : {0xFDD0, 0xFDEF, 0xFFFE, 0xFFFF, 0x1FFFE, 0x1FFFF, 0x10FFFE, 0x10FFFF}) {
    EXPECT_EQ(valid_utf8("a" + utf8(code) + "b"), std::string("a") + u_fffd + "b") << unsigned(code);
    EXPECT_EQ(characters(utf8(code)), std::vector<char32_t>{0xFFFD}) << unsigned(code);
  }
  for (const char32_t code : {0xFDCF, 0xFDF0, 0xFFFD, 0x10000, 0x1FFFD, 0x10FFFD})
    EXPECT_EQ(valid_utf8(utf8(code)), utf8(code)) << unsigned(code);
}

TEST(Characters, OfUtf16ArePairsOrAlone) {
  const auto read = [](std::initializer_list<unsigned> units) {
    std::string bytes = "\xFF\xFE";
    for (const unsigned unit : units) bytes += {static_cast<char>(unit & 0xFF), static_cast<char>(unit >> 8)};
    return without_byte_order_mark(bytes);
  };
  EXPECT_EQ(read({0xD83D, 0xDE00, 'a'}), utf8(0x1F600) + "a");
  // Halves without the other one: before a character above and below the second halves, at the end, and the wrong way.
  for (const unsigned next : {0xE000U, 0xFFFDU, 0x61U}) EXPECT_EQ(read({0xD83D, next}), u_fffd + utf8(next)) << next;
  EXPECT_EQ(read({'a', 0xD83D}), std::string("a") + u_fffd);
  EXPECT_EQ(read({0xDE00, 0xD83D}), std::string(u_fffd) + u_fffd);
}

TEST(Characters, ThatSteerTerminalsAreNotShown) {
  EXPECT_EQ(printable("\x1b[31m\x07\x7f\xC2\x9B\xE2\x80\xAE\xE2\x81\xA6\xFF"),
            std::string(u_fffd) + "[31m" + u_fffd + u_fffd + u_fffd + u_fffd + u_fffd + u_fffd);
  for (const char32_t mark : {0x061C, 0x200E, 0x200F, 0x2028, 0x2029, 0x202A, 0x202E, 0x2066, 0x2069})
    EXPECT_EQ(printable("a" + utf8(mark)), std::string("a") + u_fffd) << unsigned(mark);
  for (const char32_t letter : {0x061B, 0x061D, 0x200D, 0x2010, 0x2027, 0x202F, 0x2065, 0x206A})
    EXPECT_EQ(printable(utf8(letter)), utf8(letter)) << unsigned(letter);
  EXPECT_EQ(printable("\xC3\xA4\n\tb"), "\xC3\xA4\n\tb");
  EXPECT_EQ(one_line("\xC3\xA4\n\tb\r"), std::string("\xC3\xA4  b") + u_fffd);
}

}  // namespace
}  // namespace epura::test::text_test
