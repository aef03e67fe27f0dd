// SPDX-License-Identifier: Apache-2.0
// Shell completion. The scripts call the program for suggestions, so that names from third-party plugins are completed
// as well.
#pragma once

#include <string>
#include <vector>

#include "app/command_tree.hpp"

namespace epura {

/// Returns the shells for which there is a script.
const std::vector<std::string>& shells();

/// Returns the script for a shell. Throws Error{input} for unknown shells.
std::string completion_script(const std::string& shell);

/// Returns completions of the last of `words`, which follow the name of the program: one line for each, with its help
/// after a tab. A completion that ends with ':', '=' or ',' is incomplete. The line ":files" or ":folders" stands for
/// names of files or folders.
std::string complete(const CommandDescription& program, const std::vector<std::string>& words);

}  // namespace epura
