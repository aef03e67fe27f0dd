// SPDX-License-Identifier: Apache-2.0
// The command line of a program: parsing, help and suggestions, all from one table.
#pragma once

#include <CLI/CLI.hpp>
#include <functional>
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
  const CLI::App* app;
  std::function<int()> run;  ///< returns the exit code
  std::vector<scene::OptionInfo> options;
  std::function<std::vector<scene::OptionInfo>()> define_later{};  ///< defines the options and returns them; if empty,
                                                                   ///< they are those above
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
/// needs one at most.
template <class Part, class Run>
DefinedCommand define_command(CLI::App* app, scene::Options<Part> (*table)(), Run run) {
  const auto define_all = [app, table] {
    const scene::Options<Part> options = table();
    for (const scene::OptionInfo& option : options) define(*app, option);
    return std::vector<scene::OptionInfo>(options.begin(), options.end());
  };
  app->preparse_callback([define_all](std::size_t) { define_all(); });
  return {app,
          [app, table, run = std::move(run)] {
            Part part;
            read_options(*app, table(), part);
            return run(part);
          },
          {},
          define_all};
}

/// Runs the chosen one of the commands that `define` adds to the program. Returns the exit code. Throws Error{input}
/// for wrong usage.
int run_command_line(const ProgramTexts& texts, std::vector<DefinedCommand> (*define)(CLI::App& program), int argc,
                     char** argv);

/// Returns the exit code of `run`; prints errors to standard error.
int run_program(const std::function<int()>& run);

}  // namespace epura
