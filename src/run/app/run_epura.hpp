// SPDX-License-Identifier: Apache-2.0
// Runs epura in separate processes, so that a crash affects only one drawing.
#pragma once

#include <sys/types.h>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace epura {

struct ProgramRun {
  int code = 0;  ///< exit code; 128 + number if a signal ended it
  std::string out{}, err{};
};

/// What a process may use that draws for others. It also ends with the process that started it.
struct ProcessLimits {
  double megabytes;         ///< of memory
  double output_megabytes;  ///< on standard output
};

/// A run in parallel to this process; it is killed with this object.
class EpuraProcess {
 public:
  /// Throws Error{output} if it cannot be started.
  explicit EpuraProcess(const std::vector<std::string>& arguments, std::optional<ProcessLimits> limits = std::nullopt);
  EpuraProcess(const EpuraProcess&) = delete;
  EpuraProcess& operator=(const EpuraProcess&) = delete;
  ~EpuraProcess() { end(); }

  /// A descriptor that becomes readable when the run has ended. Throws Error{output} if the system has no more.
  [[nodiscard]] int descriptor();
  /// Waits until it has ended. To be called once.
  [[nodiscard]] ProgramRun wait();

 private:
  void end();

  int out_ = -1, err_ = -1;  ///< files without a name, so that nothing is left behind, however the run ends
  pid_t child_ = 0;          ///< 0: there is none
  int ended_ = -1;           ///< opened when it is asked for
};

/// Waits for the process to end. Throws Error{output} if it cannot be started.
ProgramRun run_epura(const std::vector<std::string>& arguments);

/// A word of a command as a shell reads it.
std::string for_shell(std::string_view word);

}  // namespace epura
