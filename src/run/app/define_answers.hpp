// SPDX-License-Identifier: Apache-2.0
// Commands that describe the program itself: the manual, and completion words for shells.
#pragma once

#include <vector>

#include "app/command_line.hpp"

namespace epura {

/// Adds these commands to the program and to `commands`. `program` and `texts` must outlive them.
void define_answers(CLI::App& program, const ProgramTexts& texts, std::vector<DefinedCommand>& commands);

}  // namespace epura
