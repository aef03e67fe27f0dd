// SPDX-License-Identifier: Apache-2.0
// The commands of the program as plain values, from which the manual and shell completion are generated.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "app/command_line_options.hpp"

namespace epura {

struct OptionDescription {
  std::vector<std::string> names;  ///< "-o", "--output"; without dashes: a positional argument
  std::string type;                ///< placeholder of the value in the help, "FILE"; empty for flags
  std::string help;
  std::string usual;        ///< default value; empty if there is none
  bool takes_word = false;  ///< the next word is its value
  bool is_required = false;
  scene::ValueForm form{};  ///< form of its value, for completion

  [[nodiscard]] bool is_argument() const { return !names.front().starts_with('-'); }

  /// Whether the manual describes both equally.
  bool operator==(const OptionDescription& other) const { return names == other.names && help == other.help; }
};

struct CommandDescription {
  std::string name;  ///< one word
  std::string help;
  std::vector<OptionDescription> options;
  std::vector<CommandDescription> commands;
};

/// Describes a command and its subcommands, except those hidden from the help.
CommandDescription describe_command(const CLI::App& command, const OptionTables& tables);

/// Returns the arguments after the command's name for a synopsis: "[OPTION...] MODEL...".
std::string synopsis(const CommandDescription& command);

}  // namespace epura
