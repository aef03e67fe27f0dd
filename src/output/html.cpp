// SPDX-License-Identifier: Apache-2.0
#include "output/html.hpp"

#include "output/xml_text.hpp"

namespace epura::output {

std::string html_text(std::string_view text) {
  std::string html;
  append_escaped(html, text);
  return html;
}

}  // namespace epura::output
