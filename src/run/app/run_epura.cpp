// SPDX-License-Identifier: Apache-2.0
#include "app/run_epura.hpp"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <string_view>
#include <utility>

#include "app/resource_limit.hpp"
#include "base/error.hpp"

namespace epura {

namespace {

[[noreturn]] void refuse(const char* what) {
  throw Error(ErrorKind::output, "epura", what, "there may be too little memory or too many processes");
}

std::string text_of(int file) {
  std::string bytes;
  std::array<char, 65536> part{};
  ::lseek(file, 0, SEEK_SET);
  for (ssize_t read = 0; (read = ::read(file, part.data(), part.size())) > 0;)
    bytes.append(part.data(), static_cast<std::size_t>(read));
  return bytes;
}

// In the new process, which has only this thread: nothing here may wait for another one.
[[noreturn]] void become_epura(char** words, int out, int err, const ProcessLimits* limits) {
  sigset_t none;
  sigemptyset(&none);
  ::sigprocmask(SIG_SETMASK, &none, nullptr);
  const int nothing = ::open("/dev/null", O_RDONLY | O_CLOEXEC);
  ::dup2(nothing, STDIN_FILENO);
  ::dup2(out, STDOUT_FILENO);
  ::dup2(err, STDERR_FILENO);
  if (limits != nullptr) {
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);
    limit_resource(RLIMIT_DATA, limits->megabytes);
    limit_resource(RLIMIT_FSIZE, limits->output_megabytes);
  }
  ::execv("/proc/self/exe", words);
  ::_exit(static_cast<int>(ErrorKind::output));
}

}  // namespace

EpuraProcess::EpuraProcess(const std::vector<std::string>& arguments, std::optional<ProcessLimits> limits) {
  std::vector<std::string> words{"epura"};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> pointers;
  for (std::string& word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  out_ = ::memfd_create("epura", MFD_CLOEXEC);
  err_ = ::memfd_create("epura", MFD_CLOEXEC);
  child_ = out_ < 0 || err_ < 0 ? -1 : ::fork();
  if (child_ == 0) become_epura(pointers.data(), out_, err_, limits ? &*limits : nullptr);
  if (child_ > 0) return;
  end();
  refuse("cannot start another epura");
}

int EpuraProcess::descriptor() {
  if (ended_ < 0) ended_ = static_cast<int>(::syscall(SYS_pidfd_open, child_, 0));
  if (ended_ < 0) refuse("cannot watch a run");
  return ended_;
}

void EpuraProcess::end() {
  if (child_ > 0) {
    ::kill(child_, SIGKILL);
    while (::waitpid(child_, nullptr, 0) < 0 && errno == EINTR) {
    }
  }
  for (const int file : {out_, err_, ended_})
    if (file >= 0) ::close(file);
}

ProgramRun EpuraProcess::wait() {
  int status = 0;
  while (::waitpid(child_, &status, 0) < 0)
    if (errno != EINTR) refuse("cannot wait for a run");
  child_ = 0;
  return {WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status), text_of(out_), text_of(err_)};
}

std::string for_shell(std::string_view word) {
  constexpr std::string_view plain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789-_./=:,+@%";
  if (!word.empty() && word.find_first_not_of(plain) == word.npos) return std::string(word);
  std::string quoted = "'";
  for (const char c : word) quoted += c == '\'' ? std::string(R"('\'')") : std::string(1, c);
  return quoted + "'";
}

ProgramRun run_epura(const std::vector<std::string>& arguments) { return EpuraProcess(arguments).wait(); }

}  // namespace epura
