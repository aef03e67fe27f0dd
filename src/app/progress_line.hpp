// SPDX-License-Identifier: Apache-2.0
// The progress line on a terminal.
#pragma once

#include <cstddef>
#include <string>

#include "base/progress.hpp"

namespace epura {

/// "2:05", "1:02:05": minutes and seconds, from an hour on hours too, rounded up.
std::string clock_text(double seconds);

/// Such as "epura: hiding lines  [########------------]  42 %  0:03 left", at most `width` characters and no control
/// characters. If the amount of work is unknown, the elapsed seconds are shown instead.
std::string progress_line(const Standing& standing, std::size_t width);

}  // namespace epura
