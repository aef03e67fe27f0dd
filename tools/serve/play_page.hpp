// SPDX-License-Identifier: Apache-2.0
// The page of `epura serve`: its frame, script and style sheet are constant, its data are JSON.
#pragma once

#include <string>

namespace epura {

/// `title` is text, `data` JSON.
std::string play_page(const std::string& title, const std::string& data);

/// Its Content-Security-Policy: its own script and style sheet, requests to its own server, and pictures made of them.
std::string play_policy();

}  // namespace epura
