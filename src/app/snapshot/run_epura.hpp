// SPDX-License-Identifier: Apache-2.0
// Runs epura in separate processes, so that a crash affects only one case.
#pragma once

#include <string>
#include <vector>

namespace epura {

struct ProgramRun {
  int code = 0;  ///< exit code; 128 + number if a signal ended it
  std::string out{}, err{};
};

/// Waits for the process to end. Throws Error{output} if it cannot be started.
ProgramRun run_epura(const std::vector<std::string>& arguments);

}  // namespace epura
