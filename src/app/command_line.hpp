// SPDX-License-Identifier: Apache-2.0
// The command line: one table parses, prints help and names what was perhaps meant.
#pragma once

#include <variant>

#include "app/options.hpp"

namespace epura {

/// Help or version text to print on standard output.
struct Answer {
  std::string text;
};

using Command = std::variant<Answer, DrawOptions, AccuracyOptions, StabilityOptions, CompareOptions, InfoOptions,
                             SnapshotOptions, PluginsOptions, CheckPluginOptions, NewProjectionOptions>;

/// Throws Error{input} for wrong usage.
Command parse_command_line(int argc, char** argv);

}  // namespace epura
