// SPDX-License-Identifier: Apache-2.0
// Formats the progress line for a terminal.
#pragma once

#include <cstddef>
#include <string>

#include "base/progress.hpp"

namespace epura {

/// "2:05", "1:02:05": minutes and seconds, with hours if there are any, rounded up.
std::string clock_text(double seconds);

/// For example "epura: hiding lines  [########------------]  42 %  0:03 left", with at most `width` characters. If the
/// amount of work is unknown, the elapsed time is shown instead.
std::string progress_line(const Standing& standing, std::size_t width);

}  // namespace epura
