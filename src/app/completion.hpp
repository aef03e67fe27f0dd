// SPDX-License-Identifier: Apache-2.0
// Shell completion. The scripts call the program for suggestions, so third-party plugins complete as well.
#pragma once

#include <string>
#include <vector>

#include "app/command_tree.hpp"

namespace epura {

/// Shells that there is a script for.
const std::vector<std::string>& shells();

/// What the shell has to read. Throws Error{input} for others.
std::string completion_script(const std::string& shell);

/// Completions of the last of `words`, which follow the name of the program: a line for each, with its help after
/// a tab. Words that end with ':', '=' or ',' are to be continued. The line ":files" or ":folders" stands for the names
/// of those.
std::string complete(const CommandDescription& program, const std::vector<std::string>& words);

}  // namespace epura
