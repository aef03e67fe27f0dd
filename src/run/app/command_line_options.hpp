// SPDX-License-Identifier: Apache-2.0
// Connects tables of options to CLI11: declares options, and reads the parsed values.
#pragma once

#include <CLI/CLI.hpp>
#include <map>
#include <string>
#include <vector>

#include "scene/option.hpp"

namespace epura {

/// Joins words with spaces.
std::string joined(const std::vector<std::string>& words);

void define(CLI::App& app, const scene::OptionInfo& option);

/// The arguments of the program.
using CommandWords = std::vector<std::string>;

/// Returns the rows of a table that a command line names, is about without names, or must name. If a word with a dash
/// is not exactly a name of the table, these are all: for help, for suggestions, and for short options in one word.
/// CLI11 takes longer to define a hundred options than a small drawing takes.
std::vector<const scene::OptionInfo*> needed_options(const CommandWords& words,
                                                     const std::vector<const scene::OptionInfo*>& rows);

/// Returns the values of an option on the command line in order; none if it is not defined; only the last value if the
/// option is not repeatable. Throws Error{input} if another option stands where a value is expected.
std::vector<scene::TomlValue> given_values(const CLI::App& app, const scene::OptionInfo& option);

/// Must be called after `app` is parsed. Throws Error{input}.
template <class Part>
void read_options(const CLI::App& app, const scene::Options<Part>& options, Part& part) {
  for (const scene::Option<Part>& option : options)
    for (const scene::TomlValue& value : given_values(app, option)) option.read(part, value);
}

/// The options of each command.
using OptionTables = std::map<const CLI::App*, std::vector<scene::OptionInfo>>;

/// Returns the innermost command on the command line.
const CLI::App& chosen_command(const CLI::App& app);

/// Turns arguments that CLI11 did not recognise into errors with suggestions. Throws Error{input}.
[[noreturn]] void refuse_wrong_use(const CLI::App& app, const CLI::ParseError& error);

}  // namespace epura
