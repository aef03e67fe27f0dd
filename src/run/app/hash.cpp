// SPDX-License-Identifier: Apache-2.0
#include "app/hash.hpp"

#include <nettle/base16.h>
#include <nettle/sha1.h>
#include <nettle/sha2.h>

#include <algorithm>
#include <array>
#include <string>

#include "base/file.hpp"

namespace epura {

namespace {

constexpr std::size_t uuid_size = 16;

std::string hexadecimal(const std::uint8_t* bytes, std::size_t size) {
  std::string text(BASE16_ENCODE_LENGTH(size), '\0');
  base16_encode_update(text.data(), size, bytes);
  return text;
}

// Of a UUID in its usual form.
std::string bytes_of_uuid(std::string_view uuid) {
  std::string digits;
  for (const char c : uuid)
    if (c != '-') digits += c;
  std::string bytes;
  for (std::size_t i = 0; i + 1 < digits.size(); i += 2)
    bytes += static_cast<char>(std::stoi(digits.substr(i, 2), nullptr, 16));
  return bytes;
}

}  // namespace

std::string hash_of_bytes(std::string_view bytes) {
  sha256_ctx context;
  sha256_init(&context);
  sha256_update(&context, bytes.size(), reinterpret_cast<const std::uint8_t*>(bytes.data()));
  std::array<std::uint8_t, SHA256_DIGEST_SIZE> digest{};
  sha256_digest(&context, digest.size(), digest.data());
  return hexadecimal(digest.data(), digest.size());
}

std::string hash_of_file(const std::filesystem::path& path) { return hash_of_bytes(read_file(path)); }

std::string uuid_of(std::string_view name, std::string_view space) {
  const std::string hashed = bytes_of_uuid(space).append(name);
  sha1_ctx context;
  sha1_init(&context);
  sha1_update(&context, hashed.size(), reinterpret_cast<const std::uint8_t*>(hashed.data()));
  std::array<std::uint8_t, SHA1_DIGEST_SIZE> digest{};
  sha1_digest(&context, digest.size(), digest.data());
  digest[6] = static_cast<std::uint8_t>((digest[6] & 0x0f) | 0x50);  // version 5
  digest[8] = static_cast<std::uint8_t>((digest[8] & 0x3f) | 0x80);  // variant of RFC 9562
  std::string uuid = hexadecimal(digest.data(), uuid_size);
  for (const std::size_t place : {8, 13, 18, 23}) uuid.insert(place, 1, '-');
  return uuid;
}

bool is_uuid(std::string_view text) {
  constexpr std::string_view form = "00000000-0000-0000-0000-000000000000";
  const auto fits = [](char c, char place) {
    return place == '-' ? c == '-' : std::string_view("0123456789abcdefABCDEF").find(c) != std::string_view::npos;
  };
  return std::equal(text.begin(), text.end(), form.begin(), form.end(), fits);
}

}  // namespace epura
