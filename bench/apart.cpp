// SPDX-License-Identifier: Apache-2.0
// A process writes lines to its pipe: "at STAGE", "number N", "trouble SENTENCE", and "end" at the end.
#include "apart.hpp"

#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <Standard_Failure.hxx>
#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <exception>
#include <stdexcept>
#include <string_view>

#include "base/text.hpp"

namespace epura::bench {

namespace {

using Clock = std::chrono::steady_clock;

struct Process {
  std::size_t number;  ///< of its task
  pid_t id;
  int pipe;
  Clock::time_point deadline;
  std::string said{};
};

void say(int pipe, std::string line) {
  std::replace(line.begin(), line.end(), '\n', ' ');
  line += '\n';
  for (std::string_view rest = line; !rest.empty();) {
    const ssize_t written = ::write(pipe, rest.data(), rest.size());
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) return;
    rest.remove_prefix(static_cast<std::size_t>(written));
  }
}

[[noreturn]] void work_in_child(const Work& work, int pipe) {
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  // Silences Open CASCADE's messages.
  if (const int nowhere = ::open("/dev/null", O_WRONLY | O_CLOEXEC); nowhere >= 0) ::dup2(nowhere, STDOUT_FILENO);
  try {
    for (const double number : work([&](const std::string& name) { say(pipe, "at " + name); }))
      say(pipe, "number " + format_number(number));
  } catch (const Standard_Failure& failure) {
    const char* message = failure.GetMessageString();
    say(pipe, std::string("trouble ") + failure.DynamicType()->Name() + " " + (message != nullptr ? message : ""));
  } catch (const std::exception& failure) {
    say(pipe, std::string("trouble ") + failure.what());
  }
  say(pipe, "end");
  ::_exit(0);  // skips the exit handlers of other libraries
}

Process start(std::size_t number, const Work& work, double seconds) {
  std::array<int, 2> ends{};
  if (::pipe2(ends.data(), O_CLOEXEC) != 0) throw std::runtime_error(std::strerror(errno));
  std::fflush(nullptr);
  const pid_t id = ::fork();
  if (id < 0) throw std::runtime_error(std::strerror(errno));
  if (id == 0) {
    ::close(ends[0]);
    work_in_child(work, ends[1]);
  }
  ::close(ends[1]);
  return {number, id, ends[0],
          Clock::now() + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds))};
}

/// Returns whether there may be more.
bool listen(Process& process) {
  std::array<char, 4096> bytes{};
  const ssize_t count = ::read(process.pipe, bytes.data(), bytes.size());
  if (count > 0) process.said.append(bytes.data(), static_cast<std::size_t>(count));
  return count > 0 || (count < 0 && errno == EINTR);
}

Outcome outcome_of(const Process& process, int status, bool late) {
  Outcome outcome;
  bool ended = false;
  for (const std::string_view line : split(process.said, '\n')) {
    const std::size_t space = std::min(line.find(' '), line.size());
    const std::string_view word = line.substr(0, space), rest = line.substr(std::min(space + 1, line.size()));
    if (word == "at") outcome.stage = rest;
    if (word == "number") outcome.numbers.push_back(parse_number(rest).value());
    if (word == "trouble") outcome.trouble = rest;
    ended = ended || word == "end";
  }
  if (late)
    outcome.trouble = "not done when its time was over";
  else if (!ended)
    outcome.trouble = WIFSIGNALED(status) ? std::string("crashed, ") + strsignal(WTERMSIG(status)) : "ended early";
  if (outcome.trouble) outcome.numbers.clear();
  return outcome;
}

Outcome finish(const Process& process, bool late) {
  if (late) ::kill(process.id, SIGKILL);
  int status = 0;
  while (::waitpid(process.id, &status, 0) < 0 && errno == EINTR) {
  }
  ::close(process.pipe);
  return outcome_of(process, status, late);
}

void wait_for(const std::vector<Process>& running, std::vector<pollfd>& pipes) {
  auto first = Clock::time_point::max();
  pipes.clear();
  for (const Process& process : running) {
    pipes.push_back({process.pipe, POLLIN, 0});
    first = std::min(first, process.deadline);
  }
  const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(first - Clock::now()).count() + 1;
  ::poll(pipes.data(), pipes.size(), static_cast<int>(std::clamp<long long>(left, 0, 3'600'000)));
}

}  // namespace

void run_apart(const std::vector<Work>& works, const Limits& limits,
               const std::function<void(std::size_t, const Outcome&)>& done) {
  std::vector<std::optional<Outcome>> outcomes(works.size());
  std::vector<Process> running;
  std::vector<pollfd> pipes;
  std::size_t next = 0, told = 0;
  while (told < works.size()) {
    while (next < works.size() && running.size() < static_cast<std::size_t>(limits.at_once)) {
      running.push_back(start(next, works[next], limits.seconds));
      ++next;
    }
    wait_for(running, pipes);
    std::vector<Process> still;
    for (std::size_t i = 0; i < running.size(); ++i) {
      const bool more = pipes[i].revents == 0 || listen(running[i]);
      const bool late = more && Clock::now() > running[i].deadline;
      if (more && !late)
        still.push_back(std::move(running[i]));
      else
        outcomes[running[i].number] = finish(running[i], late);
    }
    running = std::move(still);
    for (; told < works.size() && outcomes[told]; ++told) done(told, *outcomes[told]);
  }
}

}  // namespace epura::bench
