// SPDX-License-Identifier: Apache-2.0
#include "serve/play_page.hpp"

#include "output/html.hpp"
#include "serve/play_parts.hpp"

namespace epura {

std::string play_page(const std::string& title, const std::string& data) {
  return output::filled_page(play_frame, {{"title", output::html_text(title)},
                                          {"style", std::string(play_style)},
                                          {"script", std::string(play_script)},
                                          {"data", output::within_script(data)}});
}

std::string play_policy() {
  return output::content_policy(play_script_hash, play_style_hash, "img-src blob: data:; connect-src 'self'") +
         "; frame-ancestors 'none'";
}

}  // namespace epura
