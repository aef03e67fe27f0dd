// SPDX-License-Identifier: Apache-2.0
// SHA-256, by which contents are recognised wherever they lie, and UUIDs that names have.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace epura {

/// The digest of all bytes in 64 hexadecimal digits, small letters, as sha256sum prints it.
std::string hash_of_bytes(std::string_view bytes);

/// The hash of a file's contents. Throws Error{input} if it cannot be read.
std::string hash_of_file(const std::filesystem::path& path);

/// The UUID of a name in the namespace that another one begins, or in that of URLs: version 5 of RFC 9562, by SHA-1.
/// The same name has the same one wherever and whenever.
std::string uuid_of(std::string_view name, std::string_view space = "6ba7b811-9dad-11d1-80b4-00c04fd430c8");

/// Whether a text is a UUID in its usual form.
bool is_uuid(std::string_view text);

}  // namespace epura
