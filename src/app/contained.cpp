#include "app/contained.hpp"

#include <poll.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <cstdio>
#include <cstring>

#include "base/error.hpp"
#include "base/text.hpp"
#include "projection/loader.hpp"

namespace epura {

namespace {

[[noreturn]] void be_child(const std::function<int()>& work) {
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  const int code = work();
  std::fflush(stdout);
  ::_exit(code);  // the plugin's code at exit is not what is looked at
}

/// A pipe that ends when the child does, since nobody else holds its other end.
bool ends_within(int pipe, double seconds) {
  pollfd event{pipe, POLLIN, 0};
  return ::poll(&event, 1, static_cast<int>(1000 * seconds)) > 0;
}

}  // namespace

Contained run_contained(const std::function<int()>& work, double seconds) {
  std::fflush(stdout);
  std::array<int, 2> ends{};
  check(::pipe(ends.data()) == 0, "a pipe can be made");
  const pid_t child = ::fork();
  check(child >= 0, "a process can be made");
  if (child == 0) be_child(work);
  ::close(ends[1]);
  const bool in_time = ends_within(ends[0], seconds);
  if (!in_time) ::kill(child, SIGKILL);
  int status = 0;
  check(::waitpid(child, &status, 0) == child, "a child can be waited for");
  ::close(ends[0]);
  if (!in_time) return {{}, "takes more than " + format_number(seconds) + " s"};
  if (WIFEXITED(status)) return {WEXITSTATUS(status), {}};
  return {{}, std::string("crashes (") + ::strsignal(WTERMSIG(status)) + ")"};
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
