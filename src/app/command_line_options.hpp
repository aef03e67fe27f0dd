// SPDX-License-Identifier: Apache-2.0
// Connects tables of options to CLI11: declares them, and reads the values that it found.
#pragma once

#include <CLI/CLI.hpp>
#include <map>
#include <string>
#include <vector>

#include "scene/option.hpp"

namespace epura {

/// Words with spaces between them.
std::string joined(const std::vector<std::string>& words);

void define(CLI::App& app, const scene::OptionInfo& option);

/// What the command line gives it, in order; of an option that is not repeatable the last value alone. Throws
/// Error{input} if another option takes the place of a value.
std::vector<scene::TomlValue> given_values(const CLI::App& app, const scene::OptionInfo& option);

/// To be called when `app` is parsed. Throws Error{input}.
template <class Part>
void read_options(const CLI::App& app, const scene::Options<Part>& options, Part& part) {
  for (const scene::Option<Part>& option : options)
    for (const scene::TomlValue& value : given_values(app, option)) option.read(part, value);
}

/// The options of each command.
using OptionTables = std::map<const CLI::App*, std::vector<scene::OptionInfo>>;

/// The innermost command that was named.
const CLI::App& chosen_command(const CLI::App& app);

/// Turns arguments that CLI11 did not recognise into errors with suggestions. Throws Error{input}.
[[noreturn]] void refuse_wrong_use(const CLI::App& app, const CLI::ParseError& error);

}  // namespace epura
