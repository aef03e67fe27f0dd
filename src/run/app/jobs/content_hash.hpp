// SPDX-License-Identifier: Apache-2.0
// Hashes of 128 bits (XXH3) by which a batch recognises what has changed. They do not protect from forgery.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace epura {

/// 32 hexadecimal digits.
std::string hash_of_bytes(std::string_view bytes);

/// The hash of a file's contents. Throws Error{input} if it cannot be read.
std::string hash_of_file(const std::filesystem::path& path);

}  // namespace epura
