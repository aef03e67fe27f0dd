// SPDX-License-Identifier: Apache-2.0
#include "output/xml_text.hpp"

#include <cstddef>
#include <cstdint>

#include "base/utf8.hpp"

namespace epura::output {

void append_escaped(std::string& text, std::string_view value) {
  for (const char c : valid_utf8(value)) {
    if (c == '&') {
      text += "&amp;";
    } else if (c == '<') {
      text += "&lt;";
    } else if (c == '>') {
      text += "&gt;";
    } else if (c == '"') {
      text += "&quot;";
    } else if (c == '\n' || c == '\t') {
      text += c == '\n' ? "&#10;" : "&#09;";
    } else {
      text += static_cast<unsigned char>(c) < ' ' ? ' ' : c;
    }
  }
}

void append_attribute(std::string& text, std::string_view name, std::string_view value) {
  text.append(" ").append(name).append("=\"");
  append_escaped(text, value);
  text += '"';
}

void append_element(std::string& text, std::string_view name, std::string_view value) {
  append_escaped(text.append("<").append(name) += '>', value);
  text.append("</").append(name).append(">\n");
}

std::string base64(std::string_view bytes) {
  constexpr std::string_view letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const auto byte = [&](std::size_t at) {
      return at < bytes.size() ? std::uint32_t{static_cast<unsigned char>(bytes[at])} : 0U;
    };
    const std::uint32_t bits = byte(i) << 16 | byte(i + 1) << 8 | byte(i + 2);
    text += letters[bits >> 18];
    text += letters[bits >> 12 & 63];
    text += i + 1 < bytes.size() ? letters[bits >> 6 & 63] : '=';
    text += i + 2 < bytes.size() ? letters[bits & 63] : '=';
  }
  return text;
}

}  // namespace epura::output
