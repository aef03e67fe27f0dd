// SPDX-License-Identifier: Apache-2.0
// SHA-256, by which contents are recognised wherever they lie.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace epura {

/// The digest of all bytes in 64 hexadecimal digits, small letters, as sha256sum prints it.
std::string hash_of_bytes(std::string_view bytes);

/// The hash of a file's contents. Throws Error{input} if it cannot be read.
std::string hash_of_file(const std::filesystem::path& path);

}  // namespace epura
