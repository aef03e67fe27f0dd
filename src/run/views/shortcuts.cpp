// SPDX-License-Identifier: Apache-2.0
#include "views/shortcuts.hpp"

#include "views/choose.hpp"

namespace epura::pipeline {

const std::vector<std::pair<std::string, bool Shortcuts::*>>& shortcut_names() {
  static const std::vector<std::pair<std::string, bool Shortcuts::*>> table{
      {"clip", &Shortcuts::clip},
      {"intersections", &Shortcuts::intersections},
      {"visibility", &Shortcuts::visibility},
      {"hidden", &Shortcuts::hidden},
      {"text", &Shortcuts::text}};
  return table;
}

Shortcuts parse_shortcuts(const std::string& text) {
  if (text == "all") return {};
  Shortcuts chosen{false, false, false, false, false};
  if (text == "none") return chosen;
  for (const std::string_view name : split(text, ','))
    chosen.*choose<bool Shortcuts::*>("--plan", std::string(name), shortcut_names()) = true;
  return chosen;
}

}  // namespace epura::pipeline
