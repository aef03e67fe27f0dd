// SPDX-License-Identifier: Apache-2.0
#include "base/sha256.hpp"

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

namespace epura {

namespace {

using Word = std::uint32_t;

constexpr std::size_t block_bytes = 64, rounds = 64, words_of_state = 8;

using DigestState = std::array<Word, words_of_state>;

// The first 32 bits of the fractional part of a root of a prime number, found in integers: of `root` 2 or 3.
constexpr Word fraction_of_root(std::uint64_t prime, int root) {
  // The largest x with (x / 2^32)^root <= prime; the digits of 2^(32 root) times a prime below 2^9 fit into 128 bits.
  __extension__ typedef unsigned __int128 Wide;
  std::uint64_t x = 0;
  for (std::uint64_t bit = std::uint64_t{1} << 37; bit > 0; bit >>= 1) {
    const Wide tried = x | bit;
    const Wide power = root == 2 ? tried * tried : tried * tried * tried;
    if (power <= static_cast<Wide>(prime) << (32 * root)) x |= bit;
  }
  return static_cast<Word>(x);
}

constexpr bool is_prime(std::uint64_t number) {
  for (std::uint64_t i = 2; i * i <= number; ++i)
    if (number % i == 0) return false;
  return true;
}

template <std::size_t count>
constexpr std::array<Word, count> fractions_of_roots(int root) {
  std::array<Word, count> fractions{};
  std::uint64_t prime = 2;
  for (Word& fraction : fractions) {
    while (!is_prime(prime)) ++prime;
    fraction = fraction_of_root(prime++, root);
  }
  return fractions;
}

constexpr DigestState initial_digest = fractions_of_roots<words_of_state>(2);        // FIPS 180-4, 5.3.3
constexpr std::array<Word, rounds> round_constants = fractions_of_roots<rounds>(3);  // 4.2.2

Word word_at(const char* bytes) {
  Word word = 0;
  for (std::size_t i = 0; i < 4; ++i) word = word << 8 | static_cast<unsigned char>(bytes[i]);
  return word;
}

void add_block(DigestState& state, const char* block) {
  std::array<Word, rounds> w{};
  for (std::size_t t = 0; t < 16; ++t) w[t] = word_at(block + 4 * t);
  for (std::size_t t = 16; t < rounds; ++t) {
    const Word small0 = std::rotr(w[t - 15], 7) ^ std::rotr(w[t - 15], 18) ^ w[t - 15] >> 3;
    const Word small1 = std::rotr(w[t - 2], 17) ^ std::rotr(w[t - 2], 19) ^ w[t - 2] >> 10;
    w[t] = small1 + w[t - 7] + small0 + w[t - 16];
  }
  auto [a, b, c, d, e, f, g, h] = state;
  for (std::size_t t = 0; t < rounds; ++t) {
    const Word large1 = std::rotr(e, 6) ^ std::rotr(e, 11) ^ std::rotr(e, 25), choice = (e & f) ^ (~e & g);
    const Word large0 = std::rotr(a, 2) ^ std::rotr(a, 13) ^ std::rotr(a, 22), majority = (a & b) ^ (a & c) ^ (b & c);
    const Word first = h + large1 + choice + round_constants[t] + w[t];
    h = g, g = f, f = e, e = d + first;
    d = c, c = b, b = a, a = first + large0 + majority;
  }
  const DigestState added{a, b, c, d, e, f, g, h};
  for (std::size_t i = 0; i < words_of_state; ++i) state[i] += added[i];
}

}  // namespace

std::string sha256(std::string_view bytes) {
  DigestState state = initial_digest;
  std::size_t at = 0;
  for (; at + block_bytes <= bytes.size(); at += block_bytes) add_block(state, bytes.data() + at);
  std::string rest(bytes.substr(at));
  rest += '\x80';
  while (rest.size() % block_bytes != block_bytes - 8) rest += '\0';
  const std::uint64_t bits = std::uint64_t{bytes.size()} * 8;
  for (int shift = 56; shift >= 0; shift -= 8) rest += static_cast<char>(bits >> shift & 255);
  for (at = 0; at < rest.size(); at += block_bytes) add_block(state, rest.data() + at);
  std::string digits;
  for (const Word word : state)
    for (int shift = 28; shift >= 0; shift -= 4) digits += "0123456789abcdef"[word >> shift & 15];
  return digits;
}

}  // namespace epura
