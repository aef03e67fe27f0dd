// SPDX-License-Identifier: Apache-2.0
// Common parts of HTML reports.
#pragma once

#include <string>
#include <string_view>

#include "output/write.hpp"

namespace epura::output {

/// Text with all markup escaped.
std::string html_text(std::string_view text);

/// A picture as an element of a page: SVG without the XML declaration.
std::string inline_svg(const sheet::Sheet& sheet, const VectorOptions& options);

}  // namespace epura::output
