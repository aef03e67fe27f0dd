// SPDX-License-Identifier: Apache-2.0
// Reads the entries of a table of a scene file by a table of options.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "base/text.hpp"
#include "scene/option.hpp"

namespace epura::scene {

// A key of the whole file is often written in the last section by mistake.
inline std::string hint_for(const std::string& key, const std::vector<std::string>& known) {
  return key == "views" ? "it belongs above the first section" : did_you_mean(key, known);
}

/// Throws Error{input} for unknown keys, missing keys and invalid values; `section` is the name of the table.
template <class Part>
void read_entries(Part& part, const TomlValue& table, const Options<Part>& keys, const std::string& section) {
  std::vector<std::string> names;
  for (const auto& known : keys) names.push_back(known.key);
  const std::vector<TomlValue>& entries = table_of(table).values;
  for (const TomlValue& entry : entries)
    if (std::find(names.begin(), names.end(), entry.key) == names.end())
      throw Error(ErrorKind::input, entry.key_where, "'" + entry.key + "' is not a key of " + section,
                  hint_for(entry.key, names));
  for (const auto& known : keys) {
    const auto entry = std::find_if(entries.begin(), entries.end(),
                                    [&known](const TomlValue& candidate) { return candidate.key == known.key; });
    if (entry != entries.end())
      known.read(part, *entry);
    else if (known.required)
      throw Error(ErrorKind::input, table.where, section + " lacks '" + known.key + "'", known.help);
  }
}

}  // namespace epura::scene
