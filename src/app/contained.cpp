#include "app/contained.hpp"

#include <poll.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>

#include "base/error.hpp"
#include "base/text.hpp"
#include "projection/loader.hpp"

namespace epura {

namespace {

/// Writes a byte into the pipe when the work is done: foreign code may end the process before.
[[noreturn]] void be_child(const std::function<int()>& work, int pipe) noexcept {
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  const int code = work();
  std::fflush(stdout);
  check(::write(pipe, "", 1) == 1, "a pipe can be written to");
  ::_exit(code);  // the plugin's code at exit is not what is looked at
}

/// The pipe ends when the child does, since nobody else holds its other end.
bool ends_within(int pipe, double seconds) {
  pollfd event{pipe, POLLIN, 0};
  int happened = 0;
  do {
    happened = ::poll(&event, 1, static_cast<int>(1000 * seconds));
  } while (happened < 0 && errno == EINTR);  // it was stopped for a while
  return happened > 0;
}

/// Waits until the child is gone; reads what it left in the pipe.
Contained ending_of(pid_t child, int pipe) {
  int status = 0;
  check(::waitpid(child, &status, 0) == child, "a child can be waited for");
  if (WIFSIGNALED(status)) return {{}, std::string("crashes (") + ::strsignal(WTERMSIG(status)) + ")"};
  char byte = 0;
  if (::read(pipe, &byte, 1) != 1) return {{}, "ends the program"};
  return {WEXITSTATUS(status), {}};
}

}  // namespace

Contained run_contained(const std::function<int()>& work, double seconds) {
  std::fflush(stdout);
  std::array<int, 2> ends{};
  check(::pipe(ends.data()) == 0, "a pipe can be made");
  const pid_t child = ::fork();
  check(child >= 0, "a process can be made");
  if (child == 0) be_child(work, ends[1]);
  ::close(ends[1]);
  const bool in_time = ends_within(ends[0], seconds);
  if (!in_time) ::kill(child, SIGKILL);
  const Contained ending = ending_of(child, ends[0]);
  ::close(ends[0]);
  return in_time ? ending : Contained{{}, "takes more than " + format_number(seconds) + " s"};
}

std::string trouble_with_loading(const std::filesystem::path& plugin, double seconds) {
  const auto load = [&] {
    try {
      read_plugin(plugin);
    } catch (const Error&) {
      return 1;
    }
    return 0;
  };
  const Contained loading = run_contained(load, seconds);
  return loading.code ? "" : loading.trouble + " when it is loaded";
}

}  // namespace epura
