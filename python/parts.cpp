// SPDX-License-Identifier: Apache-2.0
// Writes epura/_parts.py: a class for each section of scene files, from the tables by which these are read.
//   parts FILE
#include <algorithm>
#include <array>
#include <cstdio>
#include <string>
#include <utility>
#include <vector>

#include "base/file.hpp"
#include "scene/scene_keys.hpp"

namespace {

using epura::scene::OptionInfo;
using epura::scene::SceneSection;

const std::string head = R"(# SPDX-License-Identifier: Apache-2.0
"""The parts of a scene. Made from the tables of epura; docs/scenes.md says more."""

from __future__ import annotations

from dataclasses import KW_ONLY, dataclass
from datetime import date as Date
from typing import Any, Literal, Mapping, Optional, Sequence, Union

#: (model, vertex), {"point": (x, y, z)}, or a feature: "hole 3", (model, "hole 3")
Anchor = Union[str, Sequence[Union[int, str]], Mapping[str, Sequence[float]]]
)";

/// What the classes of scene files hold is their type, by the beginning of the name of their form.
constexpr std::array<std::pair<const char*, const char*>, 21> types{{
    {"true or false", "bool"},
    {"text, or rows of a matrix", "Union[str, Sequence[Sequence[float]]]"},
    {"text or date", "Union[str, Date]"},
    {"text or number", "Union[str, float]"},
    {"text or table", "Any"},
    {"text, or list of texts", "Union[str, Sequence[str]]"},
    {"text", "str"},
    {"whole number", "int"},
    {"number", "float"},
    {"[[x, y, z], ...]", "Sequence[Sequence[float]]"},
    {"[x, y, z], or a feature", "Union[str, Sequence[Union[int, float, str]]]"},
    {"[x, y, z]", "Sequence[float]"},
    {"[x, y]", "Sequence[float]"},
    {"`#rgb`", "str"},
    {"`auto`, or list of texts", "Union[str, Sequence[str]]"},
    {"anchor", "Anchor"},
    {"list of anchors", "Sequence[Anchor]"},
    {"list of tables", "Sequence[Mapping[str, Any]]"},
    {"list of texts", "Sequence[str]"},
    {"list of lists of texts", "Sequence[Sequence[str]]"},
    {"table", "Mapping[str, Any]"},
}};

std::string words_of(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "\"" : ", \"") + word + "\"";
  return "Literal[" + text + "]";
}

std::string type_of(const OptionInfo& key) {
  if (key.form.is_closed && key.form.is_list) return "Union[str, Sequence[" + words_of(key.form.words) + "]]";
  if (key.form.is_closed) return words_of(key.form.words);
  // "0 to 180, degrees", "-1e+05 to 1e+05, mm"
  const char first = key.form.name.empty() ? ' ' : key.form.name.front();
  if (first == '-' || (first >= '0' && first <= '9')) return "float";
  for (const auto& [name, type] : types)
    if (key.form.name.starts_with(name)) return type;
  std::fprintf(stderr, "parts: '%s' is a '%s', which has no type in Python\n", key.key.c_str(), key.form.name.c_str());
  return {};
}

// "broken_out" -> "BrokenOut"
std::string class_of(const std::string& section) {
  std::string name;
  bool is_first = true;
  for (const char c : section) {
    if (c != '_') name += is_first ? static_cast<char>(c - 'a' + 'A') : c;
    is_first = c == '_';
  }
  return section == "model" ? "ModelOptions" : name;
}

// Words of the language cannot be names.
std::string member_of(const std::string& key) {
  constexpr std::array reserved{"from", "break", "class", "in", "is", "not", "or", "and", "with", "as", "for"};
  return std::find(reserved.begin(), reserved.end(), key) == reserved.end() ? key : key + "_";
}

std::string in_text(std::string text) {
  for (std::size_t i = text.find('\\'); i != std::string::npos; i = text.find('\\', i + 2)) text.insert(i, 1, '\\');
  return text;
}

bool append_class(std::string& module, const SceneSection& section) {
  std::vector<OptionInfo> keys;
  for (const OptionInfo& key : section.keys)
    if (!(section.name == "model" && key.key == "file")) keys.push_back(key);
  std::string text = "\n\n@dataclass\nclass " + class_of(section.name) + ":\n    \"\"\"`" +
                     (section.is_list ? "[[" : "[") + section.name + (section.is_list ? "]]" : "]") +
                     "` of scene files.\n\n";
  for (const OptionInfo& key : keys) {
    text += "    `" + member_of(key.key) + "`: " + in_text(key.meaning());
    if (!key.usual.empty()) text += "; by default: " + in_text(key.usual);
    text += "\n";
  }
  text += "    \"\"\"\n\n";
  bool is_sound = true;
  for (std::size_t i = 0; i < keys.size(); ++i) {
    // The first value can be given without its name: View("front"). Those of models are the source's.
    if (i == (section.name == "model" ? 0 : 1)) text += "    _: KW_ONLY\n";
    const std::string type = type_of(keys[i]);
    is_sound = is_sound && !type.empty();
    text += "    " + member_of(keys[i].key) + ": Optional[" + type + "] = None\n";
  }
  module += text;
  return is_sound;
}

void append_title_fields(std::string& module, const SceneSection& section) {
  module += "\n#: The known fields of the title block.\nTITLE_FIELDS = (";
  for (const OptionInfo& key : section.keys) module += "\"" + key.key + "\", ";
  module += ")\n";
}

}  // namespace

int main(int count, char** arguments) {
  if (count != 2) return 2;
  std::string module = head;
  bool is_sound = true;
  for (const SceneSection& section : epura::scene::scene_sections())
    if (section.name == "title_block") append_title_fields(module, section);
  for (const SceneSection& section : epura::scene::scene_sections())
    if (section.name != "all_sheets" && section.name != "title_block")
      is_sound = append_class(module, section) && is_sound;
  if (is_sound) epura::write_file(arguments[1], module);
  return is_sound ? 0 : 1;
}
