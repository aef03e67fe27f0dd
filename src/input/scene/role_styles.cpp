// SPDX-License-Identifier: Apache-2.0
#include "scene/role_styles.hpp"

#include <algorithm>
#include <string>
#include <utility>

#include "base/error.hpp"
#include "base/text.hpp"
#include "scene/scene_values.hpp"

namespace epura::scene {

namespace {

constexpr const char* all_roles = "all";

/// The line types by name. ISO 128-2, types 01, 02, 04 and 05.
enum class TypeName { continuous, dashed, dash_dot, dash_dot_dot };

DashType type_of(TypeName name) {
  switch (name) {
    case TypeName::continuous:
      return continuous_line;
    case TypeName::dashed:
      return dashed;
    case TypeName::dash_dot:
      return long_dash_dot;
    case TypeName::dash_dot_dot:
      break;
  }
  return long_dash_double_dot;
}

}  // namespace

template <>
struct Words<TypeName> {
  static constexpr std::array list{"continuous", "dashed", "dash-dot", "dash-dot-dot"};
};

namespace {

std::vector<std::string> names_of_roles() {
  std::vector<std::string> names = {all_roles};
  for (const SheetLineRow& row : sheet_lines) names.emplace_back(row.name);
  return names;
}

Colour read_colour(const TomlValue& value) {
  const ColourChoice read = colour().read(value);
  if (read.of_file) refuse(value, "cannot be 'file', which is for bodies", "give a colour such as \"#036\"");
  return read.colour;
}

void read_key(RoleStyle& style, const TomlValue& value, const std::string& role) {
  const std::vector<std::string> keys = {"width", "colour", "dashes"};
  if (value.key == keys[0])
    style.width = number_between(0.01, 10, "mm").read(value);
  else if (value.key == keys[1])
    style.colour = read_colour(value);
  else if (value.key == keys[2])
    style.dashes = type_of(choice<TypeName>().read(value));
  else
    throw Error(ErrorKind::input, value.key_where, "'" + value.key + "' is not a key of [" + role + "]",
                did_you_mean(value.key, keys));
}

RoleStyle read_style(const TomlValue& table, SheetLine line) {
  RoleStyle style{line};
  for (const TomlValue& value : table_of(table).values) read_key(style, value, table.key);
  return style;
}

// The values of `usual` where the style has none.
void complete(RoleStyle& style, const RoleStyle& usual) {
  if (!style.width) style.width = usual.width;
  if (!style.colour) style.colour = usual.colour;
  if (!style.dashes) style.dashes = usual.dashes;
}

}  // namespace

std::vector<RoleStyle> read_role_styles(const LocatedText& file) {
  const TomlValue root = read_toml(*file);
  std::vector<RoleStyle> styles;
  std::optional<RoleStyle> usual;
  for (const TomlValue& table : table_of(root).values) {
    const auto row = std::find_if(sheet_lines.begin(), sheet_lines.end(),
                                  [&](const SheetLineRow& one) { return one.name == table.key; });
    if (table.key == all_roles)
      usual = read_style(table, SheetLine::frame);
    else if (row != sheet_lines.end())
      styles.push_back(read_style(table, row->line));
    else
      throw Error(ErrorKind::input, table.key_where, "'" + table.key + "' is not a role of lines",
                  did_you_mean(table.key, names_of_roles()));
  }
  if (!usual) return styles;
  for (const SheetLineRow& row : sheet_lines) {
    const auto found =
        std::find_if(styles.begin(), styles.end(), [&](const auto& one) { return one.line == row.line; });
    RoleStyle& style = found != styles.end() ? *found : styles.emplace_back(RoleStyle{row.line});
    complete(style, *usual);
  }
  return styles;
}

}  // namespace epura::scene
