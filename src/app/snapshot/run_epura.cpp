// SPDX-License-Identifier: Apache-2.0
#include "app/snapshot/run_epura.hpp"

#include <fcntl.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>

#include "base/error.hpp"

namespace epura {

namespace {

[[noreturn]] void refuse(const char* what) {
  throw Error(ErrorKind::output, "epura", what, "there may be too little memory or too many processes");
}

// A file without a name, so that nothing is left behind, however the run ends.
class Capture {
 public:
  Capture() : file_(::memfd_create("epura", MFD_CLOEXEC)) {
    if (file_ < 0) refuse("cannot store the output of a run");
  }
  Capture(const Capture&) = delete;
  Capture& operator=(const Capture&) = delete;
  ~Capture() { ::close(file_); }

  [[nodiscard]] int file() const { return file_; }
  [[nodiscard]] std::string text() const {
    std::string bytes;
    std::array<char, 65536> part{};
    ::lseek(file_, 0, SEEK_SET);
    for (ssize_t read = 0; (read = ::read(file_, part.data(), part.size())) > 0;)
      bytes.append(part.data(), static_cast<std::size_t>(read));
    return bytes;
  }

 private:
  int file_;
};

}  // namespace

ProgramRun run_epura(const std::vector<std::string>& arguments) {
  std::vector<std::string> words{"epura"};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> pointers;
  for (std::string& word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);

  const Capture out, err;
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_adddup2(&actions, out.file(), STDOUT_FILENO);
  posix_spawn_file_actions_adddup2(&actions, err.file(), STDERR_FILENO);
  pid_t child = 0;
  const int failed = ::posix_spawn(&child, "/proc/self/exe", &actions, nullptr, pointers.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  if (failed != 0) refuse("cannot start another epura");
  int status = 0;
  while (::waitpid(child, &status, 0) < 0)
    if (errno != EINTR) refuse("cannot wait for a run");
  return {WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status), out.text(), err.text()};
}

}  // namespace epura
