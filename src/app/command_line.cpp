#include "app/command_line.hpp"

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "app/define_commands.hpp"
#include "app/exit_codes.hpp"
#include "base/error.hpp"
#include "base/text.hpp"

namespace epura {

namespace {

std::vector<std::string> long_names(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::Option* option : app.get_options())
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  return names;
}

std::vector<std::string> names_of_commands(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::App* command : app.get_subcommands({})) names.push_back(command->get_name());
  return names;
}

/// The innermost command that was named.
const CLI::App& chosen(const CLI::App& app) {
  const CLI::App* command = &app;
  while (!command->get_subcommands().empty()) command = command->get_subcommands().back();
  return *command;
}

// CLI11 says which arguments nobody took; this says what was perhaps meant.
[[noreturn]] void refuse(const CLI::App& app, const CLI::ParseError& error) {
  const CLI::App* command = &chosen(app);
  for (const std::string& extra : command->remaining(true)) {
    if (extra.starts_with("-"))
      throw Error(Trouble::input, "", "there is no option '" + extra + "'", did_you_mean(extra, long_names(*command)));
    if (command == &app)
      throw Error(Trouble::input, "", "there is no command '" + extra + "'",
                  did_you_mean(extra, names_of_commands(app)));
  }
  throw Error(Trouble::input, "command line", error.what(),
              "see 'epura " + (command == &app ? "" : command->get_name() + " ") + "--help'");
}

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
    return Answer{chosen(app).help()};
  } catch (const CLI::CallForVersion& version) {
    return Answer{std::string(version.what()) + "\n"};
  } catch (const CLI::ParseError& error) {
    refuse(app, error);
  }
  for (const DefinedCommand& defined : commands)
    if (defined.app == &chosen(app)) return defined.command();
  throw Error(Trouble::input, "", "names no command", "see 'epura --help'");
}

}  // namespace epura
