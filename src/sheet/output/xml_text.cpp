// SPDX-License-Identifier: Apache-2.0
#include "output/xml_text.hpp"

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

}  // namespace epura::output
