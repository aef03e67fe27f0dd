// SPDX-License-Identifier: Apache-2.0
// Foreign code at arm's length: a plugin is loaded and asked in a separate process. What it does there - crash, hang,
// end the program, print, change the floating-point environment - reaches this one as a sentence.
#pragma once

#include <filesystem>
#include <vector>

#include "projection/catalogue.hpp"

namespace epura::projection {

/// Seconds that a plugin may take to load, and again for each answer.
inline constexpr double plugin_seconds = 10;

/// Whether the process waits for questions when the table is read. One that does not is made again for the first
/// question: a list of many plugins needs no process for each.
enum class Afterwards { waits, rests };

/// What the library offers, as of `read_plugin`. The process ends with the entries. Throws Error{plugin} without the
/// path: what is wrong with the library, or what it did.
std::vector<ProjectionEntry> read_plugin_apart(const std::filesystem::path& path, Afterwards afterwards,
                                               double seconds = plugin_seconds);

}  // namespace epura::projection
