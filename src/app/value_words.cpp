// SPDX-License-Identifier: Apache-2.0
#include "app/value_words.hpp"

#include <algorithm>
#include <string_view>

#include "app/completion.hpp"
#include "app/leave_out.hpp"
#include "app/plugin_texts.hpp"
#include "base/error.hpp"
#include "base/text.hpp"
#include "output/write.hpp"

namespace epura {

namespace {

using Folders = std::vector<std::filesystem::path>;
using Words = std::vector<std::string>;

Words names_of_certificates() {
  Words names{"all", "none"};
  for (const auto& [name, member] : certificates()) names.push_back(name);
  return names;
}

/// Options whose values are words: by the name of the option, and of the command where commands differ.
const std::vector<std::pair<std::string, Words>>& words_of_options() {
  static const std::vector<std::pair<std::string, Words>> table{
      {"--unit", {"mm", "in", "m"}},
      {"--up", {"z", "y"}},
      {"--hidden", {"none", "dashed", "solid"}},
      {"--edges", {"contour", "crease", "boundary", "intersection", "tangent", "smooth"}},
      {"--dimensions", {"overall"}},
      {"--visibility", {"exact", "exact:bits=", "float", "sampled:density=", "item-buffer:dpi=", "none"}},
      {"--sheet", {"A4", "A3", "A2", "A1", "A0", "none", "auto"}},
      {"--scale", {"fit", "auto", "1:1", "1:2", "1:5", "1:10", "2:1", "5:1", "10:1"}},
      {"--frame", {"auto", "none", "plain", "full"}},
      {"--svg-text", {"outlines", "text"}},
      {"--progress", {"auto", "always", "never"}},
      {"--dump", {"edges", "spans"}},
      {"--plan", names_of_certificates()},
      {"stability --format", {"html", "json", "csv", "svg", "pdf"}},
      {"--format", format_names()},
      {"shell", shells()}};
  return table;
}

Words words_of(const CommandDescription& command, const std::string& option) {
  for (const auto& [name, words] : words_of_options())
    if (name == option || name == command.name + " " + option) return words;
  return {};
}

/// `text` up to and with the last `separator`.
std::string before_last(const std::string& text, char separator) { return text.substr(0, text.rfind(separator) + 1); }

/// The next word of a list with commas: those that are not in it yet.
std::vector<Suggestion> continue_list(const std::string& text, const std::vector<Suggestion>& words) {
  const std::string before = before_last(text, ',');
  const auto given = split(before, ',');
  std::vector<Suggestion> suggestions;
  for (const Suggestion& suggestion : words)
    if (std::find(given.begin(), given.end(), suggestion.word) == given.end())
      suggestions.push_back({before + suggestion.word, suggestion.help});
  return suggestions;
}

std::vector<Suggestion> projections(const Folders& folders) {
  std::vector<Suggestion> suggestions;
  for (const ProjectionEntry& entry : load_catalogue(folders).entries)
    suggestions.push_back({entry.name, entry.summary});
  return suggestions;
}

std::vector<Suggestion> values_of(const Parameter& parameter, const std::string& before) {
  std::vector<Suggestion> suggestions;
  for (const std::string& choice : parameter.choices) suggestions.push_back({before + choice, parameter.help});
  if (suggestions.empty() && !usual_value(parameter).empty())
    suggestions.push_back({before + usual_value(parameter), values_text(parameter)});
  return suggestions;
}

/// Parameters that have no value yet, or the values of the one that waits for its.
std::vector<Suggestion> parameters(const ProjectionEntry& entry, const std::string& text) {
  const std::string before = before_last(text, ':');
  const std::string last = text.substr(before.size());
  std::vector<Suggestion> suggestions;
  for (const Parameter& parameter : entry.parameters) {
    const std::string key = parameter.name + "=";
    if (last.starts_with(key)) return values_of(parameter, before + key);
    if (before.find(":" + key) == std::string::npos)
      suggestions.push_back({before + key, parameter.help + "; " + values_text(parameter)});
  }
  return suggestions;
}

/// NAME[:key=value...]
std::vector<Suggestion> continue_request(const std::string& text, const Folders& folders) {
  const std::size_t colon = text.find(':');
  if (colon == std::string::npos) return projections(folders);
  try {
    return parameters(find_projection(text.substr(0, colon), folders), text);
  } catch (const Error&) {
    return {};  // a name that is not known has no parameters
  }
}

}  // namespace

std::vector<Suggestion> value_suggestions(const CommandDescription& command, const OptionDescription& option,
                                          const std::string& text, const Folders& folders) {
  const std::string& name = option.names.back();
  if (name == "--projection") return continue_request(text, folders);
  if (name == "--views") return continue_list(text, projections(folders));
  if (name == "name" && command.name == "plugins") return projections(folders);
  std::vector<Suggestion> words;
  for (const std::string& word : words_of(command, name)) words.push_back({word, ""});
  return name == "--edges" || name == "--plan" ? continue_list(text, words) : words;
}

}  // namespace epura
