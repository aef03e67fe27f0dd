// SPDX-License-Identifier: Apache-2.0
// TOML files (toml.io, version 1.0) as plain values with their positions.
#pragma once

#include <filesystem>
#include <string>
#include <variant>
#include <vector>

namespace epura::scene {

struct TomlValue;

/// A date without a time of day, as written: 2026-11-21.
struct TomlDate {
  std::string text;
};

/// A time of day, with or without a date.
struct TomlTime {};

struct TomlList {
  std::vector<TomlValue> values;
};

struct TomlTable {
  std::vector<TomlValue> values;  ///< in the order of the file
};

/// Integers are stored as doubles: those above 2^53 are rounded.
using TomlContent = std::variant<std::string, double, bool, TomlDate, TomlTime, TomlList, TomlTable>;

struct TomlValue {
  std::string key;        ///< key of the value; for an element, key of its list
  std::string where;      ///< "scene.toml:12:9": file as given, line and column in characters, both from 1
  std::string key_where;  ///< the same for the key
  TomlContent content;
  bool is_option = false;  ///< from the command line: always text, also for numbers and lists; `where` is its name
};

/// Whether a character is a line break, a tab, an escape or another ASCII control character.
bool is_control(char c);

/// Returns the root table of a file. No key in it is empty or has control characters. Throws Error{input} for files
/// that cannot be read or are not TOML, with line and column, and for files that no person writes: larger than 2 MB, or
/// nested deeper than the reader can follow.
TomlValue read_toml(const std::filesystem::path& path);

}  // namespace epura::scene
