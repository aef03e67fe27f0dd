// SPDX-License-Identifier: Apache-2.0
#include <malloc.h>

#include <csignal>
#include <cstdio>
#include <exception>
#include <new>

#include "app/command_line.hpp"
#include "app/commands.hpp"
#include "base/error.hpp"
#include "base/utf8.hpp"

namespace {

int run(int argc, char** argv) {
  using namespace epura;
  const Command command = parse_command_line(argc, argv);
  if (const auto* answer = std::get_if<Answer>(&command)) {
    std::fputs(answer->text.c_str(), stdout);
    return 0;
  }
  if (const auto* options = std::get_if<DrawOptions>(&command)) return draw(*options);
  if (const auto* options = std::get_if<CheckPluginOptions>(&command)) return check_plugin(*options);
  if (const auto* options = std::get_if<NewProjectionOptions>(&command)) return new_projection(*options);
  if (const auto* options = std::get_if<StabilityOptions>(&command)) return study_stability(*options);
  if (const auto* options = std::get_if<AccuracyOptions>(&command)) return study_accuracy(*options);
  if (const auto* options = std::get_if<CompareOptions>(&command)) return compare(*options);
  if (const auto* options = std::get_if<InfoOptions>(&command)) return info(*options);
  if (const auto* options = std::get_if<SnapshotOptions>(&command)) return snapshot(*options);
  return plugins(std::get<PluginsOptions>(command));
}

}  // namespace

int main(int argc, char** argv) {
  // All threads take from one heap, where what one of them has freed serves another: a tenth less memory. They wait
  // for each other there, which makes whole runs at most a few percent longer.
  mallopt(M_ARENA_MAX, 1);
  // A file that may not grow further is refused as one on a full disk.
  std::signal(SIGXFSZ, SIG_IGN);
  try {
    const int code = run(argc, argv);
    if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0)
      throw epura::Error(epura::ErrorKind::output, "standard output", "cannot be written");
    return code;
  } catch (const epura::Error& error) {
    std::fprintf(stderr, "epura: %s\n", epura::printable(error.what()).c_str());
    if (!error.hint().empty()) std::fprintf(stderr, "  hint: %s\n", epura::printable(error.hint()).c_str());
    return static_cast<int>(error.kind());
  } catch (const std::bad_alloc&) {
    std::fputs("epura: not enough memory for this model\n", stderr);
    return 2;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "epura: %s\n", error.what());
    return 2;
  }
}
