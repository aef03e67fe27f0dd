// SPDX-License-Identifier: Apache-2.0
// Common parts of HTML reports and pages.
#pragma once

#include <map>
#include <string>
#include <string_view>

namespace epura::output {

/// Text with all markup escaped.
std::string html_text(std::string_view text);

/// JSON for an element <script>: no "<" in it can begin the end of the element, or a comment.
std::string within_script(const std::string& json);

/// A Content-Security-Policy (Level 3, 2.3.1) that permits one script and one style sheet with these hashes (SHA-256,
/// hexadecimal) and what `more` permits. Styles set by the script are not concerned.
std::string content_policy(std::string_view script_hash, std::string_view style_hash, std::string_view more = {});

/// Replaces each {{name}} of a page by its text. What is inserted is not searched for more of them.
std::string filled_page(std::string_view frame, const std::map<std::string_view, std::string>& texts);

}  // namespace epura::output
