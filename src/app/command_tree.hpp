// SPDX-License-Identifier: Apache-2.0
// The commands of the program as plain values, from which manual and shell completion are made.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "app/command_line_options.hpp"

namespace epura {

struct OptionDescription {
  std::vector<std::string> names;  ///< "-o", "--output"; one without dashes is an argument, found by its place
  std::string type;                ///< of the value as the help names it, "FILE"; empty for flags
  std::string help;
  std::string usual;        ///< default value; empty if there is none
  bool takes_word = false;  ///< the next word is its value
  bool is_required = false;
  scene::ValueForm form{};  ///< of its value, for completion

  [[nodiscard]] bool is_argument() const { return !names.front().starts_with('-'); }

  /// Whether the manual describes both in the same way.
  bool operator==(const OptionDescription& other) const { return names == other.names && help == other.help; }
};

struct CommandDescription {
  std::string name;  ///< one word
  std::string help;
  std::vector<OptionDescription> options;
  std::vector<CommandDescription> commands;
};

/// The command and those inside it; without what is hidden from the help.
CommandDescription describe_command(const CLI::App& command, const OptionTables& tables);

/// Arguments of the command after its name, as in a synopsis: "[OPTION...] MODEL...".
std::string synopsis(const CommandDescription& command);

}  // namespace epura
