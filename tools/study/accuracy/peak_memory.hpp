// SPDX-License-Identifier: Apache-2.0
// How much memory a piece of work takes.
#pragma once

#include <functional>
#include <optional>

namespace epura::study {

/// Runs `work` and returns by how many bytes the process grew at most meanwhile. Nothing where the system does not tell
/// (Linux: /proc/self/clear_refs, proc(5)).
std::optional<double> peak_memory_of(const std::function<void()>& work);

}  // namespace epura::study
