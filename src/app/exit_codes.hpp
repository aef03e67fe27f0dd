// SPDX-License-Identifier: Apache-2.0
// What the exit codes mean, for the help and the manual.
#pragma once

#include <array>

namespace epura {

struct ExitCode {
  int code;
  const char* meaning;
};

inline constexpr std::array exit_codes{
    ExitCode{0, "done"},
    ExitCode{1, "differences (compare, snapshot) or found wrong (--verify, plugins check)"},
    ExitCode{2, "wrong input"},
    ExitCode{3, "plugin"},
    ExitCode{4, "could not write"},
    ExitCode{5, "partial drawing, or no time for any (--time-limit)"},
    ExitCode{130, "cancelled"}};

}  // namespace epura
