// SPDX-License-Identifier: Apache-2.0
// Placeholders in the names of files and in texts of a batch: {name}, {folder}, {number} and {hash}.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace epura {

/// The placeholders that take part in a text, and what stands for each.
using PlaceholderValues = std::vector<std::pair<std::string_view, std::function<std::string()>>>;

bool has_placeholder(std::string_view text);

/// Throws Error{input} if something else stands in braces. `where` is the option.
void expect_known_placeholders(std::string_view text, const std::string& where);

/// The values for a model: its file name without extension, the path of its folder as given (without `..` and the root,
/// so that outputs stay in their folder), its number from 1, and the SHA-256 of its contents.
PlaceholderValues values_for(const std::string& model, std::size_t number);

/// Returns the text with values in place of placeholders. Throws Error{input} if a file cannot be read for its hash.
std::string filled(std::string_view text, const PlaceholderValues& values);

/// Returns the path with the placeholder {folder} that was replaced by nothing tidied up: "out//x.pdf" is "out/x.pdf".
std::string filled_path(std::string_view text, const PlaceholderValues& values);

}  // namespace epura
