// SPDX-License-Identifier: Apache-2.0
#include "program.hpp"

#include <fcntl.h>
#include <spawn.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "base/folder.hpp"

namespace epura::test {

namespace {

std::vector<char*> pointers(std::vector<std::string>& words) {
  std::vector<char*> list;
  for (std::string& word : words) list.push_back(word.data());
  list.push_back(nullptr);
  return list;
}

std::vector<std::string> environment() {
  std::vector<std::string> variables;
  for (char** variable = environ; *variable != nullptr; ++variable)
    if (!std::string_view(*variable).starts_with("EPURA_PLUGIN_PATH=")) variables.emplace_back(*variable);
  return variables;
}

}  // namespace

Running::Running(const std::vector<std::string>& arguments, const std::filesystem::path& folder,
                 const std::string& out_path, const std::string& limits)
    : keeps_out_(out_path.empty()),
      out_(keeps_out_ ? (scratch_ / "out").string() : out_path),
      err_((scratch_ / "err").string()) {
  std::vector<std::string> words{EPURA_TEST_PROGRAM};
  if (!limits.empty()) words.insert(words.begin(), {"/bin/sh", "-c", limits + R"(; exec "$0" "$@")"});
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<std::string> variables = environment();

  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, out_.c_str(), O_WRONLY | O_CREAT, 0600);
  posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, err_.c_str(), O_WRONLY | O_CREAT, 0600);
  posix_spawn_file_actions_addchdir_np(&actions, folder.c_str());
  // Resets what the test inherited: shells in the background ignore Ctrl-C, and so do their children.
  sigset_t ending;
  sigemptyset(&ending);
  for (const int number : {SIGINT, SIGTERM}) sigaddset(&ending, number);
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGDEF);
  posix_spawnattr_setsigdefault(&attributes, &ending);
  const int failed =
      posix_spawn(&child_, words[0].c_str(), &actions, &attributes, pointers(words).data(), pointers(variables).data());
  posix_spawnattr_destroy(&attributes);
  posix_spawn_file_actions_destroy(&actions);
  if (failed != 0) throw std::runtime_error("cannot run " + words[0]);
}

Running::~Running() {
  if (child_ == 0) return;
  signal(SIGKILL);
  ::waitpid(child_, nullptr, 0);
}

void Running::signal(int number) const { ::kill(child_, number); }

std::string Running::err() const { return read_file(err_); }

Outcome Running::wait() {
  int status = 0;
  rusage used{};
  if (::wait4(std::exchange(child_, 0), &status, 0, &used) < 0) throw std::runtime_error("cannot wait for a run");
  const int code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  return {code, keeps_out_ ? read_file(out_) : std::string(), err(), static_cast<double>(used.ru_maxrss) * 1024 / 1e6};
}

Outcome epura(const std::vector<std::string>& arguments, const std::filesystem::path& folder,
              const std::string& out_path, const std::string& limits) {
  return Running(arguments, folder, out_path, limits).wait();
}

std::vector<std::string> built_in_projections() {
  std::vector<std::string> names = names_in(EPURA_TEST_PLUGINS);
  for (std::string& name : names) name = std::filesystem::path(name).stem();
  return names;
}

}  // namespace epura::test
