// SPDX-License-Identifier: Apache-2.0
// Text in whatever encoding its byte order mark announces -> UTF-8.
#pragma once

#include <string>

namespace epura {

/// UTF-16 with a byte order mark becomes UTF-8, the mark of UTF-8 is dropped, all else stays as it is.
std::string without_byte_order_mark(std::string bytes);

}  // namespace epura
