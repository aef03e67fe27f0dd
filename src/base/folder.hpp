// SPDX-License-Identifier: Apache-2.0
// Lists folders. The iterators of the standard library end the program if there is no memory for a name.
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

}  // namespace epura
