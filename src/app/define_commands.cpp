// SPDX-License-Identifier: Apache-2.0
#include "app/define_commands.hpp"

#include <string>
#include <utility>

#include "app/command_line_options.hpp"
#include "app/command_options.hpp"
#include "app/define_answers.hpp"
#include "app/draw_options.hpp"

namespace epura {

namespace {

template <class Part>
DefinedCommand defined(CLI::App& parent, const std::string& name, const std::string& help, Options<Part> options,
                       Part usual = {}) {
  CLI::App* app = parent.add_subcommand(name, help);
  for (const OptionInfo& option : options) define(*app, option);
  std::vector<OptionInfo> infos(options.begin(), options.end());
  const auto command = [app, options = std::move(options), usual = std::move(usual)] {
    Part part = usual;
    read_options(*app, options, part);
    return Command(part);
  };
  return {app, command, std::move(infos)};
}

}  // namespace

std::vector<DefinedCommand> define_commands(CLI::App& program) {
  DrawOptions explaining;
  explaining.run.explain = true;
  std::vector<DefinedCommand> commands{
      defined(program, "draw", "draw models", draw_options()),
      defined(program, "explain", "draw, and tell which stages ran, which were left out, and why", explain_options(),
              explaining),
      defined(program, "info", "tell what a model is: size, bodies, faces, holes, repairs", info_options()),
      defined(program, "compare", "tell what a person sees that differs in two drawings", compare_options()),
      defined(program, "snapshot", "draw cases and compare them with what is expected", snapshot_options()),
      defined(program, "plugins", "list projections, show one, or check a library of them", plugins_options()),
      defined(program, "new-projection", "begin a projection plugin: C++ source and CMake file",
              new_projection_options())};
  commands.push_back(
      defined(*program.get_subcommand("plugins"), "check", "test a library of projections", check_plugin_options()));
  CLI::App& study = *program.add_subcommand("study", "measure the program itself")->require_subcommand(1);
  commands.push_back(
      defined(study, "accuracy", "error against run time of all ways to find hidden lines", accuracy_options()));
  commands.push_back(defined(study, "stability", "draw stiff and extreme cases, and say where arithmetics break",
                             stability_options()));
  define_answers(program, commands);
  return commands;
}

}  // namespace epura
