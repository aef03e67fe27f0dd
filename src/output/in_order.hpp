// SPDX-License-Identifier: Apache-2.0
// Writes long texts in several threads.
#pragma once

#include <cstddef>
#include <functional>
#include <string>

#include "base/progress.hpp"

namespace epura::output {

/// Appends write(0), write(1) ... write(count - 1). Several calls run at the same time, but only a few results are kept
/// in memory. Throws OutOfTime.
void append_in_order(std::string& text, std::size_t count, const Progress& progress,
                     const std::function<std::string(std::size_t)>& write);

}  // namespace epura::output
