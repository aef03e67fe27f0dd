// Texts as JSON has them. RFC 8259, section 7.
#pragma once

#include <string>
#include <string_view>

namespace epura {

/// In quotation marks; bytes that are no UTF-8 become U+FFFD.
std::string json_text(std::string_view text);

}  // namespace epura
