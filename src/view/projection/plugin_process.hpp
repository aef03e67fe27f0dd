// SPDX-License-Identifier: Apache-2.0
// Isolates foreign code: a plugin is loaded and called in a separate process. If it crashes, hangs, exits, prints, or
// changes the floating-point environment, this process receives a sentence about it.
#pragma once

#include <filesystem>
#include <vector>

#include "projection/catalogue.hpp"

namespace epura::projection {

/// Seconds that a plugin may take to load, and again for each answer.
inline constexpr double plugin_seconds = 10;

/// Whether the process waits for questions after the table is read. One that does not is started again for the first
/// question: a list of many plugins needs no process for each.
enum class Afterwards { waits, rests };

/// Whether the process can open nothing but the library's folder (foreign/sandbox.hpp).
enum class Confinement { none, sandbox };

/// Returns what the library contains, as `read_plugin` does. The process ends with the entries. Throws Error{plugin}
/// without the path: what is wrong with the library, or what it did.
std::vector<ProjectionEntry> read_plugin_apart(const std::filesystem::path& path, Afterwards afterwards,
                                               double seconds = plugin_seconds,
                                               Confinement confinement = Confinement::none);

}  // namespace epura::projection
