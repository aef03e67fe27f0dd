// SPDX-License-Identifier: Apache-2.0
// Work in processes of their own, so that what crashes or never ends takes nothing else with it.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace epura::bench {

using Numbers = std::vector<double>;

/// Says what is done now; of work that comes to no end it is told which it was.
using Stage = std::function<void(const std::string& name)>;

/// What work throws ends that work alone.
using Work = std::function<Numbers(const Stage& stage)>;

struct Outcome {
  Numbers numbers;
  std::string stage;
  std::optional<std::string> trouble{};  ///< why there are no numbers
};

struct Limits {
  int at_once;
  double seconds;  ///< for each work
};

/// Calls `done` for each, in order, as soon as all before it are done. The process must have no other threads. Works
/// print nothing to standard output.
void run_apart(const std::vector<Work>& works, const Limits& limits,
               const std::function<void(std::size_t number, const Outcome& outcome)>& done);

}  // namespace epura::bench
