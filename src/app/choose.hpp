// SPDX-License-Identifier: Apache-2.0
// Words that a user chooses among.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "base/error.hpp"
#include "base/text.hpp"
#include "scene/description.hpp"

namespace epura {

/// The value of the word. Throws Error{input} that names `where` it comes from, with the words that would do.
template <class Value>
Value choose(const std::string& where, const std::string& word,
             const std::vector<std::pair<std::string, Value>>& choices) {
  std::vector<std::string> names;
  for (const auto& [name, value] : choices) {
    if (name == word) return value;
    names.push_back(name);
  }
  throw Error(Trouble::input, where, "does not know '" + word + "'", did_you_mean(word, names));
}

/// The same; the first choice where no word is given.
template <class Value>
Value choose(const Given& given, const std::vector<std::pair<std::string, Value>>& choices) {
  return given.given() ? choose(given.where, given.text, choices) : choices.front().second;
}

/// What `parse` makes of the text. An error in a scene file names the place there first; an option names itself.
template <class Parse>
auto parse_given(const Given& given, const Parse& parse) {
  try {
    return parse(given.text);
  } catch (const Error& error) {
    if (given.where.starts_with("--")) throw;
    throw Error(error.trouble(), given.where, error.what(), error.hint());
  }
}

}  // namespace epura
