// SPDX-License-Identifier: Apache-2.0
#include "base/decimal_text.hpp"

#include <array>
#include <charconv>
#include <cstdint>
#include <cstring>
#include <system_error>

namespace epura {

namespace {

constexpr std::array<char, 200> make_pairs() {
  std::array<char, 200> pairs{};
  for (std::size_t i = 0; i < 100; ++i) {
    pairs[2 * i] = static_cast<char>('0' + i / 10);
    pairs[2 * i + 1] = static_cast<char>('0' + i % 10);
  }
  return pairs;
}
constexpr std::array<char, 200> pairs = make_pairs();

/// The digits of a number, preceded by zeros. What follows them may be read as well: copies of a fixed length take one
/// instruction.
struct Digits {
  static constexpr std::size_t most = 16;
  std::array<char, 2 * most> text;
  std::size_t count;

  explicit Digits(std::uint32_t value) {
    text.fill('0');
    char* at = text.data() + most;
    for (; value >= 10; value /= 100) std::memcpy(at -= 2, pairs.data() + 2 * (value % 100), 2);
    if (value > 0) *--at = static_cast<char>('0' + value);
    count = static_cast<std::size_t>(text.data() + most - at);
  }

  /// The last digits, at most `most`.
  [[nodiscard]] const char* last(std::size_t digits) const { return text.data() + most - digits; }
};

char* write_short(char* at, std::uint32_t value, std::size_t decimals, LeadingZero zero) {
  for (; decimals > 0 && value % 10 == 0; --decimals) value /= 10;
  const Digits digits(value);
  std::size_t before = digits.count > decimals ? digits.count - decimals : 0;
  if (before == 0 && (decimals == 0 || zero == LeadingZero::written)) before = 1;
  std::memcpy(at, digits.last(decimals + before), Digits::most);
  if (decimals == 0) return at + before;
  at[before] = '.';
  std::memcpy(at + before + 1, digits.last(decimals), 8);
  return at + before + 1 + decimals;
}

char* write_long(char* at, std::uint64_t value, int decimals, LeadingZero zero) {
  for (; decimals > 0 && value % 10 == 0; --decimals) value /= 10;
  std::uint64_t power = 1;
  for (int i = 0; i < decimals; ++i) power *= 10;
  const std::uint64_t whole = value / power;
  if (whole > 0 || decimals == 0 || zero == LeadingZero::written) at = std::to_chars(at, at + 20, whole).ptr;
  if (decimals == 0) return at;
  *at = '.';
  std::uint64_t rest = value - whole * power;
  for (int place = decimals; place > 0; --place) {
    at[place] = static_cast<char>('0' + rest % 10);
    rest /= 10;
  }
  return at + decimals + 1;
}

template <class Number>
const char* read(const char* at, const char* end, Number& value) {
  const auto [behind, error] = std::from_chars(at, end, value);
  const bool is_whole_word = behind == end || static_cast<unsigned char>(*behind) <= ' ';
  return error == std::errc{} && is_whole_word ? behind : nullptr;
}

}  // namespace

char* write_scaled(char* at, long long scaled, int decimals, LeadingZero zero) {
  const std::uint64_t value = scaled < 0 ? 0 - static_cast<std::uint64_t>(scaled) : static_cast<std::uint64_t>(scaled);
  if (scaled < 0) *at++ = '-';
  // Most numbers fit 32 bits, which are divided several times as fast.
  if (value > UINT32_MAX) return write_long(at, value, decimals, zero);
  return write_short(at, static_cast<std::uint32_t>(value), static_cast<std::size_t>(decimals), zero);
}

char* write_whole(char* at, long long value) { return write_scaled(at, value, 0, LeadingZero::written); }

const char* read_number(const char* at, const char* end, double& value) { return read(at, end, value); }

const char* read_number(const char* at, const char* end, long long& value) { return read(at, end, value); }

}  // namespace epura
