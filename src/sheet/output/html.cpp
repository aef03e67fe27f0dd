// SPDX-License-Identifier: Apache-2.0
#include "output/html.hpp"

#include <algorithm>
#include <cstddef>

#include "base/error.hpp"
#include "output/xml_text.hpp"

namespace epura::output {

namespace {

// A hash as the policy has it.
std::string base64_of_hexadecimal(std::string_view digits) {
  std::string bytes;
  for (std::size_t i = 0; i + 1 < digits.size(); i += 2) {
    const auto value = [&](std::size_t at) { return digits[at] <= '9' ? digits[at] - '0' : digits[at] - 'a' + 10; };
    bytes += static_cast<char>(16 * value(i) + value(i + 1));
  }
  return base64(bytes);
}

}  // namespace

std::string html_text(std::string_view text) {
  std::string html;
  append_escaped(html, text);
  return html;
}

std::string within_script(const std::string& json) {
  std::string text;
  for (const char c : json) {
    if (c == '<')
      text += "\\u003c";
    else
      text += c;
  }
  return text;
}

std::string content_policy(std::string_view script_hash, std::string_view style_hash, std::string_view more) {
  return "default-src 'none'; script-src 'sha256-" + base64_of_hexadecimal(script_hash) + "'; style-src 'sha256-" +
         base64_of_hexadecimal(style_hash) + "'" + (more.empty() ? "" : "; ") + std::string(more) +
         "; base-uri 'none'; form-action 'none'";
}

std::string filled_page(std::string_view frame, const std::map<std::string_view, std::string>& texts) {
  std::string html;
  for (std::string_view rest = frame; !rest.empty();) {
    const std::size_t open = std::min(rest.find("{{"), rest.size());
    html += rest.substr(0, open);
    rest.remove_prefix(open);
    if (rest.empty()) break;
    const std::size_t close = rest.find("}}");
    const auto text = texts.find(rest.substr(2, close - 2));
    check(text != texts.end(), "every place of a page has a text");
    html += text->second;
    rest.remove_prefix(close + 2);
  }
  return html;
}

}  // namespace epura::output
