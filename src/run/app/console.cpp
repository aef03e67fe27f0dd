// SPDX-License-Identifier: Apache-2.0
#include "app/console.hpp"

#include <poll.h>
#include <sys/eventfd.h>
#include <sys/ioctl.h>
#include <sys/signalfd.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <system_error>

#include "app/progress_line.hpp"
#include "base/error.hpp"
#include "base/utf8.hpp"
#include "composition/tell.hpp"
#include "views/budget.hpp"

namespace epura {

namespace {

// Runs shorter than the first wait show no progress.
constexpr int first_wait_ms = 300, next_wait_ms = 100;
// Greatest delay of cancelling for the sake of files that are being written.
constexpr std::chrono::seconds patience(2);

// Signals ignored by the parent process, as with nohup, remain ignored.
sigset_t ending_signals() {
  sigset_t signals;
  sigemptyset(&signals);
  for (const int number : {SIGINT, SIGTERM}) {
    struct sigaction now {};
    if (::sigaction(number, nullptr, &now) == 0 && now.sa_handler != SIG_IGN) sigaddset(&signals, number);
  }
  return signals;
}

std::size_t terminal_width() {
  winsize size{};
  const bool known = ::ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 1;
  return known ? size.ws_col - 1U : 79U;
}

[[noreturn]] void refuse_process(const std::string& what, const std::string& remedy) {
  throw Error(ErrorKind::input, "this process", what, remedy);
}
void put(std::string_view text) { std::fwrite(text.data(), 1, text.size(), stderr); }

}  // namespace

Console::Console(ProgressBoard& board, bool shows_progress, std::optional<double> time_limit)
    : board_(board), shows_progress_(shows_progress), time_limit_(time_limit) {
  // A thread waits for signals; unlike a signal handler it may take locks, and unlike a flag that stages check it ends
  // the process even while a stage is inside another library.
  const sigset_t signals = ending_signals();
  ::pthread_sigmask(SIG_BLOCK, &signals, &old_mask_);
  signals_ = ::signalfd(-1, &signals, SFD_CLOEXEC);
  end_ = signals_ < 0 ? -1 : ::eventfd(0, EFD_CLOEXEC);
  if (end_ < 0)
    refuse_process(std::string("cannot open a file descriptor: ") + std::strerror(errno), "raise ulimit -n");
  try {
    watcher_ = std::thread([this] { watch(); });
  } catch (const std::system_error& error) {
    refuse_process(std::string("cannot start a thread: ") + error.what(), "raise ulimit -v and ulimit -u");
  }
}

Console::~Console() {
  ::eventfd_write(end_, 1);
  watcher_.join();
  erase_line();
  ::close(signals_);
  ::close(end_);
  ::pthread_sigmask(SIG_SETMASK, &old_mask_, nullptr);
}

void Console::print(std::string_view lines) {
  const std::lock_guard lock(printing_);
  erase_line();
  put(printable(lines));
}

void Console::watch() {
  std::array<pollfd, 2> events{{{signals_, POLLIN, 0}, {end_, POLLIN, 0}}};
  for (bool is_first = true;; is_first = false) {
    const int happened = ::poll(events.data(), events.size(), wait_ms(is_first));
    if (happened > 0 && events[0].revents != 0) cancel();
    if (happened > 0) return;
    if (happened == 0 && shows_progress_) draw_line();
    give_up_when_over();
  }
}

int Console::wait_ms(bool is_first) const {
  const int for_line = is_first ? first_wait_ms : next_wait_ms;
  if (!time_limit_ || !board_.has_limit()) return shows_progress_ ? for_line : -1;
  constexpr double longest = 1e6;
  const double left = std::clamp(1000 * (pipeline::last_second(*time_limit_) - board_.seconds()), 0.0, longest);
  const int until_over = static_cast<int>(std::ceil(left));
  return shows_progress_ ? std::min(for_line, until_over) : until_over;
}

// Ends the process like cancel().
void Console::give_up_when_over() {
  if (!time_limit_ || !board_.has_limit() || board_.seconds() < pipeline::last_second(*time_limit_)) return;
  std::unique_lock files(board_.ending(), patience);
  const Error error = pipeline::nothing_drawn(board_.standing().stage);
  print("epura: " + std::string(error.what()) + "\n  hint: " + error.hint() + "\n");
  ::_exit(static_cast<int>(error.kind()));
}

void Console::draw_line() {
  const Standing standing = board_.standing();
  const std::string line = progress_line(standing, time_left_.at(standing), terminal_width());
  const std::lock_guard lock(printing_);
  const std::size_t rest = line_length_ > line.size() ? line_length_ - line.size() : 0;
  put("\r" + line + std::string(rest, ' '));
  line_length_ = line.size() + rest;
}

// Overwrites with blanks, since terminals differ in their control sequences.
void Console::erase_line() {
  if (line_length_ > 0) put("\r" + std::string(line_length_, ' ') + "\r");
  line_length_ = 0;
}

// Nothing needs to be unwound: memory is freed with the process, and outputs appear only when they are complete.
void Console::cancel() {
  signalfd_siginfo signal{};
  ssize_t got = 0;
  do got = ::read(signals_, &signal, sizeof signal);
  while (got < 0 && errno == EINTR);
  if (got != sizeof signal) signal.ssi_signo = SIGINT;
  std::unique_lock files(board_.ending(), patience);
  print("epura: cancelled\n");
  ::_exit(128 + static_cast<int>(signal.ssi_signo));
}

bool shows_progress(ShowProgress when) {
  return when == ShowProgress::always || (when == ShowProgress::automatic && ::isatty(STDERR_FILENO) != 0);
}

pipeline::Messages messages_to(Console& console) {
  return {[&console](const std::string& sentence) { console.warn(sentence); },
          [&console](std::string_view lines) { console.print(lines); }};
}

}  // namespace epura
