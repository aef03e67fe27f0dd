// SPDX-License-Identifier: Apache-2.0
// Handles standard error and signals of a run: warnings, the progress line, and Ctrl-C.
#pragma once

#include <csignal>
#include <cstddef>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <thread>

#include "app/options.hpp"
#include "app/progress_line.hpp"
#include "base/progress.hpp"
#include "views/messages.hpp"

namespace epura {

/// During its lifetime, SIGINT and SIGTERM end the process with exit code 128 + number, immediately and in any stage,
/// and (if requested) a line shows the progress. Must be constructed before any thread, since threads inherit the
/// signal mask.
class Console {
 public:
  /// Ends a run with a time limit if a stage that cannot be stopped, such as one in another library, exceeds the limit
  /// by more than the guaranteed margin.
  Console(ProgressBoard& board, bool shows_progress, std::optional<double> time_limit = std::nullopt);
  Console(const Console&) = delete;
  Console& operator=(const Console&) = delete;
  ~Console();

  /// Erases the progress line, and prints whole lines.
  void print(std::string_view lines);
  /// Prints a sentence after the program's name.
  void warn(const std::string& sentence) { print("epura: " + sentence + "\n"); }

 private:
  void watch();
  void draw_line();
  void erase_line();
  [[nodiscard]] int wait_ms(bool is_first) const;
  void give_up_when_over();
  [[noreturn]] void cancel();

  ProgressBoard& board_;
  const bool shows_progress_;
  const std::optional<double> time_limit_;
  sigset_t old_mask_{};
  int signals_ = -1;  ///< descriptor that receives signals
  int end_ = -1;      ///< descriptor that ends the thread
  std::mutex printing_;
  TimeLeft time_left_;           ///< used by the watcher alone
  std::size_t line_length_ = 0;  ///< length of the line on the screen
  std::thread watcher_;
};

/// Whether the progress line is shown; `automatic`: on a terminal.
bool shows_progress(ShowProgress when);

/// Prints the messages of a run to the console.
pipeline::Messages messages_to(Console& console);

}  // namespace epura
