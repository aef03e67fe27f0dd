// Text from files and command lines, made fit for XML, JSON, PDF and fonts. Definition: Unicode, table 3-7.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace epura {

/// The text with every byte that is not part of a valid character replaced by U+FFFD. U+FFFE and U+FFFF, which XML
/// forbids, count as invalid.
std::string valid_utf8(std::string_view text);

/// The characters of a text; U+FFFD for every byte that is not part of one.
std::vector<char32_t> characters(std::string_view text);

/// One character as UTF-8.
std::string utf8(char32_t character);

}  // namespace epura
