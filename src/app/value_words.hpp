// SPDX-License-Identifier: Apache-2.0
// Possible values of an option, for shell completion.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "scene/scene_values.hpp"

namespace epura {

/// A possible word at the cursor. One that ends with ':', '=' or ',' is incomplete.
struct Suggestion {
  std::string word, help;
};

/// `text` is what the value begins with so far; suggestions are whole values, some of which do not begin like it.
/// Projections and their parameters are asked of the plugins in `folders`. Nothing where every text would do.
std::vector<Suggestion> value_suggestions(const scene::ValueForm& form, const std::string& text,
                                          const std::vector<std::filesystem::path>& folders);

}  // namespace epura
