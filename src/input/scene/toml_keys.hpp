// SPDX-License-Identifier: Apache-2.0
// Finds TOML keys that nest tables too deeply, before the TOML library reads them.
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

namespace epura::scene {

/// Returns the line, from 1, of the first key with more than `max_dots` dots. Dots in strings and comments do not
/// count.
std::optional<std::size_t> line_of_deep_key(std::string_view text, std::size_t max_dots);

}  // namespace epura::scene
