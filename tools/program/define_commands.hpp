// SPDX-License-Identifier: Apache-2.0
// All commands of epura, and the texts of its help and manual.
#pragma once

#include <vector>

#include "app/command_line.hpp"

namespace epura {

const ProgramTexts& program_texts();

/// Adds the commands to the program, in the order of the help.
std::vector<DefinedCommand> define_commands(CLI::App& program);

}  // namespace epura
