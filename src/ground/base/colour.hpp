// SPDX-License-Identifier: Apache-2.0
// Colours of lines.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace epura {

/// Parts of 255. Engineering drawings are black; pictures about them need not be.
struct Colour {
  int red = 0, green = 0, blue = 0;

  auto operator<=>(const Colour&) const = default;
};

/// "#rrggbb"; "#000" for black.
std::string hexadecimal(const Colour& colour);

/// Of "#rgb" or "#rrggbb", in either case; nothing for other texts.
std::optional<Colour> parse_colour(std::string_view text);

}  // namespace epura
