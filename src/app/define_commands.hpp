// SPDX-License-Identifier: Apache-2.0
// All commands of the program.
#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <vector>

#include "app/command_line.hpp"
#include "scene/option.hpp"

namespace epura {

/// A command as CLI11 knows it, and what was asked for when it is parsed.
struct DefinedCommand {
  const CLI::App* app;
  std::function<Command()> command;
  std::vector<OptionInfo> options;
};

/// Adds them to the program in the order of its help.
std::vector<DefinedCommand> define_commands(CLI::App& program);

}  // namespace epura
