// SPDX-License-Identifier: Apache-2.0
#include "app/command_line.hpp"

#include <malloc.h>
#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <new>
#include <stdexcept>
#include <string_view>

#include "app/run_epura.hpp"
#include "base/broken.hpp"
#include "base/error.hpp"
#include "base/file.hpp"
#include "base/text.hpp"
#include "base/utf8.hpp"

namespace epura {

namespace {

std::string footer_of(const ProgramTexts& texts) {
  std::string codes;
  for (const ExitCode& exit : texts.exit_codes) append_to_list(codes, std::to_string(exit.code) + " " + exit.meaning);
  return "'" + texts.name + " COMMAND --help' shows more, '" + texts.name +
         " manual' everything. Exit codes: " + codes + ".";
}

int answer(const std::string& text) {
  std::fputs(text.c_str(), stdout);
  return 0;
}

// As the system knows it.
std::string own_command() {
  std::string words = read_file("/proc/self/cmdline");
  if (!words.empty()) words.pop_back();  // a NUL follows each word
  std::string command;
  for (const std::string_view word : split(words, '\0')) command += (command.empty() ? "" : " ") + for_shell(word);
  return command;
}

void tell_broken(const char* sentence) {
  std::fprintf(stderr, "epura: internal error: this does not hold: %s\n", sentence);
  std::fputs(
      "  hint: the fault is in epura, not in the input; to report it, send the models, the version and the command:\n",
      stderr);
  std::fputs("    epura " EPURA_VERSION "\n", stderr);
  std::fprintf(stderr, "    %s\n", printable(own_command()).c_str());
}

void tell_no_memory() { std::fputs("epura: not enough memory for this model\n", stderr); }

// Prints the exception that is being handled. Returns the exit code.
int tell_exception() {
  try {
    throw;
  } catch (const Error& error) {
    std::fprintf(stderr, "epura: %s\n", printable(error.what()).c_str());
    if (!error.hint().empty()) std::fprintf(stderr, "  hint: %s\n", printable(error.hint()).c_str());
    return static_cast<int>(error.kind());
  } catch (const std::bad_alloc&) {
    tell_no_memory();
    return static_cast<int>(ErrorKind::input);
  } catch (const std::length_error&) {  // more than there can be
    tell_no_memory();
    return static_cast<int>(ErrorKind::input);
  } catch (const std::runtime_error& error) {
    std::fprintf(stderr, "epura: %s\n", printable(error.what()).c_str());
    return static_cast<int>(ErrorKind::input);
  } catch (const std::exception& error) {
    tell_broken(error.what());
  } catch (...) {
    tell_broken("every exception is caught where it is expected");
  }
  return broken_exit_code;
}

bool is_without_memory() {
  void* const volatile some = std::malloc(1 << 16);
  std::free(some);
  return some == nullptr;
}

// Libraries ask for memory even at their end: where there is none, glibc would end the program with a code of its own.
int ends_with(int code) {
  if (!is_without_memory()) return code;
  std::fflush(stdout);
  ::_exit(code);
}

// Where an exception cannot go on: at the end of a thread, or out of a function that promises to throw none.
[[noreturn]] void end_by_exception() {
  if (std::current_exception() != nullptr) ::_exit(tell_exception());
  // There is none, or no memory for it; or it cannot leave a function that promises to throw none, such as the one of
  // libstdc++ that goes on to the next file of a folder. What these meet is missing memory, too.
  if (is_without_memory() || std::uncaught_exceptions() > 0) {
    tell_no_memory();
    ::_exit(static_cast<int>(ErrorKind::input));
  }
  tell_broken("threads end before what they work on");
  ::_exit(broken_exit_code);
}

// The first of all that runs before main: CLI11 makes objects of its own there, for which memory may be missing, too.
[[gnu::constructor(101)]] void expect_exceptions() { std::set_terminate(end_by_exception); }

}  // namespace

int run_command_line(const ProgramTexts& texts, std::vector<DefinedCommand> (*define)(CLI::App& program), int argc,
                     char** argv) {
  CLI::App app(texts.name + ": " + texts.summary, texts.name);
  app.set_version_flag("--version", texts.name + " " EPURA_VERSION);
  app.require_subcommand(1);
  app.footer(footer_of(texts));
  const std::vector<DefinedCommand> commands = define(app);
  const CommandWords words(argv + 1, argv + argc);
  for (const DefinedCommand& command : commands)
    if (command.define_later)
      command.app->preparse_callback([&command, &words](std::size_t) { command.define_later(&words); });
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
    return ends_with(code);
  } catch (...) {
    return ends_with(tell_exception());
  }
}

}  // namespace epura
