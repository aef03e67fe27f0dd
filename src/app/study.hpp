// SPDX-License-Identifier: Apache-2.0
// `epura study`: starts epura-study, a separate program that may be installed next to epura.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace epura {

/// The arguments for epura-study, if a command line is meant for it: 'epura study ...', or its completion.
std::optional<std::vector<std::string>> study_arguments(int argc, char** argv);

/// Becomes epura-study: its streams, signals and exit code are those of this process. Throws Error{input} where it is
/// not installed.
[[noreturn]] void start_study(std::vector<std::string> arguments);

}  // namespace epura
