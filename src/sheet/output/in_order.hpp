// SPDX-License-Identifier: Apache-2.0
// Writes long texts in several threads.
#pragma once

#include <cstddef>
#include <functional>
#include <string>

#include "base/progress.hpp"

namespace epura::output {

/// Appends what write(0, part), write(1, part) ... write(count - 1, part) append to `part`. Several calls run at the
/// same time, but only a few parts are kept in memory, in the same places again and again. Throws OutOfTime.
void append_in_order(std::string& text, std::size_t count, const Progress& progress,
                     const std::function<void(std::size_t, std::string& part)>& write);

}  // namespace epura::output
