// SPDX-License-Identifier: Apache-2.0
#include "app/jobs/content_hash.hpp"

#include <xxhash.h>

#include "base/file.hpp"

namespace epura {

std::string hash_of_bytes(std::string_view bytes) {
  constexpr std::string_view digits = "0123456789abcdef";
  XXH128_canonical_t canonical;
  XXH128_canonicalFromHash(&canonical, XXH3_128bits(bytes.data(), bytes.size()));
  std::string text;
  for (const unsigned char byte : canonical.digest) {
    text += digits[byte / 16];
    text += digits[byte % 16];
  }
  return text;
}

std::string hash_of_file(const std::filesystem::path& path) { return hash_of_bytes(read_file(path)); }

}  // namespace epura
