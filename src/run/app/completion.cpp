// SPDX-License-Identifier: Apache-2.0
#include "app/completion.hpp"

#include <algorithm>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "app/completion_scripts.hpp"
#include "app/plugin_texts.hpp"
#include "base/error.hpp"
#include "base/text.hpp"
#include "projection/catalogue.hpp"
#include "scene/scene_values.hpp"
#include "views/choose.hpp"

namespace epura {

namespace {

/// A possible word at the cursor. One that ends with ':', '=' or ',' is incomplete.
struct Suggestion {
  std::string word, help;
};

using Folders = std::vector<std::filesystem::path>;

/// Returns `text` up to and including the last `separator`.
std::string before_last(const std::string& text, char separator) { return text.substr(0, text.rfind(separator) + 1); }

/// Suggestions for the next word of a comma-separated list: words that are not yet in it.
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
  for (const projection::ProjectionEntry& entry : projection::load_catalogue(folders).entries)
    suggestions.push_back({entry.name, entry.summary});
  return suggestions;
}

std::vector<Suggestion> values_of(const projection::Parameter& parameter, const std::string& before) {
  std::vector<Suggestion> suggestions;
  for (const std::string& choice : parameter.choices) suggestions.push_back({before + choice, parameter.help});
  if (suggestions.empty() && !usual_value(parameter).empty())
    suggestions.push_back({before + usual_value(parameter), values_text(parameter)});
  return suggestions;
}

/// Parameters without a value, or values of the last parameter.
std::vector<Suggestion> parameters(const projection::ProjectionEntry& entry, const std::string& text) {
  const std::string before = before_last(text, ':');
  const std::string last = text.substr(before.size());
  std::vector<Suggestion> suggestions;
  for (const projection::Parameter& parameter : entry.parameters) {
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
    return parameters(projection::find_projection(text.substr(0, colon), folders), text);
  } catch (const Error&) {
    return {};  // an unknown projection has no parameters
  }
}

/// Returns suggestions for a value of which `text` has been typed. They are whole values, some of which may not begin
/// with `text`. Projections and their parameters are obtained from the plugins in `folders`. Empty if any text is
/// permitted.
std::vector<Suggestion> value_suggestions(const scene::ValueForm& form, const std::string& text,
                                          const Folders& folders) {
  if (form.completion == scene::Completion::projection) return continue_request(text, folders);
  if (form.completion == scene::Completion::projections) return continue_list(text, projections(folders));
  std::vector<Suggestion> words;
  for (const std::string& word : form.words) words.push_back({word, ""});
  return form.is_list ? continue_list(text, words) : words;
}

const std::vector<std::pair<std::string, std::string>>& scripts() {
  static const std::vector<std::pair<std::string, std::string>> table{
      {"bash", bash_completion}, {"zsh", zsh_completion}, {"fish", fish_completion}};
  return table;
}

const OptionDescription* option_named(const CommandDescription& command, const std::string& name) {
  for (const OptionDescription& option : command.options)
    if (std::find(option.names.begin(), option.names.end(), name) != option.names.end()) return &option;
  return nullptr;
}

const CommandDescription* command_named(const CommandDescription& command, const std::string& name) {
  for (const CommandDescription& inner : command.commands)
    if (inner.name == name) return &inner;
  return nullptr;
}

/// The state of the command line before the word at the cursor.
struct Place {
  const CommandDescription* command;  ///< innermost one
  const OptionDescription* option;    ///< option whose value is next, or null
  bool only_arguments;                ///< after "--"
  int arguments;                      ///< number of arguments so far
  std::vector<std::filesystem::path> plugin_path;
};

void take_value(Place& place, const std::string& value) {
  if (place.option->names.back() == "--plugin-path") place.plugin_path.emplace_back(value);
  place.option = nullptr;
}

void take_option(Place& place, const std::string& word) {
  const std::size_t equals = word.find('=');
  const OptionDescription* option = option_named(*place.command, word.substr(0, equals));
  if (option == nullptr || !option->takes_word) return;
  place.option = option;
  if (equals != std::string::npos) take_value(place, word.substr(equals + 1));
}

void take(Place& place, const std::string& word) {
  if (place.option != nullptr) return take_value(place, word);
  if (word == "--") {
    place.only_arguments = true;
  } else if (!place.only_arguments && word.starts_with('-')) {
    take_option(place, word);
  } else if (const CommandDescription* inner = command_named(*place.command, word); inner && place.arguments == 0) {
    place.command = inner;
  } else {
    ++place.arguments;
  }
}

/// The next argument, or a repeatable one.
const OptionDescription* next_argument(const Place& place) {
  const OptionDescription* next = nullptr;
  int index = 0;
  for (const OptionDescription& option : place.command->options) {
    if (!option.is_argument()) continue;
    if (index == place.arguments || (index < place.arguments && option.type.ends_with("..."))) next = &option;
    ++index;
  }
  return next;
}

std::string one_line(std::string text) {
  for (char& c : text)
    if (static_cast<unsigned char>(c) < ' ') c = ' ';
  return text;
}

/// One line for each suggestion that begins with `begin`, with the prefix `before`.
std::string lines(const std::vector<Suggestion>& suggestions, const std::string& begin,
                  const std::string& before = {}) {
  std::string text;
  for (const Suggestion& suggestion : suggestions)
    if (suggestion.word.starts_with(begin)) text += before + suggestion.word + "\t" + one_line(suggestion.help) + "\n";
  return text;
}

std::string values(const Place& place, const OptionDescription& option, const std::string& text,
                   const std::string& before = {}) {
  const scene::ValueForm& form = option.form;
  const auto suggestions = value_suggestions(form, text, projection::plugin_folders(place.plugin_path));
  if (!suggestions.empty()) return lines(suggestions, text, before);
  if (form.completion == scene::Completion::folders) return ":folders\n";
  return form.completion == scene::Completion::files ? ":files\n" : "";
}

std::string options(const CommandDescription& command, const std::string& begin) {
  std::vector<Suggestion> suggestions;
  for (const OptionDescription& option : command.options)
    for (const std::string& name : option.names)
      if (!option.is_argument() && (name.starts_with("--") || begin == "-")) suggestions.push_back({name, option.help});
  return lines(suggestions, begin);
}

std::string commands_and_argument(const Place& place, const std::string& text) {
  std::vector<Suggestion> commands;
  if (place.arguments == 0)
    for (const CommandDescription& command : place.command->commands) commands.push_back({command.name, command.help});
  const OptionDescription* argument = next_argument(place);
  return lines(commands, text) + (argument != nullptr ? values(place, *argument, text) : "");
}

}  // namespace

const std::vector<std::string>& shells() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> all;
    for (const auto& script : scripts()) all.push_back(script.first);
    return all;
  }();
  return names;
}

std::string completion_script(const std::string& shell) { return pipeline::choose("completion", shell, scripts()); }

std::string complete(const CommandDescription& program, const std::vector<std::string>& words) {
  Place place{&program, nullptr, false, 0, {}};
  for (std::size_t i = 0; i + 1 < words.size(); ++i) take(place, words[i]);
  const std::string word = words.empty() ? "" : words.back();
  if (place.option != nullptr) return values(place, *place.option, word);
  if (place.only_arguments || !word.starts_with('-')) return commands_and_argument(place, word);
  const std::size_t equals = word.find('=');
  if (equals == std::string::npos) return options(*place.command, word);
  const OptionDescription* option = option_named(*place.command, word.substr(0, equals));
  if (option == nullptr || option->type.empty()) return "";
  return values(place, *option, word.substr(equals + 1), word.substr(0, equals + 1));
}

}  // namespace epura
