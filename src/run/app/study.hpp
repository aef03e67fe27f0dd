// SPDX-License-Identifier: Apache-2.0
// `epura study`: starts epura-study, a separate program that may be installed next to epura.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace epura {

/// Returns the arguments for epura-study if the command line is meant for it: 'epura study ...', or its completion.
std::optional<std::vector<std::string>> study_arguments(int argc, char** argv);

/// Replaces this process by epura-study, which keeps its streams and determines its exit code. Throws Error{input} if
/// it is not installed.
[[noreturn]] void start_study(std::vector<std::string> arguments);

}  // namespace epura
