// SPDX-License-Identifier: Apache-2.0
#include "app/command_line.hpp"

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "app/command_line_options.hpp"
#include "app/define_commands.hpp"
#include "app/exit_codes.hpp"
#include "base/error.hpp"

namespace epura {

namespace {

std::string meanings_of_exit_codes() {
  std::string text;
  for (const ExitCode& exit : exit_codes)
    text += (text.empty() ? "" : ", ") + std::to_string(exit.code) + " " + exit.meaning;
  return text;
}

}  // namespace

Command parse_command_line(int argc, char** argv) {
  CLI::App app("epura: 3D meshes to engineering drawings with hidden lines removed", "epura");
  app.set_version_flag("--version", "epura " EPURA_VERSION);
  app.require_subcommand(1);
  app.footer("'epura COMMAND --help' says more, and 'epura manual' all. Exit codes: " + meanings_of_exit_codes() + ".");
  const std::vector<DefinedCommand> commands = define_commands(app);
  try {
    app.parse(argc, argv);
  } catch (const CLI::CallForHelp&) {
    return Answer{chosen_command(app).help()};
  } catch (const CLI::CallForVersion& version) {
    return Answer{std::string(version.what()) + "\n"};
  } catch (const CLI::ParseError& error) {
    refuse_wrong_use(app, error);
  }
  for (const DefinedCommand& defined : commands)
    if (defined.app == &chosen_command(app)) return defined.command();
  throw Error(ErrorKind::input, "", "names no command", "see 'epura --help'");
}

}  // namespace epura
