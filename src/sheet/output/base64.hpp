// SPDX-License-Identifier: Apache-2.0
// Bytes as text. RFC 4648, 4.
#pragma once

#include <string>
#include <string_view>

namespace epura::output {

std::string base64(std::string_view bytes);

}  // namespace epura::output
