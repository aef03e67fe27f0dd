// SPDX-License-Identifier: Apache-2.0
// Lists folders, and tells what lies in them. The iterators of the standard library end the program if there is no
// memory for a name.
#pragma once

#include <filesystem>
#include <string>
#include <system_error>
#include <vector>

namespace epura {

/// Returns the names of all that a folder contains, hidden files too, in the order of their bytes: that of the listing
/// is accidental. `failure` is set if the folder cannot be opened or read to its end; then what was read is returned.
std::vector<std::string> names_in(const std::filesystem::path& folder, std::error_code& failure);

/// The same, of a folder that must be readable. Throws Error{input}.
std::vector<std::string> names_in(const std::filesystem::path& folder);

/// Whether a path, both given without links, begins with that of a folder.
bool is_within(const std::filesystem::path& path, const std::filesystem::path& folder);

/// Whether a file lies in a folder (empty: the current one) or below it, whether it exists or not. Links count as what
/// they lead to: a link can come from the same stranger as the text that names it.
bool lies_below(const std::filesystem::path& file, const std::filesystem::path& folder);

}  // namespace epura
