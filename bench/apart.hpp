// SPDX-License-Identifier: Apache-2.0
// Runs tasks in separate processes, so that one that crashes or never ends does not affect the others.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace epura::bench {

using Numbers = std::vector<double>;

/// Reports the current stage; if the work does not end, it is reported as the last one.
using Stage = std::function<void(const std::string& name)>;

/// Exceptions end only this work.
using Work = std::function<Numbers(const Stage& stage)>;

struct Outcome {
  Numbers numbers;
  std::string stage;
  std::optional<std::string> trouble{};  ///< the reason if there are no numbers
};

struct Limits {
  int at_once;
  double seconds;  ///< time limit for each task
};

/// Calls `done` for each task, in order, as soon as all tasks before it are done. The process must have no other
/// threads. Tasks must not print to standard output.
void run_apart(const std::vector<Work>& works, const Limits& limits,
               const std::function<void(std::size_t number, const Outcome& outcome)>& done);

}  // namespace epura::bench
