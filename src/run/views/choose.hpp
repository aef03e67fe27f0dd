// SPDX-License-Identifier: Apache-2.0
// Words for a choice of the user.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "base/error.hpp"
#include "base/text.hpp"
#include "scene/description.hpp"

namespace epura::pipeline {

/// Returns the value of the word. Throws Error{input} that names `where` it comes from and suggests valid words.
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

/// Returns the result of `use` for the value. Errors about a value in a scene file are prefixed with its location;
/// options name themselves.
template <class Value, class Use>
auto at_place(const scene::Located<Value>& located, const Use& use) {
  try {
    return use(*located);
  } catch (const Error& error) {
    if (located.where.starts_with("--")) throw;
    throw Error(error.kind(), located.where, error.what(), error.hint());
  }
}

/// The same for functions that read a file which they name themselves.
template <class Read>
auto read_at_place(const scene::LocatedText& file, const Read& read) {
  return at_place(file, [&](const std::string&) { return read(file); });
}

}  // namespace epura::pipeline
