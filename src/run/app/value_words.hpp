// SPDX-License-Identifier: Apache-2.0
// Suggests values of an option, for shell completion.
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

/// Returns suggestions for a value of which `text` has been typed. They are whole values, some of which may not begin
/// with `text`. Projections and their parameters are obtained from the plugins in `folders`. Empty if any text is
/// permitted.
std::vector<Suggestion> value_suggestions(const scene::ValueForm& form, const std::string& text,
                                          const std::vector<std::filesystem::path>& folders);

}  // namespace epura
