// SPDX-License-Identifier: Apache-2.0
// Standard error and signals of a run: warnings, the progress line, and Ctrl-C.
#pragma once

#include <csignal>
#include <cstddef>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <thread>

#include "app/options.hpp"
#include "base/progress.hpp"
#include "pipeline/messages.hpp"

namespace epura {

/// While it lives, SIGINT and SIGTERM end the process with the exit code 128 + number, at once and at any stage, and
/// (if asked for) a line shows how far the run is. To be made before any thread: threads inherit which signals reach
/// them.
class Console {
 public:
  /// A run with a time limit is ended when a stage that cannot be stopped, such as one in another library, has gone on
  /// beyond it for longer than is promised.
  Console(ProgressBoard& board, bool shows_progress, std::optional<double> time_limit = std::nullopt);
  Console(const Console&) = delete;
  Console& operator=(const Console&) = delete;
  ~Console();

  /// Prints whole lines, with the progress line out of the way.
  void print(std::string_view lines);
  /// Prints a sentence behind the program's name.
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
  int signals_ = -1;  ///< descriptor that signals arrive at
  int end_ = -1;      ///< descriptor that makes the thread end
  std::mutex printing_;
  std::size_t line_length_ = 0;  ///< of the line on the screen
  std::thread watcher_;
};

/// Whether the line of progress is shown; `automatic`: on a terminal.
bool shows_progress(ShowProgress when);

/// Prints the messages of a run to the console.
pipeline::Messages messages_to(Console& console);

}  // namespace epura
