// SPDX-License-Identifier: Apache-2.0
// What values in a scene file may be: their names for the documentation, and how they are read.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "base/vec.hpp"
#include "scene/description.hpp"
#include "scene/toml_tree.hpp"

namespace epura {

/// Throws Error{input} at the value: "scene.toml:12:9: 'at' " + reason.
[[noreturn]] void refuse(const TomlValue& value, const std::string& reason, const std::string& hint = {});

/// A kind of values: `name` as the documentation calls it. `read` throws Error{input} for values of other kinds.
template <class Value>
struct ValueKind {
  std::string name;
  std::function<Value(const TomlValue&)> read;
};

/// An anchor of a dimension whose model is not looked up yet.
struct AnchorWords {
  std::string where;
  std::variant<int, std::string> model;  ///< number or name
  int vertex = -1;
  std::optional<Vec3> point;  ///< instead of a vertex
};

// Texts have one line without control characters, and are not empty where nothing else is said.
ValueKind<Given> any_text();
ValueKind<Given> field_text();       ///< may be empty, or a date: 2026-11-21
ValueKind<Given> words();            ///< a list of texts, or a text with commas; the latter in either case
ValueKind<Given> projection_text();  ///< NAME[:key=value...], from such a text or a table {name = NAME, key = value}
ValueKind<bool> truth();
ValueKind<int> whole_number(int least);
ValueKind<double> any_number(const std::string& unit);
ValueKind<double> number_between(double least, double most, const std::string& unit);
ValueKind<Vec2> pair_of_numbers(const std::string& unit);
ValueKind<Vec3> triple_of_numbers(const std::string& unit);
ValueKind<Vec3> direction();      ///< three numbers, not all zero
ValueKind<AnchorWords> anchor();  ///< [model, vertex] or {point = [x, y, z]}

/// The texts of words(), each with its place.
std::vector<Given> each_word(const TomlValue& value);

/// A table with entries of any name.
const TomlTable& table_of(const TomlValue& value);

/// Several tables, or a single one.
std::vector<const TomlValue*> tables_of(const TomlValue& value);

}  // namespace epura
