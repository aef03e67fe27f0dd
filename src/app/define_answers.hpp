// SPDX-License-Identifier: Apache-2.0
// Commands that tell of the program itself: the manual, and words for shells to complete.
#pragma once

#include <CLI/CLI.hpp>
#include <vector>

#include "app/define_commands.hpp"

namespace epura {

/// Adds them to the program, which has to live as long as they, and to its commands.
void define_answers(CLI::App& program, std::vector<DefinedCommand>& commands);

}  // namespace epura
