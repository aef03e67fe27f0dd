// Text from files and command lines, made fit for XML, JSON and PDF.
#pragma once

#include <string>
#include <string_view>

namespace epura {

/// The text with every byte that is not part of a valid character replaced by U+FFFD. U+FFFE and U+FFFF, which XML
/// forbids, count as invalid. Definition: Unicode, table 3-7.
std::string valid_utf8(std::string_view text);

}  // namespace epura
