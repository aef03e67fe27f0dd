// SPDX-License-Identifier: Apache-2.0
// SHA-256 (FIPS 180-4, 6.2), by which a file is recognised wherever it lies.
#pragma once

#include <string>
#include <string_view>

namespace epura {

/// The digest of all bytes in 64 hexadecimal digits, small letters, as sha256sum prints it.
std::string sha256(std::string_view bytes);

}  // namespace epura
