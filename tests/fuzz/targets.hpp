// SPDX-License-Identifier: Apache-2.0
// What strangers hand to epura, as functions of bytes: for the fuzzers, and for the test that replays what they found.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace epura::fuzz {

struct Target {
  std::string_view name;  ///< also that of its corpus, and of its dictionary if it has one
  /// Reads the bytes, or draws what they describe. Throws Error if they are refused. Aborts with a sentence if a
  /// property is violated; any other exception is a fault, too.
  void (*run)(const std::string& bytes);
};

/// Files and texts of the user, and answers of processes with foreign code.
std::span<const Target> readers();

/// Tables and answers of plugins, and what users write for their parameters.
std::span<const Target> plugins();

/// Drawings of small meshes full of ties, against the truth and against themselves.
std::span<const Target> drawings();

/// Scene files through the whole pipeline.
std::span<const Target> sheets();

/// All of them.
std::vector<Target> all_targets();

/// Returns nothing if there is none.
std::optional<Target> target_named(std::string_view name);

/// Runs a target. Returns whether the bytes were accepted. What is neither accepted nor refused ends the process.
bool run(const Target& target, const std::string& bytes);

}  // namespace epura::fuzz
