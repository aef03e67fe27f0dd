// SPDX-License-Identifier: Apache-2.0
// `epura study`: starts epura-study, a separate program that may be installed next to epura.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace epura {

/// What epura-study is to be asked, where a command line is for it: 'epura study ...', or the completion of one.
std::optional<std::vector<std::string>> study_arguments(int argc, char** argv);

/// Becomes epura-study: its streams, signals and exit code are those of this process. Throws Error{input} where it is
/// not installed.
[[noreturn]] void start_study(std::vector<std::string> arguments);

}  // namespace epura
