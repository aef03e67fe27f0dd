// SPDX-License-Identifier: Apache-2.0
// Words among which a user chooses.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "base/error.hpp"
#include "base/text.hpp"
#include "scene/description.hpp"

namespace epura::pipeline {

/// The value of the word. Throws Error{input} that names `where` it comes from, with the words that would do.
template <class Value>
Value choose(const std::string& where, const std::string& word,
             const std::vector<std::pair<std::string, Value>>& choices) {
  std::vector<std::string> names;
  for (const auto& [name, value] : choices) {
    if (name == word) return value;
    names.push_back(name);
  }
  throw Error(ErrorKind::input, where, "unknown value '" + word + "'", did_you_mean(word, names));
}

/// What `use` makes of the value. An error over one in a scene file names the place there first; an option names
/// itself.
template <class Value, class Use>
auto at_place(const scene::Located<Value>& located, const Use& use) {
  try {
    return use(*located);
  } catch (const Error& error) {
    if (located.where.starts_with("--")) throw;
    throw Error(error.kind(), located.where, error.what(), error.hint());
  }
}

}  // namespace epura::pipeline
