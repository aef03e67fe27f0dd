// SPDX-License-Identifier: Apache-2.0
// Common parts of HTML reports.
#pragma once

#include <string>
#include <string_view>

namespace epura::output {

/// Text with all markup escaped.
std::string html_text(std::string_view text);

}  // namespace epura::output
