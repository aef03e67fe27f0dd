// SPDX-License-Identifier: Apache-2.0
// Measures the memory that a task needs.
#pragma once

#include <functional>
#include <optional>

namespace epura::study {

/// Runs `work` and returns by how many bytes the process grew at most in the meantime. Nothing if the system does not
/// report it (Linux: /proc/self/clear_refs, proc(5)).
std::optional<double> peak_memory_of(const std::function<void()>& work);

}  // namespace epura::study
