// SPDX-License-Identifier: Apache-2.0
#include "app/command_line.hpp"

#include <malloc.h>

#include <csignal>
#include <cstdio>
#include <exception>
#include <new>

#include "base/error.hpp"
#include "base/utf8.hpp"

namespace epura {

namespace {

std::string footer_of(const ProgramTexts& texts) {
  std::string codes;
  for (const ExitCode& exit : texts.exit_codes)
    codes += (codes.empty() ? "" : ", ") + std::to_string(exit.code) + " " + exit.meaning;
  return "'" + texts.name + " COMMAND --help' shows more, '" + texts.name +
         " manual' everything. Exit codes: " + codes + ".";
}

int answer(const std::string& text) {
  std::fputs(text.c_str(), stdout);
  return 0;
}

}  // namespace

int run_command_line(const ProgramTexts& texts, std::vector<DefinedCommand> (*define)(CLI::App& program), int argc,
                     char** argv) {
  CLI::App app(texts.name + ": " + texts.summary, texts.name);
  app.set_version_flag("--version", texts.name + " " EPURA_VERSION);
  app.require_subcommand(1);
  app.footer(footer_of(texts));
  const std::vector<DefinedCommand> commands = define(app);
  try {
    app.parse(argc, argv);
  } catch (const CLI::CallForHelp&) {
    return answer(chosen_command(app).help());
  } catch (const CLI::CallForVersion& version) {
    return answer(std::string(version.what()) + "\n");
  } catch (const CLI::ParseError& error) {
    refuse_wrong_use(app, error);
  }
  for (const DefinedCommand& defined : commands)
    if (defined.app == &chosen_command(app)) return defined.run();
  throw Error(ErrorKind::input, "", "no command given", "see '" + texts.name + " --help'");
}

int run_program(const std::function<int()>& run) {
  // All threads share one heap, where memory freed by one thread serves another: this saves a tenth of the memory.
  // Contention makes whole runs at most a few percent slower.
  mallopt(M_ARENA_MAX, 1);
  // A file at the limit of its size then fails like one on a full disk.
  std::signal(SIGXFSZ, SIG_IGN);
  try {
    const int code = run();
    if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0)
      throw Error(ErrorKind::output, "standard output", "cannot be written");
    return code;
  } catch (const Error& error) {
    std::fprintf(stderr, "epura: %s\n", printable(error.what()).c_str());
    if (!error.hint().empty()) std::fprintf(stderr, "  hint: %s\n", printable(error.hint()).c_str());
    return static_cast<int>(error.kind());
  } catch (const std::bad_alloc&) {
    std::fputs("epura: not enough memory for this model\n", stderr);
    return 2;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "epura: %s\n", error.what());
    return 2;
  }
}

}  // namespace epura
