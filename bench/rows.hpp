// SPDX-License-Identifier: Apache-2.0
// Lines as `epura study paper --rival` reads them.
#pragma once

#include <array>
#include <span>
#include <string>

#include "base/text.hpp"
#include "base/vec.hpp"

namespace epura::bench {

/// A row "x0 y0 x1 y1" for each line.
inline std::string rows_of(std::span<const std::array<Vec2, 2>> lines) {
  std::string text;
  for (const auto& [from, to] : lines)
    text += format_number(from.x) + ' ' + format_number(from.y) + ' ' + format_number(to.x) + ' ' +
            format_number(to.y) + '\n';
  return text;
}

}  // namespace epura::bench
