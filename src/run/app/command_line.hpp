// SPDX-License-Identifier: Apache-2.0
// The command line of a program: parsing, help and suggestions, all from one table.
#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "app/command_line_options.hpp"

namespace epura {

struct ExitCode {
  int code;
  std::string meaning;
};

/// Texts for the help and manual of a program, except those of its commands.
struct ProgramTexts {
  std::string name;  ///< as typed by users: "epura study"
  std::string summary;
  std::string description;
  std::vector<ExitCode> exit_codes;
  std::vector<std::pair<std::string, std::string>> environment;  ///< variables and their meanings
  std::vector<std::pair<std::string, std::string>> examples;     ///< command lines and their meanings
  bool lists_projections = false;                                ///< whether the manual lists projections
  bool has_completion_scripts = false;                           ///< whether there are scripts for shells
};

/// A CLI11 command, and the function to call when it is parsed.
struct DefinedCommand {
  CLI::App* app;
  std::function<int()> run;  ///< returns the exit code
  std::vector<scene::OptionInfo> options;
  /// Given the words of a command line, defines the options that these need; otherwise defines and returns all. If
  /// empty, they are those above, which are defined.
  std::function<std::vector<scene::OptionInfo>(const CommandWords* words)> define_later{};
};

/// Defines a command that calls `run(part)` with the parsed options.
template <class Part, class Run>
DefinedCommand define_command(CLI::App* app, scene::Options<Part> options, Run run) {
  for (const scene::OptionInfo& option : options) define(*app, option);
  std::vector<scene::OptionInfo> infos(options.begin(), options.end());
  return {app,
          [app, options = std::move(options), run = std::move(run)] {
            Part part;
            read_options(*app, options, part);
            return run(part);
          },
          std::move(infos)};
}

/// The same with a table that is made only if the command is chosen, or described: of long tables, nearly every run
/// needs one at most, and few of its rows.
template <class Part, class Run>
DefinedCommand define_command(CLI::App* app, scene::Options<Part> (*table)(), Run run) {
  const auto made = std::make_shared<scene::Options<Part>>();
  const auto define_later = [app, table, made](const CommandWords* words) {
    *made = table();
    std::vector<const scene::OptionInfo*> rows;
    for (const scene::OptionInfo& option : *made) rows.push_back(&option);
    for (const scene::OptionInfo* option : words != nullptr ? needed_options(*words, rows) : rows)
      define(*app, *option);
    return words != nullptr ? std::vector<scene::OptionInfo>()
                            : std::vector<scene::OptionInfo>(made->begin(), made->end());
  };
  return {app,
          [app, made, run = std::move(run)] {
            Part part;
            read_options(*app, *made, part);
            return run(part);
          },
          {},
          define_later};
}

/// Runs the chosen one of the commands that `define` adds to the program. Returns the exit code. Throws Error{input}
/// for wrong usage.
int run_command_line(const ProgramTexts& texts, std::vector<DefinedCommand> (*define)(CLI::App& program), int argc,
                     char** argv);

/// Returns the exit code of `run`; prints errors to standard error.
int run_program(const std::function<int()>& run);

}  // namespace epura
